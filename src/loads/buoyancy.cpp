#include <algorithm>
#include <cmath>

#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "blocks/assembly.hpp"
#include "loads/common_keys.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {
namespace {

/// What is left of a triangle below a level.
std::vector<Vector<2>> below(const std::array<Vector<2>, 3>& corners, double level) {
  std::vector<Vector<2>> kept;
  for (int i = 0; i < 3; ++i) {
    const auto& a = corners[i];
    const auto& b = corners[(i + 1) % 3];
    if (a[1] <= level) kept.push_back(a);
    if ((a[1] <= level) != (b[1] <= level)) kept.push_back(a + ((level - a[1]) / (b[1] - a[1])) * (b - a));
  }
  return kept;
}

/// Integral of the three linear shape functions of a triangle over its part below a level [m2]. Exact: a linear
/// function takes its mean at the centroid of each triangle of the part.
std::array<double, 3> area_below(const std::array<Vector<2>, 3>& x, double level) {
  std::array<double, 3> share{};
  const double whole = cross(x[1] - x[0], x[2] - x[0]);
  const auto part = below(x, level);
  for (std::size_t i = 2; i < part.size(); ++i) {
    const double area = cross(part[i - 1] - part[0], part[i] - part[0]) / 2;
    const auto middle = (1.0 / 3) * (part[0] + part[i - 1] + part[i]);
    for (int k = 0; k < 3; ++k) share[k] += area * cross(x[(k + 1) % 3] - middle, x[(k + 2) % 3] - middle) / whole;
  }
  return share;
}

/// A point of a tetrahedron, by what each of its corners has of it.
using Shares = std::array<double, 4>;

double part_of(const std::array<Shares, 4>& t) {
  std::array<Vector<3>, 3> edge;
  for (int e = 0; e < 3; ++e)
    for (int c = 0; c < 3; ++c) edge[e][c] = t[e + 1][c + 1] - t[0][c + 1];
  return std::abs(dot(edge[0], cross(edge[1], edge[2])));
}

/// Tetrahedra that make up what of a tetrahedron lies below a level.
/// @param height  [m] of its corners
std::vector<std::array<Shares, 4>> parts_below(const std::array<double, 4>& height, double level) {
  std::array<int, 4> order{0, 1, 2, 3};  // from the lowest up
  std::sort(order.begin(), order.end(), [&](int a, int b) { return height[a] < height[b]; });
  const auto corner = [&](int k) {
    Shares at{};
    at[order[k]] = 1;
    return at;
  };
  const auto between = [&](int k, int l) {
    const double a = height[order[k]], b = height[order[l]];
    return corner(k) + ((level - a) / (b - a)) * (corner(l) - corner(k));
  };
  const auto wedge = [](const std::array<Shares, 3>& a, const std::array<Shares, 3>& b) {
    return std::vector<std::array<Shares, 4>>{
        {a[0], a[1], a[2], b[0]}, {a[1], a[2], b[0], b[1]}, {a[2], b[0], b[1], b[2]}};
  };
  switch (std::count_if(height.begin(), height.end(), [&](double h) { return h < level; })) {
    case 0:
      return {};
    case 1:
      return {{corner(0), between(0, 1), between(0, 2), between(0, 3)}};
    case 2:
      return wedge({corner(0), between(0, 2), between(0, 3)}, {corner(1), between(1, 2), between(1, 3)});
    case 3:
      return wedge({corner(0), corner(1), corner(2)}, {between(0, 3), between(1, 3), between(2, 3)});
    default:
      return {{corner(0), corner(1), corner(2), corner(3)}};
  }
}

/// The same for the four shape functions of a tetrahedron [m3].
Shares volume_below(const std::array<Vector<3>, 4>& x, double level) {
  Shares share{};
  const double whole = std::abs(dot(x[1] - x[0], cross(x[2] - x[0], x[3] - x[0]))) / 6;
  for (const auto& part : parts_below({x[0][2], x[1][2], x[2][2], x[3][2]}, level))
    share = share + (part_of(part) * whole / 4) * (part[0] + part[1] + part[2] + part[3]);
  return share;
}

/// Cells of space as tetrahedra: a hexahedron as the six around its longest diagonal.
const std::vector<std::array<int, 4>>& tetrahedra_of(const Cell& cell) {
  static const std::vector<std::array<int, 4>> itself{{0, 1, 2, 3}};
  static const std::vector<std::array<int, 4>> six{{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                                   {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  return cell.count == 8 ? six : itself;
}

void add_cell(const Structure<2>& s, const LocalBlock<2>& b, const Cell& cell, double level, double weight,
              std::vector<double>& force) {
  const double thickness = thickness_of(b.material, s.model());
  for (int i = 2; i < cell.count; ++i) {  // a quadrilateral as two triangles
    const int corner[3] = {cell.node[0], cell.node[i - 1], cell.node[i]};
    const auto area =
        area_below({b.mesh.position[corner[0]], b.mesh.position[corner[1]], b.mesh.position[corner[2]]}, level);
    for (int k = 0; k < 3; ++k) force[2 * (b.first_local + corner[k]) + 1] += weight * thickness * area[k];
  }
}

void add_cell(const Structure<3>&, const LocalBlock<3>& b, const Cell& cell, double level, double weight,
              std::vector<double>& force) {
  for (const auto& corner : tetrahedra_of(cell)) {
    std::array<Vector<3>, 4> x;
    for (int k = 0; k < 4; ++k) x[k] = b.mesh.position[cell.node[corner[k]]];
    const auto volume = volume_below(x, level);
    for (int k = 0; k < 4; ++k) force[3 * (b.first_local + cell.node[corner[k]]) + 2] += weight * volume[k];
  }
}

template <int dim>
bool is_submerged(const Block<dim>& block, double level) {
  return std::all_of(block.position.begin(), block.position.end(), [&](const auto& x) { return x[dim - 1] <= level; });
}

template <int dim>
Vector<dim> up() {
  Vector<dim> direction{};
  direction[dim - 1] = 1;
  return direction;
}

}  // namespace

void BuoyancyParameters::declare(ParameterSection& section) {
  declare_block_set(section, blocks);
  declare_water(section, level, density, gravity);
}

std::string BuoyancyParameters::summary() const {
  return "buoyancy in " + number_text(density) + " kg/m3 of " + in_quotes(blocks) + " below the level " +
         number_text(level) + " m";
}

bool BuoyancyParameters::is_zero() const { return density == 0 || gravity == 0; }

template <int dim>
void add_buoyancy(const Structure<dim>& s, const BuoyancyParameters& load, const std::vector<char>& in_set,
                  double factor, std::vector<double>& force) {
  const double weight = factor * load.density * load.gravity;  // [N/m3]
  for (std::size_t n = 0; n < s.blocks().size(); ++n) {
    const auto& b = s.blocks()[n];
    if (!in_set[n]) continue;
    if (is_submerged(b.mesh, load.level)) {  // its cells need not be cut: each node loses what it weighs in water
      const auto volume = nodal_volumes(b.mesh, b.material, s.model());
      for (std::size_t i = 0; i < volume.size(); ++i) force[dim * (b.first_local + i) + dim - 1] += weight * volume[i];
      hand_over_edges<dim>(b, weight * up<dim>(), force);
    } else {
      for (const auto& cell : b.mesh.cells) add_cell(s, b, cell, load.level, weight, force);
    }
  }
}

namespace {

template <int dim>
std::unique_ptr<Load<dim>> buoyancy(const BuoyancyParameters& p, const LoadSite<dim>& site) {
  std::vector<char> in_set;
  for (const auto& b : site.structure.blocks()) in_set.push_back(site.in_block_set(b.mesh, p.blocks));
  std::vector<double> unit(static_cast<std::size_t>(dim) * site.structure.nodes(), 0.0), per_volume;
  add_buoyancy(site.structure, p, in_set, 1.0, unit);
  for (std::size_t n = 0; n < in_set.size(); ++n) {
    const bool lifted = in_set[n] && is_submerged(site.structure.blocks()[n].mesh, p.level);
    for (const double along : up<dim>()) per_volume.push_back(lifted ? along * p.density * p.gravity : 0.0);
  }
  return std::make_unique<BodyForce<dim>>(site.structure, unit, std::move(per_volume));
}

}  // namespace

template void add_buoyancy<2>(const Structure<2>&, const BuoyancyParameters&, const std::vector<char>&, double,
                              std::vector<double>&);

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const BuoyancyParameters& p, const LoadSite<2>& site) {
  return buoyancy(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const BuoyancyParameters& p, const LoadSite<3>& site) {
  return buoyancy(p, site);
}

}  // namespace voussoir
