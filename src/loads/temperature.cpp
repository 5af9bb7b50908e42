// Forces that would hold stones at their free strain are K times the displacement of that strain: K knows every kind of
// cell, and is exact for uniform strain.
//
// Theory  B. A. Boley, J. H. Weiner, Theory of Thermal Stresses, 1960, chapters 1 and 3.
#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "loads/common_keys.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {
namespace {

/// Thermal forces, and the strain that stresses do not see.
template <int dim>
class Temperature final : public PatternLoad<dim> {
 public:
  Temperature(const std::vector<double>& unit_force, std::vector<double> strain)
      : PatternLoad<dim>(unit_force), strain_(std::move(strain)) {}

  void add_free_strain(double factor, std::vector<double>& strain) const override {
    for (std::size_t b = 0; b < strain_.size(); ++b) strain[b] += factor * strain_[b];
  }
  bool strains() const override { return true; }
  void add_turning(const std::vector<LoadMoment>& moments, std::vector<double>& force) const override {
    this->pattern().add(sum_of_factors(moments), force);
  }
  bool has_turning() const override { return true; }
  std::size_t bytes() const override {
    return PatternLoad<dim>::bytes() + sizeof(strain_) + strain_.capacity() * sizeof(double);
  }

 private:
  std::vector<double> strain_;  ///< [-] per local block
};

}  // namespace

void TemperatureParameters::declare(ParameterSection& section) {
  declare_block_set(section, blocks);
  section.add("change", change, "K", any_number().usually(0.01, 500),
              "how much warmer than when the structure was free of stress");
  section.add("expansion", expansion, "1/K", at_least(0.0).usually(1e-7, 1e-4), "coefficient of thermal expansion",
              "stones expand", "Limestone has 8e-6, granite 7e-6, brick 6e-6.");
}

std::string TemperatureParameters::summary() const {
  return "temperature of " + in_quotes(blocks) + " changed by " + number_text(change) + " K, expansion " +
         number_text(expansion) + " 1/K";
}

bool TemperatureParameters::is_zero() const { return change == 0 || expansion == 0; }

template <int dim>
void add_thermal_force(const Structure<dim>& s, const std::vector<double>& strain, double factor,
                       std::vector<double>& force) {
  for (std::size_t n = 0; n < s.blocks().size(); ++n) {
    const auto& b = s.blocks()[n];
    if (strain[n] == 0) continue;
    std::vector<double> swollen;  // the free displacement, about the first node
    swollen.reserve(dim * b.mesh.position.size());
    for (const auto& x : b.mesh.position)
      for (int c = 0; c < dim; ++c) swollen.push_back(factor * strain[n] * (x[c] - b.mesh.position.front()[c]));
    const auto& k = *b.stiffness;
    for (std::size_t row = 0; row < swollen.size(); ++row)
      for (int entry = k.start[row]; entry < k.start[row + 1]; ++entry)
        force[dim * static_cast<std::size_t>(b.first_local) + row] += k.value[entry] * swollen[k.column[entry]];
  }
}

namespace {

/// Strain that a material takes without stress where it may go in all directions of the structure. In plane strain the
/// third one, which is held, pushes back through Poisson's ratio.
double free_strain(const TemperatureParameters& p, const Material& material, bool third_is_held) {
  return (third_is_held ? 1 + material.poisson_ratio : 1.0) * p.expansion * p.change;
}

template <int dim>
std::unique_ptr<Load<dim>> temperature(const TemperatureParameters& p, const LoadSite<dim>& site) {
  const auto& s = site.structure;
  std::vector<double> strain;
  for (const auto& b : s.blocks())
    strain.push_back(site.in_block_set(b.mesh, p.blocks)
                         ? free_strain(p, b.material, dim == 2 && s.model().plane == Plane::strain)
                         : 0.0);
  std::vector<double> unit(dim * static_cast<std::size_t>(s.nodes()), 0.0);
  add_thermal_force(s, strain, 1.0, unit);
  return std::make_unique<Temperature<dim>>(unit, std::move(strain));
}

}  // namespace

template void add_thermal_force<2>(const Structure<2>&, const std::vector<double>&, double, std::vector<double>&);

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const TemperatureParameters& p, const LoadSite<2>& site) {
  return temperature(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const TemperatureParameters& p, const LoadSite<3>& site) {
  return temperature(p, site);
}

}  // namespace voussoir
