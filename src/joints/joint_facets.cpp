#include "joints/joint_facets.hpp"

#include <algorithm>

#include "base/plane_and_space.hpp"
#include "mesh/border.hpp"
#include "mesh/same_side.hpp"

namespace voussoir {
namespace {

template <int dim>
struct Place {
  int joint, within;
  Vector<dim> outward;  ///< of the block whose node it is
};
template <int dim>
using Places = std::vector<Place<dim>>;

/// Per local node the points that stand at it.
template <int dim>
std::vector<Places<dim>> points_at_nodes(const Structure<dim>& s, const ContactPoints& points) {
  std::vector<Places<dim>> at_node(static_cast<std::size_t>(s.nodes()));
  std::vector<int> count(points.joints().size(), 0);
  for (int k = 0; k < points.owned(); ++k) {
    const auto& p = points.points()[static_cast<std::size_t>(k)];
    const bool on_i = p.shares_i.is_one();
    const int node = (on_i ? p.shares_i : p.shares_j).first();
    const auto normal = in_dimension<dim>(p.axis[0]);
    at_node[static_cast<std::size_t>(node)].push_back(
        {p.joint, count[static_cast<std::size_t>(p.joint)]++, on_i ? normal : -1.0 * normal});
  }
  return at_node;
}

Vector<2> outward(const std::array<Vector<2>, 2>& x) { return {x[1][1] - x[0][1], x[0][0] - x[1][0]}; }
Vector<3> outward(const std::array<Vector<3>, 4>& x) { return cross(x[2] - x[0], x[3] - x[1]); }

/// The point of a joint at a node that looks most the way a facet does; none where none is of its side.
template <int dim>
const Place<dim>* point_at(const Places<dim>& places, int joint, const Vector<dim>& outward) {
  const Place<dim>* found = nullptr;
  for (const auto& p : places)
    if (p.joint == joint && on_same_side(p.outward, outward, false) &&
        (!found || dot(p.outward, outward) > dot(found->outward, outward)))
      found = &p;
  return found;
}

}  // namespace

template <int dim>
std::vector<std::vector<FacetOfJoint<dim>>> facets_of_joints(const BlockSource<dim>& source, const Structure<dim>& s,
                                                             const ContactPoints& points) {
  const auto at_node = points_at_nodes(s, points);
  std::vector<std::vector<FacetOfJoint<dim>>> facets(points.joints().size());
  for (const auto& block : s.blocks()) {
    const auto at = [&](int node) -> const Places<dim>& {
      return at_node[static_cast<std::size_t>(block.first_local + node)];
    };
    bool any = false;
    for (int n = 0; n < static_cast<int>(block.mesh.position.size()); ++n) any |= !at(n).empty();
    if (!any) continue;
    for (const auto& facet : border_facets<dim>({source.block(block.mesh.id)})) {
      std::array<Vector<dim>, BorderFacet<dim>::corners> x;
      for (std::size_t k = 0; k < x.size(); ++k) x[k] = s.position()[block.first_local + facet.node[k]];
      const auto way = outward(x);
      std::vector<int> joints;
      for (const auto& p : at(facet.node[0]))
        if (std::count(joints.begin(), joints.end(), p.joint) == 0) joints.push_back(p.joint);
      for (const int joint : joints) {
        FacetOfJoint<dim> found;
        std::size_t corners = 0;
        for (; corners < found.size(); ++corners) {
          const auto* p = point_at(at(facet.node[corners]), joint, way);
          if (!p) break;
          found[corners] = p->within;
        }
        if (corners == found.size()) facets[static_cast<std::size_t>(joint)].push_back(found);
      }
    }
  }
  return facets;
}

template std::vector<std::vector<FacetOfJoint<2>>> facets_of_joints(const BlockSource<2>&, const Structure<2>&,
                                                                    const ContactPoints&);
template std::vector<std::vector<FacetOfJoint<3>>> facets_of_joints(const BlockSource<3>&, const Structure<3>&,
                                                                    const ContactPoints&);

}  // namespace voussoir
