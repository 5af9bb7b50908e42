// Nodal forces and prescribed displacements of each type of load, as pure functions of a structure.
//
// All add factor times the load to the forces of nodes and of edges that bend, owned and halo.
#pragma once

#include <string>
#include <vector>

#include "blocks/block_forces.hpp"
#include "blocks/structure.hpp"
#include "blocks/support_parameters.hpp"
#include "loads/load_parameters.hpp"
#include "mesh/facet_set.hpp"

namespace voussoir {

/// Adds factor x density x volume x acceleration [m/s2].
template <int dim>
void add_inertia_force(const Structure<dim>&, const Vector<dim>& acceleration, double factor, BlockForces& force);

/// Weight, downwards.
template <int dim>
void add_self_weight(const Structure<dim>&, const SelfWeightParameters&, double factor, BlockForces& force);

/// Dead traction on a set of facets of the undeformed structure.
template <int dim>
void add_traction(const Structure<dim>&, const TractionParameters&, const FacetSet&, double factor, BlockForces& force);

/// A force at the node nearest to a point. Collective; throws InputError on every rank when it is too far.
/// @param among  1 for each local node that may bear it; empty for all
template <int dim>
void add_point_load(const Structure<dim>&, const PointLoadParameters&, double factor, const std::string& where,
                    BlockForces& force, const std::vector<char>& among = {});

/// The node nearest to a point, of equally near ones the one with the lowest number. Collective.
/// @param among  1 for each local node that counts; empty for all
struct NearestNode {
  double distance = 0;  ///< [m]
  int local = -1;       ///< on this rank, owned or halo
};
template <int dim>
NearestNode nearest_node(const Structure<dim>&, const Vector<dim>& point, const std::vector<char>& among = {});

/// Vertical force per horizontal area on a part of an edge.
template <int dim>
void add_crowd(const Structure<dim>&, const CrowdParameters&, const FacetSet&, double factor, BlockForces& force);

/// Horizontal pressure of soil.
template <int dim>
void add_earth_pressure(const Structure<dim>&, const EarthPressureParameters&, const FacetSet&, double factor,
                        BlockForces& force);

/// Pressure of water below its level.
template <int dim>
void add_water_pressure(const Structure<dim>&, const WaterPressureParameters&, const FacetSet&, double factor,
                        BlockForces& force);

/// Weight of the displaced water, upwards.
/// @param in_set  blocks that are lifted
template <int dim>
void add_buoyancy(const Structure<dim>&, const BuoyancyParameters&, const std::vector<char>& in_set, double factor,
                  BlockForces& force);

/// Forces that would give blocks their free thermal strain [-, per local block].
template <int dim>
void add_thermal_force(const Structure<dim>&, const std::vector<double>& strain, double factor, BlockForces& force);

}  // namespace voussoir
