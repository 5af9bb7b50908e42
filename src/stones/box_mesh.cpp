#include "stones/box_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "stones/box_cuts.hpp"
#include "stones/welded_points.hpp"

namespace voussoir {
namespace {

/// A stone as nodes of a lattice.
struct Lattice {
  std::array<std::vector<double>, 3> at;  ///< per direction, from 0 to 1
  int nodes(int d) const { return static_cast<int>(at[d].size()); }
  int node(int i, int j, int k) const { return (k * nodes(1) + j) * nodes(0) + i; }
  bool on_border(const std::array<int, 3>& n) const {
    for (int d = 0; d < 3; ++d)
      if (n[d] == 0 || n[d] == nodes(d) - 1) return true;
    return false;
  }
  template <class Visit>
  void for_each_node(Visit visit) const {
    for (int k = 0; k < nodes(2); ++k)
      for (int j = 0; j < nodes(1); ++j)
        for (int i = 0; i < nodes(0); ++i) visit(std::array<int, 3>{i, j, k});
  }
};

Lattice lattice_of(const CutBox& box, const std::array<std::vector<int>, 3>& cells) {
  Lattice lattice;
  for (int d = 0; d < 3; ++d) {
    const auto& cuts = box.cuts[d].at;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
      for (int i = 0; i < cells[d][k]; ++i)
        lattice.at[d].push_back(cuts[k] + (cuts[k + 1] - cuts[k]) * i / cells[d][k]);
    lattice.at[d].push_back(1);
  }
  return lattice;
}

void add_cells(const Lattice& lattice, Block<3>& block) {
  for (int k = 0; k + 1 < lattice.nodes(2); ++k)
    for (int j = 0; j + 1 < lattice.nodes(1); ++j)
      for (int i = 0; i + 1 < lattice.nodes(0); ++i) {
        Cell cell;
        cell.count = 8;
        for (std::size_t c = 0; c < 8; ++c)
          cell.node[c] = lattice.node(i + cube_corners[c][0], j + cube_corners[c][1], k + cube_corners[c][2]);
        block.cells.push_back(cell);
      }
}

/// Faces on the border, counter-clockwise from outside; `set` is 2 direction + end.
std::vector<TaggedFacet> border_of(const Lattice& lattice) {
  std::vector<TaggedFacet> faces;
  for (int d = 0; d < 3; ++d)
    for (int end = 0; end < 2; ++end) {
      const int u = (d + 1) % 3, v = (d + 2) % 3;
      for (int j = 0; j + 1 < lattice.nodes(v); ++j)
        for (int i = 0; i + 1 < lattice.nodes(u); ++i) {
          const auto node = [&](int a, int b) {
            std::array<int, 3> n{};
            n[d] = end ? lattice.nodes(d) - 1 : 0;
            n[u] = i + a, n[v] = j + b;
            return lattice.node(n[0], n[1], n[2]);
          };
          TaggedFacet face;
          face.count = 4;
          face.set = 2 * d + end;
          face.node = {node(0, 0), end ? node(1, 0) : node(0, 1), node(1, 1), end ? node(0, 1) : node(1, 0)};
          faces.push_back(face);
        }
    }
  return faces;
}

/// Gives each face the facet of the stone whose normal is nearest to that of its side.
void name_facets(const FacetedStone& stone, const Block<3>& block, std::vector<TaggedFacet>& faces) {
  std::array<int, 6> facet;
  facet.fill(-1);
  for (auto& face : faces) {
    int& known = facet[face.set];
    if (known < 0) {
      Places x;
      for (const int n : face.node) x.push_back(block.position[n]);
      const auto normal = area_vector(x);
      known = 0;
      for (int f = 1; f < static_cast<int>(stone.facets.size()); ++f)
        if (dot(stone.facets[f].normal, normal) > dot(stone.facets[known].normal, normal)) known = f;
    }
    face.set = known;
  }
}

/// Faces of all blocks by their vertices, ascending: the stones and places in their lists.
using FaceUses = std::map<std::array<VertexId, 4>, std::vector<std::pair<std::size_t, std::size_t>>>;

FaceUses uses_of(const BoxMeshes& meshes) {
  FaceUses uses;
  for (std::size_t k = 0; k < meshes.blocks.size(); ++k)
    for (std::size_t f = 0; f < meshes.free_faces[k].size(); ++f) {
      std::array<VertexId, 4> key;
      for (int i = 0; i < 4; ++i) key[i] = meshes.blocks[k].vertex[meshes.free_faces[k][f].node[i]];
      std::sort(key.begin(), key.end());
      uses[key].emplace_back(k, f);
    }
  return uses;
}

double area_of(const Block<3>& block, const TaggedFacet& face) {
  Places x;
  for (const int n : face.node) x.push_back(block.position[n]);
  return norm(area_vector(x));
}

/// Whether every two stones share the area of their joints: to a hundredth, since welded points tilt faces.
bool match(const StoneStructure& s, const BoxMeshes& meshes, const FaceUses& uses) {
  std::map<std::array<std::size_t, 2>, double> missing;  // [m2] of each pair of stones
  std::map<std::array<std::size_t, 2>, double> joint;
  for (std::size_t c = 0; c < s.imprint.cells.size(); ++c) {
    const int other = s.imprint.other[c];
    const auto k = static_cast<std::size_t>(s.imprint.cells[c].stone);
    if (other < static_cast<int>(c) || meshes.blocks[k].cells.empty()) continue;
    joint[{k, static_cast<std::size_t>(s.imprint.cells[other].stone)}] += s.imprint.cells[c].area;
  }
  missing = joint;
  for (const auto& [key, users] : uses) {
    if (users.size() > 2) return false;
    if (users.size() == 2)
      missing[{users[0].first, users[1].first}] -=
          area_of(meshes.blocks[users[0].first], meshes.free_faces[users[0].first][users[0].second]);
  }
  return std::all_of(missing.begin(), missing.end(),
                     [&](const auto& m) { return std::abs(m.second) <= 0.01 * joint[m.first]; });
}

/// Leaves the faces that one stone alone has.
void keep_free(BoxMeshes& meshes, const FaceUses& uses) {
  std::vector<std::vector<TaggedFacet>> kept(meshes.blocks.size());
  for (const auto& [key, users] : uses)
    if (users.size() == 1) kept[users[0].first].push_back(meshes.free_faces[users[0].first][users[0].second]);
  meshes.free_faces = std::move(kept);
}

}  // namespace

double volume_of_hexahedra(const Block<3>& block) {
  double sum = 0;
  for (const auto& cell : block.cells) {
    BoxShape shape;
    for (std::size_t c = 0; c < 8; ++c) shape.corner[c] = block.position[cell.node[c]];
    for (const auto& c : cube_corners)
      if (!(shape.jacobian({double(c[0]), double(c[1]), double(c[2])}) > 0)) return NAN;
    sum += shape.volume();
  }
  return sum;
}

BoxMeshes box_meshes(const StoneStructure& s) {
  const BoxCuts cuts(s);
  const auto cells = cuts.cells();
  BoxMeshes result;
  result.blocks.resize(s.stones.size());
  result.free_faces.resize(s.stones.size());
  WeldedPoints<3> border(std::min(s.weld, 0.1 * s.hexahedron_size));
  VertexId inside = 0;
  for (std::size_t k = 0; k < s.stones.size(); ++k) {
    if (!cuts[k]) continue;
    const auto lattice = lattice_of(*cuts[k], cells[k]);
    auto& block = result.blocks[k];
    lattice.for_each_node([&](const std::array<int, 3>& n) {
      const auto place = cuts[k]->shape.place({lattice.at[0][n[0]], lattice.at[1][n[1]], lattice.at[2][n[2]]});
      const bool shared = lattice.on_border(n);
      const int point = shared ? border.add(place) : -1;
      block.position.push_back(shared ? border.points()[point] : place);
      block.vertex.push_back(shared ? point : -1 - inside++);  // numbered behind those of the border below
    });
    add_cells(lattice, block);
    result.free_faces[k] = border_of(lattice);
    name_facets(s.faceted[k], block, result.free_faces[k]);
  }
  const auto on_border = static_cast<VertexId>(border.points().size());
  for (auto& block : result.blocks)
    for (auto& vertex : block.vertex)
      if (vertex < 0) vertex = on_border - 1 - vertex;
  result.vertices = on_border + inside;
  const auto uses = uses_of(result);
  bool whole = match(s, result, uses);
  for (const auto& block : result.blocks) whole = whole && std::isfinite(volume_of_hexahedra(block));
  if (!whole)
    return {std::vector<Block<3>>(s.stones.size()), std::vector<std::vector<TaggedFacet>>(s.stones.size()), 0};
  keep_free(result, uses);
  return result;
}

}  // namespace voussoir
