#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "blocks/supports.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {

void SettlementParameters::declare(ParameterSection& section) {
  section.add("support", support, "name of the support of this scene that moves; only its held components do",
              Presence::required, "Give a name from the section \"supports\".");
  section.add("ux", ux, "m", any_number(), "displacement to the right");
  section.add("uy", uy, "m", any_number(), "displacement upwards; a settlement is negative");
  section.add("rotation", rotation, "rad", any_number(), "small rotation, counter-clockwise");
  section.add("about x", about_x, "m", any_number(), "centre of the rotation");
  section.add("about y", about_y, "m", any_number(), "centre of the rotation");
}

std::string SettlementParameters::summary() const {
  return "settlement of " + in_quotes(support) + " by (" + number_text(ux) + ", " + number_text(uy) + ") m" +
         (rotation == 0 ? ""
                        : ", turned by " + number_text(rotation) + " rad about (" + number_text(about_x) + ", " +
                              number_text(about_y) + ") m");
}

bool SettlementParameters::is_zero() const { return ux == 0 && uy == 0 && rotation == 0; }

template <>
void add_settlement<2>(const Structure<2>& s, const SettlementParameters& load, const SupportParameters& support,
                       int facet_set, double factor, std::vector<double>& displacement) {
  std::vector<char> moved(s.nodes(), 0);  // a node of two facets moves once
  for_each_node_on(s, facet_set, [&](int node) {
    if (moved[node]) return;
    moved[node] = 1;
    const auto& x = s.position()[node];
    const Vector<2> u{load.ux - load.rotation * (x[1] - load.about_y), load.uy + load.rotation * (x[0] - load.about_x)};
    for (int c = 0; c < 2; ++c)
      if (holds(support, c)) displacement[2 * node + c] += factor * u[c];
  });
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const SettlementParameters& p, const LoadSite<2>& site) {
  std::vector<double> unit(2 * site.structure.nodes(), 0.0);
  std::vector<char> moved(unit.size(), 0);  // a node of two supports moves with the first
  for (const auto& [name, support] : site.supports) {
    const int set = site.facet_set(support.on);
    if (name == p.support) {
      add_settlement(site.structure, p, support, set, 1.0, unit);
      for (std::size_t i = 0; i < unit.size(); ++i)
        if (moved[i]) unit[i] = 0;
      break;
    }
    hold(site.structure, support, set, moved);
  }
  return std::make_unique<PatternLoad<2>>(unit, PatternLoad<2>::Of::displacements);
}

}  // namespace voussoir
