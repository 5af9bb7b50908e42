// Limit analysis of a model: its stones as rigid bodies, its contact points with their laws, its loads and supports.
//
// Stones stand where the model has them: as drawn, or with finite rotations where it has followed them to. One rank
// solves, all know the answer.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "model/plane/plane_model.hpp"
#include "run/limit_theorem.hpp"
#include "statics/limit_analysis.hpp"

namespace voussoir {

class RigidLimits {
 public:
  /// Collective.
  RigidLimits(const PlaneModel&, const RigidTask&);

  /// As those of LimitAnalysis; the same answers on every rank. Collective. Those of joints are by number of the point
  /// in the whole structure, those of stones by number of the block.
  LimitAnswer largest_factor(double largest) const;
  LimitAnswer bears(double factor) const;
  bool borne_at_any_factor() const;
  LimitAnswer most_balanced(double factor, double* free_share) const;
  bool is_rows() const;
  std::optional<double> without_dilatancy(double largest, const LimitAnswer& associated) const;
  std::vector<std::array<ReactionRange, 2>> reactions(int supports, double factor) const;

  /// The motion of an answer on local nodes [m], largest 1.
  std::vector<double> on_nodes(const LimitAnswer&) const;
  /// Forces on local points [N].
  PointField on_points(const LimitAnswer&) const;

 private:
  template <class Ask>
  LimitAnswer ask_first_rank(const Ask& ask) const;

  const PlaneModel& model_;
  std::vector<Vector<2>> middle_;                  ///< [m] of all blocks, from the middle of the structure
  std::vector<PointId> ids_;                       ///< of the points of the answers, ascending
  std::unique_ptr<const LimitAnalysis> analysis_;  ///< on the first rank
};

/// What they say, as a run asks.
class PlaneTheorem : public LimitTheorem {
 public:
  explicit PlaneTheorem(const PlaneModel& model) : model_(model) {}
  RigidVerdict bears(const RigidTask&) const override;
  RigidVerdict largest_factor(const RigidTask&, double largest, bool estimates) const override;

 private:
  const PlaneModel& model_;
};

}  // namespace voussoir
