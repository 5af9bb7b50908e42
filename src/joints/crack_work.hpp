// What a point that loses its strength takes along the way of a step, and what it would give back.
//
// Pure functions of the law, of the damage before and after, and of the way between (joints/softening.hpp has the law).
// The way is straight in opening and slip. Where the damage at its end is that of a larger opening than the one it ends
// at, it goes there last and comes back in proportion, as an open point does.
//
//   work of the pull       integral of (1 - D) T dg on the envelope, (1 - D) T g / g_most within the largest opening
//   work of the cohesion   integral of max(0, (1 - D) C - mu pull) ds: what a point pulls takes from its cohesion
//   fracture               both less what the point would give back afterwards that it did not before: never negative
//
// Of an opening within what stones stretch by, which leaves no damage, all is given back.
#pragma once

#include "joints/softening.hpp"

namespace voussoir {

/// Where a point stands in one mode and the other.
struct CrackEnd {
  JointWear wear;
  double gap = 0;     ///< [m] of the stones, less what their mortar gives way
  double normal = 0;  ///< [N] normal force
};

struct CrackWork {
  double pull = 0, cohesion = 0;   ///< [J] work of the two along the way
  double fracture = 0;             ///< [J] of it, lost
  double peak_pull = 0;            ///< [N] largest on a way on which the point cracks open, else 0
  double opened = 0, slipped = 0;  ///< [m] ways on which it does
};

/// Energy that an open point would give back if it closed [J].
double held_energy(const PointLaw& whole, const Softening&, const JointWear&, double gap);

/// @param whole  law without damage
CrackWork crack_work(const PointLaw& whole, const Softening&, const CrackEnd& from, const CrackEnd& to);

}  // namespace voussoir
