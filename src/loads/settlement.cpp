#include <cmath>
#include <map>
#include <utility>

#include "base/parameter_section.hpp"
#include "base/plane_and_space.hpp"
#include "base/rotation.hpp"
#include "base/text.hpp"
#include "blocks/supports.hpp"
#include "linalg/reduce.hpp"
#include "loads/facets.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {

void SettlementParameters::declare(ParameterSection& section) {
  section.add("support", support, "name of the support of this scene that moves; only its held components do",
              Presence::required, "Give a name from the section \"supports\".");
  section.add("ux", ux, "m", any_number().usually(1e-9, 2), "displacement to the right");
  section.add("uy", uy, "m", any_number().usually(1e-9, 2),
              "displacement upwards, in space along y; a settlement is negative");
  section.add("uz", uz, "m", any_number().usually(1e-9, 2), "displacement upwards in space");
  turn.declare(section, "rad", 1e-9, 1.6,
               "counter-clockwise seen from the end of its axis; a small one unless model > rotations is finite",
               "the middle of the support's edges or faces");
}

std::string SettlementParameters::summary() const {
  const auto coordinate = [](double x) { return std::isinf(x) ? "its middle" : number_text(x); };
  std::string words = "settlement of " + in_quotes(support) + " by (" + number_text(ux) + ", " + number_text(uy) +
                      (uz == 0 ? "" : ", " + number_text(uz)) + ") m";
  if (turn.rotation == 0) return words;
  words += ", turned by " + number_text(turn.rotation) + " rad about (" + coordinate(turn.about[0]) + ", " +
           coordinate(turn.about[1]);
  if (turn.keys_of_space().empty()) return words + ") m";
  return words + ", " + coordinate(turn.about[2]) + ") m, axis " + vector_text(turn.axis);
}

bool SettlementParameters::is_zero() const { return ux == 0 && uy == 0 && uz == 0 && turn.rotation == 0; }

std::vector<KeyOfSpace> SettlementParameters::keys_of_space() const {
  auto keys = turn.keys_of_space();
  add_if_given(keys, "uz", uz, "m");
  return keys;
}

namespace {

/// How a support moves by small turns where it holds a node [m].
template <int dim>
Vector<dim> motion_at(const SettlementParameters& load, const Vector<dim>& place) {
  auto u = in_dimension<dim>(load.way());
  if (load.turn.rotation != 0)
    u = u + load.turn.rotation * spin(load.turn.direction(), place - in_dimension<dim>(load.turn.about));
  return u;
}

/// Length of an edge or area of a face, and its moments about the middle of the structure.
void add_middle(const Structure<2>& s, const LoadedEdge& e, std::array<double, 3>& sum) {
  const auto middle = 0.5 * (e.x[0] + e.x[1]) - s.middle();
  sum = sum + e.length * std::array<double, 3>{1, middle[0], middle[1]};
}

void add_middle(const Structure<3>& s, const LoadedFace& face, std::array<double, 4>& sum) {
  for (int i = 0; i < face.count; ++i) {
    const auto arm = face.x[i] - s.middle();
    sum = sum + norm(face.outward[i]) * std::array<double, 4>{1, arm[0], arm[1], arm[2]};
  }
}

std::vector<LoadedEdge> facets_of(const Structure<2>& s, const FacetSet& set) { return edges_of_set(s, set); }
std::vector<LoadedFace> facets_of(const Structure<3>& s, const FacetSet& set) { return faces_of_set(s, set); }

/// The middle of the edges or faces of a support, by their size [m]. Collective.
template <int dim>
Vector<dim> middle_of_facets(const Structure<dim>& s, const FacetSet& facets) {
  std::array<double, dim + 1> mine{};
  for (const auto& facet : facets_of(s, facets))
    if (facet.node[0] < s.owned_nodes()) add_middle(s, facet, mine);
  const auto all = total_of_each(*s.comm(), mine);
  auto middle = s.middle();
  for (int c = 0; c < dim && all[0] > 0; ++c) middle[c] += all[c + 1] / all[0];
  return middle;
}

/// A direction along which a support moves a node, and what gives it a motion along this one and none along the others
/// that are held there, which need not be square to it.
template <int dim>
struct MovedAlong {
  int node;
  Vector<dim> along, only;
  void add(const Vector<dim>& motion, std::vector<double>& displacement) const {
    const auto u = dot(motion, along) * only;
    for (int c = 0; c < dim; ++c) displacement[dim * node + c] += u[c];
  }
};

/// A support that turns by a finite rotation: its nodes keep their distances, so their motion is no multiple of a
/// pattern.
template <int dim>
class TurningSupport : public Load<dim> {
 public:
  TurningSupport(const Structure<dim>& s, const SettlementParameters& p, std::vector<MovedAlong<dim>> moves)
      : translation_(in_dimension<dim>(p.way())),
        direction_(p.turn.direction()),
        rotation_(p.turn.rotation),
        moves_(std::move(moves)) {
    for (const auto& m : moves_) arm_.push_back(s.drawn_position()[m.node] - in_dimension<dim>(p.turn.about));
  }
  void add(const std::vector<LoadMoment>& moments, BlockForces&, std::vector<double>& prescribed) const override {
    const double factor = sum_of_factors(moments);
    const auto rotation = rotation_about<dim>(direction_, factor * rotation_);
    for (std::size_t k = 0; k < moves_.size(); ++k)
      moves_[k].add(factor * translation_ + rotation(arm_[k]) - arm_[k], prescribed);
  }
  std::size_t bytes() const override { return moves_.size() * (sizeof(MovedAlong<dim>) + sizeof(Vector<dim>)); }

