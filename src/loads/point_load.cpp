#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {

void PointLoadParameters::declare(ParameterSection& section) {
  section.add("x", x, "m", any_number(), "the point");
  section.add("y", y, "m", any_number(), "the point");
  section.add("fx", fx, "N", any_number(), "force to the right, on the modelled thickness");
  section.add("fy", fy, "N", any_number(), "force upwards, on the modelled thickness");
  section.add("tolerance", tolerance, "m", at_least(0.0), "largest distance from the point to the nearest node",
              "a distance", "Half the element size is enough on the outside of the structure.");
}

std::string PointLoadParameters::summary() const {
  return "point load (" + number_text(fx) + ", " + number_text(fy) + ") N at (" + number_text(x) + ", " +
         number_text(y) + ") m";
}

bool PointLoadParameters::is_zero() const { return fx == 0 && fy == 0; }

template <>
NearestNode nearest_node<2>(const Structure<2>& s, const Vector<2>& point, const std::vector<char>& among) {
  double mine = std::numeric_limits<double>::max();
  NearestNode nearest;
  const auto counts = [&](int i) { return among.empty() || among[i]; };
  for (int i = 0; i < s.nodes(); ++i)
    if (counts(i)) mine = std::min(mine, norm(s.position()[i] - point));
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_MIN, mine, Teuchos::outArg(nearest.distance));
  long long first = std::numeric_limits<long long>::max(), id = 0;  // copies of a vertex are equally near
  for (int i = 0; i < s.nodes(); ++i)
    if (counts(i) && norm(s.position()[i] - point) == nearest.distance)
      first = std::min<long long>(first, s.node_id()[i]);
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_MIN, first, Teuchos::outArg(id));
  const auto it = std::find(s.node_id().begin(), s.node_id().end(), static_cast<NodeId>(id));
  nearest.local = it == s.node_id().end() ? -1 : static_cast<int>(it - s.node_id().begin());
  return nearest;
}

template <>
void add_point_load<2>(const Structure<2>& s, const PointLoadParameters& load, double factor, const std::string& where,
                       std::vector<double>& force) {
  const auto node = nearest_node(s, Vector<2>{load.x, load.y});
  if (node.distance > load.tolerance)
    throw InputError(where + " > tolerance = " + number_text(load.tolerance) +
                     " [m]\n  is exceeded: the node nearest to (" + number_text(load.x) + ", " +
                     number_text(load.y) + ") m is " + number_text(node.distance) +
                     " m away.\n  Move the point to the outside of the structure, or give a larger tolerance.");
  if (node.local < 0) return;
  force[2 * node.local] += factor * load.fx;
  force[2 * node.local + 1] += factor * load.fy;
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const PointLoadParameters& p, const LoadSite<2>& site) {
  return pattern_of(site.structure, [&](auto& unit) { add_point_load(site.structure, p, 1.0, site.where, unit); });
}

}  // namespace voussoir
