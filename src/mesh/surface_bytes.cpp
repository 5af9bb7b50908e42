// A mesh as bytes. They come from a process in which gmsh worked on a file of a stranger, so what is read is looked at.
#include "mesh/bytes.hpp"
#include "mesh/surface_mesh.hpp"

namespace voussoir {
namespace {

/// @param mesh  const when it is written
template <class Bytes, class Mesh>
void exchange_surfaces(Bytes& bytes, Mesh& mesh) {
  plain_list(bytes, mesh.position);
  plain_list(bytes, mesh.lines);
  plain_list(bytes, mesh.corners);
  for (auto* names : {&mesh.block_sets, &mesh.facet_sets}) {
    const std::size_t count = bytes.size(*names, sizeof(std::size_t));
    for (std::size_t k = 0; k < count; ++k) plain_list(bytes, (*names)[k]);
  }
  const std::size_t surfaces = bytes.size(mesh.surfaces, sizeof mesh.surfaces[0].tag);
  for (std::size_t k = 0; k < surfaces; ++k) {
    bytes.plain(mesh.surfaces[k].tag);
    plain_list(bytes, mesh.surfaces[k].sets);
    plain_list(bytes, mesh.surfaces[k].cells);
  }
}

/// Every number that is an index points somewhere.
void check_indices(const SurfaceMesh& mesh) {
  const auto require_index = [](int index, std::size_t size, const char* of) {
    if (index < 0 || static_cast<std::size_t>(index) >= size)
      refuse_bytes(std::string("a number of ") + of + " is none");
  };
  for (const int node : mesh.corners) require_index(node, mesh.position.size(), "a node");
  for (const SurfaceMesh::Line& line : mesh.lines) {
    for (const int node : line.node) require_index(node, mesh.position.size(), "a node");
    require_index(line.set, mesh.facet_sets.size(), "a set of curves");
  }
  for (const SurfaceMesh::Surface& surface : mesh.surfaces) {
    for (const int set : surface.sets) require_index(set, mesh.block_sets.size(), "a set of surfaces");
    for (const Cell& cell : surface.cells) {
      if (cell.count != 3 && cell.count != 4) refuse_bytes("a cell is neither triangle nor quadrilateral");
      for (int k = 0; k < cell.count; ++k) require_index(cell.node[k], mesh.position.size(), "a node");
    }
  }
}

}  // namespace

std::string bytes_of(const SurfaceMesh& mesh) {
  ByteWriter writer;
  exchange_surfaces(writer, mesh);
  return writer.bytes;
}

SurfaceMesh surface_mesh_of(const std::string& bytes) {
  SurfaceMesh mesh;
  ByteReader reader(bytes);
  exchange_surfaces(reader, mesh);
  if (reader.left() > 0) refuse_bytes("it goes on behind its end");
  check_indices(mesh);
  return mesh;
}

}  // namespace voussoir
