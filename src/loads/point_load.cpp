#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "base/parameter_section.hpp"
#include "base/plane_and_space.hpp"
#include "base/text.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
#include "loads/bearer.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {

void PointLoadParameters::declare(ParameterSection& section) {
  section.add("x", x, "m", any_number(), "the point");
  section.add("y", y, "m", any_number(), "the point");
  section.add("z", z, "m", any_number(), "the point, in space");
  section.add("fx", fx, "N", any_number().usually(10, 1e9),
              "force to the right, in the plane on the modelled thickness");
  section.add("fy", fy, "N", any_number().usually(10, 1e9), "force upwards; in space along y");
  section.add("fz", fz, "N", any_number().usually(10, 1e9), "force upwards in space");
  section.add("tolerance", tolerance, "m", at_least(0.0), "largest distance from the point to the nearest node",
              "a distance", "Half the element size is enough on the outside of the structure.");
  section.add("blocks", blocks, "set of blocks whose nodes are looked at: says which stone bears a load on a joint",
              Presence::optional, "Give \"all\" or a set of the mesh.");
}

std::string PointLoadParameters::summary() const {
  if (!keys_of_space().empty())
    return "point load " + vector_text(Vector<3>{fx, fy, fz}) + " N at " + vector_text(Vector<3>{x, y, z}) + " m";
  return "point load " + vector_text(Vector<2>{fx, fy}) + " N at " + vector_text(Vector<2>{x, y}) + " m";
}

bool PointLoadParameters::is_zero() const { return fx == 0 && fy == 0 && fz == 0; }

std::vector<KeyOfSpace> PointLoadParameters::keys_of_space() const {
  std::vector<KeyOfSpace> keys;
  add_if_given(keys, "z", z, "m");
  add_if_given(keys, "fz", fz, "N");
  return keys;
}

namespace {

// Nodes as near as the nearest but for round-off: places are rounded to 1e-16 of coordinates and 1e-9 as text.
constexpr double round_off = 1e-9;  // of the size of the structure

}  // namespace

template <int dim>
NearestNode nearest_node(const Structure<dim>& s, const Vector<dim>& point, const std::vector<char>& among) {
  double mine = std::numeric_limits<double>::max();
  NearestNode nearest;
  const auto counts = [&](int i) { return among.empty() || among[i]; };
  for (int i = 0; i < s.nodes(); ++i)
    if (counts(i)) mine = std::min(mine, norm(s.drawn_position()[i] - point));
  nearest.distance = least_over_ranks(*s.comm(), mine);
  // Copies of a vertex are equally near, but for the round-off of drawings (mesh/alike_blocks.hpp).
  long long first = std::numeric_limits<long long>::max();
  for (int i = 0; i < s.nodes(); ++i)
    if (counts(i) && norm(s.drawn_position()[i] - point) <= nearest.distance + round_off * s.size())
      first = std::min<long long>(first, s.node_id()[i]);
  const long long id = least_over_ranks(*s.comm(), first);
  const auto it = std::find(s.node_id().begin(), s.node_id().end(), static_cast<NodeId>(id));
  nearest.local = it == s.node_id().end() ? -1 : static_cast<int>(it - s.node_id().begin());
  return nearest;
}

template <int dim>
void add_point_load(const Structure<dim>& s, const PointLoadParameters& load, double factor, const std::string& where,
                    BlockForces& force, const std::vector<char>& among) {
  const auto at = in_dimension<dim>({load.x, load.y, load.z}), given = in_dimension<dim>({load.fx, load.fy, load.fz});
  const auto node = nearest_node(s, at, among);
  if (node.distance > load.tolerance)
    throw InputError(where + " > tolerance = " + number_text(load.tolerance) +
                     " [m]\n  is exceeded: the node nearest to " + vector_text(at) + " m is " +
                     number_text(node.distance) +
                     " m away.\n  Move the point to the outside of the structure, or give a larger tolerance.");
  if (node.local < 0) return;
  for (int c = 0; c < dim; ++c) force.of_nodes[dim * node.local + c] += factor * given[c];
}

namespace {

constexpr WhyWhole at_one_place{"stones at one place"};

template <int dim>
class PointLoad final : public PatternLoad<dim> {
 public:
  PointLoad(const BlockForces& unit, Warnings warnings) : PatternLoad<dim>(unit), warnings_(std::move(warnings)) {}
  Warnings warnings() const override { return warnings_; }

 private:
  Warnings warnings_;
};

/// The stones of all nodes that are as near as the nearest; the bearer first. Collective.
template <int dim>
std::vector<BlockId> stones_near(const Structure<dim>& s, const Vector<dim>& point, const std::vector<char>& among) {
  const auto nearest = nearest_node(s, point, among);
  std::vector<BlockId> bearer, others;
  for (int i = 0; i < s.owned_nodes(); ++i) {
    if (!among[i] || norm(s.drawn_position()[i] - point) > nearest.distance + round_off * s.size()) continue;
    const BlockId stone = s.blocks()[s.block_of_node()[i]].mesh.id;
    (i == nearest.local ? bearer : others).push_back(stone);
  }
  auto stones = all_gather(bearer, *s.comm(), at_one_place);
  const auto more = all_gather(others, *s.comm(), at_one_place);
  stones.insert(stones.end(), more.begin(), more.end());
  return stones;
}

template <int dim>
std::unique_ptr<Load<dim>> point_load(const PointLoadParameters& p, const LoadSite<dim>& site) {
  const auto& s = site.structure;
  std::vector<char> among(s.nodes(), 0);
  for (const auto& b : s.blocks())
    if (site.in_block_set(b.mesh, p.blocks)) std::fill_n(among.begin() + b.first_local, b.mesh.position.size(), 1);
  BlockForces unit(s);
  add_point_load(s, p, 1.0, site.where, unit, among);
  const auto at = in_dimension<dim>({p.x, p.y, p.z});
  const auto stones = stones_near(s, at, among);
  return std::make_unique<PointLoad<dim>>(
      unit, warning_of_bearer(site, "load_on_several_stones", "the node nearest to " + vector_text(at) + " m", stones,
                              stones.front()));
}

}  // namespace

template NearestNode nearest_node<2>(const Structure<2>&, const Vector<2>&, const std::vector<char>&);
template NearestNode nearest_node<3>(const Structure<3>&, const Vector<3>&, const std::vector<char>&);
template void add_point_load<2>(const Structure<2>&, const PointLoadParameters&, double, const std::string&,
                                BlockForces&, const std::vector<char>&);

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const PointLoadParameters& p, const LoadSite<2>& site) {
  return point_load(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const PointLoadParameters& p, const LoadSite<3>& site) {
  return point_load(p, site);
}

}  // namespace voussoir
