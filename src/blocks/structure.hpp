// The part of the structure a rank works on: the blocks it owns, and the halo of
// blocks that share a vertex with them, so that whatever happens at a vertex of an
// owned block can be computed without asking anybody.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "blocks/material.hpp"
#include "linalg/exchange.hpp"
#include "linalg/local_csr.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

class StiffnessOfShapes;

template <int dim>
struct LocalBlock {
  Block<dim> mesh;        ///< without its name and its vertices, which the structure has sorted
  NodeId first_node = 0;  ///< number of its first node in the whole structure
  int first_local = 0;    ///< number of its first node on this rank
  Material material;
  /// [dim nodes x dim nodes] of the block alone, singular by its rigid motions [N/m]; one for all blocks that are alike
  std::shared_ptr<const LocalCsr> stiffness;
};

template <int dim>
class Structure {
 public:
  /// @param owner_of_block  rank of every block
  /// @param material_of     material of a block, called for blocks of this rank and its halo
  Structure(const BlockSource<dim>&, std::vector<int> owner_of_block, const ModelParameters&,
            const std::function<Material(const Block<dim>&)>& material_of,
            const Teuchos::RCP<const Teuchos::Comm<int>>&);

  /// Owned blocks in ascending order, then the halo in ascending order.
  const std::vector<LocalBlock<dim>>& blocks() const { return blocks_; }
  int owned_blocks() const { return owned_blocks_; }
  /// Local number of a block, -1 when it is neither owned nor in the halo.
  int local_block(BlockId) const;

  int nodes() const { return static_cast<int>(node_id_.size()); }
  int owned_nodes() const { return owned_nodes_; }
  NodeId total_nodes() const { return total_nodes_; }
  const std::vector<NodeId>& node_id() const { return node_id_; }
  /// Where nodes are: as drawn, or where blocks have been followed to.
  const std::vector<Vector<dim>>& position() const { return position_; }
  const std::vector<Vector<dim>>& drawn_position() const { return drawn_.empty() ? position_ : drawn_; }
  const std::vector<int>& block_of_node() const { return block_of_node_; }

  /// Nodes grouped by vertex: copies of group g are copy[copies_start[g]] .. copy[copies_start[g + 1] - 1],
  /// ascending by node id. Only vertices with an owned node, where the group is complete.
  const std::vector<int>& copies_start() const { return copies_start_; }
  const std::vector<int>& copy() const { return copy_; }

  const Exchange& node_exchange() const { return *node_exchange_; }
  const std::vector<int>& owner_of_block() const { return owner_; }
  const ModelParameters& model() const { return model_; }
  const Teuchos::RCP<const Teuchos::Comm<int>>& comm() const { return comm_; }

  /// y = K u on local node copies [dim nodes], owned and halo; no communication.
  void apply_stiffness(const std::vector<double>& u, std::vector<double>& y) const;
  /// Forces of the blocks against a displacement [N]: K u, of what deforms the blocks.
  void internal_forces(const std::vector<double>& u, std::vector<double>& y) const;
  /// What of a displacement deforms the blocks: all but the motion they have been followed to.
  std::vector<double> deformation(const std::vector<double>& u) const;
  /// Takes every block, undeformed, to where a displacement has moved and turned it, however far: places of nodes
  /// and K. Displacements still count from the drawing. In the plane alone. Collective.
  /// @return the largest turn since the last time [rad]
  double follow(const std::vector<double>& u);
  /// How far a local block has been followed from its drawing [rad], counter-clockwise.
  double turn(int block) const { return turn_.empty() ? 0.0 : turn_[block]; }
  /// u.K u / 2 over all ranks [J]. Collective.
  double elastic_energy(const std::vector<double>& u) const;
  /// The same structure with other matrices in the place of the stiffness of its blocks.
  /// @param matrix_of  matrix of each local block, in the rows and columns of its stiffness
  Structure with_matrices(const std::function<LocalCsr(int block)>& matrix_of) const;
  /// Diagonal of the bounding box of the whole structure as drawn [m].
  double size() const { return size_; }
  /// Middle of that box [m]: what is reckoned from it keeps its digits, wherever the drawing has its origin.
  const Vector<dim>& middle() const { return middle_; }

 private:
  void add_block(Block<dim>, NodeId first_node, const Material&, StiffnessOfShapes&, std::vector<VertexId>& vertex);
  void group_copies(const std::vector<VertexId>& vertex);
  double follow_block(int block, const std::vector<double>& u);

  std::vector<int> owner_;
  ModelParameters model_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  std::vector<LocalBlock<dim>> blocks_;
  int owned_blocks_ = 0, owned_nodes_ = 0;
  NodeId total_nodes_ = 0;
  std::vector<NodeId> node_id_;
  std::vector<Vector<dim>> position_;
  std::vector<int> block_of_node_, copies_start_, copy_;
  std::shared_ptr<const Exchange> node_exchange_;
  double size_ = 0;
  Vector<dim> middle_{};
  // Of blocks that have been followed; empty before.
  std::vector<Vector<dim>> drawn_;    ///< [m] places of nodes in the drawing
  std::vector<double> rigid_motion_;  ///< [m] to position_, dim numbers per node
  std::vector<double> turn_;          ///< [rad] per local block
};

template <>
double Structure<3>::follow_block(int block, const std::vector<double>& u);
extern template class Structure<2>;
extern template class Structure<3>;

}  // namespace voussoir
