// Quadratic tetrahedra condensed to their corners: which edges bend, and what the corners feel of them.
//
// Set-up    Boxes of cubes that are cut into six tetrahedra each, alone, in a row, and held.
// Measured  Forces and stresses in closed form; the deflection of a bar over that of a beam with its bending and shear.
#include "blocks/condensed_edges.hpp"

#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_LAPACK.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "blocks/assembly.hpp"
#include "blocks/shapes.hpp"
#include "blocks/stresses.hpp"
#include "linalg/sparse_cholesky.hpp"
#include "mesh/block_list.hpp"
#include "mesh/curved_edges.hpp"
#include "unit/blocks/cut_boxes.hpp"

namespace {

using namespace voussoir;
using test::body_force;
using test::box;

const Material stone{2.5, 0.3, 1.0};  // numbers near 1, so that absolute tolerances mean relative ones

Block<3> all_curved(Block<3> block) {
  std::vector<Block<3>> alone{block};
  alone[0].id = 0;
  find_curved_edges(alone);
  alone[0].id = block.id;
  return alone[0];
}

/// Straightens edges both ends of which are told.
template <class Tell>
Block<3> straight_where(Block<3> block, const Tell& tell) {
  auto& edges = block.curved;
  const auto both = [&](const auto& e) { return tell(block.position[e[0]]) && tell(block.position[e[1]]); };
  edges.erase(std::remove_if(edges.begin(), edges.end(), both), edges.end());
  return block;
}

BlockMatrices matrices_of(const Block<3>& block, const Material& material = stone) {
  return StiffnessOfShapes(ModelParameters{}).of(block, material);
}

/// One block by itself.
Structure<3> structure_of(const Block<3>& block, const Material& material, bool quadratic,
                          const std::function<bool(const Block<3>&, const TaggedFacet&)>& held = {}) {
  BlockList<3> list;
  list.blocks = {block};
  list.blocks[0].id = 0;
  list.facet_sets = {"low"};
  list.quadratic = quadratic;
  const auto source = make_source(std::move(list));
  return Structure<3>(
      *source, {{0}, {}, {}}, {}, [&](const Block<3>&) { return material; }, Teuchos::rcp(new Teuchos::SerialComm<int>),
      held);
}

std::vector<double> solved(const LocalCsr& k, const std::vector<char>& held, const std::vector<double>& force) {
  std::vector<int> number(k.rows(), -1), free;
  std::vector<double> right;
  for (int i = 0; i < k.rows(); ++i)
    if (!held[i]) {
      number[i] = static_cast<int>(free.size());
      free.push_back(i);
      right.push_back(force[i]);
    }
  LocalCsr upper;
  for (const int i : free) {
    for (int e = k.start[i]; e < k.start[i + 1]; ++e)
      if (number[k.column[e]] >= number[i]) {
        upper.column.push_back(number[k.column[e]]);
        upper.value.push_back(k.value[e]);
      }
    upper.start.push_back(static_cast<int>(upper.column.size()));
  }
  SparseCholesky(upper).solve(right.data(), right.data());
  std::vector<double> u(k.rows(), 0.0);
  for (std::size_t i = 0; i < free.size(); ++i) u[free[i]] = right[i];
  return u;
}

Vector<3> uniform_strain(const Vector<3>& x) {
  return {0.5 + 3 * x[0] + x[1] - x[2], -1 + 2 * x[0] - 2 * x[1] + 0.5 * x[2], 2 - x[0] + 0.5 * x[1] + x[2]};
}

TEUCHOS_UNIT_TEST(CurvedEdges, AreThoseOfOneBlockAlone) {
  // Two boxes share a face of 2 x 1 cubes, and a third touches the second along an edge.
  std::vector<Block<3>> blocks{box(0, {2, 1, 1}, 1), box(1, {2, 1, 1}, 1, {0, 0, 1}), box(2, {2, 1, 1}, 1, {0, 1, 2})};
  find_curved_edges(blocks);
  for (const auto& block : blocks) {
    const auto on = [&](double y, double z) {
      return std::count_if(block.curved.begin(), block.curved.end(), [&](const auto& e) {
        const auto &a = block.position[e[0]], &b = block.position[e[1]];
        return a[2] == z && b[2] == z && (y < 0 || (a[1] == y && b[1] == y));
      });
    };
    TEST_EQUALITY(on(-1, 1), 0);  // of the joint, the third box is above
    if (block.id > 0) TEST_EQUALITY(on(1, 2), 0);
    // Edges of boxes of 2 x 1 x 1 cubes: 20 along axes, 11 diagonals of faces, 2 within. A face of 2 x 1 has 9.
    const std::array<std::size_t, 3> left{33 - 9, 33 - 9 - 2, 33 - 2};
    TEST_EQUALITY(block.curved.size(), left[block.id]);
  }
}

TEUCHOS_UNIT_TEST(CurvedEdges, HeldFacetsHaveNone) {
  auto block = all_curved(box(0, {1, 1, 1}, 1));
  block.facets.push_back({{0, 1, 3, 3}, 3, 0});
  TEST_EQUALITY(block.curved.size(), 19u);
  TEST_EQUALITY(curved_edges_off(block, [](const TaggedFacet&) { return true; }).size(), 16u);
  TEST_EQUALITY(curved_edges_off(block, [](const TaggedFacet&) { return false; }).size(), 19u);
}

TEUCHOS_UNIT_TEST(CurvedEdges, OfLinearCellsThereAreNone) {
  const auto k = structure_of(box(0, {1, 1, 1}, 1), stone, false);
  TEST_ASSERT(!k.blocks()[0].edges && k.blocks()[0].sparse == k.blocks()[0].stiffness);
}

TEUCHOS_UNIT_TEST(CondensedEdges, BlocksMoveAndTurnFreelyAndNothingElseIsFree) {
  const auto block = straight_where(all_curved(box(0, {2, 2, 1}, 0.5)), [](const auto& x) { return x[2] == 0; });
  const auto matrices = matrices_of(block);
  const int n = matrices.stiffness->rows();
  // Of K and of K + K_linear, so that rigid motions do not divide by zero: x = k / (k + k_linear) is 0.5 at most.
  auto k = matrices.stiffness->value;
  std::vector<double> both = k, value(n), work(10 * n);
  for (int i = 0; i < n; ++i)
    for (int e = matrices.sparse->start[i]; e < matrices.sparse->start[i + 1]; ++e)
      both[i * n + matrices.sparse->column[e]] += matrices.sparse->value[e];
  int info = 0;
  auto lone = k;
  Teuchos::LAPACK<int, double>().SYEV('N', 'U', n, lone.data(), n, value.data(), work.data(), 10 * n, &info);
  TEST_EQUALITY(info, 0);
  for (int i = 0; i < 6; ++i) TEST_COMPARE(std::abs(value[i]), <=, 1e-13);
  TEST_COMPARE(value[6], >=, 1e-3 * value[n - 1]);
  for (int i = 0; i < n; ++i) both[i * n + i] += 1e-9 * value[n - 1];
  Teuchos::LAPACK<int, double>().SYGV(1, 'N', 'U', n, k.data(), n, both.data(), n, value.data(), work.data(), 10 * n,
                                      &info);
  TEST_EQUALITY(info, 0);
  const auto over_linear = [](double x) { return x / (1 - x); };
  TEST_COMPARE(over_linear(value[n - 1]), <=, 1 + 1e-6);  // what may bend is never stiffer
  TEST_COMPARE(over_linear(value[6]), >=, 1 / 12.0);      // nor much softer, so linear cells precondition
}

TEUCHOS_UNIT_TEST(CondensedEdges, UniformStrainIsExactInADistortedMesh) {
  auto block = box(0, {3, 3, 3}, 1.0);
  int k = 0;
  for (auto& x : block.position)  // inner nodes are moved
    if (std::all_of(x.begin(), x.end(), [](double c) { return c > 0 && c < 3; }))
      for (double& c : x) c += 0.2 * std::sin(7.0 * ++k);
  const auto border = [](const Vector<3>& x) {
    return std::any_of(x.begin(), x.end(), [](double c) { return c == 0 || c == 3; });
  };
  block = straight_where(all_curved(block), border);
  const auto matrices = matrices_of(block);
  std::vector<double> u, force(matrices.stiffness->rows()), linear(force.size());
  for (const auto& x : block.position)
    for (const double c : uniform_strain(x)) u.push_back(c);
  matrices.stiffness->multiply(u.data(), force.data());
  matrices.sparse->multiply(u.data(), linear.data());
  double largest = 0, apart = 0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    largest = std::max(largest, std::abs(linear[i]));
    apart = std::max(apart, std::abs(linear[i] - force[i]));
  }
  TEST_COMPARE(apart, <=, 1e-12 * largest);
  const CondensedEdges edges(block, stone, {});
  for (const auto& cell : edges.bends<3>(block, u, body_force<3>(edges, {})))
    for (const auto& bend : cell) TEST_COMPARE(norm(bend), <=, 1e-12);
}

