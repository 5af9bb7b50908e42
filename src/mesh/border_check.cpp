// Faults between blocks: borders that should match and do not, blocks in the same place.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "mesh/border.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/lattice.hpp"
#include "mesh/mesh_check.hpp"

namespace voussoir {
namespace {

/// Borders closer than this part of the shorter edge were meant to touch: rounding coordinates to millimetres moves
/// edges of a decimetre by one hundredth, while a gap somebody draws is a good part of an element.
constexpr double nearly_touching = 0.01;
/// How far inside a cell a point must be to count, as part of the shortest side of the cell: above what is
/// left of rounding, below any overlap that matters.
constexpr double well_inside = 1e-3;

/// A border edge with its place.
struct Segment {
  Vector<2> from, to;
  const BorderEdge* edge;
  bool is_joint;  ///< another block has the same edge

  Vector<2> along() const { return to - from; }
  double length() const { return norm(along()); }
  Box<2> box(double margin) const {
    Box<2> box{from, from};
    box.add({to, to});
    for (int i = 0; i < 2; ++i) box.low[i] -= margin, box.high[i] += margin;
    return box;
  }
};

std::string between_ends(const Segment& s) { return "from " + place_in_words(s.from) + " to " + place_in_words(s.to); }

int common_vertices(const BorderEdge& a, const BorderEdge& b) {
  int count = 0;
  for (const VertexId v : a.vertices) count += v == b.vertices[0] || v == b.vertices[1];
  return count;
}

[[noreturn]] void refuse_overlap(const Block<2>& a, const Block<2>& b, const Vector<2>& where) {
  if (b.id < a.id) refuse_overlap(b, a, where);
  throw InputError("mesh: " + a.name + " and " + b.name + " overlap near " + place_in_words(where) +
                   "\n  (two stones cannot be in one place).\n"
                   "  Correct the geometry, or cut one surface out of the other (BooleanFragments in gmsh).");
}

std::vector<Segment> segments_of(const std::vector<BorderEdge>& border, const std::vector<Block<2>>& blocks) {
  std::vector<Segment> segments;
  for (const BorderEdge& edge : border) {
    const Block<2>& block = blocks[edge.block];
    segments.push_back({block.position[edge.node[0]], block.position[edge.node[1]], &edge, false});
  }
  for (std::size_t i = 0; i + 1 < border.size(); ++i)
    if (border[i].vertices == border[i + 1].vertices) segments[i].is_joint = segments[i + 1].is_joint = true;
  return segments;
}

/// An edge has at most two blocks, one on either side.
void check_sides(const std::vector<Segment>& segments, const std::vector<Block<2>>& blocks) {
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    const BorderEdge &a = *segments[i].edge, &b = *segments[i + 1].edge;
    if (a.vertices != b.vertices) continue;
    const std::string names = blocks[a.block].name + ", " + blocks[b.block].name;
    if (i + 2 < segments.size() && segments[i + 2].edge->vertices == a.vertices)
      throw InputError("mesh: the edge " + between_ends(segments[i]) + " belongs to " + names + " and " +
                       blocks[segments[i + 2].edge->block].name +
                       "\n  (a joint has two sides; a third block there lies upon one of the others).\n"
                       "  Remove doubled surfaces from the file.");
    if (dot(segments[i].along(), segments[i + 1].along()) > 0)
      throw InputError("mesh: " + names + " lie on the same side of the edge " + between_ends(segments[i]) +
                       "\n  (they overlap; a joint has one block on either side).\n"
                       "  Remove doubled surfaces from the file.");
  }
}

/// The distance [m] of two borders that face each other along part of their length, negative when they do not.
double facing_distance(const Segment& a, const Segment& b) {
  const double length = a.length(), shorter = std::min(length, b.length());
  const Vector<2> along = (1 / length) * a.along();
  if (dot(along, b.along()) > -0.98 * b.length()) return -1;  // more than 11 degrees from opposite
  const double b_first = dot(b.to - a.from, along), b_last = dot(b.from - a.from, along);
  const double first = std::max(0.0, b_first), last = std::min(length, b_last);
  if (last - first < 0.05 * shorter) return -1;  // neighbours along one line touch in a point, rounded
  const double h_first = cross(along, b.to - a.from), h_last = cross(along, b.from - a.from);
  const auto height = [&](double s) { return h_first + (h_last - h_first) * (s - b_first) / (b_last - b_first); };
  // Edges have their block on the left: b lies behind a, with a thin block between them. Overlaps are looked for apart.
  if (std::min(height(first), height(last)) > well_inside * shorter) return -1;
  const double distance = std::max(std::abs(height(first)), std::abs(height(last)));
  const bool meet = common_vertices(*a.edge, *b.edge) > 0;
  return distance <= (meet ? nearly_touching_at_vertex : nearly_touching) * shorter ? distance : -1;
}

bool cross_each_other(const Segment& a, const Segment& b) {
  const double margin = well_inside * std::min(a.length(), b.length());
  const auto splits = [margin](const Segment& line, const Segment& ends) {
    const double from = cross(line.along(), ends.from - line.from) / line.length();
    const double to = cross(line.along(), ends.to - line.from) / line.length();
    return std::min(from, to) < -margin && std::max(from, to) > margin;
  };
  return splits(a, b) && splits(b, a);
}

[[noreturn]] void refuse_mismatch(const Segment& a, const Segment& b, double distance,
                                  const std::vector<Block<2>>& blocks) {
  if (b.edge->block < a.edge->block) refuse_mismatch(b, a, distance, blocks);
  const double shorter = std::min(a.length(), b.length());
  const bool touching = distance <= 1e-6 * shorter;  // the distance at which nodes are taken for one
  throw InputError("mesh: " + blocks[a.edge->block].name + " and " + blocks[b.edge->block].name +
                   (touching ? " touch without matching nodes" : " nearly touch, but their nodes do not match") +
                   ": the edge " + between_ends(a) + " lies along the edge " + between_ends(b) + ", " +
                   in_words(touching ? 0.0 : distance) + " m apart, with " +
                   counted(common_vertices(*a.edge, *b.edge), "common vertex", "common vertices") +
                   "\n  (contact acts between coincident nodes, so this joint would carry nothing).\n"
                   "  Let both surfaces share one curve (Coherence or BooleanFragments in gmsh), or divide both curves "
                   "equally.");
}

void check_pairs_of_edges(const std::vector<Segment>& segments, const std::vector<Block<2>>& blocks) {
  std::vector<Box<2>> boxes;
  for (const Segment& s : segments) boxes.push_back(s.box(0));
  const BoxTree<2> tree(std::move(boxes));
  const auto visit_pairs = [&](auto visit) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const Segment& a = segments[i];
      tree.visit_overlaps(a.box(nearly_touching_at_vertex * a.length()), [&](int j) {
        const Segment& b = segments[j];
        // The longer edge looks for the shorter, so that its margin is wide enough for both.
        const bool my_turn = std::make_pair(a.length(), int(i)) > std::make_pair(b.length(), j);
        if (my_turn && a.edge->block != b.edge->block && a.edge->vertices != b.edge->vertices) visit(a, b);
      });
    }
  };
  // Mismatches first: where nodes do not match, borders may also cross a little, and the advice must be the right one.
  visit_pairs([&](const Segment& a, const Segment& b) {
    if (a.is_joint || b.is_joint) return;
    const double distance = facing_distance(a, b);
    if (distance >= 0) refuse_mismatch(a, b, distance, blocks);
  });
  visit_pairs([&](const Segment& a, const Segment& b) {
    if (cross_each_other(a, b)) refuse_overlap(blocks[a.edge->block], blocks[b.edge->block], 0.5 * (b.from + b.to));
  });
}

