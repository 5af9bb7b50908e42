// The forces a contact point may carry, as a vertex and the generators of a cone; and what they can absorb of a motion.
//
// All forces n >= -tension, |t| <= cohesion + mu n are apex + sum of a_g x generator g with lower_g <= a_g <= upper_g.
// In the plane this is exact. In space Coulomb's cone is round: generators on it give a smaller set, those of a pyramid
// around it a larger one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/check.hpp"
#include "base/tensor.hpp"
#include "joints/contact_law.hpp"
#include "statics/limit_analysis_parameters.hpp"
#include "statics/rigid_structure.hpp"
#include "statics/round_cone_parameters.hpp"

namespace voussoir {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Which pyramid stands for a round cone; the plane has none.
enum class Pyramid {
  around,  ///< bears all that the cone does, and a little more
  within   ///< bears nothing that the cone does not
};

template <int dim>
struct Generator {
  Vector<dim> direction{};  ///< normal, tangential; of size 1
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
  double from = 0, to = 0;  ///< [rad] of an edge of a pyramid: directions in which the faces beside it touch the cone
};

template <int dim>
struct AdmissibleForces {
  Vector<dim> apex{};  ///< [N] normal, tangential
  std::vector<Generator<dim>> generators;
};

/// An edge of a pyramid around a cone of a slope, between two of its faces.
inline Generator<3> edge_between(double slope, double from, double to) {
  const double angle = (from + to) / 2, radius = slope / std::cos((to - from) / 2), size = std::hypot(1, radius);
  return {{1 / size, radius * std::cos(angle) / size, radius * std::sin(angle) / size},
          0,
          std::numeric_limits<double>::infinity(),
          from,
          to};
}

/// A line on a cone of a slope.
inline Generator<3> line_on_cone(double slope, double angle) {
  const double size = std::hypot(1, slope);
  return {{1 / size, slope * std::cos(angle) / size, slope * std::sin(angle) / size}};
}

inline void add_cone(double slope, Pyramid, std::vector<Generator<2>>& generators) {
  const double size = std::hypot(1, slope);
  for (const double sign : {1.0, -1.0}) generators.push_back({{1 / size, sign * slope / size}});
}
inline void add_cone(double slope, Pyramid pyramid, std::vector<Generator<3>>& generators) {
  const double side = RoundConeParameters::side;
  for (int k = 0; k < RoundConeParameters::sides; ++k)
    generators.push_back(pyramid == Pyramid::around ? edge_between(slope, k * side, (k + 1) * side)
                                                    : line_on_cone(slope, k * side));
}

/// Shear of any direction up to a size. In space a polygon stands for the disc, as the sum of lines.
inline void add_shear(double shear, Pyramid, std::vector<Generator<2>>& generators) {
  generators.push_back({{0, 1}, -shear, shear});
}
inline void add_shear(double shear, Pyramid pyramid, std::vector<Generator<3>>& generators) {
  if (!std::isfinite(shear)) {
    generators.push_back({{0, 1, 0}, -shear, shear});
    generators.push_back({{0, 0, 1}, -shear, shear});
    return;
  }
  const double side = RoundConeParameters::side;
  const double half = shear * (pyramid == Pyramid::around ? std::tan(side / 2) : std::sin(side / 2));
  for (int k = 0; k < RoundConeParameters::sides / 2; ++k)
    generators.push_back({{0, std::cos(k * side), std::sin(k * side)}, -half, half});
}

/// Whether a law has a cone of a slope that generators can tell.
inline bool has_cone(const PointLaw& law) {
  return law.friction > 0 && law.friction < LimitAnalysisParameters::endless_friction && std::isfinite(law.cohesion);
}

/// The least normal force: tension, or the vertex of the cone. [N]
inline double least_normal_force(const PointLaw& law) {
  return has_cone(law) ? std::max(-law.tension, -law.cohesion / law.friction) : -law.tension;
}

template <int dim>
AdmissibleForces<dim> admissible_forces(const PointLaw& law, Pyramid pyramid = Pyramid::around) {
  VOUSSOIR_EXPECT(law.friction >= 0 && law.cohesion >= 0 && law.tension >= 0 && "a law bounds forces from both sides");
  const double least = least_normal_force(law);
  AdmissibleForces<dim> set;
  const bool pulls_freely = !std::isfinite(least);
  set.apex[0] = pulls_freely ? 0 : least;
  if (!has_cone(law)) {
    Generator<dim> normal;
    normal.direction[0] = 1;
    if (pulls_freely) normal.lower = -endless;
    set.generators.push_back(normal);
    const double shear = law.friction > 0 ? endless : law.cohesion;
    if (shear > 0) add_shear(shear, pyramid, set.generators);
    return set;
  }
  add_cone(law.friction, pyramid, set.generators);
  const double shear = law.cohesion + law.friction * least;
  if (shear > 0) add_shear(shear, pyramid, set.generators);
  return set;
}

/// What admissible forces absorb at most of a motion, and how far that motion is from being one they cannot help.
struct Absorbed {
  double power = 0;    ///< [W] at most, along the nearest motion that is compatible
  double against = 0;  ///< [m/s] by which the motion presses into the point: friction cone and opening
};

/// @param motion  opening and slip of the point [m/s]
template <int dim>
Absorbed absorbed_at_most(const AdmissibleForces<dim>& set, const Vector<dim>& motion) {
  Absorbed most;
  most.power = -dot(set.apex, motion);
  for (const auto& g : set.generators) {
    const double along = dot(g.direction, motion);  // a force along g does so much work on the stones
    const double amount = along > 0 ? g.lower : g.upper;
    if (along == 0) continue;
    if (std::isfinite(amount))
      most.power -= amount * along;
    else
      most.against = std::max(most.against, std::abs(along));
  }
  return most;
}

/// The same of the law itself: in space by its round cone.
inline Absorbed absorbed_at_most(const PointLaw& law, const Vector<2>& motion) {
  return absorbed_at_most(admissible_forces<2>(law), motion);
}
inline Absorbed absorbed_at_most(const PointLaw& law, const Vector<3>& motion) {
  const double least = least_normal_force(law), slip = length(tangential(motion));
  Absorbed most;
  if (has_cone(law)) {
    most.power = (law.cohesion + law.friction * least) * slip - least * motion[0];
    most.against = std::max(0.0, (law.friction * slip - motion[0]) / std::hypot(1, law.friction));
    return most;
  }
  const bool pulls_freely = !std::isfinite(least), holds = law.friction > 0 || !std::isfinite(law.cohesion);
  most.against = std::max(pulls_freely ? std::abs(motion[0]) : -motion[0], holds ? slip : 0.0);
  most.against = std::max(0.0, most.against);
  most.power = (holds ? 0.0 : law.cohesion * slip) - (pulls_freely ? 0.0 : least * motion[0]);
  return most;
}

}  // namespace voussoir
