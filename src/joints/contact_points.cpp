#include "joints/contact_points.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "joints/joint_finder.hpp"
#include "joints/joint_finder_in_space.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

// What the plane and space do in two ways: the border of a block, the extent of a point, axes for a unit normal.
std::vector<BorderEdge> border_of(const Block<2>& block) { return border_edges({block}); }
std::vector<BorderFace> border_of(const Block<3>& block) { return border_faces({block}); }

double extent(const PointOfTwoBlocks& p) { return p.length; }
double extent(const PointInSpace& p) { return p.area; }

double thickness_between(const Structure<2>& s, const LocalBlock<2>& i, const LocalBlock<2>& j) {
  return std::min(thickness_of(i.material, s.model()), thickness_of(j.material, s.model()));
}
double thickness_between(const Structure<3>&, const LocalBlock<3>&, const LocalBlock<3>&) { return 1; }

std::array<Vector<3>, 3> axes_in_plane(const Vector<2>& normal) {
  return {in_space(normal), in_space(Vector<2>{-normal[1], normal[0]}), Vector<3>{0, 0, 1}};
}

/// In space the first tangent is the axis of the drawing that lies farthest from the normal, as far as it is
/// tangential.
std::array<Vector<3>, 3> axes(int components, const Vector<3>& normal) {
  if (components == 2) return axes_in_plane(in_plane(normal));
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
  explicit Borders(const BlockSource<dim>& source) : source_(source) {}
  const BlockWithBorder<dim>& of(BlockId b) {
    const auto it = known_.find(b);
    if (it != known_.end()) return it->second;
    auto block = source_.block(b);
    auto facets = border_of(block);
    return known_.emplace(b, BlockWithBorder<dim>{std::move(block), std::move(facets)}).first->second;
  }
  /// Those of lower numbers have met all their neighbours.
  void forget_before(BlockId b) { known_.erase(known_.begin(), known_.lower_bound(b)); }

 private:
  const BlockSource<dim>& source_;
  std::map<BlockId, BlockWithBorder<dim>> known_;
};

}  // namespace

template <int dim>
std::vector<FoundPoint> coincident_points(const BlockWithBorder<dim>& i, const BlockWithBorder<dim>& j) {
  std::vector<FoundPoint> found;
  for (const auto& p : points_of_joint(i.block, i.facets, j.block, j.facets))
    found.push_back({PointSide(p.node_i), PointSide(p.node_j), in_space(i.block.position[p.node_i]), in_space(p.normal),
                     extent(p), true});
  return found;
}

template <int dim>
ContactPoints::ContactPoints(const BlockSource<dim>& source, const Structure<dim>& structure,
                             const PointFinder<dim>& finder)
    : components_(dim) {
  std::vector<long long> mine(source.block_count(), 0);
  const auto index = find(source, structure, finder, mine);
  number(index, mine, structure.comm());
}

/// Points of block i = those with blocks of a higher number.
/// @param mine  is set to their count per block
/// @return of each point its number within those of its block i
template <int dim>
std::vector<PointId> ContactPoints::find(const BlockSource<dim>& source, const Structure<dim>& structure,
                                         const PointFinder<dim>& finder, std::vector<long long>& mine) {
  Borders<dim> borders(source);
  const auto& graph = source.graph();
  const auto& blocks = structure.blocks();
  std::vector<PointId> index;
  for (int local = 0; local < static_cast<int>(blocks.size()); ++local) {
    const auto& bi = blocks[local];
    const BlockId i = bi.mesh.id;
    PointId next = 0;
    if (local < structure.owned_blocks()) borders.forget_before(i);
    for (int k = graph.start[i]; k < graph.start[i + 1]; ++k) {
      const BlockId j = graph.neighbour[k];
      if (j < i) continue;
      const auto found = finder(borders.of(i), borders.of(j));
      const int other = structure.local_block(j);
      if (found.empty()) continue;
      total_joints_ += local < structure.owned_blocks();  // of this rank, at first
      if (other >= 0) joints_.push_back({i, j, local, other, 0, thickness_between(structure, bi, blocks[other])});
      for (const auto& p : found) {
        const PointId number = next++;
        if (other < 0) continue;
        ContactPoint point;
        point.shares_i = p.shares_i.from(bi.first_local);
        point.shares_j = p.shares_j.from(blocks[other].first_local);
        point.joint = static_cast<int>(joints_.size()) - 1;
        point.coincident = p.coincident;
        point.area = p.extent * joints_.back().thickness;
        point.place = p.place;
        point.axis = axes(dim, p.normal);
        points_.push_back(std::move(point));
        index.push_back(number);
      }
    }
    if (local < structure.owned_blocks()) {
      mine[i] = next;
      owned_ = static_cast<int>(points_.size());
    }
  }
  return index;
}

/// The count of points over all blocks i gives every point its number. Collective.
void ContactPoints::number(const std::vector<PointId>& index, const std::vector<long long>& mine,
                           const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const auto count = total_of_list(*comm, mine, WhyWhole{"a count of points per block, while a mesh is read"});
  total_joints_ = total_over_ranks(*comm, total_joints_);
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
  exchange_ = std::make_unique<Exchange>(ids, owned_, comm);
}

std::vector<char> ContactPoints::untieable() const {
  std::vector<char> none;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (points_[k].can_be_tied()) continue;
    none.resize(points_.size(), 0);
    none[k] = 1;
  }
  return none;
}

void ContactPoints::turn_axes(const Structure<2>& structure) {
  if (drawn_normal_.empty())
    for (const auto& p : points_) drawn_normal_.push_back(in_plane(p.axis[0]));
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const auto& joint = joints_[points_[k].joint];
    const double turn = (structure.turn(joint.local_i) + structure.turn(joint.local_j)) / 2;
    points_[k].axis = axes_in_plane(Rotation(turn)(drawn_normal_[k]));
  }
}

void relative_motions(const ContactPoints& points, const std::vector<double>& u, std::vector<double>& motions) {
  const int n = points.components();
  motions.resize(static_cast<std::size_t>(n) * points.size());
  for (int k = 0; k < points.size(); ++k) {
    const auto motion = points.at(k).motion(u);
    std::copy_n(motion.begin(), n, motions.begin() + static_cast<long>(n) * k);
  }
}

template std::vector<FoundPoint> coincident_points<2>(const BlockWithBorder<2>&, const BlockWithBorder<2>&);
template std::vector<FoundPoint> coincident_points<3>(const BlockWithBorder<3>&, const BlockWithBorder<3>&);
template ContactPoints::ContactPoints(const BlockSource<2>&, const Structure<2>&, const PointFinder<2>&);
template ContactPoints::ContactPoints(const BlockSource<3>&, const Structure<3>&, const PointFinder<3>&);

}  // namespace voussoir
