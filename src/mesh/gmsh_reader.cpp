#include "mesh/gmsh_reader.hpp"

#include <utility>

#include "linalg/agree.hpp"
#include "mesh/gmsh_failures.hpp"
#include "mesh/gmsh_program.hpp"
#include "mesh/gmsh_request.hpp"
#include "mesh/mesh_check.hpp"
#include "mesh/msh_format.hpp"
#include "mesh/read_blocks.hpp"
#include "mesh/surface_mesh.hpp"

namespace voussoir {

std::unique_ptr<BlockSource<2>> read_gmsh(const GmshParameters& parameters, const Teuchos::Comm<int>& comm,
                                          Trust trust) {
  BlockList<2> list;
  on_first_rank(comm, [&] {
    if (trust == Trust::no) refuse_commands(parameters.file, parameters.file);
    const auto died = [&](const ChildEnd& end) { refuse_end(parameters.file, end); };
    const std::string request = bytes_of(parameters);
    const auto look = [&] { return ask_gmsh(gmsh_work::look_at_drawing, request, died); };
    if (!(parameters.element_size > 0)) look();
    const SurfaceMesh mesh =
        with_hint(look, [&] { return surface_mesh_of(ask_gmsh(gmsh_work::mesh_drawing, request, died)); });
    list = blocks_of_surfaces(mesh);
    list.quadratic = parameters.cells == CellType::quadratic_triangle;
    check_mesh(list.blocks);
    if (is_mesh(parameters.file)) list.warnings = warnings_of_format(parameters.file, mesh);
  });
  return make_source_of_readers(handed_out(std::move(list), comm), comm);
}

}  // namespace voussoir
