// Candidates of a whole structure: those of an independent program, and the same on any number of ranks.
#include "joints/contact_points.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <fstream>
#include <set>
#include <sstream>
#include <tuple>

#include "linalg/gather.hpp"
#include "support/repository.hpp"
#include "unit/blocks/lattice_block.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr WhyWhole of_a_test{"what a test looks at"};

std::unique_ptr<BlockSource<2>> wall() {
  WallParameters p;
  p.courses = p.blocks_per_course = 4;
  return make_wall(p);
}

/// What a point is, without the numbers of a rank.
struct Fact {
  PointId id;
  BlockId block_i, block_j;
  NodeId node_i, node_j;
  double x, y, nx, ny, area;
};

std::vector<Fact> facts(const Structure<2>& s, const ContactPoints& points, bool with_halo) {
  std::vector<Fact> list;
  for (int k = 0; k < (with_halo ? points.size() : points.owned()); ++k) {
    const auto& p = points.points()[k];
    const auto& joint = points.joints()[p.joint];
    const auto& x = s.position()[p.shares_i.first()];
    list.push_back({p.id, joint.block_i, joint.block_j, s.node_id()[p.shares_i.first()],
                    s.node_id()[p.shares_j.first()], x[0], x[1], p.axis[0][0], p.axis[0][1], p.area});
  }
  return list;
}

bool same(const Fact& a, const Fact& b) {
  const auto all = [](const Fact& f) {
    return std::tie(f.id, f.block_i, f.block_j, f.node_i, f.node_j, f.x, f.y, f.nx, f.ny, f.area);
  };
  return all(a) == all(b);
}

/// block_i, block_j, x [mm], y [mm], nx, ny
using Pair = std::array<long, 6>;

TEUCHOS_UNIT_TEST(ContactPoints, AreThePairsOfTheReferenceSceneAndThoseBetweenHeldNodes) {
  // The table leaves out the three pairs on the base, whose nodes are held. Its coordinates are multiples of 125 mm.
  std::set<Pair> expected{{0, 1, 500, 0, 1, 0}, {1, 2, 1000, 0, 1, 0}, {2, 3, 1500, 0, 1, 0}};
  std::ifstream file(repository("/tests/unit/joints/reference/W4_points.csv"));
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream row(line);
    double value[6];
    char comma = 0;
    for (double& v : value) row >> v >> comma;
    expected.insert({std::lround(value[0]), std::lround(value[1]), std::lround(1000 * value[2]),
                     std::lround(1000 * value[3]), std::lround(value[4]), std::lround(value[5])});
  }
  TEST_EQUALITY(expected.size(), 114u);
  const auto source = wall();
  const auto s = structure_of(*source, everyone());
  const ContactPoints points(*source, s);
  std::set<Pair> found;
  for (const auto& f : all_gather(facts(s, points, false), *everyone(), of_a_test))
    found.insert(
        {f.block_i, f.block_j, std::lround(1000 * f.x), std::lround(1000 * f.y), std::lround(f.nx), std::lround(f.ny)});
  TEST_ASSERT(found == expected);
  TEST_EQUALITY(points.total(), 114);
}

TEUCHOS_UNIT_TEST(ContactPoints, NumbersAndGeometryDoNotDependOnRanks) {
  ArchParameters arch;  // axes in all directions
  arch.voussoirs = 9;
  for (const auto& source : {wall(), make_arch(arch)}) {
    const auto s = structure_of(*source, everyone()), serial = structure_of(*source, alone());
    const ContactPoints points(*source, s), one(*source, serial);
    const auto expected = facts(serial, one, false);
    TEST_EQUALITY(points.total(), one.total());
    TEST_EQUALITY(points.total_joints(), one.total_joints());
    TEST_EQUALITY(one.total_joints(), static_cast<long long>(one.joints().size()));
    TEST_EQUALITY(PointId(expected.size()), one.total());
    for (std::size_t k = 0; k < expected.size(); ++k) TEST_EQUALITY(expected[k].id, PointId(k));
    for (const auto& f : facts(s, points, true)) TEST_ASSERT(same(f, expected[f.id]));  // halo points too
    const auto all = all_gather(facts(s, points, false), *everyone(), of_a_test);
    std::set<PointId> ids;
    for (const auto& f : all) ids.insert(f.id);
    TEST_EQUALITY(all.size(), expected.size());  // each owned once
    TEST_EQUALITY(ids.size(), expected.size());
  }
}

