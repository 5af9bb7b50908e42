// The blocks of a rank as nodes and matrices, whatever their dimension: what unknowns, systems and steps see of a
// structure. Structure<dim> adds where blocks come from, their cells, and how they turn.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "base/ids.hpp"
#include "base/plane_and_space.hpp"
#include "blocks/material.hpp"
#include "linalg/exchange.hpp"
#include "linalg/local_csr.hpp"

namespace voussoir {

class CondensedEdges;

struct NodesOfBlock {
  BlockId id = 0;
  NodeId first_node = 0;  ///< number of its first node in the whole structure
  int first_local = 0;    ///< number of its first node on this rank
  int nodes = 0;
  Material material;
  /// [components nodes, squared] of the block alone, singular by its rigid motions [N/m]; one for all blocks alike
  std::shared_ptr<const LocalCsr> stiffness;
  /// What makes preconditioners: the same, but where edges are condensed into the stiffness that of linear cells, which
  /// is sparse and, along any motion, between once and some twelve times as stiff whatever the mesh.
  std::shared_ptr<const LocalCsr> sparse;
  std::shared_ptr<const CondensedEdges> edges;  ///< none where cells are linear
  int first_edge = 0;                           ///< number of its first edge that bends on this rank
};

class BlockSystem {
 public:
  virtual ~BlockSystem() = default;

  /// Of displacements and forces: 2 in the plane, 3 in space.
  int components() const { return components_; }
  /// Owned blocks in ascending order, then the halo in ascending order.
  virtual int local_blocks() const = 0;
  virtual const NodesOfBlock& nodes_of(int block) const = 0;
  int owned_blocks() const { return owned_blocks_; }
  /// Local number of a block, -1 when it is neither owned nor in the halo.
  int local_block(BlockId) const;

  int nodes() const { return static_cast<int>(node_id_.size()); }
  int owned_nodes() const { return owned_nodes_; }
  NodeId total_nodes() const { return total_nodes_; }
  /// Edges that bend, of local blocks.
  int edges() const { return edges_; }
  const std::vector<NodeId>& node_id() const { return node_id_; }
  const std::vector<int>& block_of_node() const { return block_of_node_; }
  /// Where a node is, and the middle of the bounding box of the whole structure as drawn [m].
  virtual Vector<3> place(int node) const = 0;
  virtual Vector<3> centre() const = 0;

  /// Nodes grouped by vertex: copies of group g are copy[copies_start[g]] .. copy[copies_start[g + 1] - 1],
  /// ascending by node id. Only vertices with an owned node, where the group is complete.
  const std::vector<int>& copies_start() const { return copies_start_; }
  const std::vector<int>& copy() const { return copy_; }

  const Exchange& node_exchange() const { return *node_exchange_; }
  /// Rank that owns a local block.
  int owner_of(int block) const {
    return block < owned_blocks_ ? comm_->getRank() : owner_of_halo_[block - owned_blocks_];
  }
  BlockId total_blocks() const { return total_blocks_; }
  const Teuchos::RCP<const Teuchos::Comm<int>>& comm() const { return comm_; }

  /// y = K u on local node copies [components x nodes], owned and halo; no communication.
  void apply_stiffness(const std::vector<double>& u, std::vector<double>& y) const;
  /// Forces of the blocks against a displacement [N]: K u, of what deforms the blocks.
  void internal_forces(const std::vector<double>& u, std::vector<double>& y) const;
  /// What of a displacement deforms the blocks: all but the motion they have been followed to.
  std::vector<double> deformation(const std::vector<double>& u) const;
  /// u.K u / 2 over all ranks [J]. Collective.
  double elastic_energy(const std::vector<double>& u) const;
  /// Parts a motion of local node copies in that of each block as a whole, and what deforms it, which is left in u.
  virtual void split_rigid_motions(std::vector<double>& u, std::vector<double>& rigid) const = 0;
  /// Volume that each local node copy stands for [m3].
  virtual std::vector<double> nodal_volumes() const = 0;
  const ModelParameters& model() const { return model_; }
  /// Diagonal of the bounding box of the whole structure as drawn [m].
  double size() const { return size_; }

 protected:
  BlockSystem(int components, BlockId blocks, std::vector<int> owner_of_halo, const ModelParameters& model,
              const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
      : components_(components),
        total_blocks_(blocks),
        owner_of_halo_(std::move(owner_of_halo)),
        model_(model),
        comm_(comm) {}
  BlockSystem(const BlockSystem&) = default;

  int components_;
  BlockId total_blocks_;
  std::vector<int> owner_of_halo_;
  ModelParameters model_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  int owned_blocks_ = 0, owned_nodes_ = 0, edges_ = 0;
  NodeId total_nodes_ = 0;
  std::vector<NodeId> node_id_;
  std::vector<int> block_of_node_, copies_start_, copy_;
  std::shared_ptr<const Exchange> node_exchange_;
  double size_ = 0;
  std::vector<double> rigid_motion_;  ///< [m] of blocks that have been followed, to where they are; empty before
};

}  // namespace voussoir
