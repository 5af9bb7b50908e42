#include <algorithm>

#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "loads/common_keys.hpp"
#include "loads/facets.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {

void WaterPressureParameters::declare(ParameterSection& section) {
  declare_facet_set(section, on, blocks);
  declare_water(section, level, density, gravity);
}

std::string WaterPressureParameters::summary() const {
  return "water pressure of " + number_text(density) + " kg/m3 below the level " + number_text(level) + " m on " +
         in_quotes(on);
}

std::optional<FacetsOfLoad> WaterPressureParameters::facets() const {
  FacetsOfLoad facets{on, blocks};
  facets.reaches = [level = level](const Vector<3>& low, const Vector<3>&) { return low[2] < level; };
  return facets;
}

bool WaterPressureParameters::is_zero() const { return density == 0 || gravity == 0; }

template <int dim>
void add_water_pressure(const Structure<dim>& s, const WaterPressureParameters& load, const FacetSet& facets,
                        double factor, BlockForces& force) {
  constexpr int up = dim - 1;
  const double weight = factor * load.density * load.gravity;
  add_on_facets(
      s, facets, {below(up, load.level)},
      [&](const Vector<dim>& x, const Vector<dim>& outward) { return (-weight * (load.level - x[up])) * outward; },
      force);
}

namespace {

template <int dim>
std::unique_ptr<Load<dim>> water_pressure(const WaterPressureParameters& p, const LoadSite<dim>& site) {
  return pattern_of(site.structure, [&](auto& unit) {
    add_water_pressure(site.structure, p, site.facet_set(p.on, p.blocks), 1.0, unit);
  });
}

}  // namespace

template void add_water_pressure<2>(const Structure<2>&, const WaterPressureParameters&, const FacetSet&, double,
                                    BlockForces&);

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const WaterPressureParameters& p, const LoadSite<2>& site) {
  return water_pressure(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const WaterPressureParameters& p, const LoadSite<3>& site) {
  return water_pressure(p, site);
}

}  // namespace voussoir
