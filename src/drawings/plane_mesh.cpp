#include "drawings/plane_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "mesh/cell_count.hpp"
#include "mesh/lattice.hpp"
#include "stones/gmsh_stones.hpp"

namespace voussoir {
namespace {

using Loop = std::vector<int>;

/// Sines of corners of cells below this make a stone one of triangles: five degrees.
constexpr double least_sine = 0.087;

/// Sets of facets, by number.
enum End { base, top, left, right, faces };

void refuse_too_many_cells(const PlaneStones& s) {
  double cells = 0;
  for (const auto& stone : s.stones)
    for (const auto& loop : stone.loops) cells += area(loop.corners) / (s.element_size * s.element_size);
  if (cells > most_cells())
    throw InputError("mesh: element size = " + number_text(s.element_size) + " m makes some " + three_digits(cells) +
                     " cells, more than the memory of this machine holds.\n"
                     "  Look at mesh > stones > unit, or give a larger element size.");
}

class Meshing {
 public:
  Meshing(const PlaneStones& s, StoneCells cells) : s_(s), divisions_(divided(s, cells)), nodes_(s.snapped.points) {}

  PlaneMeshes run() {
    list_.facet_sets = {"base", "top", "left", "right", "faces"};
    find_ends();
    for (std::size_t k = 0; k < s_.stones.size(); ++k) add_block(k);
    fill_with_triangles();
    add_facets();
    add_sets();
    for (const auto& block : list_.blocks) {
      result_.nodes += block.position.size();
      result_.cells += block.cells.size();
    }
    list_.warnings = s_.warnings;
    result_.list = std::move(list_);
    return std::move(result_);
  }

 private:
  /// Nodes from one point of an outline to the next, without the last.
  void append(int a, int b, Loop& loop) {
    const auto edge = std::pair<int, int>(std::minmax(a, b));
    const auto [known, is_new] = between_.emplace(edge, Loop{});
    if (is_new) {
      const int parts = divisions_.parts.at(edge);
      const auto &from = s_.snapped.points[edge.first], &to = s_.snapped.points[edge.second];
      for (int k = 1; k < parts; ++k) {
        known->second.push_back(static_cast<int>(nodes_.size()));
        nodes_.push_back(from + (static_cast<double>(k) / parts) * (to - from));
      }
    }
    loop.push_back(a);
    if (a < b)
      loop.insert(loop.end(), known->second.begin(), known->second.end());
    else
      loop.insert(loop.end(), known->second.rbegin(), known->second.rend());
  }

  void add_block(std::size_t k) {
    borders_.emplace_back();
    Loop nodes;
    for (const auto& loop : s_.snapped.loops[k]) {
      borders_.back().emplace_back();
      for (std::size_t i = 0; i < loop.size(); ++i)
        append(loop[i], loop[(i + 1) % loop.size()], borders_.back().back());
      nodes.insert(nodes.end(), borders_.back().back().begin(), borders_.back().back().end());
    }
    sort_unique(nodes);
    Block<2> block;
    block.id = static_cast<BlockId>(k);
    block.name = stone_name(s_.stones[k]) + " at " + place_of_drawing(middle_of(s_.stones[k]));
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      block.vertex.push_back(nodes[n]);
      block.position.push_back(nodes_[nodes[n]]);
      if (nodes[n] < static_cast<int>(s_.snapped.points.size()) && s_.snapped.turns[nodes[n]])
        block.folds.push_back(static_cast<int>(n));
    }
    border_nodes_.push_back(std::move(nodes));
    list_.blocks.push_back(std::move(block));
    if (!divisions_.sides[k].empty() && fill_with_quadrilaterals(k)) ++result_.of_quadrilaterals;
  }

  int local(std::size_t stone, int node) const {
    const auto& nodes = border_nodes_[stone];
    return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
  }

