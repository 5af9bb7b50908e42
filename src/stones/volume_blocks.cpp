#include "stones/volume_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "mesh/border.hpp"
#include "mesh/surface_mesh.hpp"
#include "stones/welded_points.hpp"

namespace voussoir {
namespace {

using Pair = std::array<int, 2>;

// Of the area that two stones share, which may lack node to node: slivers at corners of joints.
constexpr double nearly_all = 1e-3;

/// [m] The distance at which nodes are one, as in the plane (mesh/surface_mesh.hpp), by the shortest edge of all.
double distance_of_one(const VolumeMesh& mesh) {
  double shortest = std::numeric_limits<double>::infinity(), far = 0;
  for (const auto& volume : mesh.volumes)
    for (const auto& face : volume.border)
      for (int k = 0; k < face.count; ++k) {
        const auto &a = mesh.position[face.node[k]], &b = mesh.position[face.node[(k + 1) % face.count]];
        shortest = std::min(shortest, norm(b - a));
        far = std::max(far, norm(a));
      }
  return std::max(coincidence * shortest, std::min(coincidence_far * far, farthest_coincidence * shortest));
}

/// A block for each volume, with places of vertices.
std::vector<Block<3>> blocks_of(const VolumeMesh& mesh, double within) {
  WeldedPoints<3> welded(within);
  std::vector<Block<3>> blocks(mesh.volumes.size());
  for (std::size_t v = 0; v < blocks.size(); ++v) {
    auto& block = blocks[v];
    block.id = static_cast<BlockId>(v);
    block.name = mesh.name_of(v);
    block.cells = mesh.volumes[v].cells;
    std::vector<int> nodes;
    for (const auto& cell : block.cells) nodes.insert(nodes.end(), cell.node.begin(), cell.node.begin() + cell.count);
    sort_unique(nodes);
    std::set<VertexId> known;
    for (const int node : nodes) {
      const int vertex = welded.add(mesh.position[node]);
      if (!known.insert(vertex).second)
        throw InputError("mesh: " + block.name + " has two nodes at " + place_in_words(mesh.position[node]) +
                         "\n  (a slit in it, or faces that do not hang together, which would be one).\n  Make one node "
                         "of them, or two volumes of the stone.");
      block.vertex.push_back(vertex);
      block.position.push_back(welded.points()[vertex]);
    }
    for (const int fold : mesh.folds)
      if (const auto n = std::lower_bound(nodes.begin(), nodes.end(), fold); n != nodes.end() && *n == fold)
        block.folds.push_back(static_cast<int>(n - nodes.begin()));
    sort_unique(block.folds);
    for (auto& cell : block.cells)
      for (int k = 0; k < cell.count; ++k)
        cell.node[k] = static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), cell.node[k]) - nodes.begin());
  }
  return blocks;
}

Places corners_of(const Block<3>& block, const BorderFace& face) {
  Places corners;
  for (std::size_t k = 0; k < face.node.size(); ++k)
    if (k < 3 || face.node[k] != face.node[2]) corners.push_back(block.position[face.node[k]]);
  return corners;
}

/// Borders of all blocks: what is free, and what two of them share.
class Borders {
 public:
  explicit Borders(const std::vector<Block<3>>& blocks) : blocks_(blocks) {
    const auto faces = border_facets(blocks);
    for (std::size_t from = 0, to = 0; from < faces.size(); from = to) {
      while (to < faces.size() && faces[to].vertices == faces[from].vertices) ++to;
      if (to == from + 1) {
        free_.push_back(faces[from]);
        continue;
      }
      const auto& one = faces[from];
      const auto &a = blocks[one.block], &b = blocks[faces[from + 1].block];
      const auto corners = corners_of(a, one);
      if (to > from + 2)
        refuse(a, b, mean(corners), "and " + blocks[faces[from + 2].block].name + " have a face in common",
               "(a face has two sides)");
      const auto across = area_vector(corners);
      if (dot(across, area_vector(corners_of(b, faces[from + 1]))) > 0)
        refuse(a, b, mean(corners), "lie on the same side of a face", "(they overlap there)");
      shared_[{one.block, faces[from + 1].block}] += norm(across);
    }
  }
  const std::vector<BorderFace>& free() const { return free_; }
  const std::map<Pair, double>& shared() const { return shared_; }  ///< [m2] by blocks, the lower number first

 private:
  [[noreturn]] static void refuse(const Block<3>& a, const Block<3>& b, const Vector<3>& place,
                                  const std::string& fault, const std::string& why) {
    throw InputError("mesh: " + a.name + " and " + b.name + " " + fault + " at " + place_in_words(place) + "\n  " +
                     why + ".\n  Look whether a volume is there twice or misplaced.");
  }

  const std::vector<Block<3>>& blocks_;
  std::vector<BorderFace> free_;
  std::map<Pair, double> shared_;
};

