#include "stones/skins.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "base/text.hpp"
#include "mesh/translates.hpp"

namespace voussoir {
namespace {

using Loop = std::vector<int>;

/// Nodes on the edges of cells, the same for all cells that have the edge.
class EdgeNodes {
 public:
  EdgeNodes(Places& nodes, double size) : nodes_(nodes), size_(size) {}

  /// From a to b, without b.
  void append(int a, int b, Loop& loop) {
    const auto [known, is_new] = between_.emplace(std::minmax(a, b), Loop{});
    if (is_new) known->second = divided(known->first.first, known->first.second);
    loop.push_back(a);
    if (a < b)
      loop.insert(loop.end(), known->second.begin(), known->second.end());
    else
      loop.insert(loop.end(), known->second.rbegin(), known->second.rend());
  }

 private:
  Loop divided(int a, int b) {
    // A length that is a whole number of sizes but for its round-off is divided into that number.
    const int parts = std::max(1, static_cast<int>(std::ceil(norm(nodes_[b] - nodes_[a]) / size_ - 1e-9)));
    Loop between;
    for (int k = 1; k < parts; ++k) {
      between.push_back(static_cast<int>(nodes_.size()));
      nodes_.push_back(nodes_[a] + (static_cast<double>(k) / parts) * (nodes_[b] - nodes_[a]));
    }
    return between;
  }

  Places& nodes_;
  double size_;
  std::map<std::pair<int, int>, Loop> between_;
};

/// A cell as it is meshed: the nodes of its borders, and its plane.
struct CellBorder {
  std::vector<Loop> loops;
  PlaneAxes axes;
};

CellBorder border_of(const ImprintedCell& cell, const Places& points, EdgeNodes& edges) {
  std::vector<Loop> corners{cell.outer};
  corners.insert(corners.end(), cell.holes.begin(), cell.holes.end());
  const auto outer = places_of(points, cell.outer);
  CellBorder border{{}, PlaneAxes(mean(outer), area_vector(outer))};
  for (const auto& loop : corners) {
    border.loops.emplace_back();
    for (std::size_t k = 0; k < loop.size(); ++k)
      edges.append(loop[k], loop[(k + 1) % loop.size()], border.loops.back());
  }
  return border;
}

/// Heights over the plane, of the border as given and inside as means of their neighbours.
///
/// Gauss-Seidel: what is left of the error after this many rounds, a part in a thousand of a height that is itself at
/// most the weld distance, moves nodes within their face only.
constexpr int rounds = 100;

std::vector<double> lifted(std::vector<double> height, std::size_t border, const std::vector<Triangle>& triangles) {
  std::vector<std::set<int>> around(height.size());
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k) around[t[k]].insert({t[(k + 1) % 3], t[(k + 2) % 3]});
  for (int round = 0; round < rounds; ++round)
    for (std::size_t n = border; n < height.size(); ++n) {
      double sum = 0;
      for (const int other : around[n]) sum += height[other];
      height[n] = around[n].empty() ? 0 : sum / static_cast<double>(around[n].size());
    }
  return height;
}

/// Puts a flat mesh of a cell into space; returns its triangles by numbers of nodes.
std::vector<Triangle> put(const FlatMesh& flat, const CellBorder& border, Places& nodes) {
  Loop number;
  std::vector<double> height;
  for (const auto& loop : border.loops)
    for (const int node : loop) {
      number.push_back(node);
      height.push_back(dot(nodes[node] - border.axes.origin, border.axes.normal));
    }
  const std::size_t on_border = number.size();
  height.resize(on_border + flat.inside.size(), 0.0);
  height = lifted(std::move(height), on_border, flat.triangles);
  Polygon place;
  for (const int node : number) place.push_back(border.axes(nodes[node]));
  for (std::size_t k = 0; k < flat.inside.size(); ++k) {
    number.push_back(static_cast<int>(nodes.size()));
    place.push_back(flat.inside[k]);
    nodes.push_back(border.axes.place(flat.inside[k]) + height[on_border + k] * border.axes.normal);
  }
  std::vector<Triangle> triangles;
  for (const auto& t : flat.triangles) {
    const bool left = area({place[t[0]], place[t[1]], place[t[2]]}) > 0;
    triangles.push_back({number[t[0]], number[t[left ? 1 : 2]], number[t[left ? 2 : 1]]});
  }
  return triangles;
}

/// A cell that is meshed for itself and the one it faces.
struct CellToMesh {
  std::size_t cell = 0;
  CellBorder border;
  std::vector<int> nodes;   ///< of its border, ascending
  Translates::Match alike;  ///< which of the cells meshed it is like
};

CellToMesh cell_to_mesh(std::size_t c, const StoneStructure& s, EdgeNodes& edges, const Places& nodes,
                        Translates& shapes) {
  CellToMesh cell{c, border_of(s.imprint.cells[c], s.imprint.points, edges), {}, {}};
  for (const auto& loop : cell.border.loops) cell.nodes.insert(cell.nodes.end(), loop.begin(), loop.end());
  sort_unique(cell.nodes);
  const auto local = [&](int node) {
    return static_cast<int>(std::lower_bound(cell.nodes.begin(), cell.nodes.end(), node) - cell.nodes.begin());
  };
  std::vector<int> sides;
  for (const auto& loop : cell.border.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      sides.push_back(local(loop[k]));
      sides.push_back(local(loop[(k + 1) % loop.size()]));
    }
  cell.alike = shapes.add(places_of(nodes, cell.nodes), 2, sides);
  return cell;
}

FlatDomain domain_of(const CellBorder& border, const Places& nodes, double size) {
  FlatDomain domain;
  domain.size = size;
  for (const auto& loop : border.loops) {
    domain.loops.emplace_back();
    for (const int node : loop) domain.loops.back().push_back(border.axes(nodes[node]));
  }
  return domain;
}

/// What is put into space of a cell that others are like.
struct MeshedCell {
  const CellToMesh* cell = nullptr;
  int first_inside = 0, behind_inside = 0;  ///< numbers of its nodes inside
};

/// The mesh of another cell moved to one that is like it; the same seen from the other side where that is outside.
std::vector<Triangle> moved(const MeshedCell& from, const std::vector<Triangle>& triangles, const CellToMesh& to,
                            Places& nodes) {
  std::map<int, int> number;
  for (std::size_t k = 0; k < to.nodes.size(); ++k) number[from.cell->nodes[k]] = to.nodes[to.alike.order[k]];
  const auto by = nodes[to.nodes[to.alike.order[0]]] - nodes[from.cell->nodes[0]];
  for (int node = from.first_inside; node < from.behind_inside; ++node) {
    number[node] = static_cast<int>(nodes.size());
    nodes.push_back(nodes[node] + by);
  }
  const bool same_side = dot(from.cell->border.axes.normal, to.border.axes.normal) > 0;
  std::vector<Triangle> result;
  for (const auto& t : triangles)
    result.push_back({number.at(t[0]), number.at(t[same_side ? 1 : 2]), number.at(t[same_side ? 2 : 1])});
  return result;
}

[[noreturn]] void refuse_cell(const StoneStructure& s, const ImprintedCell& cell, const std::string& failure) {
  throw InputError("mesh > stones: a face of " + in_words(s.stones[cell.stone]) + " of " + six_digits(cell.area) +
                   " m2 cannot be meshed:\n    " + failure +
                   "\n  Its shortest edges may be too short for its cells: try a larger weld, or a smaller element "
                   "size.");
}

}  // namespace

