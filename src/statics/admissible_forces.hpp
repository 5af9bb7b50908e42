// The forces a contact point may carry, as a vertex and the generators of a cone; and what they can absorb of a motion.
//
// All forces n >= -tension, |t| <= cohesion + mu n are apex + sum of a_g x generator g with lower_g <= a_g <= upper_g.
// In the plane this is exact. In three dimensions generators on Coulomb's round cone give a smaller set, generators of
// a pyramid around it a larger one.
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

namespace voussoir {

struct Generator {
  Vector<2> direction{};  ///< normal, tangential; of size 1
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
};

struct AdmissibleForces {
  Vector<2> apex{};  ///< [N] normal, tangential
  std::vector<Generator> generators;
};

inline AdmissibleForces admissible_forces(const PointLaw& law) {
  VOUSSOIR_EXPECT(law.friction >= 0 && law.cohesion >= 0 && law.tension >= 0 && "a law bounds forces from both sides");
  constexpr double endless = std::numeric_limits<double>::infinity();
  const bool cone =
      law.friction > 0 && law.friction < LimitAnalysisParameters::endless_friction && std::isfinite(law.cohesion);
  const double least = cone ? std::max(-law.tension, -law.cohesion / law.friction) : -law.tension;
  AdmissibleForces set;
  const bool pulls_freely = !std::isfinite(least);
  set.apex[0] = pulls_freely ? 0 : least;
  if (!cone) {
    set.generators.push_back({{1, 0}, pulls_freely ? -endless : 0, endless});
    const double shear = law.friction > 0 ? endless : law.cohesion;
    if (shear > 0) set.generators.push_back({{0, 1}, -shear, shear});
    return set;
  }
  const double size = std::hypot(1, law.friction);
  for (const double sign : {1.0, -1.0}) set.generators.push_back({{1 / size, sign * law.friction / size}, 0, endless});
  const double shear = law.cohesion + law.friction * least;
  if (shear > 0) set.generators.push_back({{0, 1}, -shear, shear});
  return set;
}

/// What admissible forces absorb at most of a motion, and how far that motion is from being one they cannot help.
struct Absorbed {
  double power = 0;    ///< [W] at most, along the nearest motion that is compatible
  double against = 0;  ///< [m/s] by which the motion presses into the point: friction cone and opening
};

/// @param motion  opening and slip of the point [m/s]
inline Absorbed absorbed_at_most(const AdmissibleForces& set, const Vector<2>& motion) {
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

}  // namespace voussoir
