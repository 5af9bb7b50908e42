#include "stones/stone_source.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "mesh/msh_format.hpp"
#include "mesh/read_blocks.hpp"
#include "stones/filled_stones.hpp"
#include "stones/gmsh_volumes.hpp"
#include "stones/stone_files.hpp"
#include "stones/volume_blocks.hpp"

namespace voussoir {
namespace {

std::string of_meshes(const StoneMeshQuality& q, long long stones) {
  std::string line = counted(q.of_hexahedra, "stone") + " of hexahedra, " + std::to_string(stones - q.of_hexahedra) +
                     " of tetrahedra" + (q.filled > 0 ? " (" + counted(q.filled, "shape") + " filled)" : "") + ": " +
                     counted(q.nodes, "node") + ", " + counted(q.cells, "cell") + ", " + six_digits(q.volume) + " m3";
  if (q.of_hexahedra < stones)
    line += "; least angle between faces of a tetrahedron " + six_digits(q.least_dihedral) + " degrees, " +
            counted(q.flat, "cell") + " below 5";
  return line;
}

/// What is said of blocks that are alike.
std::string of_shapes(int shapes, long long stones) {
  const bool none = shapes == stones;
  return counted(stones, "stone") + ", " + counted(shapes, "shape") +
         (none ? "" : ": those that are drawn alike and cut alike by their joints have one mesh");
}

bool all_tetrahedra(const VolumeMesh& mesh) {
  for (const auto& volume : mesh.volumes)
    for (const auto& cell : volume.cells)
      if (cell.count != 4) return false;
  return true;
}

/// Volumes of gmsh whose cells are not kept, from their outlines.
StoneShells outlined(VolumeMesh mesh, const StonesParameters& p, Trust trust, const std::string& origin,
                     const PolygonMesher& mesher) {
  if (!is_mesh(p.file)) {
    mesh = read_volumes(p, VolumesAs::outlined, trust);
    turn_up(p.up, mesh.position);
  }
  auto structure = structure_of(surfaces_of(mesh, origin), p);
  if (structure.stones.size() != mesh.volumes.size())
    throw InputError("mesh: a volume is in pieces\n  (" + list_of(structure.report, 1) +
                     ").\n  Make each piece a volume of its own.");
  const double within = std::max(structure.tolerance, structure.weld);
  auto shells = shells_of(structure, mesher);
  auto& blocks = shells.list.blocks;
  for (std::size_t k = 0; k < blocks.size(); ++k) blocks[k].name = mesh.name_of(k);
  add_sets_of_file(mesh, within, shells.list);
  return shells;
}

StoneShells shells_of_volumes(const StonesParameters& p, Trust trust, const PolygonMesher& mesher) {
  const auto origin = std::filesystem::path(p.file).filename().string();
  auto mesh = read_volumes(p, VolumesAs::meshed, trust);
  turn_up(p.up, mesh.position);
  const int turned = find_borders(mesh);
  const bool asked =
      (is_mesh(p.file) && p.element_size > 0) || (p.cells == StoneCells::tetrahedra && !all_tetrahedra(mesh));
  std::string anew = "other cells are asked for than the file has";
  StoneShells shells;
  if (!asked) {
    const auto stones = surfaces_of(mesh, origin);
    auto kept = blocks_as_meshed(mesh, stones, tolerance_of(stones, p));
    anew = kept.unmatched;
    if (anew.empty()) add_sets_of_file(mesh, kept.within, kept.list);
    shells = shells_of(std::move(kept.list));
  }
  if (!anew.empty()) {
    shells = outlined(std::move(mesh), p, trust, origin, mesher);
    shells.list.report.insert(shells.list.report.begin(), "volumes are meshed anew: " + anew);
  }
  if (turned > 0)
    add_warning(shells.list.warnings,
                {"volumes_turned", "mesh > stones", "", static_cast<double>(turned),
                 counted(turned, "volume has", "volumes have") + " cells that are inside out, all of them; they are "
                                                                 "turned, look whether these stones are as meant"});
  return shells;
}

}  // namespace

std::unique_ptr<BlockSource<3>> read_stone_blocks(const StonesParameters& p, const Teuchos::Comm<int>& comm,
                                                  Trust trust) {
  StoneShells shells;
  on_first_rank_meshed_by_all(comm, [&](const PolygonMesher& mesher) {
    shells = is_of_gmsh(p.file) ? shells_of_volumes(p, trust, mesher) : shells_of(structure_of(p), mesher);
    shells.list.quadratic = p.element == StoneElement::quadratic;
    make_alike_equal(shells);
  });
  shells = handed_out(std::move(shells), comm);
  const auto stones = shells.stones;
  const int shapes = shells.shapes_to_fill + shells.whole_shapes;
  const bool meshed_here = shells.are_meshed_here;
  auto meshes = filled_stones(std::move(shells), comm);
  auto& report = meshes.list.report;
  if (meshed_here) report.push_back(of_meshes(meshes.quality, stones));
  report.push_back(of_shapes(shapes, stones));
  return make_source_of_readers(std::move(meshes.list), comm);
}

}  // namespace voussoir
