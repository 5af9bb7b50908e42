// Theory  B. A. Boley, J. H. Weiner, Theory of Thermal Stresses, 1960, chapters 1 and 3.
#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "blocks/assembly.hpp"
#include "blocks/element_matrices.hpp"
#include "loads/common_keys.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {
namespace {

/// Thermal forces, and the strain that stresses do not see.
class Temperature final : public PatternLoad<2> {
 public:
  Temperature(const std::vector<double>& unit_force, std::vector<double> strain)
      : PatternLoad<2>(unit_force), strain_(std::move(strain)) {}

  void add_free_strain(double factor, std::vector<double>& strain) const override {
    for (std::size_t b = 0; b < strain_.size(); ++b) strain[b] += factor * strain_[b];
  }
  bool strains() const override { return true; }
  std::size_t bytes() const override {
    return PatternLoad<2>::bytes() + sizeof(strain_) + strain_.capacity() * sizeof(double);
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

template <>
void add_thermal_force<2>(const Structure<2>& s, const std::vector<double>& strain, double factor,
                          std::vector<double>& force) {
  for (std::size_t n = 0; n < s.blocks().size(); ++n) {
    const auto& b = s.blocks()[n];
    if (strain[n] == 0) continue;
    const auto d = plane_elasticity(b.material, s.model().plane);
    const double stress = factor * strain[n] * (d[0][0] + d[0][1]) * s.model().thickness;  // [N/m] both ways
    for (const auto& cell : b.mesh.cells)
      for (const auto& q : shape_values(cell, cell_positions(b.mesh, cell)))
        for (int i = 0; i < cell.count; ++i)
          for (int c = 0; c < 2; ++c)
            force[2 * (b.first_local + cell.node[i]) + c] += q.weight * q.gradient[i][c] * stress;
  }
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const TemperatureParameters& p, const LoadSite<2>& site) {
  const auto& s = site.structure;
  std::vector<double> strain;
  for (const auto& b : s.blocks()) {
    // In plane strain the third direction, which is held, pushes back through Poisson's ratio.
    const double plane = s.model().plane == Plane::strain ? 1 + b.material.poisson_ratio : 1.0;
    strain.push_back(site.in_block_set(b.mesh, p.blocks) ? plane * p.expansion * p.change : 0.0);
  }
  std::vector<double> unit(2 * s.nodes(), 0.0);
  add_thermal_force(s, strain, 1.0, unit);
  return std::make_unique<Temperature>(unit, std::move(strain));
}

}  // namespace voussoir
