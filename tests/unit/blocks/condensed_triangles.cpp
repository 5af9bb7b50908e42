// Quadratic triangles condensed to their corners: the plane's case of condensed_edges.cpp.
//
// Set-up    Rectangles of squares that are cut into two triangles each.
// Measured  Forces and stresses in closed form; the deflection of a bar over that of a beam with its bending and shear.
#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_LAPACK.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <array>
#include <cmath>

#include "blocks/assembly.hpp"
#include "blocks/condensed_edges.hpp"
#include "blocks/stresses.hpp"
#include "blocks/structure.hpp"
#include "mesh/block_list.hpp"
#include "mesh/curved_edges.hpp"
#include "unit/blocks/cut_boxes.hpp"

namespace {

using namespace voussoir;
using test::body_force;
using test::rectangle_of_triangles;

const Material stone{2.5, 0.3, 1.0};  // numbers near 1, so that absolute tolerances mean relative ones
constexpr double thickness = 0.7;

/// One block by itself, whose edges of a set are held.
Structure<2> structure_of(const Block<2>& block, const Material& material, bool quadratic, int held) {
  BlockList<2> list;
  list.blocks = {block};
  list.facet_sets = {"low", "left"};
  list.quadratic = quadratic;
  ModelParameters model;
  model.thickness = thickness;
  const auto source = make_source(std::move(list));
  return Structure<2>(
      *source, {{0}, {}, {}}, model, [&](const Block<2>&) { return material; },
      Teuchos::rcp(new Teuchos::SerialComm<int>),
      [held](const Block<2>&, const TaggedFacet& f) { return f.set == held; });
}

std::vector<double> solved(const LocalCsr& k, const std::vector<char>& held, const std::vector<double>& force) {
  std::vector<int> free;
  for (int i = 0; i < k.rows(); ++i)
    if (!held[i]) free.push_back(i);
  const int n = static_cast<int>(free.size());
  std::vector<double> dense(static_cast<std::size_t>(n) * n), right;
  for (const int i : free) {
    for (int j = 0; j < n; ++j) {
      const auto *from = &k.column[k.start[i]], *to = from + (k.start[i + 1] - k.start[i]);
      const auto* at = std::lower_bound(from, to, free[j]);
      dense[static_cast<std::size_t>(j) * n + right.size()] =
          at != to && *at == free[j] ? k.value[at - &k.column[0]] : 0;
    }
    right.push_back(force[i]);
  }
  std::vector<int> pivot(n);
  int info = 0;
  Teuchos::LAPACK<int, double>().GESV(n, 1, dense.data(), n, pivot.data(), right.data(), n, &info);
  std::vector<double> u(k.rows(), 0.0);
  for (int i = 0; i < n; ++i) u[free[i]] = right[i];
  return u;
}

TEUCHOS_UNIT_TEST(CondensedTriangles, EdgesOfOneBlockAloneBend) {
  std::vector<Block<2>> blocks{rectangle_of_triangles(0, 2, 1, 1), rectangle_of_triangles(1, 2, 1, 1, 2)};
  find_curved_edges(blocks);
  for (const auto& block : blocks) {
    TEST_EQUALITY(block.curved.size(), 8);  // nine, less the one that both have
    for (const auto& e : block.curved) TEST_ASSERT(block.position[e[0]][0] != 2 || block.position[e[1]][0] != 2);
    // None bends along what is held.
    const auto free = curved_edges_off(block, [](const TaggedFacet& f) { return f.set == 0; });
    TEST_EQUALITY(free.size(), 6);
  }
}

TEUCHOS_UNIT_TEST(CondensedTriangles, NothingBendsUnderUniformStrain) {
  std::vector<Block<2>> blocks{rectangle_of_triangles(0, 3, 2, 0.5)};
  find_curved_edges(blocks);
  // The outside stays straight, as on joints: there stress is borne.
  auto& edges = blocks[0].curved;
  const auto outside = [&](const auto& e) {
    const auto &a = blocks[0].position[e[0]], &b = blocks[0].position[e[1]];
    return (a[0] == b[0] && (a[0] == 0 || a[0] == 1.5)) || (a[1] == b[1] && (a[1] == 0 || a[1] == 1));
  };
  edges.erase(std::remove_if(edges.begin(), edges.end(), outside), edges.end());
  TEST_ASSERT(!edges.empty());
  std::vector<double> u;
  for (const auto& x : blocks[0].position) {
    u.push_back(0.5 + 3 * x[0] + x[1]);
    u.push_back(-1 + 2 * x[0] - 2 * x[1]);
  }
  const CondensedEdges condensed(blocks[0], stone, {});
  for (const auto& cell : condensed.bends<2>(blocks[0], u, body_force<2>(condensed, {})))
    for (const auto& bend : cell) TEST_COMPARE(norm(bend), <=, 1e-12);
}

TEUCHOS_UNIT_TEST(CondensedTriangles, HandOverNoForceAndNoMoment) {
  std::vector<Block<2>> blocks{rectangle_of_triangles(0, 2, 3, 0.5)};
  find_curved_edges(blocks);
  std::vector<double> force(2 * blocks[0].position.size(), 0.0);
  const CondensedEdges edges(blocks[0], stone, {});
  edges.hand_over(body_force<2>(edges, {1, -2}), force.data());
  Vector<2> sum{};
  double moment = 0, largest = 0;
  for (std::size_t i = 0; i < blocks[0].position.size(); ++i) {
    const Vector<2> f{force[2 * i], force[2 * i + 1]};
    sum = sum + f;
    moment += cross(blocks[0].position[i], f);
    largest = std::max(largest, norm(f));
  }
  TEST_COMPARE(largest, >, 1e-3);
  TEST_COMPARE(norm(sum) + std::abs(moment), <=, 1e-13);
}

// Where nothing is strained across, u = w (y^2 / 2 - h y) / E: a quadratic, which these cells have. The mean stress of
// a cell is that at its middle.
TEUCHOS_UNIT_TEST(CondensedTriangles, AColumnUnderItsOwnWeightIsExact) {
  const double weight = 0.7, height = 1.5;
  const Material slack{2.5, 0.0, 1.0};
  const auto block = rectangle_of_triangles(0, 2, 3, 0.5);
  const auto s = structure_of(block, slack, true, 0);
  const auto& b = s.blocks()[0];
  std::vector<double> force(2 * block.position.size(), 0.0);
  std::vector<char> held(force.size(), 0);
  const auto volume = nodal_volumes(block, thickness);
  for (std::size_t i = 0; i < volume.size(); ++i) {
    force[2 * i + 1] = -weight * volume[i];
    for (int c = 0; c < 2 && block.position[i][1] == 0; ++c) held[2 * i + c] = 1;
  }
  const auto of_edges = body_force<2>(*b.edges, {0, -weight});
  b.edges->hand_over(of_edges, force.data());
  const auto u = solved(*b.stiffness, held, force);
  for (std::size_t i = 0; i < volume.size(); ++i) {
    const double y = block.position[i][1];
    TEST_COMPARE(std::abs(u[2 * i + 1] - weight * (y * y / 2 - height * y) / slack.young_modulus), <=, 1e-13);
    TEST_COMPARE(std::abs(u[2 * i]), <=, 1e-13);
  }
  const auto stress = cell_stresses(s, u, {{}, of_edges});
  for (std::size_t n = 0; n < block.cells.size(); ++n) {
    double middle = 0;
    for (int i = 0; i < 3; ++i) middle += block.position[block.cells[n].node[i]][1] / 3;
    TEST_COMPARE(std::abs(stress[3 * n + 1] - weight * (middle - height)), <=, 1e-12);
    TEST_COMPARE(std::abs(stress[3 * n]) + std::abs(stress[3 * n + 2]), <=, 1e-12);
  }
}

/// How far the end of a bar 2 : 1 that is held at the left and sheared at the right goes, over a beam's.
double of_a_beam(int across, bool quadratic) {
  const double h = 2.0 / across;
  const auto block = rectangle_of_triangles(0, across, across / 2, h);
  const auto s = structure_of(block, stone, quadratic, 1);
  std::vector<double> force(2 * block.position.size(), 0.0);
  std::vector<char> held(force.size(), 0);
  for (std::size_t i = 0; i < block.position.size(); ++i) {
    const auto& x = block.position[i];
    for (int c = 0; c < 2 && x[0] == 0; ++c) held[2 * i + c] = 1;
    if (x[0] == 2) force[2 * i + 1] = x[1] == 0 || x[1] == 1 ? h / 2 : h;  // 1 in all
  }
  const auto u = solved(*s.blocks()[0].stiffness, held, force);
  double way = 0;
  for (std::size_t i = 0; i < block.position.size(); ++i)
    if (block.position[i][0] == 2) way += force[2 * i + 1] * u[2 * i + 1];
  const double bends = 8 / (3 * stone.young_modulus * thickness / 12);
  const double shears = 1.2 * 2 * 2 * (1 + stone.poisson_ratio) / (stone.young_modulus * thickness);
  return way / (bends + shears);
}

TEUCHOS_UNIT_TEST(CondensedTriangles, ABarBendsAsABeam) {
  // The held end may not narrow, and points of the free one bear more than a beam's parabola gives them: within 2 %.
  const double coarse = of_a_beam(4, true), fine = of_a_beam(8, true);
  TEST_COMPARE(coarse, >, 0.97);
  TEST_COMPARE(coarse, <, 1.0);
  TEST_COMPARE(fine, >, coarse);
  TEST_COMPARE(fine, <, 1.02);
  // Linear ones are worth keeping for comparison alone.
  TEST_COMPARE(of_a_beam(4, false), <, 0.7);
}

}  // namespace
