#include "stones/stone_source.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "mesh/alike_blocks.hpp"
#include "mesh/msh_format.hpp"
#include "stones/cell_mesh.hpp"
#include "stones/gmsh_volumes.hpp"
#include "stones/stone_files.hpp"
#include "stones/volume_blocks.hpp"

namespace voussoir {
namespace {

std::string of_meshes(const StoneMeshQuality& q, std::size_t stones) {
  std::string line = counted(q.of_hexahedra, "stone") + " of hexahedra, " +
                     std::to_string(stones - static_cast<std::size_t>(q.of_hexahedra)) + " of tetrahedra" +
                     (q.filled > 0 ? " (" + counted(q.filled, "shape") + " filled)" : "") + ": " +
                     counted(q.nodes, "node") + ", " + counted(q.cells, "cell") + ", " + six_digits(q.volume) + " m3";
  if (q.of_hexahedra < static_cast<int>(stones))
    line += "; least angle between faces of a tetrahedron " + six_digits(q.least_dihedral) + " degrees, " +
            counted(q.flat, "cell") + " below 5";
  return line;
}

/// What is said of blocks that are alike.
std::string of_shapes(int shapes, std::size_t stones) {
  const bool none = static_cast<std::size_t>(shapes) == stones;
  return counted(stones, "stone") + ", " + counted(shapes, "shape") +
         (none ? "" : ": those that are drawn alike and cut alike by their joints have one mesh");
}

BlockList<3> meshed_stones(StoneStructure structure, const PieceMesher& mesher) {
  auto meshes = mesh_stones(structure, mesher);
  auto list = std::move(meshes.list);
  list.report = std::move(structure.report);
  list.report.push_back(of_meshes(meshes.quality, structure.stones.size()));
  return list;
}

bool all_tetrahedra(const VolumeMesh& mesh) {
  for (const auto& volume : mesh.volumes)
    for (const auto& cell : volume.cells)
      if (cell.count != 4) return false;
  return true;
}

/// Volumes of gmsh whose cells are not kept, from their outlines.
BlockList<3> meshed_anew(VolumeMesh mesh, const StonesParameters& p, Trust trust, const std::string& origin,
                         const PieceMesher& mesher) {
  if (!is_mesh(p.file)) {
    mesh = read_volumes(p, VolumesAs::outlined, trust);
    turn_up(p.up, mesh.position);
  }
  auto structure = structure_of(surfaces_of(mesh, origin), p);
  if (structure.stones.size() != mesh.volumes.size())
    throw InputError("mesh: a volume is in pieces\n  (" + list_of(structure.report, 1) +
                     ").\n  Make each piece a volume of its own.");
  const double within = std::max(structure.tolerance, structure.weld);
  auto list = meshed_stones(std::move(structure), mesher);
  for (std::size_t k = 0; k < list.blocks.size(); ++k) list.blocks[k].name = mesh.name_of(k);
  add_sets_of_file(mesh, within, list);
  return list;
}

BlockList<3> blocks_of_volumes(const StonesParameters& p, Trust trust, const PieceMesher& mesher) {
  const auto origin = std::filesystem::path(p.file).filename().string();
  auto mesh = read_volumes(p, VolumesAs::meshed, trust);
  turn_up(p.up, mesh.position);
  const int turned = find_borders(mesh);
  const bool asked =
      (is_mesh(p.file) && p.element_size > 0) || (p.cells == StoneCells::tetrahedra && !all_tetrahedra(mesh));
  std::string anew = "other cells are asked for than the file has";
  BlockList<3> list;
  if (!asked) {
    const auto stones = surfaces_of(mesh, origin);
    auto kept = blocks_as_meshed(mesh, stones, tolerance_of(stones, p));
    anew = kept.unmatched;
    list = std::move(kept.list);
    if (anew.empty()) add_sets_of_file(mesh, kept.within, list);
  }
  if (!anew.empty()) {
    list = meshed_anew(std::move(mesh), p, trust, origin, mesher);
    list.report.insert(list.report.begin(), "volumes are meshed anew: " + anew);
  }
  if (turned > 0)
    add_warning(list.warnings,
                {"volumes_turned", "mesh > stones", "", static_cast<double>(turned),
                 counted(turned, "volume has", "volumes have") + " cells that are inside out, all of them; they are "
                                                                 "turned, look whether these stones are as meant"});
  return list;
}

}  // namespace

std::unique_ptr<BlockSource<3>> read_stone_blocks(const StonesParameters& p, const Teuchos::Comm<int>& comm,
                                                  Trust trust) {
  BlockList<3> list;
  on_first_rank_meshed_by_all(comm, [&](const PieceMesher& mesher) {
    list = is_of_gmsh(p.file) ? blocks_of_volumes(p, trust, mesher) : meshed_stones(structure_of(p), mesher);
    list.quadratic = p.element == StoneElement::quadratic;
    list.report.push_back(of_shapes(make_alike_equal(list.blocks), list.blocks.size()));
  });
  return make_source_on_first(std::move(list), comm);
}

}  // namespace voussoir
