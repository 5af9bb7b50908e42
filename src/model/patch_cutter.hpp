// Cuts stuck stones out of a structure, as patches for src/nonlinear/stuck_stones.
//
// Blocks that are out of balance, or have a point that violates its law, by more than a threshold are cut out together
// with their neighbours; those that meet make a patch. Patches are shared among ranks by their numbers, and all ranks
// get what came out. Which blocks those are does not depend on ranks.
#pragma once

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
  double group(bool all_that_parted) override;
  std::vector<CutPatch> cut(const TpetraVector& x, const PointField& lambda, const PatchRequest&) override;
  void put_back(const std::vector<SolvedPatch>& mine, TpetraVector& x, PointField& lambda) override;
  bool keep_stuck(const std::vector<int>& numbers) override;

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
    PatchParts parts;
  };

  void measure(const TpetraVector& x);
  void find_patches(const std::vector<BlockId>& stuck);
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
  Mine* mine(int patch);

  Parts parts_;
  int dim_;
  Teuchos::RCP<TpetraVector> linear_;  ///< K x - f
  PointField gap_;
  std::vector<BlockId> stuck_;  ///< ascending, the same on every rank
  std::vector<BlockId> block_;  ///< of patches, ascending, the same on every rank
  std::vector<int> patch_;      ///< of each of them
  int patches_ = 0;
  std::vector<int> cluster_patch_;  ///< per local cluster, -1 outside
  std::vector<Mine> mine_;          ///< of the patches of this rank, in their order
  bool measured_ = false;           ///< linear_ and gap_ are those of where the structure is
  bool together_ = true;
};

}  // namespace voussoir