TEUCHOS_UNIT_TEST(CondensedEdges, HandOverNoForceAndNoMoment) {
  const auto block = straight_where(all_curved(box(0, {2, 1, 3}, 0.5)), [](const auto& x) { return x[0] == 0; });
  std::vector<double> force(3 * block.position.size(), 0.0);
  const CondensedEdges edges(block, stone, {});
  edges.hand_over(body_force<3>(edges, {1, -2, 3}), force.data());
  Vector<3> sum{}, moment{};
  double largest = 0;
  for (std::size_t i = 0; i < block.position.size(); ++i) {
    const Vector<3> f{force[3 * i], force[3 * i + 1], force[3 * i + 2]};
    sum = sum + f;
    moment = moment + cross(block.position[i], f);
    largest = std::max(largest, norm(f));
  }
  TEST_COMPARE(largest, >, 1e-3);
  TEST_COMPARE(norm(sum) + norm(moment), <=, 1e-13);
}

// Where nothing is strained across, u = w (z^2 / 2 - h z) / E: a quadratic, which these cells have. The mean stress of
// a cell is that at its middle.
TEUCHOS_UNIT_TEST(CondensedEdges, AColumnUnderItsOwnWeightIsExact) {
  const double weight = 0.7, height = 1.5;
  const Material slack{2.5, 0.0, 1.0};
  auto block = box(0, {2, 1, 3}, 0.5);
  for (const auto& t : std::array<std::array<int, 3>, 4>{{{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}})
    block.facets.push_back({{t[0], t[1], t[2], t[2]}, 3, 0});
  const auto s = structure_of(block, slack, true, [](const Block<3>&, const TaggedFacet& f) { return f.set == 0; });
  const auto& b = s.blocks()[0];
  std::vector<double> force(3 * block.position.size(), 0.0);
  std::vector<char> held(force.size(), 0);
  const auto volume = nodal_volumes(block);
  for (std::size_t i = 0; i < volume.size(); ++i) {
    force[3 * i + 2] = -weight * volume[i];
    for (int c = 0; c < 3 && block.position[i][2] == 0; ++c) held[3 * i + c] = 1;
  }
  const auto of_edges = body_force<3>(*b.edges, {0, 0, -weight});
  b.edges->hand_over(of_edges, force.data());
  const auto u = solved(*b.stiffness, held, force);
  for (std::size_t i = 0; i < volume.size(); ++i) {
    const double z = block.position[i][2];
    TEST_COMPARE(std::abs(u[3 * i + 2] - weight * (z * z / 2 - height * z) / slack.young_modulus), <=, 1e-13);
    TEST_COMPARE(std::abs(u[3 * i]) + std::abs(u[3 * i + 1]), <=, 1e-13);
  }
  const auto stress = cell_stresses(s, u, {{}, of_edges});
  for (std::size_t n = 0; n < block.cells.size(); ++n) {
    double z = 0;
    for (int k = 0; k < 4; ++k) z += block.position[block.cells[n].node[k]][2] / 4;
    for (int c = 0; c < 6; ++c)
      TEST_COMPARE(std::abs(stress[6 * n + c] - (c == 5 ? -weight * (height - z) : 0.0)), <=, 1e-12);
  }
}

TEUCHOS_UNIT_TEST(CondensedEdges, WhatSwellsFreelyHasNoStress) {
  const auto s = structure_of(box(0, {2, 1, 1}, 0.5), stone, true);
  std::vector<double> u;
  for (const auto& x : s.position())
    for (const double c : x) u.push_back(1e-3 * c);
  for (const double value : cell_stresses(s, u, {{1e-3}, {}})) TEST_COMPARE(std::abs(value), <=, 1e-15);
}

/// Of a bar of 2 x 1 x 1 m held at one end and sheared at the other, over that of a beam.
/// @param joints  faces whose edges stay straight beside those of the held one
using Face = bool (*)(const Vector<3>&);
double deflection(int n, bool quadratic, const std::vector<Face>& joints) {
  const double h = 1.0 / n;
  auto block = box(0, {2 * n, n, n}, h);
  const auto held_end = [](const Vector<3>& x) { return x[0] == 0; };
  if (quadratic) block = straight_where(all_curved(block), held_end);
  for (const Face joint : joints) block = straight_where(block, joint);
  const Material material{1e9, 0.2, 0};
  const auto k = matrices_of(block, material).stiffness;
  std::vector<double> force(k->rows(), 0.0);
  std::vector<char> held(force.size(), 0);
  for (std::size_t i = 0; i < block.position.size(); ++i)
    for (int c = 0; c < 3 && held_end(block.position[i]); ++c) held[3 * i + c] = 1;
  for (const auto& cell : block.cells)
    for (int left_out = 0; left_out < 4; ++left_out) {
      bool end = true;
      for (int c = 0; c < 4; ++c) end &= c == left_out || std::abs(block.position[cell.node[c]][0] - 2) < 1e-9;
      for (int c = 0; c < 4 && end; ++c)
        if (c != left_out) force[3 * cell.node[c] + 2] += h * h / 2 / 3;
    }
  const auto u = solved(*k, held, force);
  const double shear = material.young_modulus / (2 * (1 + material.poisson_ratio));
  const double beam = 8 / (3 * material.young_modulus / 12) + 2 * 1.2 / shear;
  return std::inner_product(u.begin(), u.end(), force.begin(), 0.0) / beam;
}

TEUCHOS_UNIT_TEST(CondensedEdges, ABarOfFewCellsBendsAsABeamDoes) {
  const Face end = [](const Vector<3>& x) { return std::abs(x[0] - 2) < 1e-9; };
  const Face left = [](const Vector<3>& x) { return x[1] == 0; };
  const Face right = [](const Vector<3>& x) { return std::abs(x[1] - 1) < 1e-9; };
  TEST_COMPARE(deflection(2, false, {}), <, 0.6);  // linear
  TEST_COMPARE(std::abs(deflection(2, true, {}) - 1), <=, 0.03);
  TEST_COMPARE(std::abs(deflection(2, true, {end}) - 1), <=, 0.03);
  // With joints on two sides more edges stay straight; one cell between them has few that bend.
  TEST_COMPARE(std::abs(deflection(2, true, {end, left, right}) - 0.825), <=, 0.01);
  TEST_COMPARE(std::abs(deflection(1, true, {end, left, right}) - 0.449), <=, 0.01);
}

TEUCHOS_UNIT_TEST(CondensedEdges, BlocksThatAreAlikeShareThemWhereTheirCurvedEdgesAgree) {
  StiffnessOfShapes shapes{ModelParameters{}};
  const auto block = all_curved(box(0, {1, 1, 1}, 1)), other = all_curved(box(1, {1, 1, 1}, 1, {5, 6, 7}));
  const auto k = shapes.of(block, stone);
  TEST_ASSERT(shapes.of(other, stone).stiffness == k.stiffness && shapes.of(other, stone).edges == k.edges);
  TEST_ASSERT(shapes.of(straight_where(other, [](const auto& x) { return x[2] == 7; }), stone).stiffness !=
              k.stiffness);
}

}  // namespace
