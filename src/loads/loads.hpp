// Nodal forces and prescribed displacements of the loads of a scene; one source file per load.
#pragma once

#include <vector>

#include "blocks/structure.hpp"
#include "blocks/support_parameters.hpp"
#include "loads/load_parameters.hpp"

namespace voussoir {

/// Adds factor x density x volume x acceleration [m/s2] to the forces [N, dim x local node copies].
template <int dim>
void add_inertia_force(const Structure<dim>&, const Vector<dim>& acceleration, double factor,
                       std::vector<double>& force);

/// Weight, downwards.
template <int dim>
void add_self_weight(const Structure<dim>&, const SelfWeightParameters&, double factor, std::vector<double>& force);

/// Dead traction on a set of facets of the undeformed structure.
template <int dim>
void add_traction(const Structure<dim>&, const TractionParameters&, int facet_set, double factor,
                  std::vector<double>& force);

/// Moves the held components of a support.
/// @param displacement  prescribed values [m, dim x local node copies]
template <int dim>
void add_settlement(const Structure<dim>&, const SettlementParameters&, const SupportParameters&, int facet_set,
                    double factor, std::vector<double>& displacement);

}  // namespace voussoir
