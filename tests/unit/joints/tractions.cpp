// Forces of tied points: equilibrium of every block, closed forms, and the split where three blocks meet.
#include "joints/tractions.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "homogenisation/continuum.hpp"
#include "loads/loads.hpp"
#include "unit/blocks/lattice_block.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// A structure whose joints are all bonded, held at y = 0, and its forces in equilibrium with a load.
struct Bonded {
  Structure<2> structure;
  ContactPoints points;
  std::vector<char> held;
  Continuum continuum;
  std::vector<double> residual, lambda;  // K u - f per node copy [N], forces of the points [N]
  double largest_force = 0;

  Bonded(const BlockSource<2>& source, const Comm& comm, const Material& stone, const Vector<2>& acceleration)
      : structure(structure_of(source, comm, {Plane::stress, 0.5}, stone)),
        points(source, structure),
        held(held_at_base(structure)),
        continuum(structure, points, held, {}) {
    BlockForces forces(structure);
    std::vector<double> u;
    add_inertia_force<2>(structure, acceleration, 1.0, forces);
    const auto& load = forces.of_nodes;
    TpetraVector b(continuum.space().map()), x(continuum.space().map());
    continuum.space().sum(load, b);
    continuum.preconditioner()->apply(b, x);  // small enough to be factored
    continuum.space().scatter(x, u);
    structure.apply_stiffness(u, residual);
    for (std::size_t i = 0; i < residual.size(); ++i) residual[i] -= load[i];
    lambda.assign(2 * points.size(), 0.0);
    recover_tied_forces(points, continuum.space().cluster(), held, residual, lambda);
    points.exchange().update(lambda, 2);
    for (double f : lambda) largest_force = std::max(largest_force, std::abs(f));
    largest_force = largest_of_ranks(*comm, largest_force);
  }

  static std::vector<char> held_at_base(const Structure<2>& s) {
    std::vector<char> marks(2 * s.nodes(), 0);
    for (int i = 0; i < s.nodes(); ++i)
      if (s.position()[i][1] == 0) marks[2 * i] = marks[2 * i + 1] = 1;
    return marks;
  }

  Vector<2> force(int k) const {  // on block j, in x and y
    const auto& axis = points.points()[k].axis;
    return in_plane(lambda[2 * k] * axis[0] + lambda[2 * k + 1] * axis[1]);
  }
};

constexpr double gravity = 10, density = 2000, side = 0.25;  // m/s2, kg/m3, m of a cell

/// Stones of 3 x 2 cells on each other.
std::unique_ptr<BlockSource<2>> column(int stones) {
  BlockList<2> list;
  for (int b = 0; b < stones; ++b) list.blocks.push_back(block_of_cells(b, rectangle(0, 2 * b, 3, 2), side));
  return make_source<2>(list);
}

std::unique_ptr<BlockSource<2>> wall() {
  WallParameters p;
  p.courses = p.blocks_per_course = 4;
  return make_wall(p);
}

TEUCHOS_UNIT_TEST(TiedForces, EachJointOfABondedColumnCarriesTheWeightAbove) {
  constexpr int stones = 5;
  const auto source = column(stones);
  for (const double poisson : {0.0, 0.3}) {
    const Bonded bonded(*source, everyone(), {1e9, poisson, density}, {0, -gravity});
    std::vector<double> mine(2 * (stones - 1), 0.0), carried(mine.size());
    for (int k = 0; k < bonded.points.owned(); ++k) {
      const auto& p = bonded.points.points()[k];
      const int joint = bonded.points.joints()[p.joint].block_i;
      mine[2 * joint] += bonded.lambda[2 * k];
      mine[2 * joint + 1] += bonded.lambda[2 * k + 1];
      // Without Poisson effect the pressure is the same all along the joint.
      if (poisson == 0)
        TEST_FLOATING_EQUALITY(bonded.lambda[2 * k] / p.area, density * gravity * (4 - joint) * 2 * side, 1e-10);
    }
    Teuchos::reduceAll(*everyone(), Teuchos::REDUCE_SUM, int(mine.size()), mine.data(), carried.data());
    const double weight = density * gravity * 6 * side * side * 0.5;  // of a stone
    for (int joint = 0; joint < stones - 1; ++joint) {
      TEST_FLOATING_EQUALITY(carried[2 * joint], weight * (stones - 1 - joint), 1e-10);
      TEST_COMPARE(std::abs(carried[2 * joint + 1]), <=, 1e-10 * weight);
    }
  }
}

TEUCHOS_UNIT_TEST(TiedForces, HoldEveryNodeOfABondedWallInEquilibriumAlsoWhereThreeBlocksMeet) {
  const auto source = wall();
  const Bonded bonded(*source, everyone(), {1e9, 0.2, density}, {1.5, -gravity});
  auto rest = bonded.residual;
  add_contact_forces(bonded.points, {}, bonded.lambda, -1.0, rest);
  double largest = 0;
  for (int i = 0; i < 2 * bonded.structure.owned_nodes(); ++i)
    if (!bonded.held[i]) largest = std::max(largest, std::abs(rest[i]));
  TEST_COMPARE(largest, <=, 1e-10 * bonded.largest_force);
  TEST_COMPARE(bonded.largest_force, >, 100.0);  // a joint below 1 m of wall carries 20 kPa
}

