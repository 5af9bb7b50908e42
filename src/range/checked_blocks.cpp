#include "range/checked_blocks.hpp"

#include "base/error.hpp"
#include "drawings/drawing_source.hpp"
#include "dynamics/load_steps.hpp"
#include "mesh/block_source.hpp"
#include "mesh/mesh_check.hpp"
#include "model/phase.hpp"
#include "model/scene_fit.hpp"
#include "range/joint_sides.hpp"
#include "stones/stone_source.hpp"

namespace voussoir {
namespace {

template <int dim>
std::unique_ptr<BlockSource<dim>> blocks_of(const MeshParameters& mesh, const Teuchos::Comm<int>& comm, Trust trust) {
  if (mesh.type == MeshType::stones && mesh.dimension() == dim) {
    if constexpr (dim == 3) return read_stone_blocks(mesh.stones, comm, trust);
    if constexpr (dim == 2) return read_drawn_blocks(mesh.stones, comm);
  }
  return make_block_source<dim>(mesh, comm, trust);
}

}  // namespace

template <int dim>
std::unique_ptr<BlockSource<dim>> checked_blocks(const Scene& scene, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                                                 Trust trust) {
  Phase phase("mesh");
  std::unique_ptr<BlockSource<dim>> source;
  try {
    source = blocks_of<dim>(scene.mesh, *comm, trust);
    check_fit(scene, *source, *comm);
    check_sides(scene, *source, *comm);
    std::vector<FacetNames> supported;
    // Blocks may fly where no static equilibrium is sought: then no support is asked for.
    if (!only_time(scene.stages))
      for (const auto& [name, support] : scene.supports) supported.emplace_back(support.on, support.blocks);
    check_supports(*source, supported, *comm);
  } catch (const InputError& error) {
    std::string what = error.what();
    if (what.rfind(scene.file, 0) == 0) throw;
    const std::string mesh = "mesh: ";
    if (scene.mesh.from_file() && what.rfind(mesh, 0) == 0) {
      const bool stones = scene.mesh.type == MeshType::stones;
      what = std::string("mesh > ") + (stones ? "stones" : "gmsh") +
             " > file = " + (stones ? scene.mesh.stones.file : scene.mesh.gmsh.file) + "\n  " +
             what.substr(mesh.size());
    }
    // What may be wrong with the file is the more likely reason of what is wrong with the scene.
    if (source && !source->warnings().empty()) {
      what += "\n  The mesh is warned of too:";
      for (const auto& warning : source->warnings()) what += "\n    " + warning.text;
    }
    throw InputError(scene.file + ": " + what);
  }
  return source;
}

template std::unique_ptr<BlockSource<2>> checked_blocks(const Scene&, const Teuchos::RCP<const Teuchos::Comm<int>>&,
                                                        Trust);
template std::unique_ptr<BlockSource<3>> checked_blocks(const Scene&, const Teuchos::RCP<const Teuchos::Comm<int>>&,
                                                        Trust);

}  // namespace voussoir
