// Forces that creep round a vertex, from one contact point to another.
//
// Where a stone slides on two that stick to each other and whose beds are not one plane it cannot lie on both: one of
// the points at the vertex is to open. What each linear solve moves of its force to the others is its resistance times
// a gap that may be 1e-16 m, the next solve moves as much again, and no node feels it: forces that go round are in
// balance by themselves. So such a change is repeated at once, as often as it takes the first point beyond its bound.
#pragma once

#include <vector>

#include "nonlinear/nonlinear_problem.hpp"
#include "nonlinear/point_update.hpp"

namespace voussoir {

/// What points did in the last linear solve, and are to do in the next.
struct Creep {
  const std::vector<char>& closed;  ///< per point
  const PointField& sliding;        ///< direction of friction, [points x tangential components]; 0 where a point sticks
  const PointField& change_before;  ///< [N] of the forces by the solve before; empty where there was none
  const PointField& change;         ///< [N] likewise by that solve
};

/// Moves the forces. False where their change is not that of the solve before, or not in balance by itself, so that
/// nodes answer to it, or where it takes no point to a bound. Collective.
/// @param alike  share of a change by which the next may differ and be out of balance; points that change by less have
///               no part in it
bool go_to_the_bound(NonlinearProblem&, const CurrentLaws&, const Creep&, double alike, PointField& lambda);

}  // namespace voussoir
