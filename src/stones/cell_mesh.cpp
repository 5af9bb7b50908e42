#include "stones/cell_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "mesh/border.hpp"
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

/// The surface mesh of one stone, and what its nodes are among those of all.
struct StoneSkin {
  ClosedMesh mesh;
  std::vector<int> nodes;
};

std::vector<StoneSkin> skins_of_stones(const StoneStructure& s, const Skins& skins) {
  std::vector<StoneSkin> stones(s.stones.size());
  for (std::size_t c = 0; c < s.imprint.cells.size(); ++c) {
    auto& mesh = stones[s.imprint.cells[c].stone].mesh;
    mesh.triangles.insert(mesh.triangles.end(), skins.triangles[c].begin(), skins.triangles[c].end());
  }
  for (auto& stone : stones) {
    for (const auto& t : stone.mesh.triangles) stone.nodes.insert(stone.nodes.end(), t.begin(), t.end());
    sort_unique(stone.nodes);
    stone.mesh.nodes = places_of(skins.nodes, stone.nodes);
    stone.mesh.size = s.tetrahedron_size;
    for (auto& t : stone.mesh.triangles)
      for (int& node : t)
        node = static_cast<int>(std::lower_bound(stone.nodes.begin(), stone.nodes.end(), node) - stone.nodes.begin());
  }
  return stones;
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

/// Sets of blocks by the stones that are in them.
void add_sets(const StoneStructure& s, BlockList<3>& list) {
  std::map<std::string, int> number;
  const auto add = [&](const std::string& name, std::size_t stone) {
    const auto [known, is_new] = number.emplace(name, static_cast<int>(list.block_sets.size()));
    if (is_new) list.block_sets.push_back(name);
    list.blocks[stone].sets.push_back(known->second);
  };
  for (std::size_t k = 0; k < s.stones.size(); ++k) add(s.stones[k].name, k);
  for (std::size_t k = 0; k < s.stones.size(); ++k)
    if (s.stones[k].support) add("supports", k);
  std::vector<std::set<int>> neighbours(s.stones.size());
  for (const auto& joint : s.joints.joints)
    for (int side = 0; side < 2; ++side) neighbours[joint.stone[side]].insert(joint.stone[1 - side]);
  for (std::size_t k = 0; k < neighbours.size(); ++k)
    if (neighbours[k].size() == 1) add("one neighbour", k);
  for (auto& block : list.blocks) sort_unique(block.sets);
}

/// Free faces that look down, of the lowest stones, and those that look up, of the highest.
class Ends {
 public:
  explicit Ends(const StoneStructure& s) : s_(s) {
    low_ = s.faceted[0].box.low[2], high_ = s.faceted[0].box.high[2];
    for (const auto& stone : s.faceted) {
      low_ = std::min(low_, stone.box.low[2]);
      high_ = std::max(high_, stone.box.high[2]);
    }
  }
  /// Adds a free face to the block of its stone where it is of one of them. @param face  `set` is its facet
  void add(TaggedFacet face, int stone, BlockList<3>& list) const {
    const auto& box = s_.faceted[stone].box;
    const double steep = std::sqrt(0.5), up = s_.faceted[stone].facets[face.set].normal[2],
                 near = 0.01 * (high_ - low_);
    if (up < -steep && box.low[2] <= low_ + near)
      face.set = 0;
    else if (up > steep && box.high[2] >= high_ - near)
      face.set = 1;
    else
      return;
    list.blocks[stone].facets.push_back(face);
  }

 private:
  const StoneStructure& s_;
  double low_, high_;
};

/// @param nodes  of its stone, ascending
TaggedFacet facet_of(const Triangle& t, const std::vector<int>& nodes, int set) {
  TaggedFacet facet;
  facet.count = 3;
  facet.set = set;
  for (int k = 0; k < 3; ++k)
    facet.node[k] = static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), t[k]) - nodes.begin());
  facet.node[3] = facet.node[2];  // a quadrilateral with two corners in one place has the integrals of the triangle
  return facet;
}

