// Volumes of a file of gmsh over common nodes: every one is a stone.
#pragma once

#include <string>
#include <vector>

#include "mesh/block_list.hpp"
#include "stones/surface.hpp"

namespace voussoir {

struct VolumeMesh {
  struct Face {
    std::array<int, 4> node{};  ///< of a triangle the first three
    int count = 0;
  };
  struct Volume {
    int tag = 0;
    std::vector<int> sets;    ///< into block_sets, ascending
    std::vector<Cell> cells;  ///< of node numbers; none where the outline alone was asked for
    std::vector<Face> border;
  };
  /// A face of a named set.
  struct Named {
    Face face;
    int set = 0;  ///< into facet_sets
  };
  Places position;              ///< [m] per node
  std::vector<Volume> volumes;  ///< in the order of the blocks
  std::vector<Named> faces;
  std::vector<int> folds;  ///< nodes at points and curves of the drawing, but for seams of one surface
  std::vector<std::string> block_sets, facet_sets;

  /// "volume 17 (ring, west)"
  std::string name_of(std::size_t volume) const;
};

/// The mesh as bytes, for another process of this program, and back. Throws InputError for bytes that are no mesh.
std::string bytes_of(const VolumeMesh&);
VolumeMesh volume_mesh_of(const std::string& bytes);

/// Turns volumes whose cells are all inside out, and finds the borders of all. Throws InputError by volume and place
/// for cells that are inverted or have no volume, lie on each other or do not hang together, and for volumes without
/// cells.
/// @return how many volumes were turned
int find_borders(VolumeMesh&);

/// The borders of volumes as those of stones. Faces of different named sets are of different parts, so that facets end
/// where a set does.
/// @param origin  for messages: the name of the file
std::vector<StoneSurface> surfaces_of(const VolumeMesh&, const std::string& origin);

/// Gives blocks of the volumes, whatever their cells, the sets of the file; facets of the last set of the list must be
/// all those of the borders. Throws InputError for a set of surfaces that bounds no volume.
/// @param within  [m] how far a face may lie from the one it is a part of
void add_sets_of_file(const VolumeMesh&, double within, BlockList<3>&);

}  // namespace voussoir
