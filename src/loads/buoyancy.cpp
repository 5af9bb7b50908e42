#include <algorithm>
#include <cmath>

#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "blocks/assembly.hpp"
#include "blocks/condensed_edges.hpp"
#include "loads/common_keys.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"

namespace voussoir {
namespace {

/// A point of a triangle or tetrahedron, by what each of its corners has of it.
template <int dim>
using Shares = std::array<double, dim + 1>;
template <int dim>
using Part = std::array<Shares<dim>, dim + 1>;

template <int dim>
Shares<dim> corner(int k) {
  Shares<dim> at{};
  at[k] = 1;
  return at;
}

/// Triangles that make up what of a triangle lies below a level.
/// @param height  [m] of its corners
std::vector<Part<2>> parts_below(const std::array<double, 3>& height, double level) {
  std::vector<Shares<2>> kept;
  for (int i = 0; i < 3; ++i) {
    const double a = height[i], b = height[(i + 1) % 3];
    const auto from = corner<2>(i), to = corner<2>((i + 1) % 3);
    if (a <= level) kept.push_back(from);
    if ((a <= level) != (b <= level)) kept.push_back(from + ((level - a) / (b - a)) * (to - from));
  }
  std::vector<Part<2>> parts;
  for (std::size_t i = 2; i < kept.size(); ++i) parts.push_back({kept[0], kept[i - 1], kept[i]});
  return parts;
}

/// The same of a tetrahedron.
std::vector<Part<3>> parts_below(const std::array<double, 4>& height, double level) {
  std::array<int, 4> order{0, 1, 2, 3};  // from the lowest up
  std::sort(order.begin(), order.end(), [&](int a, int b) { return height[a] < height[b]; });
  const auto risen = [&](int k) { return corner<3>(order[k]); };
  const auto between = [&](int k, int l) {
    const double a = height[order[k]], b = height[order[l]];
    return risen(k) + ((level - a) / (b - a)) * (risen(l) - risen(k));
  };
  const auto wedge = [](const std::array<Shares<3>, 3>& a, const std::array<Shares<3>, 3>& b) {
    return std::vector<Part<3>>{{a[0], a[1], a[2], b[0]}, {a[1], a[2], b[0], b[1]}, {a[2], b[0], b[1], b[2]}};
  };
  switch (std::count_if(height.begin(), height.end(), [&](double h) { return h < level; })) {
    case 0:
      return {};
    case 1:
      return {{risen(0), between(0, 1), between(0, 2), between(0, 3)}};
    case 2:
      return wedge({risen(0), between(0, 2), between(0, 3)}, {risen(1), between(1, 2), between(1, 3)});
    case 3:
      return wedge({risen(0), risen(1), risen(2)}, {between(0, 3), between(1, 3), between(2, 3)});
    default:
      return {{risen(0), risen(1), risen(2), risen(3)}};
  }
}

double share_of(const Part<2>& t) { return std::abs(dot(t[0], cross(t[1], t[2]))); }

double share_of(const Part<3>& t) {
  std::array<Vector<3>, 3> edge;
  for (int e = 0; e < 3; ++e)
    for (int c = 0; c < 3; ++c) edge[e][c] = t[e + 1][c + 1] - t[0][c + 1];
  return std::abs(dot(edge[0], cross(edge[1], edge[2])));
}

/// Integrals over what of a triangle or tetrahedron lies below a level, exact [m2], in space [m3].
template <int dim>
struct Below {
  Shares<dim> corners{};                            ///< of L_i
  std::array<double, Simplex<dim>::edges> edges{};  ///< of 4 L_i L_j, in the order of simplex_edges