/// Stones that touch, by plane facets that face each other, over more than they share node to node; "" for none.
std::string unmatched_of(const std::vector<StoneSurface>& stones, double tolerance,
                         const std::map<Pair, double>& shared) {
  std::map<Pair, double> touching;
  const auto faceted = facets_of(stones, tolerance);
  for (const auto& joint : find_joints(faceted, tolerance).joints) touching[joint.stone] += joint.area;
  for (const auto& [pair, area] : touching) {
    const auto known = shared.find(pair);
    const double matched = known == shared.end() ? 0 : known->second;
    if (area - matched <= nearly_all * area) continue;
    return in_words(stones[pair[0]]) + " and " + in_words(stones[pair[1]]) + " touch over " + six_digits(area) +
           " m2, of which " + six_digits(matched) + " m2 match node to node";
  }
  return "";
}

/// "base", "top" and "faces", as of other stones.
void add_faces(const Borders& borders, BlockList<3>& list) {
  list.facet_sets = {"base", "top", "faces"};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::vector<std::array<double, 2>> heights;
  for (const auto& block : list.blocks) {
    heights.push_back({block.position[0][2], block.position[0][2]});
    for (const auto& x : block.position) {
      heights.back()[0] = std::min(heights.back()[0], x[2]);
      heights.back()[1] = std::max(heights.back()[1], x[2]);
    }
    low = std::min(low, heights.back()[0]);
    high = std::max(high, heights.back()[1]);
  }
  const auto add = [&](const BorderFace& face, int set) {
    list.blocks[face.block].facets.push_back({face.node, face.node[3] == face.node[2] ? 3 : 4, set});
  };
  const double near = 0.01 * (high - low), steep = std::sqrt(0.5);
  for (const auto& face : borders.free()) {
    const auto across = area_vector(corners_of(list.blocks[face.block], face));
    const double up = across[2] / norm(across);
    if (up < -steep && heights[face.block][0] <= low + near)
      add(face, 0);
    else if (up > steep && heights[face.block][1] >= high - near)
      add(face, 1);
  }
  for (const auto& face : border_facets(list.blocks)) add(face, 2);
}

void add_stones(const std::vector<StoneSurface>& stones, const std::map<Pair, double>& shared, BlockList<3>& list) {
  std::vector<int> neighbours(stones.size(), 0);
  for (const auto& [pair, area] : shared) ++neighbours[pair[0]], ++neighbours[pair[1]];
  std::vector<std::string> alone;
  for (std::size_t k = 0; k < stones.size(); ++k) {
    list.blocks[k].sets.push_back(static_cast<int>(list.block_sets.size()));
    list.block_sets.push_back(stones[k].name);
    if (neighbours[k] == 0) alone.push_back(stones[k].name);
  }
  const int single = static_cast<int>(list.block_sets.size());
  bool any = false;
  for (std::size_t k = 0; k < stones.size(); ++k)
    if (neighbours[k] == 1) list.blocks[k].sets.push_back(single), any = true;
  if (any) list.block_sets.push_back("one neighbour");
  if (alone.empty() || stones.size() == 1) return;
  add_warning(list.warnings, {"stones_without_joint", "mesh > stones", "", static_cast<double>(alone.size()),
                              counted(alone.size(), "stone shares", "stones share") + " no joint with another (" +
                                  list_of(alone, 5) + "): look whether they are meant to touch"});
}

void tell(const std::vector<StoneSurface>& stones, const std::map<Pair, double>& shared, BlockList<3>& list) {
  std::size_t nodes = 0, cells = 0, tetrahedra = 0;
  double inside = 0, common = 0;
  for (const auto& block : list.blocks) {
    nodes += block.position.size();
    cells += block.cells.size();
    for (const auto& cell : block.cells) tetrahedra += cell.count == 4;
  }
  for (const auto& stone : stones) inside += volume(stone);
  for (const auto& [pair, area] : shared) common += area;
  list.report.push_back(counted(stones.size(), "volume") + " as the file has them meshed: " + counted(nodes, "node") +
                        ", " + counted(tetrahedra, "tetrahedron", "tetrahedra") + ", " +
                        counted(cells - tetrahedra, "hexahedron", "hexahedra") + ", " + six_digits(inside) + " m3");
  list.report.push_back(counted(shared.size(), "pair of stones shares", "pairs of stones share") + " " +
                        six_digits(common) + " m2, node to node");
}

}  // namespace

VolumeBlocks blocks_as_meshed(const VolumeMesh& mesh, const std::vector<StoneSurface>& stones, double tolerance) {
  VolumeBlocks result;
  result.within = distance_of_one(mesh);
  result.list.blocks = blocks_of(mesh, result.within);
  const Borders borders(result.list.blocks);
  refuse_overlaps(stones, tolerance);
  result.unmatched = unmatched_of(stones, tolerance, borders.shared());
  if (!result.unmatched.empty()) return result;
  add_faces(borders, result.list);
  add_stones(stones, borders.shared(), result.list);
  tell(stones, borders.shared(), result.list);
  return result;
}

}  // namespace voussoir