  /// Nodes on the four sides, each with both ends; those across run the same way.
  std::array<Loop, 4> sides_of(std::size_t k) const {
    const auto &outline = s_.snapped.loops[k][0], &border = borders_[k][0];
    std::array<Loop, 4> sides;
    for (std::size_t side = 0; side < 4; ++side) {
      const int from = outline[divisions_.sides[k][side]], to = outline[divisions_.sides[k][(side + 1) % 4]];
      auto at = static_cast<std::size_t>(std::find(border.begin(), border.end(), from) - border.begin());
      sides[side].push_back(from);
      while (sides[side].back() != to) sides[side].push_back(border[at = (at + 1) % border.size()]);
    }
    std::reverse(sides[2].begin(), sides[2].end());
    std::reverse(sides[3].begin(), sides[3].end());
    return sides;
  }

  /// A lattice between the four sides (W. J. Gordon, C. A. Hall, Int. J. Numer. Methods Eng. 7 (1973) 461-477). Returns
  /// whether all its cells are good.
  bool fill_with_quadrilaterals(std::size_t k) {
    const auto [below, beside, above, before] = sides_of(k);
    const int across = static_cast<int>(below.size()) - 1, up = static_cast<int>(beside.size()) - 1;
    auto& block = list_.blocks[k];
    std::vector<int> number(static_cast<std::size_t>((across + 1) * (up + 1)));
    Polygon inside;
    for (int j = 0; j <= up; ++j)
      for (int i = 0; i <= across; ++i) {
        int& node = number[static_cast<std::size_t>(j * (across + 1) + i)];
        if (j == 0 || j == up || i == 0 || i == across) {
          node = local(k, j == 0 ? below[i] : j == up ? above[i] : i == 0 ? before[j] : beside[j]);
          continue;
        }
        const double u = static_cast<double>(i) / across, v = static_cast<double>(j) / up;
        const auto x = [&](int n) { return nodes_[n]; };
        const auto sides = (1 - v) * x(below[i]) + v * x(above[i]) + (1 - u) * x(before[j]) + u * x(beside[j]);
        const auto corners = (1 - v) * ((1 - u) * x(below[0]) + u * x(below[across])) +
                             v * ((1 - u) * x(above[0]) + u * x(above[across]));
        node = static_cast<int>(block.position.size() + inside.size());
        inside.push_back(sides - corners);
      }
    auto all = block.position;
    all.insert(all.end(), inside.begin(), inside.end());
    auto cells = lattice_cells(across, up, CellType::quadrilateral);
    for (auto& cell : cells) {
      for (int c = 0; c < 4; ++c) cell.node[c] = number[cell.node[c]];
      for (int c = 0; c < 4; ++c) {
        const auto in = all[cell.node[(c + 3) % 4]] - all[cell.node[c]],
                   out = all[cell.node[(c + 1) % 4]] - all[cell.node[c]];
        if (cross(out, in) < least_sine * norm(in) * norm(out)) return false;
      }
    }
    block.cells = std::move(cells);
    add_inside(block, inside);
    return true;
  }

  void add_inside(Block<2>& block, const Polygon& inside) {
    for (const auto& x : inside) {
      block.position.push_back(x);
      block.vertex.push_back(static_cast<VertexId>(nodes_.size()));
      nodes_.push_back(x);
    }
  }

  void fill_with_triangles() {
    std::vector<FlatDomain> domains;
    std::vector<std::size_t> stones;
    for (std::size_t k = 0; k < list_.blocks.size(); ++k) {
      if (!list_.blocks[k].cells.empty()) continue;
      stones.push_back(k);
      domains.push_back({{}, s_.element_size});
      for (const auto& loop : borders_[k]) {
        domains.back().loops.emplace_back();
        for (const int n : loop) domains.back().loops.back().push_back(nodes_[n]);
      }
    }
    const auto meshes = meshed(domains);
    std::vector<std::string> faults;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const std::size_t k = stones[m];
      auto& block = list_.blocks[k];
      if (!meshes[m].failure.empty()) faults.push_back(in_words(s_.stones[k]) + ": " + meshes[m].failure);
      std::vector<int> number;  // of nodes as gmsh has them
      for (const auto& loop : borders_[k])
        for (const int n : loop) number.push_back(local(k, n));
      for (std::size_t n = 0; n < meshes[m].inside.size(); ++n)
        number.push_back(static_cast<int>(block.position.size() + n));
      add_inside(block, meshes[m].inside);
      for (const auto& t : meshes[m].triangles) block.cells.push_back({{number[t[0]], number[t[1]], number[t[2]]}, 3});
    }
    if (faults.empty()) return;
    std::string message = "mesh: " + counted(faults.size(), "stone") + " cannot be filled with cells:";
    for (std::size_t k = 0; k < std::min<std::size_t>(faults.size(), 5); ++k) message += "\n    " + faults[k];
    throw InputError(message + "\n  Try a smaller element size, or draw such stones with fewer corners.");
  }

