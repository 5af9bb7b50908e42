// Joints that have parted side by side within one step: which of them had to?
//
// The slopes of their laws tell whether cracks that soften compete (stability.hpp). Those of cracks that one step has
// taken beyond the part of the law that falls tell nothing any more: a bar in which two joints have parted is in
// equilibrium, without a force and without a slope, and so is the one in which a single joint has, which takes half
// the energy. So where at least two joints have come that far within the step they are cracked anew, one by one: each
// time the joint that has gone furthest, while all that have not cracked yet hold the strength of the start of the
// step, until none is overloaded. Of both states the one with the lower potential is taken,
//
//   potential = work of second order of the stones + sum over points of (energy that the law takes + mortar + friction)
//
// whose first part is, between two equilibria, the mean of the forces of points times the change of their gaps.
#pragma once

#include <vector>

#include "nonlinear/first_of_alike.hpp"
#include "nonlinear/iterate.hpp"
#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir {

/// How many joints have come, within the step, to where the slope of their law is less than half of what it was at its
/// start, and have taken more than the stones beside a point store at its strength: less is nothing to win, as where
/// cohesion goes with a joint that opens without a pull. Collective.
int parted_side_by_side(NonlinearProblem&, const Iterate& at);

/// Joints that are let crack, by their points on this rank; empty before the first.
using LetCrack = std::vector<char>;

/// Adds the joint that a state opens or slides furthest of those that lose strength there and are not among them, of
/// joints that are alike the one with the first point. Then joints among them are worn as the state wears them; others
/// keep the damage they have. Returns the one added, -1 where there was none. Collective.
/// @param strength  with which the state was found
FirstOfAlike wear_one_more(NonlinearProblem&, const Iterate& at, StrengthIs strength, LetCrack&);

/// What an equilibrium has beyond another, and how much of it joints have taken in both since the start of the step.
struct PotentialBeyond {
  double potential = 0;  ///< [J] less than 0 where the second is lower
  double taken = 0;      ///< [J] what the difference is measured by
};
/// Of two equilibria of one step, with the damage of each. Friction is held at the mean of its bounds. Collective.
PotentialBeyond potential_beyond(NonlinearProblem&, const Iterate& first, const Iterate& second);

}  // namespace voussoir
