// Theory  J. Jaky, The coefficient of earth pressure at rest, J. Soc. Hung. Archit. Eng. 78 (1944) 355-358.
//         W. J. M. Rankine, On the stability of loose earth, Phil. Trans. R. Soc. 147 (1857) 9-27.
#include <algorithm>
#include <cmath>

#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "loads/common_keys.hpp"
#include "loads/facets.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {

void EarthPressureParameters::declare(ParameterSection& section) {
  declare_facet_set(section, on, blocks);
  section.add("unit weight", unit_weight, "N/m3", at_least(0.0).usually(1000, 1e5), "of the soil", "a weight",
              "Backfill has 16e3 to 20e3.");
  section.add("surface", surface, "m", any_number(),
              "height (y, in space z) of the surface of the soil; facets above bear nothing");
  section.add("surcharge", surcharge, "Pa", any_number().usually(50, 1e7), "vertical pressure on that surface");
  section.add_choice<State>(
      "state", state,
      {{"at rest", State::at_rest}, {"active", State::active}, {"passive", State::passive}, {"given", State::given}},
      "horizontal by vertical stress K: 1 - sin phi at rest, tan2(45 - phi / 2) where the wall "
      "gives way (active, the least), tan2(45 + phi / 2) where it is pushed in (passive, the "
      "largest), or given");
  section.add("friction angle", friction_angle, "degrees", between(0, 60).usually(2, 60), "phi of the soil",
              "an angle of soil", "Loose sand has 30, gravel 40.");
  section.add("coefficient", given, "-", at_least(0.0).usually(0.05, 20), "K when state = given", "a soil pushes");
}

double EarthPressureParameters::coefficient() const {
  const double sine = std::sin(friction_angle * 3.141592653589793 / 180);
  switch (state) {
    case State::at_rest:
      return 1 - sine;
    case State::active:
      return (1 - sine) / (1 + sine);
    case State::passive:
      return (1 + sine) / (1 - sine);
    case State::given:
      break;
  }
  return given;
}

std::string EarthPressureParameters::summary() const {
  return "earth pressure with K " + six_digits(coefficient()) + ", " + number_text(unit_weight) +
         " N/m3 below the level " + number_text(surface) + " m, surcharge " + number_text(surcharge) + " Pa on " +
         in_quotes(on);
}

std::optional<FacetsOfLoad> EarthPressureParameters::facets() const {
  FacetsOfLoad facets{on, blocks};
  facets.reaches = [surface = surface](const Vector<3>& low, const Vector<3>&) { return low[2] < surface; };
  return facets;
}

bool EarthPressureParameters::is_zero() const { return coefficient() == 0 || (unit_weight == 0 && surcharge == 0); }

template <int dim>
void add_earth_pressure(const Structure<dim>& s, const EarthPressureParameters& load, const FacetSet& facets,
                        double factor, BlockForces& force) {
  constexpr int up = dim - 1;
  const double k = load.coefficient();
  add_on_facets(
      s, facets, {below(up, load.surface)},
      [&](const Vector<dim>& x, const Vector<dim>& outward) {
        const double vertical = load.unit_weight * (load.surface - x[up]) + load.surcharge;
        auto horizontal = outward;
        horizontal[up] = 0;
        return (-factor * k * vertical) * horizontal;
      },
      force);
}

namespace {

template <int dim>
std::unique_ptr<Load<dim>> earth_pressure(const EarthPressureParameters& p, const LoadSite<dim>& site) {
  return pattern_of(site.structure, [&](auto& unit) {
    add_earth_pressure(site.structure, p, site.facet_set(p.on, p.blocks), 1.0, unit);
  });
}

}  // namespace

template void add_earth_pressure<2>(const Structure<2>&, const EarthPressureParameters&, const FacetSet&, double,
                                    BlockForces&);

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const EarthPressureParameters& p, const LoadSite<2>& site) {
  return earth_pressure(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const EarthPressureParameters& p, const LoadSite<3>& site) {
  return earth_pressure(p, site);
}

}  // namespace voussoir
