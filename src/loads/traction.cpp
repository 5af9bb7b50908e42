#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "loads/common_keys.hpp"
#include "loads/facets.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {

void TractionParameters::declare(ParameterSection& section) {
  declare_facet_set(section, on, blocks);
  section.add("tx", tx, "Pa", any_number().usually(10, 1e9), "traction to the right");
  section.add("ty", ty, "Pa", any_number().usually(10, 1e9), "traction upwards");
  section.add("pressure", pressure, "Pa", any_number().usually(10, 1e9),
              "against the outward normal, added to (tx, ty)");
}

std::string TractionParameters::summary() const {
  return "traction (" + number_text(tx) + ", " + number_text(ty) + ") Pa, pressure " + number_text(pressure) +
         " Pa on " + in_quotes(on);
}

std::optional<FacetsOfLoad> TractionParameters::facets() const {
  FacetsOfLoad facets{on, blocks};
  facets.adds_up = tx != 0 || ty != 0;
  return facets;
}

bool TractionParameters::is_zero() const { return tx == 0 && ty == 0 && pressure == 0; }

template <>
void add_traction<2>(const Structure<2>& s, const TractionParameters& load, const FacetSet& facets, double factor,
                     std::vector<double>& force) {
  for (const auto& e : edges_of_set(s, facets)) {
    const Vector<2> traction{factor * (load.tx - load.pressure * e.outward[0]),
                             factor * (load.ty - load.pressure * e.outward[1])};
    add_along(
        e, {0, 1}, s.model().thickness, [&](const Vector<2>&) { return traction; }, force);
  }
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const TractionParameters& p, const LoadSite<2>& site) {
  return pattern_of(site.structure,
                    [&](auto& unit) { add_traction(site.structure, p, site.facet_set(p.on, p.blocks), 1.0, unit); });
}

}  // namespace voussoir
