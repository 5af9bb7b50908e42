// The part of the structure a rank works on: the blocks it owns, and the halo of
// blocks that share a vertex with them, so that whatever happens at a vertex of an
// owned block can be computed without asking anybody.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "base/rotation.hpp"
#include "blocks/block_system.hpp"
#include "mesh/block_share.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

class StiffnessOfShapes;

template <int dim>
struct LocalBlock : NodesOfBlock {
  Block<dim> mesh;  ///< without its name and its vertices, which the structure has sorted
};

template <int dim>
class Structure : public BlockSystem {
 public:
  /// Collective.
  /// @param share        of this rank, whose blocks the source can be asked of
  /// @param material_of  material of a block, called for blocks of this rank and its halo
  /// @param held         whether a facet of a block is held, so that its edges stay straight; none for no facet
  Structure(const BlockSource<dim>&, const BlockShare& share, const ModelParameters&,
            const std::function<Material(const Block<dim>&)>& material_of,
            const Teuchos::RCP<const Teuchos::Comm<int>>&,
            const std::function<bool(const Block<dim>&, const TaggedFacet&)>& held = {});

  const std::vector<LocalBlock<dim>>& blocks() const { return blocks_; }
  int local_blocks() const override { return static_cast<int>(blocks_.size()); }
  const NodesOfBlock& nodes_of(int block) const override { return blocks_[block]; }

  /// Where nodes are: as drawn, or where blocks have been followed to.
  const std::vector<Vector<dim>>& position() const { return position_; }
  const std::vector<Vector<dim>>& drawn_position() const { return drawn_.empty() ? position_ : drawn_; }
  Vector<3> place(int node) const override { return in_space(position_[node]); }
  /// The local edge that bends between two local nodes; -1 where none does.
  int edge_between(int node, int other) const;
  void split_rigid_motions(std::vector<double>& u, std::vector<double>& rigid) const override;
  std::vector<double> nodal_volumes() const override;

  /// Takes every block, undeformed, to where a displacement has moved and turned it, however far: places of nodes
  /// and K. Displacements still count from the drawing. No block has edges that are condensed. Collective.
  /// @return the largest turn since the last time [rad]
  double move_to(const std::vector<double>& u);
  /// How far a local block has been followed from its drawing.
  Rotation<dim> turn(int block) const { return turn_.empty() ? Rotation<dim>() : turn_[block]; }
  /// The same structure with other matrices in the place of the stiffness of its blocks.
  /// @param matrix_of  matrix of each local block in the place of its stiffness
  /// @param sparse_of  likewise of what makes preconditioners; none where that is the same matrix
  Structure with_matrices(const std::function<LocalCsr(int block)>& matrix_of,
                          const std::function<LocalCsr(int block)>& sparse_of = {}) const;
  /// Middle of the bounding box [m]: what is reckoned from it keeps its digits, wherever the drawing has its origin.
  const Vector<dim>& middle() const { return middle_; }
  Vector<3> centre() const override { return in_space(middle_); }

 private:
  void add_block(Block<dim>, NodeId first_node, const Material&, StiffnessOfShapes&, std::vector<VertexId>& vertex);
  void group_copies(const std::vector<VertexId>& vertex);
  double follow_block(int block, const std::vector<double>& u);

  std::vector<LocalBlock<dim>> blocks_;
  std::vector<Vector<dim>> position_;
  Vector<dim> middle_{};
  // Of blocks that have been followed; empty before.
  std::vector<Vector<dim>> drawn_;   ///< [m] places of nodes in the drawing
  std::vector<Rotation<dim>> turn_;  ///< per local block
};

extern template class Structure<2>;
extern template class Structure<3>;

}  // namespace voussoir
