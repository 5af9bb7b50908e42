#include "mesh/block_source.hpp"

#include "linalg/agree.hpp"
#include "mesh/cell_count.hpp"
#include "mesh/generators.hpp"
#include "mesh/gmsh_reader.hpp"

namespace voussoir {

template <int dim>
std::unique_ptr<BlockSource<dim>> make_block_source(const MeshParameters& parameters, const Teuchos::Comm<int>& comm,
                                                    Trust trust) {
  static_assert(dim == 2, "there is no source of spatial blocks yet");
  on_first_rank(comm, [&] { refuse_too_many_cells(parameters); });  // machines of ranks may differ
  switch (parameters.type) {
    case MeshType::wall:
      return make_wall(parameters.wall);
    case MeshType::arch:
      return make_arch(parameters.arch);
    case MeshType::gmsh:
      break;
  }
  return read_gmsh(parameters.gmsh, comm, trust);
}

template std::unique_ptr<BlockSource<2>> make_block_source(const MeshParameters&, const Teuchos::Comm<int>&, Trust);

}  // namespace voussoir
