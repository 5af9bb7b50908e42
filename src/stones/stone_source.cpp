#include "stones/stone_source.hpp"

#include <utility>

#include "base/text.hpp"
#include "linalg/agree.hpp"
#include "stones/cell_mesh.hpp"

namespace voussoir {
namespace {

std::string of_meshes(const StoneMeshQuality& q, std::size_t stones) {
  std::string line = std::to_string(q.of_hexahedra) + " stones of hexahedra, " +
                     std::to_string(stones - static_cast<std::size_t>(q.of_hexahedra)) +
                     " of tetrahedra: " + std::to_string(q.nodes) + " nodes, " + std::to_string(q.cells) + " cells, " +
                     six_digits(q.volume) + " m3";
  if (q.of_hexahedra < static_cast<int>(stones))
    line += "; least angle between faces of a tetrahedron " + six_digits(q.least_dihedral) + " degrees, " +
            std::to_string(q.flat) + " cells below 5";
  return line;
}

}  // namespace

std::unique_ptr<BlockSource<3>> read_stone_blocks(const StonesParameters& p, const Teuchos::Comm<int>& comm) {
  BlockList<3> list;
  on_first_rank(comm, [&] {
    auto structure = structure_of(p);
    auto meshes = mesh_stones(structure);
    list = std::move(meshes.list);
    list.report = std::move(structure.report);
    list.report.push_back(of_meshes(meshes.quality, structure.stones.size()));
  });
  broadcast_blocks(comm, list);
  return make_source(std::move(list));
}

}  // namespace voussoir
