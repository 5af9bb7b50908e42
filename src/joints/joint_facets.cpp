#include "joints/joint_facets.hpp"

#include <algorithm>

#include "joints/same_side.hpp"
#include "mesh/border.hpp"

namespace voussoir {
namespace {

struct Place {
  int joint, within;
  Vector<2> outward;  ///< of the block whose node it is
};

/// Per local node the points that stand at it.
std::vector<std::vector<Place>> points_at_nodes(const Structure<2>& s, const ContactPoints& points) {
  std::vector<std::vector<Place>> at_node(static_cast<std::size_t>(s.nodes()));
  std::vector<int> count(points.joints().size(), 0);
  for (int k = 0; k < points.owned(); ++k) {
    const auto& p = points.points()[static_cast<std::size_t>(k)];
    const bool on_i = p.shares_i.is_one();
    const int node = (on_i ? p.shares_i : p.shares_j).first();
    const auto normal = in_plane(p.axis[0]);
    at_node[static_cast<std::size_t>(node)].push_back(
        {p.joint, count[static_cast<std::size_t>(p.joint)]++, on_i ? normal : -1.0 * normal});
  }
  return at_node;
}

/// Whether a point is that of a facet: of those of its joint at the node the one that faces the most as the facet does.
bool faces(const Place& p, const std::vector<Place>& at_node, const Vector<2>& outward) {
  return on_same_side(p.outward, outward, false) && std::all_of(at_node.begin(), at_node.end(), [&](const Place& q) {
           return q.joint != p.joint || dot(q.outward, outward) <= dot(p.outward, outward);
         });
}

}  // namespace

std::vector<std::vector<FacetOfJoint>> facets_of_joints(const BlockSource<2>& source, const Structure<2>& s,
                                                        const ContactPoints& points) {
  const auto at_node = points_at_nodes(s, points);
  std::vector<std::vector<FacetOfJoint>> facets(points.joints().size());
  for (const auto& block : s.blocks()) {
    const auto at = [&](int node) -> const std::vector<Place>& {
      return at_node[static_cast<std::size_t>(block.first_local + node)];
    };
    bool any = false;
    for (int n = 0; n < static_cast<int>(block.mesh.position.size()); ++n) any |= !at(n).empty();
    if (!any) continue;
    for (const auto& edge : border_edges({source.block(block.mesh.id)})) {
      const auto along =
          s.position()[block.first_local + edge.node[1]] - s.position()[block.first_local + edge.node[0]];
      const Vector<2> outward{along[1], -along[0]};
      for (const auto& one : at(edge.node[0]))
        for (const auto& other : at(edge.node[1]))
          if (one.joint == other.joint && faces(one, at(edge.node[0]), outward) &&
              faces(other, at(edge.node[1]), outward))
            facets[static_cast<std::size_t>(one.joint)].push_back({one.within, other.within});
    }
  }
  return facets;
}

}  // namespace voussoir
