// The state of points where points come and go: who stands where another stood goes on from its state, whoever is new
// begins open and without a past, and what is gone is forgotten. All lists of a state that go by points are named here.
#pragma once

#include "joints/point_places.hpp"
#include "model/contact_state.hpp"

namespace voussoir {

/// Calls f(name, list, values a point, largest) for every list that holds something of each point; largest is that of
/// words and counts, which begin at 0, and negative for other numbers.
template <class F>
void each_list_of_points(ContactState& state, int components, const F& f) {
  constexpr double any = -1, flag = 1, most_steps = 2e9;  // the last: what can be added to
  f("lambda", state.lambda, components, any);
  f("slip_origin", state.slip_origin, components, any);
  f("selected", state.selected, 1, flag);
  f("status", state.status, 1, static_cast<double>(PointStatus::bonded));
  f("opened", state.opened, 1, any);
  f("slipped", state.slipped, 1, any);
  f("initial_gap", state.initial_gap, 1, any);
  f("rest.place", state.rest.place, components, any);
  f("rest.steps", state.rest.steps, 1, most_steps);
  f("rest.needed", state.rest.needed, 1, most_steps);
  f("rest.bonded", state.rest.bonded, 1, flag);
}

/// Points without a past: they are selected and open, and have slipped no further than they have come.
/// @param begins  1 per point that does
void begin_points(const std::vector<char>& begins, const ContactPoints&, ContactState&);

/// The state of some points as one of others, which may reach other nodes. Slip goes on from where it was: what the
/// weights of a point change in its motion so far is none. The caller sets gaps of what is not drawn closed.
/// @param before  per point the number that it had, -1 for one that is new (same_places)
void carry_points(const ContactPoints& from, const ContactPoints& to, const std::vector<int>& before, ContactState&);

}  // namespace voussoir