Skins skins_of(const StoneStructure& s, const std::vector<char>& wanted, const PolygonMesher& mesher) {
  const auto& cells = s.imprint.cells;
  Skins skins;
  skins.nodes = s.imprint.points;
  skins.triangles.resize(cells.size());
  EdgeNodes edges(skins.nodes, s.tetrahedron_size);
  Translates shapes(DrawnNumbers(largest_coordinate(s.imprint.points)).within());
  std::vector<CellToMesh> to_mesh;
  std::vector<FlatDomain> domains;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const int other = s.imprint.other[c];
    if (!wanted[cells[c].stone] || (other >= 0 && other < static_cast<int>(c))) continue;
    to_mesh.push_back(cell_to_mesh(c, s, edges, skins.nodes, shapes));
    const auto& cell = to_mesh.back();
    if (cell.alike.is_first) domains.push_back(domain_of(cell.border, skins.nodes, s.tetrahedron_size));
  }
  const auto flat = mesher(domains);
  std::vector<MeshedCell> meshed_cells(flat.size());
  for (const auto& cell : to_mesh) {
    const int shape = cell.alike.shape;
    auto& first = meshed_cells[shape];
    auto& triangles = skins.triangles[cell.cell];
    if (cell.alike.is_first) {
      if (!flat[shape].failure.empty()) refuse_cell(s, cells[cell.cell], flat[shape].failure);
      first = {&cell, static_cast<int>(skins.nodes.size()), 0};
      triangles = put(flat[shape], cell.border, skins.nodes);
      first.behind_inside = static_cast<int>(skins.nodes.size());
    } else {
      triangles = moved(first, skins.triangles[first.cell->cell], cell, skins.nodes);
    }
    if (s.imprint.other[cell.cell] < 0) continue;
    auto& turned = skins.triangles[s.imprint.other[cell.cell]];
    for (const auto& t : triangles) turned.push_back({t[0], t[2], t[1]});
  }
  return skins;
}

}  // namespace voussoir
