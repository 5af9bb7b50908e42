#include "joints/contact_points.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "base/rotation.hpp"
#include "joints/joint_finder.hpp"
#include "joints/joint_finder_in_space.hpp"
#include "joints/point_operator.hpp"
#include "linalg/numbering.hpp"
#include "linalg/parcels.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

// What the plane and space do in two ways: the border of a block, the extent of a point, axes for a unit normal.
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
    auto facets = border_facets<dim>({block});
    return known_.emplace(b, BlockWithBorder<dim>{std::move(block), std::move(facets)}).first->second;
  }
  /// Those of lower numbers have met all their neighbours.
  void forget_before(BlockId b) { known_.erase(known_.begin(), known_.lower_bound(b)); }

 private:
  const BlockSource<dim>& source_;
  std::map<BlockId, BlockWithBorder<dim>> known_;
};

/// The rotation nearest to several.
template <int dim>
Rotation<dim> mean_of(const std::vector<Rotation<dim>>& turns) {
  if (turns.size() == 1) return turns[0];
  NearestRotation<dim> nearest;
  for (const auto& turn : turns)
    for (int a = 0; a < dim; ++a) {
      Vector<dim> arm{};
      arm[a] = 1;
      nearest.add(arm, turn(arm) - arm);
    }
  return nearest.found();
}

/// How far each node copy's block has turned, together with those at its vertex that have turned alike. Of copies at
/// vertices that have an owned node.
template <int dim>
std::vector<Rotation<dim>> turns_at_nodes(const Structure<dim>& structure, double alike) {
  std::vector<Rotation<dim>> turn;
  for (const int block : structure.block_of_node()) turn.push_back(structure.turn(block));
  const auto own = turn;
  const auto& start = structure.copies_start();
  for (std::size_t g = 0; g + 1 < start.size(); ++g) {
    std::vector<int> left(structure.copy().begin() + start[g], structure.copy().begin() + start[g + 1]);
    while (!left.empty()) {
      std::vector<int> together{left.back()};
      left.pop_back();
      for (std::size_t n = 0; n < together.size(); ++n) {
        const auto joins = [&](int node) { return own[node].apart(own[together[n]]) <= alike; };
        const auto rest = std::stable_partition(left.begin(), left.end(), [&](int node) { return !joins(node); });
        together.insert(together.end(), rest, left.end());
        left.erase(rest, left.end());
      }
      std::sort(together.begin(), together.end(),
                [&](int a, int b) { return structure.node_id()[a] < structure.node_id()[b]; });
      std::vector<Rotation<dim>> turns;
      for (const int node : together) turns.push_back(own[node]);
      const auto mean = mean_of(turns);
      for (const int node : together) turn[node] = mean;
    }
  }
  return turn;
}

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
  find(source, structure, finder);
  number(structure);
}

/// Points of block i = those with blocks of a higher number.
template <int dim>
void ContactPoints::find(const BlockSource<dim>& source, const Structure<dim>& structure,
                         const PointFinder<dim>& finder) {
  Borders<dim> borders(source);
  const auto& blocks = structure.blocks();
  for (int local = 0; local < static_cast<int>(blocks.size()); ++local) {
    const auto& bi = blocks[local];
    const BlockId i = bi.mesh.id;
    if (local < structure.owned_blocks()) borders.forget_before(i);
    for (const auto& beside : source.neighbours(i)) {
      const BlockId j = beside.block;
      const int other = j < i ? -1 : structure.local_block(j);
      if (other < 0) continue;
      const auto found = finder(borders.of(i), borders.of(j));
      if (found.empty()) continue;
      joints_.push_back({i, j, local, other, 0, thickness_between(structure, bi, blocks[other])});
      for (const auto& p : found) {
        ContactPoint point;
        point.shares_i = p.shares_i.from(bi.first_local);
        point.shares_j = p.shares_j.from(blocks[other].first_local);
        point.joint = static_cast<int>(joints_.size()) - 1;
        point.coincident = p.coincident;
        point.area = p.extent * joints_.back().thickness;
        point.place = p.place;
        point.axis = axes(dim, p.normal);
        points_.push_back(std::move(point));
      }
    }
    if (local == structure.owned_blocks() - 1) owned_ = static_cast<int>(points_.size());
  }
  points_.shrink_to_fit();
  joints_.shrink_to_fit();
}