  Below(const typename Simplex<dim>::Places& x, double level) {
    Shares<dim> height;
    for (int k = 0; k <= dim; ++k) height[k] = x[k][dim - 1];
    const double whole = std::abs(Simplex<dim>(x).measure);
    for (const auto& part : parts_below(height, level)) {
      const double measure = share_of(part) * whole;
      Shares<dim> sum{};
      for (const auto& at : part) sum = sum + at;
      corners = corners + (measure / (dim + 1)) * sum;
      for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [i, j] = simplex_edges[e];
        double product = sum[i] * sum[j];
        for (const auto& at : part) product += at[i] * at[j];
        edges[e] += 4 * measure / ((dim + 1) * (dim + 2)) * product;
      }
    }
  }
};

/// Cells as triangles or tetrahedra: a quadrilateral as two, a hexahedron as the six around its longest diagonal.
template <int dim>
const std::vector<std::array<int, dim + 1>>& simplices_of(const Cell& cell) {
  if constexpr (dim == 2) {
    static const std::vector<std::array<int, 3>> itself{{0, 1, 2}}, two{{0, 1, 2}, {0, 2, 3}};
    return cell.count == 4 ? two : itself;
  } else {
    static const std::vector<std::array<int, 4>> itself{{0, 1, 2, 3}};
    static const std::vector<std::array<int, 4>> six{{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                                     {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
    return cell.count == 8 ? six : itself;
  }
}

/// @param weight  [N/m3], of the plane times its thickness
template <int dim>
void add_cell(const Structure<dim>& s, const LocalBlock<dim>& b, const Cell& cell, double level, double weight,
              BlockForces& force) {
  for (const auto& corner : simplices_of<dim>(cell)) {
    typename Simplex<dim>::Places x;
    std::array<int, dim + 1> node;
    for (int k = 0; k <= dim; ++k) {
      x[k] = b.mesh.position[cell.node[corner[k]]];
      node[k] = b.first_local + cell.node[corner[k]];
    }
    const Below<dim> below(x, level);
    for (int k = 0; k <= dim; ++k) force.of_nodes[dim * node[k] + dim - 1] += weight * below.corners[k];
    for (std::size_t e = 0; b.edges && e < below.edges.size(); ++e)
      if (const int edge = s.edge_between(node[simplex_edges[e][0]], node[simplex_edges[e][1]]); edge >= 0)
        force.of_edges[dim * edge + dim - 1] += weight * below.edges[e];
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
                  double factor, BlockForces& force) {
  const double weight = factor * load.density * load.gravity;  // [N/m3]
  for (std::size_t n = 0; n < s.blocks().size(); ++n) {
    const auto& b = s.blocks()[n];
    if (!in_set[n]) continue;
    if (is_submerged(b.mesh, load.level)) {  // its cells need not be cut: each node loses what it weighs in water
      const auto volume = nodal_volumes(b.mesh, b.material, s.model());
      for (std::size_t i = 0; i < volume.size(); ++i)
        force.of_nodes[dim * (b.first_local + i) + dim - 1] += weight * volume[i];
      if (b.edges) b.edges->template add_body_force<dim>(weight * up<dim>(), &force.of_edges[dim * b.first_edge]);
    } else {
      const double thickness = dim == 2 ? thickness_of(b.material, s.model()) : 1.0;
      for (const auto& cell : b.mesh.cells) add_cell(s, b, cell, load.level, thickness * weight, force);
    }
  }
}

namespace {

template <int dim>
std::unique_ptr<Load<dim>> buoyancy(const BuoyancyParameters& p, const LoadSite<dim>& site) {
  std::vector<char> in_set;
  for (const auto& b : site.structure.blocks()) in_set.push_back(site.in_block_set(b.mesh, p.blocks));
  return made_of<BodyForce<dim>>(site.structure,
                                 [&](auto& unit) { add_buoyancy(site.structure, p, in_set, 1.0, unit); });
}

}  // namespace

template void add_buoyancy<2>(const Structure<2>&, const BuoyancyParameters&, const std::vector<char>&, double,
                              BlockForces&);

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const BuoyancyParameters& p, const LoadSite<2>& site) {
  return buoyancy(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const BuoyancyParameters& p, const LoadSite<3>& site) {
  return buoyancy(p, site);
}

}  // namespace voussoir
