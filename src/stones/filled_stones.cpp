#include "stones/filled_stones.hpp"

#include <Teuchos_DefaultSerialComm.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "linalg/agree.hpp"
#include "linalg/reduce.hpp"
#include "mesh/alike_blocks.hpp"
#include "mesh/translates.hpp"
#include "stones/box_mesh.hpp"

namespace voussoir {
namespace {

double volume_of(const std::array<Vector<3>, 4>& x) { return dot(x[3] - x[0], cross(x[1] - x[0], x[2] - x[0])) / 6; }

/// [degree] the smallest angle between two faces of a tetrahedron.
double least_dihedral(const std::array<Vector<3>, 4>& x) {
  double least = 180;
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b) {  // the edge a - b, and the other two corners seen along it
      const int c = a == 0 ? (b == 1 ? 2 : 1) : 0, d = 6 - a - b - c;
      const auto edge = (1 / norm(x[b] - x[a])) * (x[b] - x[a]);
      const auto across = [&](int corner) {
        const auto to = x[corner] - x[a];
        return to - dot(to, edge) * edge;
      };
      const auto u = across(c), v = across(d);
      least =
          std::min(least, std::acos(std::clamp(dot(u, v) / (norm(u) * norm(v)), -1.0, 1.0)) * 180 / std::acos(-1.0));
    }
  return least;
}

double volume_inside(const ClosedMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += volume_of({mesh.nodes[0], mesh.nodes[t[0]], mesh.nodes[t[1]], mesh.nodes[t[2]]});
  return sum;
}

/// Whether the faces of cells that no other cell has are those of the surface.
bool keeps_surface(const FilledMesh& filled, const ClosedMesh& surface) {
  std::map<Triangle, int> uses;
  const auto key = [](Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  for (const auto& cell : filled.cells)
    for (int k = 0; k < 4; ++k) ++uses[key({cell[(k + 1) % 4], cell[(k + 2) % 4], cell[(k + 3) % 4]})];
  for (const auto& t : surface.triangles)
    if (--uses[key(t)] != 0) return false;
  return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 0 || use.second == 2; });
}

std::array<Vector<3>, 4> corners_of(const Tetrahedron& cell, const Places& nodes) {
  return {nodes[cell[0]], nodes[cell[1]], nodes[cell[2]], nodes[cell[3]]};
}

/// Turns cells to positive volumes, and looks whether they fill the stone. Returns what is wrong, or "".
std::string look_at(FilledMesh& filled, const ClosedMesh& surface, StoneMeshQuality& quality) {
  if (!filled.failure.empty()) return filled.failure;
  if (!keeps_surface(filled, surface)) return "gmsh changed its surface";
  auto nodes = surface.nodes;
  nodes.insert(nodes.end(), filled.inside.begin(), filled.inside.end());
  double sum = 0;
  for (auto& cell : filled.cells) {
    if (volume_of(corners_of(cell, nodes)) < 0) std::swap(cell[2], cell[3]);
    const auto corners = corners_of(cell, nodes);
    sum += volume_of(corners);
    const double angle = least_dihedral(corners);
    quality.least_dihedral = std::min(quality.least_dihedral, angle);
    if (angle < 5) ++quality.flat;
  }
  quality.nodes += nodes.size();
  quality.cells += filled.cells.size();
  quality.volume += sum;
  // Sums of thousands of products round to 1e-12; a cell that is missing or turned is 1e-6 of a stone and more.
  const double inside = volume_inside(surface);
  if (std::abs(sum - inside) > 1e-9 * inside)
    return "its cells fill " + six_digits(sum) + " m3 of " + six_digits(inside);
  return "";
}

/// Adds what is known of one stone to what is known of all.
void add(const StoneMeshQuality& stone, StoneMeshQuality& all) {
  all.least_dihedral = std::min(all.least_dihedral, stone.least_dihedral);
  all.flat += stone.flat;
  all.nodes += stone.nodes;
  all.cells += stone.cells;
  all.volume += stone.volume;
}

/// What the fillings of all shapes of a rank are: of one that fails, why.
struct Fillings {
  std::vector<FilledMesh> meshes;
  std::vector<StoneMeshQuality> quality;
  std::vector<std::string> fault;
};

Fillings fillings_of(const std::vector<ShellShape>& shapes, const SurfaceFiller& fill) {
  std::vector<ClosedMesh> surfaces;
  for (const auto& shape : shapes) surfaces.push_back(shape.surface);
  Fillings all;
  all.meshes = fill(surfaces);
  all.quality.resize(surfaces.size());
  for (std::size_t k = 0; k < surfaces.size(); ++k)
    all.fault.push_back(look_at(all.meshes[k], surfaces[k], all.quality[k]));
  return all;
}

