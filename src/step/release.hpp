// Which tied points of a state become contact points, and with which forces they begin.
#pragma once

#include "model/contact_problem.hpp"
#include "model/model.hpp"

namespace voussoir {

/// Selects the points whose predicted decrease `eta` [J, per owned point] holds the share the scene asks for, with
/// their joints where it says so; their forces become admissible. Collective.
/// @param cluster  per local node copy; a point is tied when its nodes have the same cluster
/// @return how many were newly selected
long long release(const Model&, const PointLaws&, const std::vector<int>& cluster, const std::vector<double>& eta,
                  ContactState&);

/// Selects every point, with admissible forces; false when all were selected already. Collective.
bool release_all(const Model&, const PointLaws&, ContactState&);

/// Selects every point with mortar, for which no bond can stand, with admissible forces; false when there was none to
/// select. Collective where joints have mortar.
bool release_mortar(const Model&, const PointLaws&, ContactState&);

/// Selects all points of the blocks marked [per local block], with admissible forces; returns how many were newly
/// selected. Collective.
long long release_blocks(const Model&, const PointLaws&, const std::vector<char>& marked, ContactState&);

/// Selected points of all ranks. Collective.
long long count_selected(const Model&, const ContactState&);

}  // namespace voussoir
