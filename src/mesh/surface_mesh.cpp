#include "mesh/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "mesh/border.hpp"

namespace voussoir {
namespace {

/// Classes of nodes that are one vertex; a class never holds two nodes of the same surface.
class Classes {
 public:
  explicit Classes(const SurfaceMesh& mesh) : sets_(mesh.position.size()), surfaces_(mesh.position.size()) {
    for (std::size_t s = 0; s < mesh.surfaces.size(); ++s)
      for (const Cell& cell : mesh.surfaces[s].cells)
        for (int k = 0; k < cell.count; ++k) {
          std::vector<int>& of_node = surfaces_[cell.node[k]];
          if (of_node.empty() || of_node.back() != static_cast<int>(s)) of_node.push_back(static_cast<int>(s));
        }
  }
  bool is_used(int node) const { return !surfaces_[node].empty(); }
  int find(int node) { return sets_.root(node); }
  void unite(int a, int b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    if (b < a) std::swap(a, b);
    std::vector<int> both;
    std::merge(surfaces_[a].begin(), surfaces_[a].end(), surfaces_[b].begin(), surfaces_[b].end(),
               std::back_inserter(both));
    if (std::adjacent_find(both.begin(), both.end()) != both.end()) return;
    surfaces_[a] = std::move(both);
    sets_.join(b, a);
  }

 private:
  DisjointSets sets_;
  std::vector<std::vector<int>> surfaces_;  ///< per node, of a root those of its class; ascending
};

std::vector<double> shortest_edges(const SurfaceMesh& mesh) {
  std::vector<double> shortest(mesh.position.size(), std::numeric_limits<double>::infinity());
  for (const SurfaceMesh::Surface& surface : mesh.surfaces)
    for (const Cell& cell : surface.cells)
      for (int k = 0; k < cell.count; ++k) {
        const int a = cell.node[k], b = cell.node[(k + 1) % cell.count];
        const double length = norm(mesh.position[b] - mesh.position[a]);
        shortest[a] = std::min(shortest[a], length);
        shortest[b] = std::min(shortest[b], length);
      }
  return shortest;
}

double doubled_area(const SurfaceMesh& mesh, const Cell& cell) {
  const Vector<2>& origin = mesh.position[cell.node[0]];
  double area = 0;
  for (int k = 1; k + 1 < cell.count; ++k)
    area += cross(mesh.position[cell.node[k]] - origin, mesh.position[cell.node[k + 1]] - origin);
  return area;
}

std::string name_of(const SurfaceMesh& mesh, const SurfaceMesh::Surface& surface) {
  std::string sets;
  for (const int set : surface.sets) sets += (sets.empty() ? " (" : ", ") + mesh.block_sets[set];
  return "surface " + std::to_string(surface.tag) + sets + (sets.empty() ? "" : ")");
}

/// The copy of a surface; positions are those of the vertices, so that copies of a point are bitwise equal.
Block<2> block_of(const SurfaceMesh& mesh, const SurfaceMesh::Surface& surface, const std::vector<VertexId>& vertex,
                  const std::vector<Vector<2>>& vertex_position) {
  Block<2> block;
  block.name = name_of(mesh, surface);
  block.sets = surface.sets;
  block.cells = surface.cells;
  std::vector<int> nodes;
  double area = 0;
  for (const Cell& cell : surface.cells) {
    nodes.insert(nodes.end(), cell.node.begin(), cell.node.begin() + cell.count);
    area += doubled_area(mesh, cell);
  }
  sort_unique(nodes);
  for (const int node : nodes) {
    block.vertex.push_back(vertex[node]);
    block.position.push_back(vertex_position[vertex[node]]);
  }
  for (const int corner : mesh.corners)
    if (const auto n = std::lower_bound(nodes.begin(), nodes.end(), corner); n != nodes.end() && *n == corner)
      block.folds.push_back(static_cast<int>(n - nodes.begin()));
  sort_unique(block.folds);
  for (Cell& cell : block.cells) {
    for (int k = 0; k < cell.count; ++k)
      cell.node[k] = static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), cell.node[k]) - nodes.begin());
    if (area < 0) std::reverse(cell.node.begin() + 1, cell.node.begin() + cell.count);
  }
  return block;
}

