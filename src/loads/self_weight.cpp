// Weight and inertia: the acceleration times what each node weighs.
#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "blocks/assembly.hpp"
#include "blocks/condensed_edges.hpp"
#include "loads/common_keys.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {

void SelfWeightParameters::declare(ParameterSection& section) { declare_gravity(section, gravity); }

std::string SelfWeightParameters::summary() const { return "self weight, gravity " + number_text(gravity) + " m/s2"; }
bool SelfWeightParameters::is_zero() const { return gravity == 0; }

void AccelerationParameters::declare(ParameterSection& section) {
  section.add("ax", ax, "m/s2", any_number().usually(1e-4, 1000), "acceleration to the right; 0.15 g = 1.4715");
  section.add("ay", ay, "m/s2", any_number().usually(1e-4, 1000), "acceleration upwards; in space along y");
  section.add("az", az, "m/s2", any_number().usually(1e-4, 1000), "acceleration upwards in space");
}

std::string AccelerationParameters::summary() const {
  return "acceleration (" + number_text(ax) + ", " + number_text(ay) + (az == 0 ? "" : ", " + number_text(az)) +
         ") m/s2";
}
bool AccelerationParameters::is_zero() const { return ax == 0 && ay == 0 && az == 0; }

std::vector<KeyOfSpace> AccelerationParameters::keys_of_space() const {
  std::vector<KeyOfSpace> keys;
  add_if_given(keys, "az", az, "m/s2");
  return keys;
}

template <int dim>
void add_inertia_force(const Structure<dim>& s, const Vector<dim>& acceleration, double factor, BlockForces& force) {
  for (const auto& b : s.blocks()) {
    const auto volume = nodal_volumes(b.mesh, b.material, s.model());
    for (std::size_t i = 0; i < volume.size(); ++i)
      for (int c = 0; c < dim; ++c)
        force.of_nodes[dim * (b.first_local + i) + c] += factor * b.material.density * volume[i] * acceleration[c];
    if (b.edges)
      b.edges->template add_body_force<dim>(factor * b.material.density * acceleration,
                                            &force.of_edges[dim * b.first_edge]);
  }
}

namespace {

template <int dim>
Vector<dim> down(double gravity) {
  Vector<dim> acceleration{};
  acceleration[dim - 1] = -gravity;
  return acceleration;
}

}  // namespace

template <int dim>
void add_self_weight(const Structure<dim>& s, const SelfWeightParameters& weight, double factor, BlockForces& force) {
  add_inertia_force(s, down<dim>(weight.gravity), factor, force);
}

namespace {

template <int dim>
std::unique_ptr<Load<dim>> inertia_force(const Vector<dim>& acceleration, const LoadSite<dim>& site) {
  return made_of<BodyForce<dim>>(site.structure,
                                 [&](auto& unit) { add_inertia_force(site.structure, acceleration, 1.0, unit); });
}

template <int dim>
std::unique_ptr<Load<dim>> weight(const SelfWeightParameters& p, const LoadSite<dim>& site) {
  return inertia_force(down<dim>(p.gravity), site);
}

}  // namespace

template void add_inertia_force<2>(const Structure<2>&, const Vector<2>&, double, BlockForces&);
template void add_inertia_force<3>(const Structure<3>&, const Vector<3>&, double, BlockForces&);
template void add_self_weight<2>(const Structure<2>&, const SelfWeightParameters&, double, BlockForces&);
template void add_self_weight<3>(const Structure<3>&, const SelfWeightParameters&, double, BlockForces&);

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const SelfWeightParameters& p, const LoadSite<2>& site) {
  return weight(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const SelfWeightParameters& p, const LoadSite<3>& site) {
  return weight(p, site);
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const AccelerationParameters& p, const LoadSite<2>& site) {
  return inertia_force<2>({p.ax, p.ay}, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const AccelerationParameters& p, const LoadSite<3>& site) {
  return inertia_force<3>({p.ax, p.ay, p.az}, site);
}

}  // namespace voussoir