  void find_ends() {
    low_ = high_ = s_.snapped.points[0];
    for (const auto& x : s_.snapped.points)
      for (std::size_t i = 0; i < 2; ++i) low_[i] = std::min(low_[i], x[i]), high_[i] = std::max(high_[i], x[i]);
  }

  /// The end of the drawing that a free edge looks to and its stone reaches, or faces.
  End end_of(const Vector<2>& outward, const Vector<2>& low, const Vector<2>& high) const {
    const double near = 0.01, steep = std::sqrt(0.5) * norm(outward), tie = 1e-9 * norm(outward);
    if (outward[1] < -steep + tie && low[1] <= low_[1] + near * (high_[1] - low_[1])) return base;
    if (outward[1] > steep - tie && high[1] >= high_[1] - near * (high_[1] - low_[1])) return top;
    if (outward[0] < -steep && low[0] <= low_[0] + near * (high_[0] - low_[0])) return left;
    if (outward[0] > steep && high[0] >= high_[0] - near * (high_[0] - low_[0])) return right;
    return faces;
  }

  void add_facets() {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& loops : borders_)
      for (const auto& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) ++uses[std::minmax(loop[i], loop[(i + 1) % loop.size()])];
    for (std::size_t k = 0; k < borders_.size(); ++k) {
      Vector<2> low = nodes_[borders_[k][0][0]], high = low;
      for (const int n : borders_[k][0])
        for (std::size_t i = 0; i < 2; ++i)
          low[i] = std::min(low[i], nodes_[n][i]), high[i] = std::max(high[i], nodes_[n][i]);
      for (const auto& loop : borders_[k])
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const int a = loop[i], b = loop[(i + 1) % loop.size()];
          TaggedFacet facet;
          facet.node = {local(k, a), local(k, b)};
          facet.count = 2;
          facet.set = faces;
          list_.blocks[k].facets.push_back(facet);
          const auto along = nodes_[b] - nodes_[a];
          if (uses[std::minmax(a, b)] > 1) continue;
          facet.set = end_of({along[1], -along[0]}, low, high);
          if (facet.set != faces) list_.blocks[k].facets.push_back(facet);
        }
    }
  }

  void add_sets() {
    std::map<std::string, int> number;
    const auto add = [&](const std::string& name, std::size_t stone) {
      const auto [known, is_new] = number.emplace(name, static_cast<int>(list_.block_sets.size()));
      if (is_new) list_.block_sets.push_back(name);
      list_.blocks[stone].sets.push_back(known->second);
    };
    for (std::size_t k = 0; k < s_.stones.size(); ++k)
      for (const auto& set : s_.stones[k].sets) add(set, k);
    for (std::size_t k = 0; k < s_.stones.size(); ++k) add(s_.stones[k].name, k);
    for (auto& block : list_.blocks) sort_unique(block.sets);
  }

  const PlaneStones& s_;
  EdgeDivisions divisions_;
  Polygon nodes_;  ///< [m] points of the drawing, then on edges and in stones
  std::map<std::pair<int, int>, Loop> between_;
  std::vector<std::vector<Loop>> borders_;  ///< per stone its loops, of nodes
  std::vector<Loop> border_nodes_;          ///< per stone, ascending
  Vector<2> low_{}, high_{};                ///< of the drawing
  BlockList<2> list_;
  PlaneMeshes result_;
};

}  // namespace

PlaneMeshes mesh_plane_stones(const PlaneStones& s, StoneCells cells) {
  refuse_too_many_cells(s);
  return Meshing(s, cells).run();
}

}  // namespace voussoir
