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

}  // namespace

void BuoyancyParameters::declare(ParameterSection& section) {
  declare_block_set(section, blocks);
  declare_water(section, level, density, gravity);
}

std::string BuoyancyParameters::summary() const {
  return "buoyancy in " + number_text(density) + " kg/m3 of " + in_quotes(blocks) + " below y = " + number_text(level) +
         " m";
}

bool BuoyancyParameters::is_zero() const { return density == 0 || gravity == 0; }

template <>
void add_buoyancy<2>(const Structure<2>& s, const BuoyancyParameters& load, const std::vector<char>& in_set,
                     double factor, std::vector<double>& force) {
  const double weight = factor * load.density * load.gravity * s.model().thickness;  // [N/m2]
  for (std::size_t n = 0; n < s.blocks().size(); ++n) {
    const auto& b = s.blocks()[n];
    if (!in_set[n]) continue;
    for (const auto& cell : b.mesh.cells)
      for (int i = 2; i < cell.count; ++i) {  // a quadrilateral as two triangles
        const int corner[3] = {cell.node[0], cell.node[i - 1], cell.node[i]};
        const auto area = area_below(
            {b.mesh.position[corner[0]], b.mesh.position[corner[1]], b.mesh.position[corner[2]]}, load.level);
        for (int k = 0; k < 3; ++k) force[2 * (b.first_local + corner[k]) + 1] += weight * area[k];
      }
  }
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const BuoyancyParameters& p, const LoadSite<2>& site) {
  std::vector<char> in_set;
  for (const auto& b : site.structure.blocks()) in_set.push_back(site.in_block_set(b.mesh, p.blocks));
  return pattern_of(site.structure, [&](auto& unit) { add_buoyancy(site.structure, p, in_set, 1.0, unit); });
}

}  // namespace voussoir
