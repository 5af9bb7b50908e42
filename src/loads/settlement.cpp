#include <cmath>

#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "blocks/supports.hpp"
#include "linalg/reduce.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {

void SettlementParameters::declare(ParameterSection& section) {
  section.add("support", support, "name of the support of this scene that moves; only its held components do",
              Presence::required, "Give a name from the section \"supports\".");
  section.add("ux", ux, "m", any_number().usually(1e-9, 2), "displacement to the right");
  section.add("uy", uy, "m", any_number().usually(1e-9, 2), "displacement upwards; a settlement is negative");
  section.add("rotation", rotation, "rad", any_number().usually(1e-9, 1.6),
              "rotation, counter-clockwise; a small one unless model > rotations is finite");
  section.add("about x", about_x, "m", any_number().or_infinite(),
              "centre of the rotation; inf: the middle of the support's edges");
  section.add("about y", about_y, "m", any_number().or_infinite(),
              "centre of the rotation; inf: the middle of the support's edges");
}

std::string SettlementParameters::summary() const {
  const auto coordinate = [](double x) { return std::isinf(x) ? "its middle" : number_text(x); };
  return "settlement of " + in_quotes(support) + " by (" + number_text(ux) + ", " + number_text(uy) + ") m" +
         (rotation == 0 ? ""
                        : ", turned by " + number_text(rotation) + " rad about (" + coordinate(about_x) + ", " +
                              coordinate(about_y) + ") m");
}

bool SettlementParameters::is_zero() const { return ux == 0 && uy == 0 && rotation == 0; }

template <>
void add_settlement<2>(const Structure<2>& s, const SettlementParameters& load, const SupportParameters& support,
                       const FacetSet& facets, double factor, std::vector<double>& displacement) {
  std::vector<char> moved(s.nodes(), 0);  // a node of two facets moves once
  for_each_node_on(s, facets, [&](int node) {
    if (moved[node]) return;
    moved[node] = 1;
    const auto& x = s.drawn_position()[node];
    Vector<2> u{load.ux, load.uy};
    if (load.rotation != 0) u = u + load.rotation * Vector<2>{load.about_y - x[1], x[0] - load.about_x};
    for (int c = 0; c < 2; ++c)
      if (holds(support, c)) displacement[2 * node + c] += factor * u[c];
  });
}

namespace {

/// The middle of the edges of a support, by their length [m]. Collective.
Vector<2> middle_of_edges(const Structure<2>& s, const FacetSet& facets) {
  std::array<double, 3> mine{};  // lengths, and their moments about the middle of the structure
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    for (const auto& facet : block.mesh.facets) {
      if (!facets.has(block.mesh, facet)) continue;
      const auto from = s.drawn_position()[block.first_local + facet.node[0]] - s.middle();
      const auto to = s.drawn_position()[block.first_local + facet.node[1]] - s.middle();
      const auto middle = 0.5 * (from + to);
      mine = mine + norm(to - from) * std::array<double, 3>{1, middle[0], middle[1]};
    }
  }
  const auto all = total_of_each(*s.comm(), mine);
  return all[0] > 0 ? s.middle() + Vector<2>{all[1] / all[0], all[2] / all[0]} : s.middle();
}

/// A support that turns by a finite rotation: its nodes keep their distances, so their motion is no multiple of a
/// pattern.
class TurningSupport : public Load<2> {
 public:
  /// @param moves  1 for the components [2 x local node copies] that the support takes along
  TurningSupport(const Structure<2>& s, const SettlementParameters& p, const std::vector<char>& moves)
      : translation_{p.ux, p.uy}, rotation_(p.rotation) {
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (!moves[i]) continue;
      index_.push_back(static_cast<int>(i));
      arm_.push_back(s.drawn_position()[i / 2] - Vector<2>{p.about_x, p.about_y});
    }
  }
  void add(const std::vector<LoadMoment>& moments, std::vector<double>&,
           std::vector<double>& prescribed) const override {
    const double factor = sum_of_factors(moments);
    const Rotation rotation(factor * rotation_);
    for (std::size_t k = 0; k < index_.size(); ++k) {
      const auto& r = arm_[k];
      prescribed[index_[k]] += (factor * translation_ + rotation(r) - r)[index_[k] % 2];
    }
  }
  std::size_t bytes() const override { return index_.size() * (sizeof(int) + sizeof(Vector<2>)); }

 private:
  Vector<2> translation_;  ///< [m] for factor 1
  double rotation_;        ///< [rad] for factor 1
  std::vector<int> index_;
  std::vector<Vector<2>> arm_;  ///< [m] from the centre
};

}  // namespace

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const SettlementParameters& given, const LoadSite<2>& site) {
  const auto& s = site.structure;
  auto p = given;
  for (const auto& [name, support] : site.supports)
    if (name == p.support && p.rotation != 0) {
      const auto middle = middle_of_edges(s, site.facet_set(support.on, support.blocks));
      if (std::isinf(p.about_x)) p.about_x = middle[0];
      if (std::isinf(p.about_y)) p.about_y = middle[1];
    }
  std::vector<double> unit(2 * s.nodes(), 0.0);
  std::vector<char> moved(unit.size(), 0), moves(unit.size(), 0);  // a node of two supports moves with the first
  for (const auto& [name, support] : site.supports) {
    const auto set = site.facet_set(support.on, support.blocks);
    if (name == p.support) {
      add_settlement(s, p, support, set, 1.0, unit);
      hold(s, support, set, moves);
      for (std::size_t i = 0; i < unit.size(); ++i)
        if (moved[i]) unit[i] = moves[i] = 0;
      break;
    }
    hold(s, support, set, moved);
  }
  if (p.rotation != 0 && s.model().rotations == Rotations::finite) return std::make_unique<TurningSupport>(s, p, moves);
  return std::make_unique<PatternLoad<2>>(unit, PatternLoad<2>::Of::displacements);
}

}  // namespace voussoir
