#include "stones/stone_shells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/sort_unique.hpp"
#include "mesh/alike_blocks.hpp"
#include "mesh/block_bytes.hpp"
#include "mesh/border.hpp"
#include "mesh/read_blocks.hpp"
#include "mesh/translates.hpp"
#include "stones/box_mesh.hpp"
#include "stones/gmsh_pieces.hpp"
#include "stones/skins.hpp"

namespace voussoir {
namespace {

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

/// The set "faces" of a block with cells.
void add_all_faces(Block<3>& block) {
  for (const auto& face : border_facets<3>({block}))
    block.facets.push_back({face.node, face.node[3] == face.node[2] ? 3 : 4, 2});
}

/// The same of one whose surface is all there is of it.
void add_all_faces(const ClosedMesh& surface, Block<3>& block) {
  auto triangles = surface.triangles;
  const auto ascending = [](Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  std::sort(triangles.begin(), triangles.end(),
            [&](const Triangle& a, const Triangle& b) { return ascending(a) < ascending(b); });
  for (const auto& t : triangles) block.facets.push_back({{t[0], t[1], t[2], t[2]}, 3, 2});
}

/// Gives stones without cells their surfaces, and the shapes of these.
void add_surfaces(const StoneStructure& s, const PolygonMesher& mesher, const Ends& ends, StoneShells& shells) {
  auto& blocks = shells.list.blocks;
  std::vector<char> wanted;
  for (const auto& block : blocks) wanted.push_back(block.cells.empty());
  const auto skins = skins_of(s, wanted, mesher);
  auto stones = skins_of_stones(s, skins);
  Translates shapes(DrawnNumbers(largest_coordinate(skins.nodes)).within());
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (!wanted[k]) continue;
    const auto& mesh = stones[k].mesh;
    blocks[k].position = mesh.nodes;
    for (const int node : stones[k].nodes) blocks[k].vertex.push_back(shells.vertices + node);
    std::vector<int> corners;
    for (const auto& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
    auto match = shapes.add(mesh.nodes, 3, corners);
    shells.shape[k] = match.shape;
    shells.order[k] = std::move(match.order);
    if (match.is_first)
      shells.shapes.push_back({mesh, false});
    else
      shells.shapes[match.shape].is_shared = true;
  }
  shells.vertices += static_cast<VertexId>(skins.nodes.size());
  shells.shapes_to_fill = shapes.shapes();
  add_free_triangles(s, skins, stones, ends, shells.list);
  add_folds(s, skins, stones, shells.list);
  for (std::size_t k = 0; k < blocks.size(); ++k)
    if (wanted[k]) add_all_faces(stones[k].mesh, blocks[k]);
}

double largest_coordinate_of(const std::vector<Block<3>>& blocks) {
  double largest = 0;
  for (const auto& block : blocks) largest = std::max(largest, largest_coordinate(block.position));
  return largest;
}

/// What is the same on every rank.
template <class Bytes, class Shells>
void exchange_of_all(Bytes& bytes, Shells& shells) {
  bytes.plain(shells.stones);
  bytes.plain(shells.shapes_to_fill);
  bytes.plain(shells.whole_shapes);
  bytes.plain(shells.vertices);
  bytes.plain(shells.largest);
  bytes.plain(shells.are_meshed_here);
}

/// The part of some shells that a rank reads, as bytes; it is taken out of them.
std::string bytes_of_span(StoneShells& shells, BlockSpan span) {
  std::vector<BlockToSend<3>> blocks;
  std::vector<int> shape, used, number(shells.shapes.size(), -1);
  for (BlockId b = span.from; b < span.to; ++b) {
    blocks.emplace_back(std::exchange(shells.list.blocks[b], {}), shells.list.block_sets);
    const int k = shells.shape[b];
    if (k >= 0 && number[k] < 0) {
      number[k] = static_cast<int>(used.size());
      used.push_back(k);
    }
    shape.push_back(k < 0 ? k : number[k]);
  }
  ByteWriter writer;
  exchange_of_all(writer, std::as_const(shells));
  const auto block_bytes = bytes_of(blocks);
  plain_list(writer, block_bytes);
  plain_list(writer, shape);
  for (BlockId b = span.from; b < span.to; ++b) {
    const auto order = std::exchange(shells.order[b], {});
    plain_list(writer, order);
  }
  for (const int k : used) {
    exchange_closed(writer, std::as_const(shells.shapes[k].surface));
    writer.plain(shells.shapes[k].is_shared);
  }
  return writer.bytes;
}

void read_span(const std::string& bytes, StoneShells& shells) {
  ByteReader reader(bytes);
  exchange_of_all(reader, shells);
  std::string blocks;
  plain_list(reader, blocks);
  for (auto& one : blocks_of_bytes<3>(blocks)) {
    one.teach(shells.list.block_sets);
    shells.list.blocks.push_back(std::move(one.block));
  }
  plain_list(reader, shells.shape);
  shells.order.resize(shells.shape.size());
  for (auto& order : shells.order) plain_list(reader, order);
  while (reader.left() > 0) {
    auto& shape = shells.shapes.emplace_back();
    exchange_closed(reader, shape.surface);
    reader.plain(shape.is_shared);
  }
}

}  // namespace

StoneShells shells_of(const StoneStructure& s, const PolygonMesher& mesher) {
  StoneShells shells;
  shells.list.facet_sets = {"base", "top", "faces"};
  shells.list.warnings = s.warnings;
  shells.list.report = s.report;
  shells.stones = static_cast<long long>(s.stones.size());
  shells.shape.assign(s.stones.size(), -1);
  shells.order.resize(s.stones.size());
  const Ends ends(s);
  BoxMeshes boxes;
  boxes.blocks.resize(s.stones.size());
  if (s.cells == StoneCells::by_shape) boxes = box_meshes(s);
  shells.list.blocks = std::move(boxes.blocks);
  shells.vertices = boxes.vertices;
  for (std::size_t k = 0; k < s.stones.size(); ++k) {
    auto& block = shells.list.blocks[k];
    block.id = static_cast<BlockId>(k);
    block.name = "stone " + s.stones[k].name;
    if (block.cells.empty()) continue;
    for (const auto& face : boxes.free_faces[k]) ends.add(face, static_cast<int>(k), shells.list);
    add_all_faces(block);
  }
  add_surfaces(s, mesher, ends, shells);
  add_sets(s, shells.list);
  shells.largest = largest_coordinate_of(shells.list.blocks);
  return shells;
}

StoneShells shells_of(BlockList<3> list) {
  StoneShells shells;
  shells.stones = static_cast<long long>(list.blocks.size());
  shells.shape.assign(list.blocks.size(), -1);
  shells.order.resize(list.blocks.size());
  shells.largest = largest_coordinate_of(list.blocks);
  shells.are_meshed_here = false;
  shells.list = std::move(list);
  return shells;
}

void make_alike_equal(StoneShells& shells) {
  shells.whole_shapes = make_alike_equal(shells.list.blocks, shells.largest);
}

StoneShells handed_out(StoneShells of_first, const Teuchos::Comm<int>& comm) {
  if (comm.getSize() == 1) return of_first;
  StoneShells mine;
  mine.list = without_blocks(of_first.list, comm);
  const auto bytes = part_of_first(comm, [&](int reader) {
    return bytes_of_span(of_first, span_read_by(reader, comm.getSize(), static_cast<BlockId>(of_first.stones)));
  });
  read_span(bytes, mine);
  return mine;
}

}  // namespace voussoir
