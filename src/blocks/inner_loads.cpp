#include "blocks/inner_loads.hpp"

#include <numeric>

#include "blocks/assembly.hpp"
#include "blocks/block_forces.hpp"
#include "blocks/condensed_edges.hpp"

namespace voussoir {

template <int dim>
std::vector<double> free_displacement(const LocalBlock<dim>& block, double strain) {
  std::vector<double> u;
  u.reserve(dim * block.mesh.position.size());
  for (const auto& x : block.mesh.position)
    for (int c = 0; c < dim; ++c) u.push_back(strain * (x[c] - block.mesh.position.front()[c]));
  return u;
}

template <int dim>
std::vector<double> force_of_strain(const LocalBlock<dim>& block, double strain) {
  const auto u = free_displacement(block, strain);
  std::vector<double> force(u.size());
  block.stiffness->multiply(u.data(), force.data());
  return force;
}

namespace {

/// What is stored across the plane by a block that is held there, is warm and moves freely in it [J]. Its free strain
/// in the plane is 1 + nu times that of its material.
template <int dim>
double energy_across(const Structure<dim>& s, const LocalBlock<dim>& block, double strain) {
  if (dim == 3 || s.model().plane == Plane::stress) return 0;
  const auto volume = nodal_volumes(block.mesh, block.material, s.model());
  const double across = strain / (1 + block.material.poisson_ratio);
  return block.material.young_modulus * across * across * std::accumulate(volume.begin(), volume.end(), 0.0) / 2;
}

/// (u - e).K (u - e) / 2 less u.K u / 2, and what is stored across the plane [J].
template <int dim>
double energy_of_strain(const Structure<dim>& s, const LocalBlock<dim>& block, const std::vector<double>& deformation,
                        double strain) {
  const auto free = free_displacement(block, strain), force = force_of_strain(block, strain);
  const double* u = &deformation[dim * static_cast<std::size_t>(block.first_local)];
  double energy = energy_across(s, block, strain);
  for (std::size_t i = 0; i < free.size(); ++i) energy += force[i] * (free[i] / 2 - u[i]);
  return energy;
}

}  // namespace

template <int dim>
double inner_energy(const Structure<dim>& s, const std::vector<double>& deformation, const InnerLoads& inner,
                    const std::vector<char>& absent) {
  double energy = 0;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    if (!absent.empty() && absent[b]) continue;
    if (!inner.free_strain.empty() && inner.free_strain[b] != 0)
      energy += energy_of_strain(s, block, deformation, inner.free_strain[b]);
    if (block.edges && !inner.edge_force.empty())
      energy += block.edges->energy(forces_of_edges(s, b, inner.edge_force));
  }
  return energy;
}

template std::vector<double> free_displacement(const LocalBlock<2>&, double);
template std::vector<double> free_displacement(const LocalBlock<3>&, double);
template std::vector<double> force_of_strain(const LocalBlock<2>&, double);
template std::vector<double> force_of_strain(const LocalBlock<3>&, double);
template double inner_energy(const Structure<2>&, const std::vector<double>&, const InnerLoads&,
                             const std::vector<char>&);
template double inner_energy(const Structure<3>&, const std::vector<double>&, const InnerLoads&,
                             const std::vector<char>&);

}  // namespace voussoir
