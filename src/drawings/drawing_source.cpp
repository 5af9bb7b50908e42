#include "drawings/drawing_source.hpp"

#include <utility>

#include "base/words.hpp"
#include "drawings/plane_mesh.hpp"
#include "linalg/agree.hpp"
#include "mesh/mesh_check.hpp"
#include "mesh/read_blocks.hpp"

namespace voussoir {

std::unique_ptr<BlockSource<2>> read_drawn_blocks(const StonesParameters& p, const Teuchos::Comm<int>& comm) {
  BlockList<2> list;
  on_first_rank(comm, [&] {
    auto stones = plane_stones_of(p);
    auto meshes = mesh_plane_stones(stones, p.cells);
    list = std::move(meshes.list);
    check_mesh(list.blocks);
    list.quadratic = p.cells == StoneCells::quadratic_triangles;
    list.picture = picture_of(stones);
    list.report = std::move(stones.report);
    list.report.push_back(
        counted(meshes.of_quadrilaterals, "stone") + " of quadrilaterals, " +
        std::to_string(list.blocks.size() - static_cast<std::size_t>(meshes.of_quadrilaterals)) +
        (p.cells == StoneCells::quadratic_triangles ? " of quadratic triangles: " : " of triangles: ") +
        counted(meshes.nodes, "node") + ", " + counted(meshes.cells, "cell"));
  });
  return make_source_of_readers(handed_out(std::move(list), comm), comm);
}

}  // namespace voussoir
