#include "blocks/structure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

#include "base/check.hpp"
#include "blocks/assembly.hpp"
#include "blocks/rigid_motion.hpp"
#include "blocks/shapes.hpp"
#include "linalg/numbering.hpp"
#include "linalg/reduce.hpp"
#include "mesh/curved_edges.hpp"

namespace voussoir {

template <int dim>
Structure<dim>::Structure(const BlockSource<dim>& source, const BlockShare& share, const ModelParameters& model,
                          const std::function<Material(const Block<dim>&)>& material_of,
                          const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                          const std::function<bool(const Block<dim>&, const TaggedFacet&)>& held)
    : BlockSystem(dim, source.block_count(), share.owner_of_halo, model, comm) {
  std::vector<long long> numbers(share.owned.begin(), share.owned.end()), counts;
  numbers.insert(numbers.end(), share.halo.begin(), share.halo.end());
  for (const BlockId b : share.owned) counts.push_back(source.node_count(b));
  const auto nodes_before = first_numbers(numbers, counts, source.block_count(), *comm);
  total_nodes_ = nodes_before.total;
  StiffnessOfShapes stiffness(model);
  std::vector<VertexId> vertex;  // per local node
  const auto add = [&](BlockId b) {
    auto block = source.block(b);
    const auto material = material_of(block);
    if (held) block.curved = curved_edges_off(block, [&](const TaggedFacet& facet) { return held(block, facet); });
    add_block(std::move(block), nodes_before.first[blocks_.size()], material, stiffness, vertex);
  };
  for (const BlockId b : share.owned) add(b);
  owned_blocks_ = static_cast<int>(blocks_.size());
  owned_nodes_ = nodes();
  for (const BlockId b : share.halo) add(b);
  blocks_.shrink_to_fit();
  node_id_.shrink_to_fit();
  position_.shrink_to_fit();
  block_of_node_.shrink_to_fit();
  group_copies(vertex);
  node_exchange_ = std::make_shared<Exchange>(node_id_, owned_nodes_, comm);

  Vector<dim> low, high;
  low.fill(std::numeric_limits<double>::max());
  high.fill(std::numeric_limits<double>::lowest());
  for (const auto& x : position_)
    for (int c = 0; c < dim; ++c) {
      low[c] = std::min(low[c], x[c]);
      high[c] = std::max(high[c], x[c]);
    }
  low = least_of_each(*comm, low);
  high = largest_of_each(*comm, high);
  size_ = norm(high - low);
  middle_ = low + 0.5 * (high - low);
}

template <int dim>
void Structure<dim>::add_block(Block<dim> mesh, NodeId first_node, const Material& material,
                               StiffnessOfShapes& stiffness, std::vector<VertexId>& vertex) {
  std::string().swap(mesh.name);
  vertex.insert(vertex.end(), mesh.vertex.begin(), mesh.vertex.end());
  std::vector<VertexId>().swap(mesh.vertex);
  LocalBlock<dim> b;
  b.id = mesh.id;
  b.nodes = static_cast<int>(mesh.position.size());
  b.mesh = std::move(mesh);
  b.first_node = first_node;
  b.first_local = nodes();
  b.material = material;
  const auto matrices = stiffness.of(b.mesh, material);
  b.stiffness = matrices.stiffness;
  b.sparse = matrices.sparse;
  b.edges = matrices.edges;
  b.first_edge = edges_;
  edges_ += static_cast<int>(b.mesh.curved.size());
  const int local = static_cast<int>(blocks_.size());
  for (std::size_t i = 0; i < b.mesh.position.size(); ++i) {
    node_id_.push_back(b.first_node + static_cast<NodeId>(i));
    position_.push_back(b.mesh.position[i]);
    block_of_node_.push_back(local);
  }
  blocks_.push_back(std::move(b));
}

template <int dim>
void Structure<dim>::group_copies(const std::vector<VertexId>& vertex) {
  std::vector<int> order(nodes());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::make_pair(vertex[a], node_id_[a]) < std::make_pair(vertex[b], node_id_[b]);
  });
  copies_start_ = {0};
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    bool owned = false;
    while (end < order.size() && vertex[order[end]] == vertex[order[i]]) owned |= order[end++] < owned_nodes_;
    if (owned) {
      copy_.insert(copy_.end(), order.begin() + static_cast<long>(i), order.begin() + static_cast<long>(end));
      copies_start_.push_back(static_cast<int>(copy_.size()));
    }
    i = end;
  }
}

