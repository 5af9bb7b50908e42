// Limit analysis of a model: its stones as rigid bodies, its contact points with their laws, its loads and supports.
//
// Stones stand where the model has them: as drawn, or with finite rotations where it has followed them to. The first
// rank has all of them and solves, since the library of linear programmes works on one; the others are told the answer,
// and of stones and points what they have of them.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "linalg/parcels.hpp"
#include "model/model_of_blocks.hpp"
#include "run/limit_theorem.hpp"
#include "statics/limit_analysis.hpp"

namespace voussoir {

template <int dim>
class RigidLimits {
 public:
  /// Collective.
  RigidLimits(const ModelOfBlocks<dim>&, const RigidTask&);

  /// As those of LimitAnalysis; the same on every rank, but for motions and forces, which the first has. Collective.
  LimitAnswer<dim> largest_factor(double largest, const LimitAnswer<dim>& borne = {}) const;
  /// With the least forces that balance a hair less.
  /// @param begin  where the programme begins: that of another answer, if it had one
  LimitAnswer<dim> largest_borne(double largest, const LimitAnswer<dim>& begin) const;
  LimitAnswer<dim> bears(double factor) const;
  LimitAnswer<dim> refuses(double factor) const;
  bool borne_at_any_factor() const;
  LimitAnswer<dim> most_balanced(double factor, double* free_share, const LimitAnswer<dim>& borne) const;
  LimitAnswer<dim> least_pressed(double factor) const;
  bool is_rows() const;
  std::optional<double> without_dilatancy(double largest, const LimitAnswer<dim>& associated) const;
  std::vector<std::array<ReactionRange, dim>> reactions(int supports, double factor,
                                                        const LimitAnswer<dim>& borne) const;

  /// The motion of an answer on local nodes [m], largest 1; zero without a motion. Collective.
  std::vector<double> on_nodes(const LimitAnswer<dim>&) const;
  /// Forces on local points [N]. Collective.
  PointField on_points(const LimitAnswer<dim>&) const;

 private:
  template <class Ask>
  LimitAnswer<dim> ask_first_rank(const Ask& ask) const;
  template <class Ask>
  bool first_rank_says(const Ask& ask) const;

  const ModelOfBlocks<dim>& model_;
  std::vector<Vector<dim>> middle_;  ///< [m] of local blocks, from the middle of the structure
  // On the first rank.
  std::vector<Parcel<BlockId>> blocks_of_rank_;  ///< that a rank has, in its order
  std::vector<Parcel<PointId>> points_of_rank_;
  std::vector<PointId> ids_;  ///< of the points of the answers, ascending
  std::unique_ptr<const LimitAnalysis<dim>> analysis_;
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
