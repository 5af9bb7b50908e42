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
  section.add("ty", ty, "Pa", any_number().usually(10, 1e9), "traction upwards; in space along y");
  section.add("tz", tz, "Pa", any_number().usually(10, 1e9), "traction upwards in space");
  section.add("pressure", pressure, "Pa", any_number().usually(10, 1e9),
              "against the outward normal, added to (tx, ty, tz)");
}

std::string TractionParameters::summary() const {
  return "traction (" + number_text(tx) + ", " + number_text(ty) + (tz == 0 ? "" : ", " + number_text(tz)) +
         ") Pa, pressure " + number_text(pressure) + " Pa on " + in_quotes(on);
}

std::optional<FacetsOfLoad> TractionParameters::facets() const {
  FacetsOfLoad facets{on, blocks};
  facets.adds_up = tx != 0 || ty != 0 || tz != 0;
  return facets;
}

bool TractionParameters::is_zero() const { return tx == 0 && ty == 0 && tz == 0 && pressure == 0; }

std::vector<KeyOfSpace> TractionParameters::keys_of_space() const {
  std::vector<KeyOfSpace> keys;
  add_if_given(keys, "tz", tz, "Pa");
  return keys;
}

template <>
void add_traction<2>(const Structure<2>& s, const TractionParameters& load, const FacetSet& facets, double factor,
                     BlockForces& force) {
  add_on_facets(
      s, facets, {},
      [&](const Vector<2>&, const Vector<2>& outward) {
        return Vector<2>{factor * (load.tx - load.pressure * outward[0]),
                         factor * (load.ty - load.pressure * outward[1])};
      },
      force);
}

template <>
void add_traction<3>(const Structure<3>& s, const TractionParameters& load, const FacetSet& facets, double factor,
                     BlockForces& force) {
  const Vector<3> dead{load.tx, load.ty, load.tz};
  for (const auto& face : faces_of_set(s, facets)) {
    const auto force_of = [&](const Vector<3>& area) { return factor * (norm(area) * dead - load.pressure * area); };
    for (int i = 0; i < face.count; ++i)
      for (int c = 0; c < 3; ++c) force.of_nodes[3 * face.node[i] + c] += force_of(face.outward[i])[c];
    // Over a triangle the integral of 4 L_i L_j is that of L_i.
    for (const int edge : face.edge)
      for (int c = 0; c < 3 && edge >= 0; ++c) force.of_edges[3 * edge + c] += force_of(face.outward[0])[c];
  }
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const TractionParameters& p, const LoadSite<3>& site) {
  return pattern_of(site.structure,
                    [&](auto& unit) { add_traction(site.structure, p, site.facet_set(p.on, p.blocks), 1.0, unit); });
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const TractionParameters& p, const LoadSite<2>& site) {
  return pattern_of(site.structure,
                    [&](auto& unit) { add_traction(site.structure, p, site.facet_set(p.on, p.blocks), 1.0, unit); });
}

}  // namespace voussoir