/// Throws on every rank where one has stones whose shapes could not be filled. Collective.
void refuse_unfilled(const StoneShells& shells, const Fillings& fillings, const Teuchos::Comm<int>& comm) {
  std::vector<std::string> faults;
  for (std::size_t b = 0; b < shells.shape.size(); ++b)
    if (const int shape = shells.shape[b]; shape >= 0 && !fillings.fault[shape].empty())
      faults.push_back(shells.list.blocks[b].name + ": " + fillings.fault[shape]);
  const auto all = total_over_ranks(comm, static_cast<long long>(faults.size()));
  if (all == 0) return;
  constexpr std::size_t told = 5;
  std::string message = "mesh > stones: " + std::to_string(all) + " of " + counted(shells.stones, "stone") +
                        " cannot be filled with cells:";
  for (const auto& fault : first_texts(comm, faults, told)) message += "\n    " + fault;
  throw InputError(message + "\n  Try a larger weld where faces have very short edges, or a smaller element size.");
}

/// The first stone of a shape, filled, as those that have it become.
Block<3> model_of(const ShellShape& shape, const FilledMesh& mesh, const DrawnNumbers& drawn) {
  Block<3> model;
  model.position = shape.surface.nodes;
  model.position.insert(model.position.end(), mesh.inside.begin(), mesh.inside.end());
  for (const auto& cell : mesh.cells) model.cells.push_back({{cell[0], cell[1], cell[2], cell[3]}, 4});
  if (shape.is_shared) round_places(model, drawn);
  return model;
}

/// @param inside  vertex of the first node inside
/// @param order   per node of the surface of its shape its own
void fill_block(const Block<3>& model, bool is_shared, const DrawnNumbers& drawn, VertexId inside,
                std::vector<int> order, Block<3>& block) {
  for (auto n = order.size(); n < model.position.size(); ++n) {
    order.push_back(static_cast<int>(n));
    block.vertex.push_back(inside++);
  }
  block.position.resize(model.position.size());
  if (is_shared) return take_shape(model, order, drawn, block);
  block.position = model.position;
  block.cells = model.cells;
}

StoneMeshQuality over_ranks(const Teuchos::Comm<int>& comm, const StoneMeshQuality& mine) {
  auto all = mine;
  all.least_dihedral = least_over_ranks(comm, mine.least_dihedral);
  all.flat = total_over_ranks(comm, mine.flat);
  all.nodes = total_over_ranks(comm, mine.nodes);
  all.cells = total_over_ranks(comm, mine.cells);
  all.of_hexahedra = total_over_ranks(comm, mine.of_hexahedra);
  all.volume = total_over_ranks(comm, mine.volume);
  return all;
}

/// Of a block that has cells already.
void add_whole(const Block<3>& block, StoneMeshQuality& all) {
  ++all.of_hexahedra;
  all.nodes += static_cast<long long>(block.position.size());
  all.cells += static_cast<long long>(block.cells.size());
  all.volume += volume_of_hexahedra(block);
}

}  // namespace

StoneMeshes filled_stones(StoneShells shells, const Teuchos::Comm<int>& comm, const SurfaceFiller& fill) {
  Fillings fillings;
  agree(comm, [&] { fillings = fillings_of(shells.shapes, fill); });
  refuse_unfilled(shells, fillings, comm);
  const DrawnNumbers drawn(shells.largest);
  std::vector<Block<3>> models;
  for (std::size_t k = 0; k < shells.shapes.size(); ++k)
    models.push_back(model_of(shells.shapes[k], fillings.meshes[k], drawn));
  const auto inside_of = [&](int shape) {
    return shape < 0 ? 0 : static_cast<VertexId>(fillings.meshes[shape].inside.size());
  };
  VertexId inside = 0, until = 0;
  for (const int shape : shells.shape) inside += inside_of(shape);
  Teuchos::scan(comm, Teuchos::REDUCE_SUM, inside, Teuchos::outArg(until));
  VertexId next = shells.vertices + until - inside;
  StoneMeshes result;
  for (std::size_t b = 0; b < shells.shape.size(); ++b) {
    auto& block = shells.list.blocks[b];
    const int shape = shells.shape[b];
    if (shape < 0) {
      if (shells.are_meshed_here) add_whole(block, result.quality);
      continue;
    }
    fill_block(models[shape], shells.shapes[shape].is_shared, drawn, next, std::move(shells.order[b]), block);
    next += inside_of(shape);
    add(fillings.quality[shape], result.quality);
  }
  result.quality = over_ranks(comm, result.quality);
  result.quality.filled = shells.shapes_to_fill;
  result.list = std::move(shells.list);
  return result;
}

StoneMeshes mesh_stones(const StoneStructure& s) { return filled_stones(shells_of(s), Teuchos::SerialComm<int>()); }

}  // namespace voussoir