bool is_well_inside(const Vector<2>& x, const Block<2>& block, const Cell& cell) {
  double shortest = INFINITY, nearest = INFINITY;
  for (int k = 0; k < cell.count; ++k) {
    const Vector<2>& from = block.position[cell.node[k]];
    const Vector<2> side = block.position[cell.node[(k + 1) % cell.count]] - from;
    const double length = norm(side);
    shortest = std::min(shortest, length);
    nearest = std::min(nearest, cross(side, x - from) / length);
  }
  return nearest > well_inside * shortest;
}

/// No node of a border, no point between two of them and no middle of a cell lies inside a cell of another block.
void check_points_in_cells(const std::vector<Segment>& segments, const std::vector<Block<2>>& blocks) {
  struct Place {
    BlockId block;
    const Cell* cell;
  };
  std::vector<Place> places;
  std::vector<Box<2>> boxes;
  for (const Block<2>& block : blocks)
    for (const Cell& cell : block.cells) {
      Box<2> box{block.position[cell.node[0]], block.position[cell.node[0]]};
      for (int k = 1; k < cell.count; ++k) box.add({block.position[cell.node[k]], block.position[cell.node[k]]});
      places.push_back({block.id, &cell});
      boxes.push_back(box);
    }
  const BoxTree<2> tree(std::move(boxes));
  const auto check_point = [&](const Vector<2>& x, BlockId owner) {
    tree.visit_overlaps({x, x}, [&](int i) {
      const Block<2>& other = blocks[places[i].block];
      if (other.id != owner && is_well_inside(x, other, *places[i].cell)) refuse_overlap(blocks[owner], other, x);
    });
  };
  const double golden = 0.38196601125;  // unlike halves and thirds it does not fall onto sides of cells of a finer mesh
  for (const Segment& s : segments) {
    check_point(s.from, s.edge->block);
    check_point(s.from + golden * s.along(), s.edge->block);
  }
  for (const Place& place : places) {
    Vector<2> middle{};
    for (int k = 0; k < place.cell->count; ++k) middle = middle + blocks[place.block].position[place.cell->node[k]];
    check_point((1.0 / place.cell->count) * middle, place.block);
  }
}

}  // namespace

void check_borders(const std::vector<Block<2>>& blocks) {
  const std::vector<BorderEdge> border = border_facets(blocks);
  const std::vector<Segment> segments = segments_of(border, blocks);
  check_sides(segments, blocks);
  check_pairs_of_edges(segments, blocks);
  check_points_in_cells(segments, blocks);
}

}  // namespace voussoir