template <int dim>
int Structure<dim>::edge_between(int node, int other) const {
  const auto& block = blocks_[block_of_node_[node]];
  const auto& curved = block.mesh.curved;
  const std::array<int, 2> ends{std::min(node, other) - block.first_local, std::max(node, other) - block.first_local};
  const auto at = std::lower_bound(curved.begin(), curved.end(), ends);
  return at != curved.end() && *at == ends ? block.first_edge + static_cast<int>(at - curved.begin()) : -1;
}

template <int dim>
void Structure<dim>::split_rigid_motions(std::vector<double>& u, std::vector<double>& rigid) const {
  rigid.resize(u.size());
  for (const auto& block : blocks_) {
    const auto motion = rigid_motion(position_, block, u);
    for (int i = block.first_local; i < block.first_local + block.nodes; ++i) {
      const auto whole = motion.at(position_[i]);
      for (int c = 0; c < dim; ++c) {
        rigid[dim * i + c] = whole[c];
        u[dim * i + c] -= whole[c];
      }
    }
  }
}

template <int dim>
std::vector<double> Structure<dim>::nodal_volumes() const {
  std::vector<double> volume;
  for (const auto& b : blocks_) {
    const auto more = voussoir::nodal_volumes(b.mesh, b.material, model_);
    volume.insert(volume.end(), more.begin(), more.end());
  }
  return volume;
}

/// The motion is found about the middle of the block, and its matrix where that is the origin: places far from the
/// origin of the drawing have fewer digits than displacements.
template <int dim>
double Structure<dim>::follow_block(int block, const std::vector<double>& u) {
  auto& b = blocks_[block];
  VOUSSOIR_EXPECT(!b.edges && "how edges bend does not turn with a block");
  const auto rigid = rigid_motion(drawn_, b, u);
  const auto rotation = nearest_rotation(drawn_, b, u, rigid);
  for (std::size_t i = 0; i < b.mesh.position.size(); ++i) {
    const std::size_t node = b.first_local + i;
    const auto arm = drawn_[node] - rigid.middle, turned = rotation(arm);
    const auto motion = rigid.mean + (turned - arm);
    b.mesh.position[i] = turned;
    position_[node] = drawn_[node] + motion;
    for (int c = 0; c < dim; ++c) rigid_motion_[dim * node + c] = motion[c];
  }
  if (!(rotation == turn_[block]))  // else it is the matrix of this turn, which blocks that have not turned share
    b.sparse = b.stiffness = std::make_shared<const LocalCsr>(block_stiffness(b.mesh, b.material, model_));
  for (std::size_t i = 0; i < b.mesh.position.size(); ++i) b.mesh.position[i] = position_[b.first_local + i];
  return rotation.apart(std::exchange(turn_[block], rotation));
}

template <int dim>
double Structure<dim>::move_to(const std::vector<double>& u) {
  if (drawn_.empty()) {
    drawn_ = position_;
    rigid_motion_.assign(u.size(), 0.0);
    turn_.assign(blocks_.size(), Rotation<dim>());
  }
  double largest = 0;
  for (int b = 0; b < static_cast<int>(blocks_.size()); ++b) largest = std::max(largest, follow_block(b, u));
  return largest_over_ranks(*comm_, largest);
}

/// Blocks that are alike and as dense have one matrix here too, so one must not depend on where its block stands, not
/// in the last bit either: which of them is asked for depends on ranks.
template <int dim>
Structure<dim> Structure<dim>::with_matrices(const std::function<LocalCsr(int block)>& matrix_of,
                                             const std::function<LocalCsr(int block)>& sparse_of) const {
  Structure other = *this;
  std::map<std::pair<const LocalCsr*, double>,
           std::pair<std::shared_ptr<const LocalCsr>, std::shared_ptr<const LocalCsr>>>
      made;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const auto& block = blocks_[b];
    auto& [matrix, sparse] = made[{block.stiffness.get(), block.material.density}];
    if (!matrix) {
      sparse = matrix = std::make_shared<const LocalCsr>(matrix_of(static_cast<int>(b)));
      if (sparse_of && block.sparse != block.stiffness)
        sparse = std::make_shared<const LocalCsr>(sparse_of(static_cast<int>(b)));
    }
    other.blocks_[b].stiffness = matrix;
    other.blocks_[b].sparse = sparse;
  }
  return other;
}

template class Structure<2>;
template class Structure<3>;

}  // namespace voussoir