 private:
  Vector<dim> translation_;  ///< [m] for factor 1
  Vector<3> direction_;      ///< of length one
  double rotation_;          ///< [rad] for factor 1
  std::vector<MovedAlong<dim>> moves_;
  std::vector<Vector<dim>> arm_;  ///< [m] from the centre
};

/// Where a settlement moves nodes along what. What two supports hold of a node alike moves with the first.
template <int dim>
std::vector<MovedAlong<dim>> moved_by(const SettlementParameters& p, const LoadSite<dim>& site) {
  struct Way {
    Vector<dim> along;
    bool moves;
  };
  std::map<int, std::vector<Way>> of_node;
  std::map<int, Directions<dim>> known;
  for (const auto& [name, support] : site.supports)
    for (const auto& [node, held] : held_along(site.structure, support, site.facet_set(support.on, support.blocks)))
      for (const auto& along : held)
        if (known[node].add(along)) of_node[node].push_back({along, name == p.support});
  std::vector<MovedAlong<dim>> moves;
  for (const auto& [node, ways] : of_node)
    for (const auto& way : ways) {
      if (!way.moves) continue;
      Directions<dim> others;
      for (const auto& other : ways)
        if (&other != &way) others.add(other.along);
      const auto still = others.across(way.along);
      moves.push_back({node, way.along, (1 / dot(still, way.along)) * still});
    }
  return moves;
}

template <int dim>
std::unique_ptr<Load<dim>> settlement(SettlementParameters p, const LoadSite<dim>& site) {
  const auto& s = site.structure;
  for (const auto& [name, support] : site.supports)
    if (name == p.support && p.turn.rotation != 0)
      p.turn.set_middle(middle_of_facets(s, site.facet_set(support.on, support.blocks)));
  auto moves = moved_by(p, site);
  if (p.turn.rotation != 0 && s.model().rotations == Rotations::finite)
    return std::make_unique<TurningSupport<dim>>(s, p, std::move(moves));
  std::vector<double> unit(dim * static_cast<std::size_t>(s.nodes()), 0.0);
  for (const auto& m : moves) m.add(motion_at<dim>(p, s.drawn_position()[m.node]), unit);
  return std::make_unique<PatternLoad<dim>>(unit);
}

}  // namespace

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const SettlementParameters& p, const LoadSite<2>& site) {
  return settlement(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const SettlementParameters& p, const LoadSite<3>& site) {
  return settlement(p, site);
}

}  // namespace voussoir
