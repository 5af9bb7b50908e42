// Limit analysis of a model: its stones as rigid bodies, its contact points with their laws, its loads and supports.
//
// Stones stand where the model has them: as drawn, or with finite rotations where it has followed them to. One rank
// solves, all know the answer.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "model/contact_state.hpp"
#include "model/plane/plane_model.hpp"
#include "nonlinear/nonlinear_problem.hpp"
#include "statics/limit_analysis.hpp"

namespace voussoir {

/// What is there of the model, and how it is loaded.
struct RigidTask {
  const std::vector<char>* absent = nullptr;  ///< per local block, of what is not there; none: all is there
  const ContactState* state = nullptr;        ///< whose joints have what is left of their strength; none: all are whole
  std::vector<double> fixed;                  ///< [N] nodal loads that stay
  std::vector<double> raised;                 ///< [N] nodal loads that a factor multiplies; may be empty
};

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

/// Nodal loads by which a pattern changes per unit of the load factor [N]. Collective.
std::vector<double> loads_of_pattern(const PlaneModel&, const std::map<std::string, double>& factors,
                                     const std::map<std::string, double>& pattern, double time);

}  // namespace voussoir
