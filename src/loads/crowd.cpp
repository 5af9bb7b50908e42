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
              "vertical force per horizontal area of what looks up; a dense crowd has 5000");
  const auto declare_part = [&](const std::string& axis, double& from, double& to, const std::string& where) {
    section.add(axis + " from", from, "m", any_number(), "where it begins" + where);
    section.add(axis + " to", to, "m", any_number(), "where it ends" + where);
    section.check(to > from, axis + " to", number_text(to) + " m",
                  "must be > " + axis + " from = " + number_text(from) + " m (a crowd needs a place to stand)",
                  "Exchange the two values");
  };
  declare_part("x", x_from, x_to, "");
  declare_part("y", y_from, y_to, " across, in space");
}

std::string CrowdParameters::summary() const {
  return "crowd of " + number_text(intensity) + " Pa on " + in_quotes(on) + " from x = " + number_text(x_from) +
         " m to " + number_text(x_to) + " m" +
         (keys_of_space().empty() ? "" : ", y = " + number_text(y_from) + " m to " + number_text(y_to) + " m");
}

std::optional<FacetsOfLoad> CrowdParameters::facets() const {
  FacetsOfLoad facets{on, blocks};
  facets.adds_up = true;
  facets.reaches = [part = *this](const Vector<3>& low, const Vector<3>& high) {
    return has_width({low[0], low[2]}, {high[0], high[2]}) && high[0] > part.x_from && low[0] < part.x_to &&
           high[1] > part.y_from && low[1] < part.y_to;
  };
  return facets;
}

bool CrowdParameters::is_zero() const { return intensity == 0; }

std::vector<KeyOfSpace> CrowdParameters::keys_of_space() const {
  std::vector<KeyOfSpace> keys;
  add_if_given(keys, "y from", y_from, "m", CrowdParameters{}.y_from);
  add_if_given(keys, "y to", y_to, "m", CrowdParameters{}.y_to);
  return keys;
}

template <int dim>
void add_crowd(const Structure<dim>& s, const CrowdParameters& load, const FacetSet& facets, double factor,
               BlockForces& force) {
  constexpr int up = dim - 1;
  std::vector<Slab> part{{0, load.x_from, load.x_to}};
  if constexpr (dim == 3) part.push_back({1, load.y_from, load.y_to});
  add_on_facets(
      s, facets, part,
      [&](const Vector<dim>&, const Vector<dim>& outward) {
        Vector<dim> down{};
        down[up] = -factor * load.intensity * std::max(0.0, outward[up]);  // nobody stands below
        return down;
      },
      force);
}

namespace {

template <int dim>
std::unique_ptr<Load<dim>> crowd(const CrowdParameters& p, const LoadSite<dim>& site) {
  return pattern_of(site.structure,
                    [&](auto& unit) { add_crowd(site.structure, p, site.facet_set(p.on, p.blocks), 1.0, unit); });
}

}  // namespace

template void add_crowd<2>(const Structure<2>&, const CrowdParameters&, const FacetSet&, double, BlockForces&);

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const CrowdParameters& p, const LoadSite<2>& site) {
  return crowd(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const CrowdParameters& p, const LoadSite<3>& site) {
  return crowd(p, site);
}

}  // namespace voussoir
