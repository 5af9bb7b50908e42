// Cuts stuck stones out of a structure, as patches for src/nonlinear/stuck_stones.
//
// Blocks that are out of balance, or have a point that violates its law, by more than a threshold are cut out together
// with their neighbours; those that meet make a patch. Each goes to the rank that owns most of its blocks, and what
// came out to the owners of its unknowns and points. Which blocks those are does not depend on ranks.
#pragma once

#include <map>
#include <unordered_map>
#include <utility>

#include "homogenisation/merged_space.hpp"
#include "model/patch_messages.hpp"
#include "nonlinear/nonlinear_problem.hpp"
#include "nonlinear/stuck_stones.hpp"

namespace voussoir {

class PatchCutter : public PatchSource {
 public:
  /// The problem that patches are cut from; must outlive the cutter.
  struct Parts {
    const BlockSystem& structure;
    const ContactPoints& points;
    const MergedSpace& space;
    const std::vector<double>& proximal_weight;
    NonlinearProblem& problem;
  };
  explicit PatchCutter(const Parts& parts) : parts_(parts), dim_(parts.points.components()) {}

  bool find_stuck(const TpetraVector& x, const PointField& lambda, double threshold) override;
  bool parts_together() const override { return together_; }
  void part_no_more_together() override { together_ = false; }
  bool group(bool all_that_parted, double most) override;
  std::vector<CutPatch> cut(const TpetraVector& x, const PointField& lambda, const PatchRequest&) override;
  void put_back(const std::vector<SolvedPatch>& mine, TpetraVector& x, PointField& lambda) override;

 private:
  using Unknown = PatchMessages::Unknown;
  using Entry = PatchMessages::Entry;
  using Point = PatchMessages::Point;
  using Share = PatchMessages::Share;
  using Motion = PatchMessages::Motion;
  using Force = PatchMessages::Force;
  /// What the structure calls the unknowns and points of a patch that this rank has cut, and the forces there.
  struct Mine {
    std::vector<GlobalOrdinal> unknowns;
    std::vector<PointId> points, border;
    std::vector<int> owner_of_unknown, owner_of_point, owner_of_border;
    PatchParts parts;
  };

  void measure(const TpetraVector& x);
  double share_of(const std::vector<BlockId>&) const;
  void find_patches();
  void choose_owners();
  std::vector<BlockId> parted_blocks() const;
  int patch_of_block(BlockId) const;
  std::vector<int> patch_of_clusters() const;
  std::vector<Unknown> unknowns(const TpetraVector& x, const TpetraVector& start) const;
  std::vector<Entry> entries() const;
  struct PointsAndShares {
    std::vector<Point> points;
    std::vector<Share> shares;
  };
  PointsAndShares points(const PointField& lambda, const std::vector<PointStiffness>& resistance) const;
  std::vector<int> patches_of(int point) const;
  PointOfPatch of_patch(int point, const PointLaw&, const PointField& lambda, const PointStiffness&) const;
  void take_unknowns(const TpetraVector& x, const TpetraVector& start);
  void take_stiffness();
  void take_points(const PointField& lambda, const std::vector<PointStiffness>& resistance);
  void move_unknowns(const std::vector<SolvedPatch>&, TpetraVector& x);
  void change_forces(const std::vector<SolvedPatch>&, PointField& lambda);
  int number_in(int patch, GlobalOrdinal unknown) const;

  Parts parts_;
  int dim_;
  Teuchos::RCP<TpetraVector> linear_;  ///< K x - f
  PointField gap_;
  std::vector<BlockId> stuck_;  ///< that this rank knows of, ascending
  std::vector<BlockId> block_;  ///< of patches, ascending, the same on every rank
  std::vector<int> patch_;      ///< of each of them
  std::vector<int> owner_of_patch_;
  std::vector<int> cluster_patch_;  ///< per local cluster, -1 outside
  std::map<int, Mine> mine_;        ///< the patches of this rank
  /// Of unknowns of those: the patch, and the number there.
  std::unordered_map<GlobalOrdinal, std::pair<int, int>> place_;
  bool measured_ = false;  ///< linear_ and gap_ are those of where the structure is
  bool together_ = true;
};

}  // namespace voussoir
