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
  return "water pressure of " + number_text(density) + " kg/m3 below y = " + number_text(level) + " m on " +
         in_quotes(on);
}

std::optional<FacetsOfLoad> WaterPressureParameters::facets() const {
  FacetsOfLoad facets{on, blocks};
  facets.reaches = [level = level](const Vector<2>& a, const Vector<2>& b) { return std::min(a[1], b[1]) < level; };
  return facets;
}

bool WaterPressureParameters::is_zero() const { return density == 0 || gravity == 0; }

template <>
void add_water_pressure<2>(const Structure<2>& s, const WaterPressureParameters& load, const FacetSet& facets,
                           double factor, std::vector<double>& force) {
  for (const auto& e : edges_of_set(s, facets))
    add_along(
        e, part_between(e, 1, -1e30, load.level), s.model().thickness,
        [&](const Vector<2>& x) { return (-factor * load.density * load.gravity * (load.level - x[1])) * e.outward; },
        force);
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const WaterPressureParameters& p, const LoadSite<2>& site) {
  return pattern_of(site.structure, [&](auto& unit) {
    add_water_pressure(site.structure, p, site.facet_set(p.on, p.blocks), 1.0, unit);
  });
}

}  // namespace voussoir
