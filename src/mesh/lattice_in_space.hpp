// Masonry in space whose stones are boxes of cells of one lattice, wherever its corners are mapped to.
//
// A corner of the lattice is a vertex, so stones that touch have matching nodes. Place and vertex of a node follow from
// its corner alone: any rank builds any block by itself, from a list of 32 bytes a stone.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// A corner, or a number of cells, along the three directions of a lattice.
using LatticeIndex = std::array<int, 3>;

/// The cells between two corners.
struct LatticeStone {
  LatticeIndex from, to;
  int group;   ///< index into Masonry::groups
  int number;  ///< in its group, for messages
};

/// Stones of one name that are in the same sets of blocks, such as a course.
struct StoneGroup {
  std::string name;
  std::vector<int> sets;  ///< indices into Masonry::block_sets, ascending
  int part = 0;           ///< what MasonrySide::part means: 0 is masonry, others are grounds
};

/// A set of facets: faces of stones across an axis that lie at one plane of the lattice or at any.
struct MasonrySide {
  static constexpr int any = -1000000000;
  int set;  ///< index into Masonry::facet_sets
  int axis;
  bool far;              ///< the ends at higher corners
  int plane = any;       ///< the corner along the axis
  bool covered = false;  ///< with the faces that lie on another stone
  int part = 0;          ///< of the stones
};

/// What a generator makes: stones, what they are called, and where the lattice lies.
struct Masonry {
  /// First and last corners. The place of any between them has to exist only where a stone has it.
  LatticeIndex low{}, high{};
  /// Along direction 1 the last corners are the first ones; stones may reach beyond them.
  bool closed = false;
  std::vector<LatticeStone> stones;
  std::vector<StoneGroup> groups;
  std::vector<MasonrySide> sides;  ///< in the order in which a block has its facets
  SetNames block_sets;
  std::vector<std::string> facet_sets;
  /// [m] Right-handed: directions 0, 1, 2 in this order.
  std::function<Vector<3>(const LatticeIndex&)> place;
};

/// Part of a masonry with one ground.
constexpr int ground_part = 1;

/// A set of facets of the outer faces of a ground, and of those below and above it with what stands on them: held
/// there, a ground of one cell along direction 2 does not move.
void add_ground_sides(Masonry&, const std::string& name, int part);

/// A block for each stone, in their order.
std::unique_ptr<BlockSource<3>> make_lattice_in_space(Masonry);

}  // namespace voussoir
