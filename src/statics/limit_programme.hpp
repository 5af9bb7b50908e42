// The linear programme behind limit analysis: which column is which force, and to how many digits it is believed.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "statics/admissible_forces.hpp"
#include "statics/limit_analysis.hpp"

namespace voussoir {

constexpr double endless = std::numeric_limits<double>::infinity();

inline bool dry(const PointLaw& law) { return law.cohesion == 0 && law.tension == 0; }

/// Forces over a unit, moments over the unit times a radius too.
inline Wrench scaled(const Wrench& w, double radius, double unit) {
  return {w[0] / unit, w[1] / unit, w[2] / (radius * unit)};
}

inline double power(const Wrench& load, const Wrench& motion) {
  return load[0] * motion[0] + load[1] * motion[1] + load[2] * motion[2];
}

struct LimitAnalysis::Programme {
  /// What holds a stone in one direction; moments over the radius of the stone.
  struct Held {
    int stone, support;
    Wrench direction;
  };
  LinearProgramme lp;
  std::vector<AdmissibleForces> forces;       ///< per kept contact
  std::vector<int> first_column;              ///< of a kept contact
  std::vector<std::array<Vector<2>, 2>> arm;  ///< of kept contacts, on both stones
  std::vector<Held> held;                     ///< per column from held_column on
  int held_column = 0, factor_column = 0;
  double move = 0;  ///< [-] share of a joint by which each of its pairs has moved from its end to the other

  /// Force of a kept contact [N]: normal, tangential.
  Vector<2> force(std::size_t k, const std::vector<double>& x, double unit) const {
    auto f = forces[k].apex;
    for (std::size_t g = 0; g < forces[k].generators.size(); ++g)
      f = f + unit * x[static_cast<std::size_t>(first_column[k]) + g] * forces[k].generators[g].direction;
    return f;
  }
};

}  // namespace voussoir