void tag_facets(const SurfaceMesh& mesh, const std::vector<VertexId>& vertex, std::vector<Block<2>>& blocks) {
  const std::vector<BorderEdge> border = border_facets(blocks);
  std::vector<char> found(mesh.facet_sets.size(), 0);
  for (const SurfaceMesh::Line& line : mesh.lines) {
    const BorderEdge key{ascending(vertex[line.node[0]], vertex[line.node[1]]), -1, {}};
    for (auto edge = std::lower_bound(border.begin(), border.end(), key);
         edge != border.end() && edge->vertices == key.vertices; ++edge) {
      TaggedFacet facet;
      facet.node = {edge->node[0], edge->node[1]};
      facet.count = 2;
      facet.set = line.set;
      blocks[edge->block].facets.push_back(facet);
      found[line.set] = 1;
    }
  }
  for (std::size_t set = 0; set < found.size(); ++set)
    if (!found[set])
      throw InputError(
          "mesh > gmsh: the set of curves \"" + mesh.facet_sets[set] +
          "\" lies on the border of no block\n  (its curves bound no meshed surface, so supports and loads "
          "on it would reach nothing).\n  Put curves that bound surfaces into the Physical Curve, or remove it.");
  for (Block<2>& block : blocks) {
    const auto order = [](const TaggedFacet& a, const TaggedFacet& b) {
      return std::tie(a.set, a.node) < std::tie(b.set, b.node);
    };
    const auto same = [](const TaggedFacet& a, const TaggedFacet& b) { return a.set == b.set && a.node == b.node; };
    std::sort(block.facets.begin(), block.facets.end(), order);
    block.facets.erase(std::unique(block.facets.begin(), block.facets.end(), same), block.facets.end());
  }
}

}  // namespace

std::vector<VertexId> vertices_of_nodes(const SurfaceMesh& mesh) {
  const std::vector<double> shortest = shortest_edges(mesh);
  Classes classes(mesh);
  const auto within = [&](std::size_t node) {  // [m] distance at which another coincides with it
    const double far = coincidence_far * norm(mesh.position[node]);
    return std::max(coincidence * shortest[node], std::min(far, farthest_coincidence * shortest[node]));
  };
  double reach = 0;  // [m] largest distance at which any two nodes coincide
  for (std::size_t n = 0; n < shortest.size(); ++n)
    if (std::isfinite(shortest[n]) && std::isfinite(within(n))) reach = std::max(reach, within(n));

  // Nodes by the square of side `reach` they lie in: coincident nodes lie in the same or in neighbouring squares.
  struct Place {
    double column, row;  // whole numbers; doubles, since they may exceed 2^63
    int node;
    bool operator<(const Place& o) const { return std::tie(column, row, node) < std::tie(o.column, o.row, o.node); }
  };
  std::vector<Place> places;
  if (reach > 0)
    for (std::size_t n = 0; n < mesh.position.size(); ++n)
      if (classes.is_used(static_cast<int>(n)) && std::isfinite(norm(mesh.position[n])))
        places.push_back({std::floor(mesh.position[n][0] / reach), std::floor(mesh.position[n][1] / reach), int(n)});
  std::sort(places.begin(), places.end());
  for (const Place& place : places)
    for (int column = 0; column <= 1; ++column) {  // the columns to the left have seen this one already
      const Place first{place.column + column, place.row - 1, -1};
      for (auto other = std::lower_bound(places.begin(), places.end(), first);
           other != places.end() && other->column == first.column && other->row <= place.row + 1; ++other) {
        const double distance = norm(mesh.position[other->node] - mesh.position[place.node]);
        if (distance <= std::min(within(place.node), within(other->node))) classes.unite(place.node, other->node);
      }
    }

  std::vector<VertexId> vertex(mesh.position.size());
  VertexId count = 0;
  for (std::size_t n = 0; n < vertex.size(); ++n) {
    const std::size_t root = classes.find(static_cast<int>(n));
    vertex[n] = root == n ? count++ : vertex[root];
  }
  return vertex;
}

BlockList<2> blocks_of_surfaces(const SurfaceMesh& mesh) {
  const std::vector<VertexId> vertex = vertices_of_nodes(mesh);
  std::vector<Vector<2>> vertex_position;
  for (std::size_t n = 0; n < vertex.size(); ++n)
    if (vertex[n] == static_cast<VertexId>(vertex_position.size())) vertex_position.push_back(mesh.position[n]);
  BlockList<2> list;
  list.block_sets = mesh.block_sets;
  list.facet_sets = mesh.facet_sets;
  for (const SurfaceMesh::Surface& surface : mesh.surfaces) {
    list.blocks.push_back(block_of(mesh, surface, vertex, vertex_position));
    list.blocks.back().id = static_cast<BlockId>(list.blocks.size()) - 1;
  }
  tag_facets(mesh, vertex, list.blocks);
  return list;
}

}  // namespace voussoir
