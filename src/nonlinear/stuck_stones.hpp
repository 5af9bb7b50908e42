// Stones that keep a structure from closing, brought to rest alone (patches.md).
//
// A structure hands out patches as values: the stones that are stuck, with their neighbours. Each is solved here by the
// rank that was given it, and those who own its unknowns and points take back what came out. A patch that leaves more
// to its surroundings than they should bear is left as it was. Where little of a structure has parted, all of that is
// one patch.
#pragma once

#include <vector>

#include "linalg/types.hpp"
#include "nonlinear/method_parameters.hpp"
#include "nonlinear/patch_parts.hpp"
#include "nonlinear/point_field.hpp"

namespace voussoir {

/// How stuck stones are to be brought to rest.
struct PatchRequest {
  double threshold = 0;  ///< [N] blocks out of balance or against the law by more are brought to rest
  double tolerance = 0;  ///< relative to the largest force
  double scale = 0;      ///< [N] that force
  double most = 0;       ///< [N] patches that pass more on to their surroundings are left as they were
  const std::vector<PointStiffness>& resistance;  ///< of the last linear solve
  const TpetraVector& start;  ///< where stones of patches begin: before that solve, which they may have fled from
};

/// A patch as it is handed out.
struct CutPatch {
  int number = 0;  ///< among the patches of all ranks
  PatchParts parts;
};

/// A patch that has come to rest.
struct SolvedPatch {
  int number = 0;
  std::vector<double> displacement;        ///< [m] of its unknowns
  std::vector<PatchPoint> points, border;  ///< with their forces, in the order in which they were handed out
};

/// A structure from which patches can be cut. All functions are collective, and answer the same on all ranks.
class PatchSource {
 public:
  virtual ~PatchSource() = default;
  /// Blocks out of balance, or with a point against its law, by more than a threshold [N] are stuck. Are there any?
  virtual bool find_stuck(const TpetraVector& x, const PointField& lambda, double threshold) = 0;
  /// May all that has parted be one patch? That is no more tried once it was too much, or came to no rest.
  virtual bool parts_together() const = 0;
  virtual void part_no_more_together() = 0;
  /// Groups what is stuck with its neighbours, or else all that has parted. Returns whether that is no more than a
  /// share of all unknowns; else nothing is grouped.
  virtual bool group(bool all_that_parted, double most) = 0;
  /// The groups that this rank solves, cut out of the state (x, lambda).
  virtual std::vector<CutPatch> cut(const TpetraVector& x, const PointField& lambda, const PatchRequest&) = 0;
  /// Moves x and lambda by what came to rest.
  virtual void put_back(const std::vector<SolvedPatch>& mine, TpetraVector& x, PointField& lambda) = 0;
};

/// Brings stuck stones to rest, and moves x and lambda. Returns linear solves of patches over all ranks, 0 where
/// nothing is stuck or patches would be too large. Collective.
int bring_to_rest(PatchSource&, const Teuchos::Comm<int>&, TpetraVector& x, PointField& lambda, const PatchRequest&,
                  const MethodParameters&);

}  // namespace voussoir