TEUCHOS_UNIT_TEST(TiedForces, WhereThreeBlocksMeetTheSplitIsTheLeastSquaresOne) {
  // Forces that could be added without changing equilibrium run in a circle through the three points. The split that is
  // least in sum(force^2 / area) has none of it: tractions add to zero around the circle.
  const auto source = wall();
  const Bonded bonded(*source, everyone(), {1e9, 0.2, density}, {1.5, -gravity});
  const auto& points = bonded.points.points();
  std::map<std::pair<int, int>, int> point_between;
  for (int k = 0; k < bonded.points.size(); ++k)
    point_between[{points[k].shares_i.first(), points[k].shares_j.first()}] = k;
  int junctions = 0;
  for (const auto& [ij, k] : point_between)
    for (const auto& [jl, m] : point_between) {
      const auto il = point_between.find({ij.first, jl.second});
      if (ij.second != jl.first || il == point_between.end()) continue;
      ++junctions;
      const auto traction = [&](int n) { return (1 / points[n].area) * bonded.force(n); };
      const auto around = traction(k) + traction(m) - traction(il->second);
      TEST_COMPARE(norm(around), <=, 1e-10 * norm(traction(k)) + 1e-10 * norm(traction(m)));
    }
  if (everyone()->getSize() == 1) TEST_EQUALITY(junctions, 21);
}

TEUCHOS_UNIT_TEST(TiedForces, DoNotDependOnRanks) {
  const auto source = wall();
  const Bonded many(*source, everyone(), {1e9, 0.2, density}, {1.5, -gravity});
  const Bonded one(*source, alone(), {1e9, 0.2, density}, {1.5, -gravity});
  for (int k = 0; k < many.points.size(); ++k)
    for (int c = 0; c < 2; ++c)
      TEST_COMPARE(std::abs(many.lambda[2 * k + c] - one.lambda[2 * many.points.points()[k].id + c]), <=,
                   1e-10 * one.largest_force);
}

TEUCHOS_UNIT_TEST(TiedForces, FollowFromTheResidualWithFreePointsAndReactionsSetAside) {
  // Two stones: the first point is free and its node below held, so that an unknown reaction acts on it; the second
  // is tied with the node below held; the others are tied.
  const auto source = column(2);
  const auto s = structure_of(*source, alone());
  const ContactPoints points(*source, s);
  std::vector<double> expected(2 * points.size()), residual(2 * s.nodes(), 0.0);
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = noise(i);
  add_contact_forces(points, {}, expected, 1.0, residual);
  std::vector<int> cluster(s.nodes());
  for (int i = 0; i < s.nodes(); ++i) cluster[i] = i;
  for (int k = 1; k < points.size(); ++k)
    cluster[points.points()[k].shares_j.first()] = points.points()[k].shares_i.first();
  std::vector<char> held(2 * s.nodes(), 0);
  for (const int k : {0, 1})
    for (int c = 0; c < 2; ++c) {
      held[2 * points.points()[k].shares_i.first() + c] = 1;
      residual[2 * points.points()[k].shares_i.first() + c] += 100;
    }
  auto lambda = expected;
  std::fill(lambda.begin() + 2, lambda.end(), -7.0);  // what stood there before does not matter
  recover_tied_forces(points, cluster, held, residual, lambda);
  for (std::size_t i = 0; i < expected.size(); ++i) TEST_COMPARE(std::abs(lambda[i] - expected[i]), <=, 1e-14);
}

TEUCHOS_UNIT_TEST(ContactForces, CompressionPushesTheBlocksApartAndTiedPointsMayBeLeftOut) {
  const auto source = column(2);  // the normal of the joint points up, from stone 0 to stone 1
  const auto s = structure_of(*source, alone());
  const ContactPoints points(*source, s);
  std::vector<double> lambda(2 * points.size(), 0.0), nodal(2 * s.nodes(), 0.0);
  for (int k = 0; k < points.size(); ++k) lambda[2 * k] = 3.0;
  std::vector<int> cluster(s.nodes());
  for (int i = 0; i < s.nodes(); ++i) cluster[i] = i;
  cluster[points.points()[0].shares_j.first()] = points.points()[0].shares_i.first();
  add_contact_forces(points, cluster, lambda, 2.0, nodal);
  double sum = 0, size = 0;
  for (double f : nodal) {
    sum += f;
    size += std::abs(f);
  }
  TEST_EQUALITY(sum, 0.0);
  TEST_EQUALITY(size, 2 * 3 * 6.0);  // three of the four points, both sides
  for (int k = 0; k < points.size(); ++k) {
    const auto& p = points.points()[k];
    TEST_EQUALITY(nodal[2 * p.shares_j.first() + 1], k == 0 ? 0.0 : 6.0);
    TEST_EQUALITY(nodal[2 * p.shares_i.first() + 1], k == 0 ? 0.0 : -6.0);
  }
}

}  // namespace