void add_free_triangles(const StoneStructure& s, const Skins& skins, const std::vector<StoneSkin>& stones,
                        const Ends& ends, BlockList<3>& list) {
  for (std::size_t c = 0; c < s.imprint.cells.size(); ++c) {
    if (s.imprint.other[c] >= 0) continue;
    const auto& nodes = stones[s.imprint.cells[c].stone].nodes;
    for (const auto& t : skins.triangles[c])
      ends.add(facet_of(t, nodes, s.imprint.cells[c].facet), s.imprint.cells[c].stone, list);
  }
}

/// Per joint which part it is of what its two stones share: joints whose planes are within 5 degrees of each other,
/// directly or through others, are one, as facets of something curved are. -1 where the stones share one part.
std::vector<int> parts_of_joints(const StoneJoints& all) {
  std::vector<int> part(all.joints.size(), -1);
  std::map<std::array<int, 2>, std::vector<std::size_t>> of_pair;
  for (std::size_t k = 0; k < all.joints.size(); ++k) of_pair[all.joints[k].stone].push_back(k);
  int parts = 0;
  for (const auto& [pair, joints] : of_pair) {
    const int before = parts;
    for (const auto first : joints) {
      if (part[first] >= 0) continue;
      part[first] = parts++;
      for (std::vector<std::size_t> next{first}; !next.empty();) {
        const auto k = next.back();
        next.pop_back();
        for (const auto j : joints) {
          if (part[j] >= 0 || dot(all.joints[k].normal, all.joints[j].normal) < opposed) continue;
          part[j] = part[k];
          next.push_back(j);
        }
      }
    }
    if (parts == before + 1)
      for (const auto k : joints) part[k] = -1;
  }
  return part;
}

/// Folds of joints that are drawn: where parts of them meet.
void add_folds(const StoneStructure& s, const Skins& skins, const std::vector<StoneSkin>& stones, BlockList<3>& list) {
  const auto part = parts_of_joints(s.joints);
  std::vector<std::map<int, int>> part_of_node(list.blocks.size());
  for (std::size_t c = 0; c < s.imprint.cells.size(); ++c) {
    const auto& cell = s.imprint.cells[c];
    if (s.imprint.other[c] < 0 || cell.joint < 0 || part[cell.joint] < 0) continue;
    for (const auto& t : skins.triangles[c])
      for (const int node : facet_of(t, stones[cell.stone].nodes, 0).node)
        if (const auto at = part_of_node[cell.stone].insert({node, part[cell.joint]}).first;
            at->second != part[cell.joint])
          list.blocks[cell.stone].folds.push_back(node);
  }
  for (auto& block : list.blocks) sort_unique(block.folds);
}

/// The set "faces".
void add_all_faces(Block<3>& block) {
  for (const auto& face : border_facets<3>({block}))
    block.facets.push_back({face.node, face.node[3] == face.node[2] ? 3 : 4, 2});
}

[[noreturn]] void refuse_unfilled(const std::vector<std::string>& faults, std::size_t stones) {
  std::string message = "mesh > stones: " + std::to_string(faults.size()) + " of " + counted(stones, "stone") +
                        " cannot be filled with cells:";
  for (std::size_t k = 0; k < std::min<std::size_t>(faults.size(), 5); ++k) message += "\n    " + faults[k];
  throw InputError(message + "\n  Try a larger weld where faces have very short edges, or a smaller element size.");
}

/// The surfaces of some stones, each that is a translate of another by the number of the first.
struct SurfacesToFill {
  std::vector<ClosedMesh> first;          ///< of each shape
  std::vector<std::size_t> stones;        ///< that are filled, ascending
  std::vector<Translates::Match> shapes;  ///< of these stones
};

