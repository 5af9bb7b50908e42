// What the program knows of geometry: blocks, each with a mesh of its own.
//
// A mesh is handed out block by block by a BlockSource, so that a rank builds
// only the blocks it owns and those it touches, and a generated wall of a
// million blocks never exists in one place. Of a mesh from a file each rank is
// the reader of a span of blocks, and is brought what else it asks for.
// Numbers do not depend on ranks.
#pragma once

#include <Teuchos_Comm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/ids.hpp"
#include "base/tensor.hpp"
#include "base/warning.hpp"
#include "mesh/set_names.hpp"

namespace voussoir {

/// P1 or Q1 cell: `count` local node numbers. In 2D counter-clockwise, 3 = triangle, 4 = quadrilateral. In 3D
/// 8 = hexahedron: four of one face, counter-clockwise seen from the other four, which lie across from them;
/// 4 = tetrahedron: three of one face, counter-clockwise seen from the fourth.
struct Cell {
  std::array<int, 8> node{};
  int count = 0;
};

/// A facet (edge in 2D) on the surface of a block that belongs to a named set.
struct TaggedFacet {
  std::array<int, 4> node{};  ///< local node numbers; a triangle has its last one twice
  int count = 0;              ///< 2 in 2D, 3 or 4 in 3D
  int set = 0;                ///< index into BlockSource::facet_sets()
};

/// Mesh of one block.
template <int dim>
struct Block {
  BlockId id = -1;
  std::string name;                   ///< for messages: "block 17 (course 3, stone 2)"
  std::vector<Vector<dim>> position;  ///< [m] per node
  std::vector<VertexId> vertex;       ///< per node; equal for coincident nodes of touching blocks
  std::vector<Cell> cells;
  /// Edges of its triangles or tetrahedra that may bend, by local nodes, ascending. Linear cells have none.
  std::vector<std::array<int, 2>> curved;
  /// Nodes where the drawing has an edge (a corner in 2D), ascending: facets that meet there at an angle are two sides
  /// of a joint, where others are parts of something curved (mesh/same_side.hpp).
  std::vector<int> folds;
  std::vector<TaggedFacet> facets;  ///< only those in a named set
  std::vector<int> sets;            ///< indices into BlockSource::block_sets(), ascending
};

/// A block that shares vertices with another one, and how many.
struct Neighbour {
  BlockId block;
  int shared_vertices;
};

/// Blocks from one number up to the one before another.
struct BlockSpan {
  BlockId from, to;
};

/// The blocks that a rank reads where all ranks read equal numbers of them, in the order of their numbers.
inline BlockSpan span_read_by(int rank, int ranks, BlockId blocks) {
  const auto first_of = [&](long long r) { return static_cast<BlockId>((r * blocks + ranks - 1) / ranks); };
  return {first_of(rank), first_of(rank + 1LL)};
}

/// Which blocks share vertices, in compressed rows: neighbours of the first block plus b are
/// neighbour[start[b]] .. neighbour[start[b + 1] - 1], in ascending order.
struct BlockGraph {
  std::vector<int> start;
  std::vector<BlockId> neighbour;
  std::vector<int> shared_vertices;  ///< per neighbour entry: number of vertices the two blocks share
};

/// A structure made of blocks.
///
/// Every function but bring() is local (no communication), and what it says does not depend on the rank. Of blocks that
/// are generated every rank can be asked; of those from a file their readers, and who was brought them.
template <int dim>
class BlockSource {
 public:
  virtual ~BlockSource() = default;

  virtual BlockId block_count() const = 0;
  /// Number of nodes of a block, without building it.
  virtual int node_count(BlockId) const = 0;
  virtual Block<dim> block(BlockId) const = 0;
  /// Blocks that share at least one vertex with a block, ascending.
  virtual std::vector<Neighbour> neighbours(BlockId) const = 0;
  /// The rank that looks a block over and tells of it as long as blocks have no owners: every rank its share by number.
  int reader_of(BlockId b, int ranks) const {
    return static_cast<int>(static_cast<long long>(b) * ranks / block_count());
  }
  /// All blocks that a rank is the reader of.
  BlockSpan read_by(int rank, int ranks) const { return span_read_by(rank, ranks, block_count()); }
  /// From now on this rank can be asked of these blocks, too. Collective.
  virtual void bring(const std::vector<BlockId>&, const Teuchos::Comm<int>&) const {}
  /// Names of sets of blocks ("ring west") that this rank knows: those of the blocks that it can be asked of. The set
  /// "all" is implied and not listed.
  virtual const SetNames& block_sets() const = 0;
  /// Names of sets of boundary facets ("foundation pier west").
  virtual const std::vector<std::string>& facet_sets() const = 0;
  /// What the source cannot vouch for; `where` is a key of the scene.
  virtual Warnings warnings() const { return {}; }
  /// What was found and made of what was given, line by line, for the user.
  virtual std::vector<std::string> report() const { return {}; }
  /// A picture of it as SVG, on the first rank alone; "" where there is none to be looked at.
  virtual std::string picture() const { return {}; }
};

/// The rows of a span of blocks that this rank can be asked of.
template <int dim>
BlockGraph graph_of(const BlockSource<dim>&, BlockSpan);
/// From now on this rank can be asked of what touches a span of its blocks, too. Collective.
template <int dim>
void bring_neighbours(const BlockSource<dim>&, BlockSpan, const Teuchos::Comm<int>&);
/// The names of all sets of blocks by number, on the first rank; none on the others. Collective.
template <int dim>
std::vector<std::string> names_of_block_sets(const BlockSource<dim>&, const Teuchos::Comm<int>&);
/// Of all blocks.
template <int dim>
BlockGraph graph_of(const BlockSource<dim>& source) {
  return graph_of(source, {0, source.block_count()});
}

}  // namespace voussoir