/// Points are numbered block by block in the order of blocks i, and there in the order of blocks j. Ghosts ask the
/// owner of their block i where their joint begins. Collective.
void ContactPoints::number(const BlockSystem& s) {
  const auto& comm = *s.comm();
  std::vector<long long> own_blocks, count(static_cast<std::size_t>(s.owned_blocks()), 0);
  for (int b = 0; b < s.owned_blocks(); ++b) own_blocks.push_back(s.nodes_of(b).id);
  for (int k = 0; k < owned_; ++k) ++count[joint_of(k).local_i];
  auto numbers = first_numbers(own_blocks, count, s.total_blocks(), comm);
  total_ = numbers.total;
  std::vector<PointId> first(joints_.size(), -1);  // of each joint
  for (int k = 0; k < owned_; ++k) {
    points_[k].id = numbers.first[joint_of(k).local_i]++;
    if (first[points_[k].joint] < 0) first[points_[k].joint] = points_[k].id;
  }
  const auto own = std::partition_point(joints_.begin(), joints_.end(),
                                        [&](const Joint& joint) { return joint.local_i < s.owned_blocks(); });
  const auto own_joints = own - joints_.begin();
  total_joints_ = total_over_ranks(comm, static_cast<long long>(own_joints));
  struct Asked {
    BlockId i, j;
    int number;  ///< of the joint, where it is asked for
  };
  struct Told {
    int number;
    PointId first;
  };
  Post<Asked> ask(comm);
  for (std::size_t n = own_joints; n < joints_.size(); ++n)
    ask.add(s.owner_of(joints_[n].local_i), {joints_[n].block_i, joints_[n].block_j, static_cast<int>(n)});
  Post<Told> answer(comm);
  const auto before = [](const Joint& a, const Asked& b) {
    return std::make_pair(a.block_i, a.block_j) < std::make_pair(b.i, b.j);
  };
  for (const auto& parcel : std::move(ask).send())
    for (const auto& asked : parcel.items) {
      const auto at = std::lower_bound(joints_.begin(), own, asked, before);
      VOUSSOIR_CHECK(at != own && at->block_i == asked.i && at->block_j == asked.j && "a joint is found on both sides");
      answer.add(parcel.rank, {asked.number, first[at - joints_.begin()]});
    }
  for (const auto& told : std::move(answer).send_all()) first[told.number] = told.first;
  std::vector<long long> ids;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (static_cast<int>(k) >= owned_) points_[k].id = first[points_[k].joint]++;
    ids.push_back(points_[k].id);
  }
  exchange_ = std::make_unique<Exchange>(ids, owned_, s.comm());
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

template <int dim>
void ContactPoints::turn_axes(const Structure<dim>& structure, double alike) {
  if (drawn_axes_.empty())
    for (const auto& p : points_) drawn_axes_.push_back(p.axis);
  const auto turn_at = turns_at_nodes(structure, alike);
  std::vector<double> axes;  // by row
  for (int k = 0; k < size(); ++k) {
    const auto& point = points_[k];
    const auto turn_of = [&](Side side, int block) {
      return point.coincident && k < owned_ ? turn_at[at(k).main_node(side)] : structure.turn(block);
    };
    const auto& joint = joints_[point.joint];
    const auto turn = turn_of(Side::i, joint.local_i).halfway_to(turn_of(Side::j, joint.local_j));
    for (int a = 0; a < dim; ++a) {
      const auto axis = turn(in_dimension<dim>(drawn_axes_[k][a]));
      axes.insert(axes.end(), axis.begin(), axis.end());
    }
  }
  exchange_->update(axes, dim * dim);  // a rank may not have all blocks at the vertex of a ghost
  for (int k = 0; k < size(); ++k)
    for (int a = 0; a < dim; ++a)
      std::copy_n(axes.begin() + (static_cast<long>(k) * dim + a) * dim, dim, points_[k].axis[a].begin());
}

void relative_motions(const ContactPoints& points, const std::vector<double>& u, std::vector<double>& motions) {
  const int n = points.components();
  motions.resize(static_cast<std::size_t>(n) * points.size());
  for (int k = 0; k < points.size(); ++k) {
    const auto motion = points.at(k).motion(u);
    std::copy_n(motion.begin(), n, motions.begin() + static_cast<long>(n) * k);
  }
}

template void ContactPoints::turn_axes(const Structure<2>&, double);
template void ContactPoints::turn_axes(const Structure<3>&, double);
template std::vector<FoundPoint> coincident_points<2>(const BlockWithBorder<2>&, const BlockWithBorder<2>&);
template std::vector<FoundPoint> coincident_points<3>(const BlockWithBorder<3>&, const BlockWithBorder<3>&);
template ContactPoints::ContactPoints(const BlockSource<2>&, const Structure<2>&, const PointFinder<2>&);
template ContactPoints::ContactPoints(const BlockSource<3>&, const Structure<3>&, const PointFinder<3>&);

}  // namespace voussoir