SurfacesToFill surfaces_to_fill(const std::vector<StoneSkin>& stones, const std::vector<char>& wanted, double largest) {
  SurfacesToFill surfaces;
  Translates shapes(DrawnNumbers(largest).within());
  for (std::size_t k = 0; k < stones.size(); ++k) {
    if (!wanted[k]) continue;
    const auto& mesh = stones[k].mesh;
    std::vector<int> corners;
    for (const auto& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
    surfaces.stones.push_back(k);
    surfaces.shapes.push_back(shapes.add(mesh.nodes, 3, corners));
    if (surfaces.shapes.back().is_first) surfaces.first.push_back(mesh);
  }
  return surfaces;
}

/// What fills a stone moved to one that is like it.
/// @param order  per node of the first one that of the surface
void add_cells(const FilledMesh& mesh, const ClosedMesh& first, const ClosedMesh& surface,
               const std::vector<int>& order, Block<3>& block) {
  const auto by = surface.nodes[order[0]] - first.nodes[0];
  block.position = surface.nodes;
  for (const auto& x : mesh.inside) block.position.push_back(x + by);
  const auto on_surface = static_cast<int>(order.size());
  for (const auto& cell : mesh.cells) {
    block.cells.push_back({{cell[0], cell[1], cell[2], cell[3]}, 4});
    for (int k = 0; k < 4; ++k)
      if (int& node = block.cells.back().node[k]; node < on_surface) node = order[node];
  }
}

/// Fills all stones without cells with tetrahedra, and adds their free faces.
void add_tetrahedra(const StoneStructure& s, const PieceMesher& mesher, VertexId vertex, const Ends& ends,
                    StoneMeshes& result) {
  std::vector<char> wanted;
  for (const auto& block : result.list.blocks) wanted.push_back(block.cells.empty());
  const auto skins = skins_of(s, wanted, mesher);
  const auto stones = skins_of_stones(s, skins);
  const auto surfaces = surfaces_to_fill(stones, wanted, largest_coordinate(skins.nodes));
  auto meshes = mesher.surfaces(surfaces.first);
  result.quality.filled = static_cast<int>(meshes.size());
  std::vector<StoneMeshQuality> quality(meshes.size());
  std::vector<std::string> fault, faults;
  for (std::size_t m = 0; m < meshes.size(); ++m) fault.push_back(look_at(meshes[m], surfaces.first[m], quality[m]));
  VertexId inside = vertex + static_cast<VertexId>(skins.nodes.size());
  for (std::size_t i = 0; i < surfaces.stones.size(); ++i) {
    const auto k = surfaces.stones[i];
    const int m = surfaces.shapes[i].shape;
    if (!fault[m].empty()) {
      faults.push_back(in_words(s.stones[k]) + ": " + fault[m]);
      continue;
    }
    add(quality[m], result.quality);
    auto& block = result.list.blocks[k];
    add_cells(meshes[m], surfaces.first[m], stones[k].mesh, surfaces.shapes[i].order, block);
    for (const int node : stones[k].nodes) block.vertex.push_back(vertex + node);
    for (std::size_t n = 0; n < meshes[m].inside.size(); ++n) block.vertex.push_back(inside++);
  }
  if (!faults.empty()) refuse_unfilled(faults, stones.size());
  add_free_triangles(s, skins, stones, ends, result.list);
  add_folds(s, skins, stones, result.list);
}

}  // namespace

StoneMeshes mesh_stones(const StoneStructure& s, const PieceMesher& mesher) {
  StoneMeshes result;
  result.list.facet_sets = {"base", "top", "faces"};
  result.list.warnings = s.warnings;
  const Ends ends(s);
  BoxMeshes boxes;
  boxes.blocks.resize(s.stones.size());
  if (s.cells == StoneCells::by_shape) boxes = box_meshes(s);
  result.list.blocks = std::move(boxes.blocks);
  for (std::size_t k = 0; k < s.stones.size(); ++k) {
    auto& block = result.list.blocks[k];
    block.id = static_cast<BlockId>(k);
    block.name = "stone " + s.stones[k].name;
    if (block.cells.empty()) continue;
    ++result.quality.of_hexahedra;
    result.quality.nodes += block.position.size();
    result.quality.cells += block.cells.size();
    result.quality.volume += volume_of_hexahedra(block);
    for (const auto& face : boxes.free_faces[k]) ends.add(face, static_cast<int>(k), result.list);
  }
  add_tetrahedra(s, mesher, boxes.vertices, ends, result);
  for (auto& block : result.list.blocks) add_all_faces(block);
  add_sets(s, result.list);
  return result;
}

}  // namespace voussoir
