// The motion of a mechanism under Coulomb's friction, in which what slides stays closed.
//
// The mechanism that proves a limit obeys the flow rule of limit analysis: where it slides it opens by friction times
// its slip. All forces in balance at the limit vanish where it opens by more, lie on their cone where it slides, and
// are anything where it rests. So a motion that may open where it opens by more, slides the same way but closed where
// it slides, and rests where it rests, does the same work on them: they allow it without dilatancy as well. In space
// it slides the same way as far as an edge of a pyramid can tell ways from each other.
#pragma once

#include <vector>

#include "statics/rigid_structure.hpp"

namespace voussoir {

template <int dim>
struct CoulombMotion {
  std::vector<Wrench<dim>> of_stones;
  bool dilates = false;  ///< there is none: stones that slide must lift, and the motion is the mechanism itself
};

/// Of all such motions the nearest to the mechanism along which the loads that drive it do as much work, or more where
/// such a motion would be much smaller than the mechanism.
/// @param mechanism  per stone, the largest motion 1 m
/// @param driving    per stone, loads that do work along it
template <int dim>
CoulombMotion<dim> coulomb_motion(const RigidStructure<dim>&, const std::vector<Wrench<dim>>& mechanism,
                                  const std::vector<Wrench<dim>>& driving);

}  // namespace voussoir
