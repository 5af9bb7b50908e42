// Limit analysis of a model: its stones as rigid bodies, its contact points with their laws, its loads and supports.
//
// Stones stand where the model has them: as drawn, or with finite rotations where it has followed them to. One rank
// solves, all know the answer.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "model/model_of_blocks.hpp"
#include "run/limit_theorem.hpp"
#include "statics/limit_analysis.hpp"

namespace voussoir {

template <int dim>
class RigidLimits {
 public:
  /// Collective.
  RigidLimits(const ModelOfBlocks<dim>&, const RigidTask&);

  /// As those of LimitAnalysis; the same answers on every rank. Collective. Those of joints are by number of the point
  /// in the whole structure, those of stones by number of the block.
  LimitAnswer<dim> largest_factor(double largest) const;
  LimitAnswer<dim> largest_borne(double largest) const;
  LimitAnswer<dim> bears(double factor) const;
  LimitAnswer<dim> refuses(double factor) const;
  bool borne_at_any_factor() const;
  LimitAnswer<dim> most_balanced(double factor, double* free_share) const;
  LimitAnswer<dim> least_pressed(double factor) const;
  bool is_rows() const;
  std::optional<double> without_dilatancy(double largest, const LimitAnswer<dim>& associated) const;
  std::vector<std::array<ReactionRange, dim>> reactions(int supports, double factor) const;

  /// The motion of an answer on local nodes [m], largest 1.
  std::vector<double> on_nodes(const LimitAnswer<dim>&) const;
  /// Forces on local points [N].
  PointField on_points(const LimitAnswer<dim>&) const;

 private:
  template <class Ask>
  LimitAnswer<dim> ask_first_rank(const Ask& ask) const;
  template <class Ask>
  bool first_rank_says(const Ask& ask) const;

  const ModelOfBlocks<dim>& model_;
  std::vector<Vector<dim>> middle_;                     ///< [m] of all blocks, from the middle of the structure
  std::vector<PointId> ids_;                            ///< of the points of the answers, ascending
  std::unique_ptr<const LimitAnalysis<dim>> analysis_;  ///< on the first rank
};

/// What they say, as a run asks.
template <int dim>
class RigidTheorem : public LimitTheorem {
 public:
  explicit RigidTheorem(const ModelOfBlocks<dim>& model) : model_(model) {}
  RigidVerdict refuses(const RigidTask&) const override;
  RigidVerdict largest_factor(const RigidTask&, double largest, bool estimates) const override;

 private:
  const ModelOfBlocks<dim>& model_;
};

}  // namespace voussoir
