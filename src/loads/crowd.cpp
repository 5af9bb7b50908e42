#include <algorithm>

#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "loads/common_keys.hpp"
#include "loads/facets.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {

void CrowdParameters::declare(ParameterSection& section) {
  declare_facet_set(section, on, blocks);
  section.add("intensity", intensity, "Pa", any_number().usually(50, 1e6),
              "vertical force per horizontal area; a dense crowd has 5000");
  section.add("x from", x_from, "m", any_number(), "where it begins");
  section.add("x to", x_to, "m", any_number(), "where it ends");
  section.check(x_to > x_from, "x to", number_text(x_to) + " m",
                "must be > x from = " + number_text(x_from) + " m (a crowd needs a place to stand)",
                "Exchange the two values");
}

std::string CrowdParameters::summary() const {
  return "crowd of " + number_text(intensity) + " Pa on " + in_quotes(on) + " from x = " + number_text(x_from) +
         " m to " + number_text(x_to) + " m";
}

std::optional<FacetsOfLoad> CrowdParameters::facets() const {
  FacetsOfLoad facets{on, blocks};
  facets.adds_up = true;
  facets.reaches = [from = x_from, to = x_to](const Vector<2>& a, const Vector<2>& b) {
    return has_width(a, b) && std::max(a[0], b[0]) > from && std::min(a[0], b[0]) < to;
  };
  return facets;
}

bool CrowdParameters::is_zero() const { return intensity == 0; }

template <>
void add_crowd<2>(const Structure<2>& s, const CrowdParameters& load, const FacetSet& facets, double factor,
                  std::vector<double>& force) {
  for (const auto& e : edges_of_set(s, facets)) {
    const Vector<2> traction{0, -factor * load.intensity * std::abs(e.x[1][0] - e.x[0][0]) / e.length};
    add_along(
        e, part_between(e, 0, load.x_from, load.x_to), s.model().thickness, [&](const Vector<2>&) { return traction; },
        force);
  }
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const CrowdParameters& p, const LoadSite<2>& site) {
  return pattern_of(site.structure,
                    [&](auto& unit) { add_crowd(site.structure, p, site.facet_set(p.on, p.blocks), 1.0, unit); });
}

}  // namespace voussoir
