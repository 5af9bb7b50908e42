// What a step that stands leaves open, be it a load step, a time step or an attempt at a load factor.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/energies.hpp"
#include "base/text.hpp"
#include "dynamics/energy_book.hpp"
#include "linalg/reduce.hpp"
#include "model/joint_strength.hpp"
#include "model/model_settings.hpp"
#include "model/step.hpp"
#include "step/step_parameters.hpp"
#include "ties/tie_balance.hpp"

namespace voussoir {

/// Whether cracks grew in a jump within a step.
inline bool jumped(const StepReport& report, const StepParameters& numbers) {
  return report.newton.lost_on_the_way >= numbers.jump;
}

/// What a structure that let go within a load step lost, where it is seen in the energies: one warning or none.
/// @param lost  [J] in the step
/// @param book  after it
/// @param when  stage and load factor
inline Warnings lost_in_jump(double lost, const Energies& book, const std::string& when) {
  constexpr double seen = 0.01;  // of the energy that went in: less is hidden by the size of steps
  const double in = std::max({0.0, book.external_work, book.elastic});  // no energy goes into stones that only turn
  if (!(lost > seen * in)) return {};
  return {
      {"lost_in_jump", "the structure", when, lost,
       "the structure let go faster than it was moved, as a bar that snaps: of the energy in it " + six_digits(lost) +
           " J, where " + six_digits(in) +
           " J went in, were taken by no joint and are lost in motion; where it came to rest is one place of several "
           "that it may come to"}};
}

/// @param left   larger residual of a step over the largest force, where that is round-off and more than the step was
///               to leave; time steps ask themselves for less than a scene does
/// @param asked  tolerance of the scene
inline Warnings round_off(double left, double asked, const std::string& when) {
  if (!(left > asked)) return {};
  return {{"round_off", "the structure", when, left,
           "forces are exact to " + six_digits(left) +
               " of the largest and not to the tolerance asked for: that is the round-off of stiffness times "
               "displacement, which neither more solves nor shorter steps make less; ask for a tolerance above it"}};
}

/// Forces where stones meet that no motion tells apart, and that could not be split in the one way that is told else.
/// @param apart   by how much the forces found differ from that split, relative to the largest
/// @param asked   tolerance of the scene: nearer ones are the same
/// @param stones  of the joint where they differ most
inline Warnings forces_undetermined(double apart, double asked, const std::array<int, 2>& stones,
                                    const std::string& when) {
  if (!(apart > asked)) return {};
  return {{"forces_undetermined", "joint " + std::to_string(stones[0]) + " - " + std::to_string(stones[1]), when, apart,
           "where three stones or more meet, forces can run round between them without moving any: those told here are "
           "one set of several that balance, and another, " +
               six_digits(apart) +
               " of the largest force apart from it, may be told by another number of ranks or another way of loading; "
               "how stones have moved and what supports bear does not hang on which, where they slip next may"}};
}

/// @param when  stage and load factor or time
inline Warnings warnings_of(const StepReport& report, const ModelSettings& settings, const std::string& when) {
  auto all = held_by_ties(report.tied_share, report.tied_block, when);
  const auto between = [](const std::array<int, 2>& stones) {
    return std::to_string(stones[0]) + " - " + std::to_string(stones[1]);
  };
  const auto say = [&](Warnings some) {
    for (auto& warning : some) all.push_back(std::move(warning));
  };
  if (report.newton.unstable > 0) say(unstable(report.newton.unstable, between(report.unstable_joint), when));
  if (report.newton.alike > 1) say(one_of_alike(report.newton.alike, between(report.alike_joint), when));
  say(forces_undetermined(report.newton.undetermined, settings.newton.tolerance, report.undetermined_joint, when));
  say(round_off(report.newton.round_off, settings.newton.tolerance, when));
  if (!jumped(report, settings.internals.step)) return all;
  say(lost_on_the_way(report.newton.lost_on_the_way, when));
  return all;
}

/// What is said of load steps that begin while a structure moves.
/// @param before   the first of them
/// @param removed  [J] after it
inline Warnings motion_dropped(bool moved, const EnergyBook& before, double removed, const std::string& when) {
  constexpr double stands = 1e-2;  // of the elastic energy: vibrates by a tenth of what loads do
  removed -= before.sums().removed;
  if (!moved || !(std::max(before.kinetic(), removed) > stands * std::max(0.0, before.elastic()))) return {};
  return {{"velocity_dropped", "the structure", when, removed,
           "load steps begin while the structure moves, and know no velocity: its kinetic energy of " +
               six_digits(before.kinetic()) +
               " J leaves it, and what it had stored beyond the equilibrium that it goes to, " + six_digits(removed) +
               " J in all, as removed_J of the energy book tells; let it come to rest in the stage before, or go on "
               "in time"}};
}

/// What may be why a step has no answer: with friction without bound a point may neither stick, which would take a
/// pull, nor open, which would have stones in each other. Collective.
inline std::string of_unbounded_friction(const Model& model) {
  bool mine = false;
  for (int k = 0; k < model.points().owned(); ++k) mine |= std::isinf(model.law()[k].friction);
  if (!any_of_ranks(*model.structure().comm(), mine)) return "";
  return "; a joint has friction without bound, with which equations of contact need not have a solution: give it a "
         "large finite friction coefficient";
}

}  // namespace voussoir
