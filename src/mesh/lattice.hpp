// A block that is the image of a rectangular lattice, and the words in which generators refuse parameters.
#pragma once

#include <functional>
#include <string>

#include "mesh/mesh.hpp"
#include "mesh/mesh_parameters.hpp"

namespace voussoir {

/// Cells of a block of `across` x `up` lattice cells; node (i, j) has the local number j * (across + 1) + i.
/// Triangles are halves of the lattice cells with alternating diagonals, so that no direction is preferred.
std::vector<Cell> lattice_cells(int across, int up, CellType);

enum class LatticeSide { bottom, right, top, left };

/// Appends the facets of one side of the lattice, counter-clockwise, as members of a facet set.
void add_lattice_facets(Block<2>&, int across, int up, LatticeSide, int set);

/// Hexahedra of a box of cells along x, y and z; node (i, j, k) has the local number (k (y + 1) + j) (x + 1) + i.
std::vector<Cell> box_cells(const std::array<int, 3>& cells);

/// Appends the facets of one side of the box, counter-clockwise seen from outside, as members of a facet set.
/// @param axis    across which the side lies;  @param far  at its far end
/// @param wanted  which, by their cells along the two axes that follow
void add_box_facets(Block<3>&, const std::array<int, 3>& cells, int axis, bool far, int set,
                    const std::function<bool(int, int)>& wanted);

/// Refuses a wall of more blocks or lattice lines than numbers here can count.
/// @param lines  the most of any direction or block
void require_countable(const std::string& key, int courses, double blocks, double lines);

/// Throws InputError "mesh > `key` = `value`\n  `why`\n  `advice`".
[[noreturn]] void refuse_mesh(const std::string& key, const std::string& value, const std::string& why,
                              const std::string& advice);

/// Refuses a number that is not finite and positive; `unit` is for the message.
void require_positive(const std::string& key, double value, const std::string& unit);
void require_at_least(const std::string& key, int value, int least);

/// A number as people write it: "0.25", not "0.250000".
std::string in_words(double);

}  // namespace voussoir
