// How far the imbalance drives a step.
//
// A stone that next to nothing holds has far to go in a linear solve, and soon meets a neighbour or comes to where its
// points turn round. There the forces of the law change, and what is out of balance works against the step. So along a
// step of displacements d, with the forces P(t) that the law admits at a share t of it,
//
//   w(t) = d . (f + B^T P(t) - K (x + t d))     [J]
//
// is followed to where it changes its sign. No system is solved for that. A step that is worked against from its start
// on, and ever more, heads for an equilibrium that stones are driven away from, as friction that grows with the way
// makes one: then they go the other way.
//
// Theory   H. Matthies, G. Strang, Int. J. Numer. Methods Eng. 14 (1979) 1613-1626 (line search by the work of what is
//          out of balance).
#pragma once

#include <functional>

namespace voussoir {

/// Share of a step, 1 where at its end no more than `left` of the work at its start is against it; below 0, to -1, the
/// other way.
/// @param work  w(t) [J]
double driven_share(const std::function<double(double)>& work, double left);

}  // namespace voussoir
