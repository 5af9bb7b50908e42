#include "joints/contact_points.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "joints/joint_finder.hpp"
#include "joints/joint_finder_in_space.hpp"

namespace voussoir {
namespace {

// What the plane and space do in two ways: the border of a block, the area of a point, axes for a unit normal.
std::vector<BorderEdge> border_of(const Block<2>& block) { return border_edges({block}); }
std::vector<BorderFace> border_of(const Block<3>& block) { return border_faces({block}); }

double area(const PointOfTwoBlocks& p, double thickness) { return p.length * thickness; }
double area(const PointInSpace& p, double) { return p.area; }

std::array<Vector<2>, 2> axes(const Vector<2>& normal) { return {normal, {-normal[1], normal[0]}}; }
/// The first tangent is the axis of the drawing that lies farthest from the normal, as far as it is tangential.
std::array<Vector<3>, 3> axes(const Vector<3>& normal) {
  const auto least =
      std::min_element(normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  Vector<3> tangent{};
  tangent[least - normal.begin()] = 1;
  tangent = tangent - *least * normal;
  tangent = (1 / norm(tangent)) * tangent;
  return {normal, tangent, cross(normal, tangent)};
}

/// Blocks with their borders, made when first asked for.
template <int dim>
class Borders {
 public:
  struct Entry {
    Block<dim> block;
    std::vector<BorderFacet<dim>> facets;
  };
  explicit Borders(const BlockSource<dim>& source) : source_(source) {}
  const Entry& of(BlockId b) {
    const auto it = known_.find(b);
    if (it != known_.end()) return it->second;
    auto block = source_.block(b);
    auto facets = border_of(block);
    return known_.emplace(b, Entry{std::move(block), std::move(facets)}).first->second;
  }
  /// Those of lower numbers have met all their neighbours.
  void forget_before(BlockId b) { known_.erase(known_.begin(), known_.lower_bound(b)); }

 private:
  const BlockSource<dim>& source_;
  std::map<BlockId, Entry> known_;
};

}  // namespace

template <int dim>
ContactPoints<dim>::ContactPoints(const BlockSource<dim>& source, const Structure<dim>& structure) {
  Borders<dim> borders(source);
  const auto& graph = source.graph();
  const auto& blocks = structure.blocks();
  // Points of block i = those with blocks of a higher number. Their count over all i gives every point its number.
  std::vector<long long> mine(source.block_count(), 0), count(source.block_count(), 0);
  std::vector<PointId> index;  // of each point within those of its block i
  long long joints = 0;
  for (int local = 0; local < static_cast<int>(blocks.size()); ++local) {
    const auto& bi = blocks[local];
    const BlockId i = bi.mesh.id;
    PointId next = 0;
    if (local < structure.owned_blocks()) borders.forget_before(i);
    for (int k = graph.start[i]; k < graph.start[i + 1]; ++k) {
      const BlockId j = graph.neighbour[k];
      if (j < i) continue;
      const auto& one = borders.of(i);
      const auto& two = borders.of(j);
      const auto found = points_of_joint(one.block, one.facets, two.block, two.facets);
      const int other = structure.local_block(j);
      if (found.empty()) continue;
      joints += local < structure.owned_blocks();
      if (other >= 0) joints_.push_back({i, j, 0});
      for (const auto& p : found) {
        const PointId number = next++;
        if (other < 0) continue;
        ContactPoint<dim> point;
        point.node_i = bi.first_local + p.node_i;
        point.node_j = blocks[other].first_local + p.node_j;
        point.joint = static_cast<int>(joints_.size()) - 1;
        point.area = area(p, structure.model().thickness);
        point.axis = axes(p.normal);
        points_.push_back(point);
        index.push_back(number);
      }
    }
    if (local < structure.owned_blocks()) {
      mine[i] = next;
      owned_ = static_cast<int>(points_.size());
    }
  }
  Teuchos::reduceAll(*structure.comm(), Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), count.data());
  Teuchos::reduceAll(*structure.comm(), Teuchos::REDUCE_SUM, joints, Teuchos::outArg(total_joints_));
  std::vector<PointId> first(count.size() + 1, 0);
  for (std::size_t b = 0; b < count.size(); ++b) first[b + 1] = first[b] + count[b];
  total_ = first.back();
  std::vector<long long> ids;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    points_[k].id = first[joints_[points_[k].joint].block_i] + index[k];
    ids.push_back(points_[k].id);
  }
  points_.shrink_to_fit();
  joints_.shrink_to_fit();
  exchange_ = std::make_unique<Exchange>(ids, owned_, structure.comm());
}

template <int dim>
void ContactPoints<dim>::follow(const Structure<dim>& structure) {
  if (drawn_normal_.empty())
    for (const auto& p : points_) drawn_normal_.push_back(p.axis[0]);
  const auto& block = structure.block_of_node();
  for (std::size_t k = 0; k < points_.size(); ++k) {
    auto& p = points_[k];
    const double turn = (structure.turn(block[p.node_i]) + structure.turn(block[p.node_j])) / 2;
    p.axis = axes(Rotation(turn)(drawn_normal_[k]));
  }
}

template <>
void ContactPoints<3>::follow(const Structure<3>&) {
  VOUSSOIR_EXPECT(!"blocks are followed in the plane alone");
}

template class ContactPoints<2>;
template class ContactPoints<3>;

}  // namespace voussoir
