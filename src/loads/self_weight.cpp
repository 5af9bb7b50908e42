#include "blocks/assembly.hpp"
#include "loads/loads.hpp"

namespace voussoir {

template <int dim>
void add_inertia_force(const Structure<dim>& s, const Vector<dim>& acceleration, double factor,
                       std::vector<double>& force) {
  for (const auto& b : s.blocks()) {
    const auto volume = nodal_volumes(b.mesh, s.model().thickness);
    for (std::size_t i = 0; i < volume.size(); ++i)
      for (int c = 0; c < dim; ++c)
        force[dim * (b.first_local + i) + c] += factor * b.material.density * volume[i] * acceleration[c];
  }
}

template <int dim>
void add_self_weight(const Structure<dim>& s, const SelfWeightParameters& weight, double factor,
                     std::vector<double>& force) {
  Vector<dim> down{};
  down[1] = -weight.gravity;
  add_inertia_force(s, down, factor, force);
}

template void add_inertia_force<2>(const Structure<2>&, const Vector<2>&, double, std::vector<double>&);
template void add_self_weight<2>(const Structure<2>&, const SelfWeightParameters&, double, std::vector<double>&);

}  // namespace voussoir
