// Stones that keep a structure from closing, brought to rest alone.
//
// Blocks that are out of balance, or have a point that violates its law, by more than a threshold are cut out together
// with their neighbours; those that meet make a patch. Each patch is solved by one rank, and all get what came out.
// One that leaves more to its surroundings than they should bear is left as it was and tried with more neighbours.
// Which blocks those are does not depend on ranks. Where little of a structure has parted, all of that is one patch.
#pragma once

#include "homogenisation/merged_space.hpp"
#include "nonlinear/method_parameters.hpp"
#include "nonlinear/nonlinear_problem.hpp"
#include "simulation/patch_messages.hpp"

namespace voussoir {

template <int dim>
class LocalCorrection {
 public:
  /// The problem that patches are cut from; must outlive the correction.
  struct Parts {
    const Structure<dim>& structure;
    const ContactPoints<dim>& points;
    const MergedSpace<dim>& space;
    const std::vector<double>& proximal_weight;
    NonlinearProblem& problem;
    bool& together;  ///< whether all that has parted may be one patch; false once that is too much or came to no rest
    const MethodParameters& methods;
  };
  explicit LocalCorrection(const Parts& parts) : parts_(parts) {}

  /// As NonlinearProblem::correct_locally.
  int apply(TpetraVector& x, PointField& lambda, const LocalRequest&);

 private:
  using Unknown = typename PatchMessages<dim>::Unknown;
  using Entry = typename PatchMessages<dim>::Entry;
  using Point = typename PatchMessages<dim>::Point;
  using Motion = typename PatchMessages<dim>::Motion;
  using Force = typename PatchMessages<dim>::Force;
  using Outcome = typename PatchMessages<dim>::Outcome;
  /// A patch that this rank solves: what it is made of, and as what the structure knows that.
  struct Mine {
    int patch = 0;
    PatchParts parts;
    std::vector<GlobalOrdinal> unknowns;
    std::vector<PointId> points, border;
  };
  /// What became of the patches of all ranks.
  struct Result {
    int solves;
    bool at_rest;                     ///< every patch that was solved came to rest
    std::vector<BlockId> too_narrow;  ///< blocks of patches that passed on too much
  };

  void find_blocks(const PointField& lambda, double threshold);
  std::vector<BlockId> parted_blocks() const;
  void find_patches();
  std::vector<BlockId> blocks_of(const std::vector<int>& patches) const;
  int patch_of_block(BlockId) const;
  std::vector<int> patch_of_clusters() const;
  bool larger_than(double share) const;
  std::vector<Unknown> unknowns(const TpetraVector& x, const TpetraVector& start) const;
  std::vector<Entry> entries() const;
  std::vector<Point> points(const PointField& lambda, const std::vector<PointStiffness>& resistance) const;
  std::vector<Mine> put_together(const LocalRequest&, const std::vector<Unknown>&, const std::vector<Entry>&,
                                 const std::vector<Point>&) const;
  void solve(Mine, double tolerance, double bearable, NewtonReport&, Outcome&) const;
  Result solve_patches(TpetraVector& x, PointField& lambda, const LocalRequest&, double bearable);
  void put_back(const std::vector<Motion>&, const std::vector<Force>&, TpetraVector& x, PointField& lambda) const;

  Parts parts_;
  Teuchos::RCP<TpetraVector> linear_;  ///< K x - f
  PointField gap_;
  std::vector<BlockId> stuck_;  ///< ascending, the same on every rank
  std::vector<BlockId> block_;  ///< of patches, ascending, the same on every rank
  std::vector<int> patch_;      ///< of each of them
  int patches_ = 0;
  std::vector<int> cluster_patch_;  ///< per local cluster, -1 outside
};

extern template class LocalCorrection<2>;

}  // namespace voussoir
