#include "mesh/block_source.hpp"

#include "base/check.hpp"
#include "linalg/agree.hpp"
#include "mesh/cell_count.hpp"
#include "mesh/curved_edges.hpp"
#include "mesh/generators.hpp"
#include "mesh/gmsh_reader.hpp"
#include "mesh/lattice.hpp"

namespace voussoir {

template <int dim>
std::unique_ptr<BlockSource<dim>> make_block_source(const MeshParameters& parameters, const Teuchos::Comm<int>& comm,
                                                    Trust trust) {
  if (parameters.dimension() != dim)
    refuse_mesh(
        "type", '"' + parameters.word() + '"',
        std::string("is asked of something that takes blocks ") + (dim == 2 ? "of the plane" : "in space") + " alone.",
        "Give another mesh.");
  on_first_rank(comm, [&] { refuse_too_many_cells(parameters); });  // machines of ranks may differ
  if constexpr (dim == 3) {
    VOUSSOIR_CHECK(parameters.type != MeshType::stones);  // which stones/ reads
    if (parameters.type == MeshType::prism) return make_prism(parameters.prism);
    if (parameters.type == MeshType::dome) return make_dome(parameters.dome);
    if (parameters.type == MeshType::barrel_vault) return make_barrel_vault(parameters.barrel_vault);
    return make_wall_in_space(parameters.wall_in_space);
  } else {
    VOUSSOIR_CHECK(parameters.type != MeshType::stones);  // which drawings/ reads
    if (parameters.type == MeshType::gmsh) return read_gmsh(parameters.gmsh, comm, trust);
    auto source = parameters.type == MeshType::wall ? make_wall(parameters.wall) : make_arch(parameters.arch);
    return parameters.has_quadratic_triangles() ? with_curved_edges(std::move(source)) : std::move(source);
  }
}

template std::unique_ptr<BlockSource<2>> make_block_source(const MeshParameters&, const Teuchos::Comm<int>&, Trust);
template std::unique_ptr<BlockSource<3>> make_block_source(const MeshParameters&, const Teuchos::Comm<int>&, Trust);

}  // namespace voussoir
