#include "blocks/solid_matrices.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "blocks/hexahedron.hpp"
#include "blocks/tetrahedron.hpp"

namespace voussoir {
namespace {

bool is_tetrahedron(const Cell& cell) {
  VOUSSOIR_EXPECT(cell.count == 4 || cell.count == 8);
  return cell.count == 4;
}

std::array<Vector<3>, 4> first_four(const std::array<Vector<3>, 8>& x) { return {x[0], x[1], x[2], x[3]}; }

}  // namespace

std::vector<double> solid_stiffness(const Cell& cell, const std::array<Vector<3>, 8>& x, const Material& material,
                                    Hexahedra kind) {
  return is_tetrahedron(cell) ? tetrahedron_stiffness(first_four(x), material)
                              : hexahedron_stiffness(x, material, kind);
}

std::array<double, 8> solid_volumes(const Cell& cell, const std::array<Vector<3>, 8>& x) {
  if (!is_tetrahedron(cell)) return hexahedron_volumes(x);
  const auto share = tetrahedron_volumes(first_four(x));
  std::array<double, 8> volume{};
  std::copy(share.begin(), share.end(), volume.begin());
  return volume;
}

std::vector<double> solid_products(const Cell& cell, const std::array<Vector<3>, 8>& x) {
  return is_tetrahedron(cell) ? tetrahedron_products(first_four(x)) : hexahedron_products(x);
}

std::array<double, 6> solid_stress(const Cell& cell, const std::array<Vector<3>, 8>& x,
                                   const std::array<Vector<3>, 8>& u, const Material& material) {
  return is_tetrahedron(cell) ? tetrahedron_stress(first_four(x), first_four(u), material)
                              : hexahedron_stress(x, u, material);
}

}  // namespace voussoir
