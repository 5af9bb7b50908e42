// What acts within blocks beside the displacements of their nodes: strain that they take freely, such as by heat, and
// forces on edges that bend. Stresses depend on both, and so does energy:
//
//   energy of a block = (u - e).K (u - e) / 2 + f_e.K_ee^-1 f_e / 2
//
// with the displacement e of the free strain. The sum u.K u / 2 of a solver is that of a block that is neither warm nor
// bent by forces on its edges; inner_energy is what is to be added to it.
#pragma once

#include <vector>

#include "blocks/structure.hpp"

namespace voussoir {

/// Lists are empty for none.
struct InnerLoads {
  std::vector<double> free_strain;  ///< [-, per local block] taken without stress in every direction
  std::vector<double> edge_force;   ///< [N, dim x local edges that bend]
};

/// Where a strain in every direction takes the nodes of a block freely, from its first one on [m].
template <int dim>
std::vector<double> free_displacement(const LocalBlock<dim>&, double strain);

/// Forces that would give a block its free strain: K times the free displacement [N]. K knows every kind of cell and
/// edges that bend, and is exact for uniform strain.
template <int dim>
std::vector<double> force_of_strain(const LocalBlock<dim>&, double strain);

/// Energy of the owned blocks beside u.K u / 2, those of this rank [J].
/// @param deformation  [m, dim x local node copies]
/// @param absent       1 for each local block that is not there; empty for none
template <int dim>
double inner_energy(const Structure<dim>&, const std::vector<double>& deformation, const InnerLoads&,
                    const std::vector<char>& absent);

}  // namespace voussoir