TEUCHOS_UNIT_TEST(ContactPoints, ARankOwnsThePointsOfItsLowerBlocksAndSeesAllThatTouchItsNodes) {
  const auto source = wall();
  const auto s = structure_of(*source, everyone()), serial = structure_of(*source, alone());
  const ContactPoints points(*source, s), one(*source, serial);
  std::set<PointId> seen;
  for (int k = 0; k < points.size(); ++k) {
    const auto& p = points.points()[k];
    seen.insert(p.id);
    TEST_EQUALITY(k < points.owned(), p.shares_i.first() < s.owned_nodes());
    if (k > 0 && k != points.owned()) TEST_COMPARE(points.points()[k - 1].id, <, p.id);
  }
  for (const auto& f : facts(serial, one, false)) {
    const auto mine = [&](BlockId b) { return s.local_block(b) >= 0 && s.local_block(b) < s.owned_blocks(); };
    if (mine(f.block_i) || mine(f.block_j)) TEST_ASSERT(seen.count(f.id) == 1);
  }
}

TEUCHOS_UNIT_TEST(ContactPoints, AreasSumToTheJointsAndAxesAreRightHanded) {
  const auto source = wall();
  const auto s = structure_of(*source, everyone(), {Plane::stress, 0.3});
  const ContactPoints points(*source, s);
  double area = 0;
  for (int k = 0; k < points.size(); ++k) {
    const auto& p = points.points()[k];
    if (k < points.owned()) area += p.area;
    TEST_FLOATING_EQUALITY(cross(in_plane(p.axis[0]), in_plane(p.axis[1])), 1.0, 1e-15);
    TEST_EQUALITY(dot(p.axis[0], p.axis[1]), 0.0);
  }
  // Three bed planes of 2 m, and 2 x (3 + 4) head joints of 0.25 m, 0.3 m thick.
  TEST_FLOATING_EQUALITY(sum_over_ranks(*everyone(), area), 0.3 * (3 * 2.0 + 14 * 0.25), 1e-14);
}

/// Turns every block about the origin of the drawing by its number times an angle [rad].
std::vector<double> turned_one_by_one(const Structure<2>& s, double more) {
  std::vector<double> u;
  for (int n = 0; n < s.nodes(); ++n) {
    const double angle = more * static_cast<double>(s.nodes_of(s.block_of_node()[n]).id);
    const auto x = s.position()[n];
    const auto moved = Rotation<2>(angle)(x) - x;
    u.insert(u.end(), moved.begin(), moved.end());
  }
  return u;
}

// The plane of a bed below two blocks is one plane where they have turned alike, and two where they have not.
TEUCHOS_UNIT_TEST(ContactPoints, APlaneStaysOneWhereBlocksHaveTurnedAlike) {
  for (const double more : {1e-6, 1e-2}) {
    const auto source = wall();
    auto s = structure_of(*source, everyone()), serial = structure_of(*source, alone());
    ContactPoints points(*source, s), one(*source, serial);
    s.move_to(turned_one_by_one(s, more));
    serial.move_to(turned_one_by_one(serial, more));
    points.turn_axes(s, 1e-4);
    one.turn_axes(serial, 1e-4);
    for (const auto& p : points.points()) TEST_COMPARE(norm(p.axis[0] - one.points()[p.id].axis[0]), <=, 1e-15);
    double apart = 0;  // of normals across beds at one node
    for (const auto& p : one.points())
      for (const auto& q : one.points())
        if (p.shares_i.first() == q.shares_i.first() && p.id < q.id && std::abs(dot(p.axis[0], q.axis[0])) > 0.5)
          apart = std::max(apart, norm(p.axis[0] - q.axis[0]));
    if (more < 1e-4)
      TEST_COMPARE(apart, <=, 1e-15)
    else
      TEST_FLOATING_EQUALITY(apart, more / 2, 1e-3);
  }
}

TEUCHOS_UNIT_TEST(ContactPoints, HaloPointsTakeTheValuesOfTheirOwners) {
  const auto source = wall();
  const auto s = structure_of(*source, everyone());
  const ContactPoints points(*source, s);
  std::vector<double> value(points.size(), -1.0);
  for (int k = 0; k < points.owned(); ++k) value[k] = noise(points.points()[k].id);
  points.exchange().update(value, 1);
  for (int k = 0; k < points.size(); ++k) TEST_EQUALITY(value[k], noise(points.points()[k].id));
}

}  // namespace
