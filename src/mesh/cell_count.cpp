#include "mesh/cell_count.hpp"

#include <algorithm>
#include <cmath>

#include "base/free_memory.hpp"
#include "base/text.hpp"
#include "mesh/lattice.hpp"

namespace voussoir {
namespace {

// What a bonded run takes for a cell [bytes], where a stone has a hundred thousand: 3.2 kB measured. Small stones and
// contact take two to four times as much, but a limit is to refuse only what cannot be.
constexpr double bytes_per_cell = 3000;
// gmsh fails on stones whose cells are shorter than 1e-7 of the way to the origin, as measured; cells are rarely
// shorter than a thousandth of a drawing. Where a drawing that failed is nearer than this, its place is no reason.
constexpr double far_off = 1e4;

std::string why(double cells) {
  return "asks for " + three_digits(cells) + " cells, and this machine's memory of " +
         three_digits(whole_memory() / 1e9) + " GB holds at most " + three_digits(most_cells()) + " of " +
         three_digits(bytes_per_cell / 1000) + " kB";
}

double size_of(const Drawing& d) { return std::hypot(d.to[0] - d.from[0], d.to[1] - d.from[1]); }

}  // namespace

void Drawing::add(int curve, const std::vector<Vector<2>>& points) {
  double length = 0, area = 0;
  if (from[0] == infinity && !points.empty()) first_ = points[0];
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (int c = 0; c < 2; ++c) {
      from[c] = std::min(from[c], points[k][c]);
      to[c] = std::max(to[c], points[k][c]);
    }
    if (k == 0) continue;
    length += norm(points[k] - points[k - 1]);
    area += cross(points[k - 1] - first_, points[k] - first_) / 2;
  }
  auto& stone = stones.back();
  stone.area += curve < 0 ? -area : area;
  stone.border += length;
  stone.length_of[std::abs(curve)] = length;
}

void Drawing::divide(double length) {
  for (auto& stone : stones) stone.edges = stone.border / length;
}

void Drawing::divide(const std::map<int, double>& edges) {
  for (auto& stone : stones) {
    stone.edges = 0;
    for (const auto& [curve, length] : stone.length_of) {
      const auto found = edges.find(curve);
      stone.edges += found == edges.end() ? 1 : found->second;
    }
  }
}

std::map<int, double> least_edges(const std::map<int, double>& edges, const std::map<int, double>& coarser,
                                  double times) {
  std::map<int, double> least;
  for (const auto& [curve, count] : edges) {
    const auto before = coarser.find(curve);
    const bool follows = before != coarser.end() && before->second != count;
    least[curve] = follows ? std::max(1.0, (count - 1) * times) : count;
  }
  return least;
}

double cells_of(const Drawing& drawing) {
  double cells = 0;
  for (const auto& stone : drawing.stones)
    if (stone.border > 0) cells += std::abs(stone.area) * std::pow(stone.edges / stone.border, 2);
  return cells;
}

double cells_of(const MeshParameters& p) {
  const auto* masonry = p.masonry();
  return masonry ? masonry->cell_count() : 0;
}

double most_cells() { return whole_memory() / bytes_per_cell; }

std::string too_many_cells(double cells) { return cells > most_cells() ? why(cells) : ""; }

void refuse_too_many_cells(const GmshParameters& p, const Drawing& drawing) {
  const double cells = cells_of(drawing);
  if (!(cells > most_cells())) return;
  const auto side = [&](int c) { return six_digits(drawing.to[c] - drawing.from[c]); };
  const std::string size = side(0) + " x " + side(1);
  const std::string unit = p.unit == 1 ? "m" : number_text(p.unit) + " m";
  const bool given = p.element_size > 0;
  refuse_mesh(given ? "gmsh > element size" : "gmsh > file", given ? in_words(p.element_size) + " m" : p.file,
              why(cells) + ": the drawing measures " + size + " m, if its unit is " + unit + ".",
              "If it is drawn in millimetres, centimetres or feet say so by mesh > gmsh > unit = mm, cm or ft (now: " +
                  unit + "); else give a larger element size.");
}

void refuse_too_many_cells(const MeshParameters& p) {
  const double cells = cells_of(p);
  if (cells > most_cells())
    refuse_mesh(p.word(), three_digits(cells) + " cells", why(cells) + ".",
                "Give fewer stones, or fewer cells in each.");
}

std::string far_from_origin(const Drawing& d) {
  const double size = size_of(d);
  const double away =
      std::hypot(std::max(std::abs(d.from[0]), std::abs(d.to[0])), std::max(std::abs(d.from[1]), std::abs(d.to[1])));
  if (!(size > 0) || !(away > far_off * size)) return "";
  return "  The drawing lies " + three_digits(away) + " m from its origin, " + three_digits(away / size) +
         " times its size: gmsh has too few digits there. Move its origin to the structure (subtract a round number "
         "from all coordinates).";
}

}  // namespace voussoir
