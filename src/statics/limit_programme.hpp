// The linear programme behind limit analysis: which column is which force, and to how many digits it is believed.
#pragma once

#include <array>
#include <vector>

#include "statics/admissible_forces.hpp"
#include "statics/limit_analysis.hpp"

namespace voussoir {

/// Forces over a unit, moments over the unit times a radius too.
template <std::size_t n>
std::array<double, n> scaled(std::array<double, n> w, double radius, double unit) {
  const std::size_t forces = n == freedoms<2> ? 2 : 3;
  for (std::size_t c = 0; c < n; ++c) w[c] /= c < forces ? unit : radius * unit;
  return w;
}

template <int dim>
struct LimitAnalysis<dim>::Programme {
  /// What holds a stone in one direction; moments over the radius of the stone.
  struct Held {
    int stone;
    Wrench<dim> direction;
  };
  LinearProgramme lp;
  Pyramid pyramid = Pyramid::around;
  bool finer = true;                            ///< pyramids are made so
  double off_the_cone = 0;                      ///< up to what
  int most_for_finer = 0;                       ///< iterations that this may cost
  Lines added;                                  ///< where they are within cones
  std::vector<AdmissibleForces<dim>> forces;    ///< per kept contact
  std::vector<std::vector<int>> columns;        ///< of a kept contact, per generator
  std::vector<std::array<Vector<dim>, 2>> arm;  ///< of kept contacts, on both stones
  std::vector<Held> held;                       ///< per column from held_column on
  int held_column = 0, factor_column = 0;
  double most = endless;   ///< times the largest load, at which forces of joints end
  double share_moved = 0;  ///< [-] of a joint, that each of its corners gives to all of them alike

  /// Force of a kept contact [N]: normal, tangential.
  Vector<dim> force(std::size_t k, const std::vector<double>& x, double unit) const {
    auto f = forces[k].apex;
    for (std::size_t g = 0; g < forces[k].generators.size(); ++g)
      f = f + unit * x[static_cast<std::size_t>(columns[k][g])] * forces[k].generators[g].direction;
    return f;
  }
};

}  // namespace voussoir
