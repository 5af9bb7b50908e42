// What joints have left of their strength in a state, and what a step takes of it (joints/softening.hpp).
#pragma once

#include "base/warning.hpp"
#include "dynamics/energy_book.hpp"
#include "joints/crack_work.hpp"
#include "joints/softening.hpp"
#include "model/contact_state.hpp"
#include "model/model.hpp"

namespace voussoir {

/// Share of its strength that a point has lost, 0 for one without.
inline double damage_of(const Model& model, const ContactState& state, int k) {
  if (model.softening().empty()) return 0;
  const auto& s = model.softening()[k];
  return s.damage(s.kappa(state.opened[k], state.slipped[k]));
}

/// Law of a point with the strength that is left.
inline PointLaw law_left(const Model& model, const ContactState& state, int k) {
  auto law = model.law()[k];
  const double damage = damage_of(model, state, k);
  law.cohesion = strength_left(law.cohesion, damage);
  law.tension = strength_left(law.tension, damage);
  return law;
}

/// Laws of all points likewise.
inline PointLaws laws_left(const Model& model, const ContactState& state) {
  auto laws = model.law();
  if (!model.softening().empty())
    for (int k = 0; k < model.points().size(); ++k) laws.set(k, law_left(model, state, k));
  return laws;
}

/// Law of a point as it bears now: one that has opened pulls no more than it does at its opening.
/// @param gap  [m] of the stones
inline PointLaw law_now(const Model& model, const ContactState& state, double gap, int k) {
  if (model.softening().empty()) return model.law()[k];
  return weaken(model.law()[k], model.softening()[k], {state.opened[k], state.slipped[k]}, gap, 0).law;
}

/// Wear of a time step, whose end is farther than the middle that was solved.
/// @param before  the state at its start
/// @param after   with the forces of the middle and the wear up to there
/// @param gap     [m] gaps of the stones at its end
/// @param slip    [m] slips in the step, [points x dim], normal component not looked at
void wear(const Model&, const ContactState& before, ContactState& after, const PointField& gap, const PointField& slip);

/// What friction and lost strength take at one point in a time step [J]. A point that pulls takes its force times the
/// way it opens; what it would give back is no loss.
/// @param mid      the middle of the step, with the wear of its end
/// @param opening  [m] half the gap at the start, 0 where the point was closed
/// @param gap      [m] gaps of the middle as a time step has them, half of those at the end
EnergyOfStep loss_in_time(const Model&, const ContactState& before, const ContactState& mid, int k, double opening,
                          const PointField& gap);

/// Energy that a point would give back if it closed [J].
/// @param gap  [m] of the stones
inline double held_by_joint(const Model& model, const ContactState& state, double gap, int k) {
  if (model.softening().empty() || !model.bears(k)) return 0;
  return held_energy(model.law()[k], model.softening()[k], {state.opened[k], state.slipped[k]}, gap);
}

/// Energy that open joints would give back [J], of this rank's points.
double held_by_joints(const Model&, const ContactState&);

/// What is said of joints that lost more strength on the way to an equilibrium than it asks of them: one warning or
/// none.
/// @param damage  [-] beyond that of the state, at the point where it is most
Warnings lost_on_the_way(double damage, const std::string& when);
/// What is said of an equilibrium that gives way on its own, since joints soften faster than stones follow.
/// @param excess  [-] of softening over stiffness, relative to their sum
/// @param stones  names of those at the joint that softens fastest there
Warnings unstable(double excess, const std::string& stones, const std::string& when);
/// What is said of a joint that was let crack of several that were alike.
/// @param joints  how many there were
/// @param stones  names of those at the one
Warnings one_of_alike(int joints, const std::string& stones, const std::string& when);
/// What is said of a load step that nothing in statics leads through: the structure was let go in time.
/// @param seconds  until it came to rest
Warnings passed_in_time(double seconds, const std::string& when);

}  // namespace voussoir
