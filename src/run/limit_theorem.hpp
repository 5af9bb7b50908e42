// What limit analysis says of a model whose stones are rigid: how it is asked, whatever knows the geometry of stones.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "model/contact_state.hpp"
#include "model/model.hpp"
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

/// Motion and forces are there where the verdict is refused or limited.
struct RigidVerdict {
  LimitVerdict verdict = LimitVerdict::unknown;
  double factor = 0;              ///< [-] as of LimitAnswer
  std::vector<double> mechanism;  ///< on local nodes, largest 1
  bool dilates = false;           ///< what slides in it lifts (statics/coulomb_motion.hpp)
  PointField lambda;              ///< [N] forces on local points that balance as much of the loads as can be
  double without_dilatancy = std::numeric_limits<double>::infinity();  ///< [-] an estimate, where it was asked for
};

class LimitTheorem {
 public:
  virtual ~LimitTheorem() = default;
  /// Whether it is proven that no admissible forces balance the loads that stay: refused, else unknown. Collective.
  virtual RigidVerdict refuses(const RigidTask&) const = 0;
  /// Up to which factor they do. Collective.
  /// @param estimates  whether the factor of slip that does not dilate is estimated too
  virtual RigidVerdict largest_factor(const RigidTask&, double largest, bool estimates) const = 0;
};

/// Nodal loads by which a pattern changes per unit of the load factor [N]. Collective.
std::vector<double> loads_of_pattern(const Model&, const std::map<std::string, double>& factors,
                                     const std::map<std::string, double>& pattern, double time);

}  // namespace voussoir
