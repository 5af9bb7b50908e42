// Forces that run round where three stones meet: the split is one, whatever the forces it is made from.
#include "joints/shared_forces.hpp"

#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "joints/tractions.hpp"
#include "mesh/generators.hpp"
#include "unit/blocks/lattice_block.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Two stones side by side on one as wide as both: in the middle of its top three points meet.
struct Three {
  std::unique_ptr<BlockSource<2>> source;
  Structure<2> structure;
  ContactPoints points;
  std::vector<int> cluster;
  std::vector<int> middle;  // points that meet, where they are local
  SharedForces shared;
  std::vector<PointFreedom> freedom;
  std::vector<double> lambda;  // N

  explicit Three(const Comm& comm)
      : source(stones()),
        structure(structure_of(*source, comm)),
        points(*source, structure),
        cluster(structure.nodes()),
        shared(structure, points, numbered(cluster), std::vector<char>(2 * structure.nodes(), 0),
               std::vector<char>(points.size(), 1)),
        freedom(points.size(), {true, true, {}, {0.0, infinity, infinity}}),
        lambda(2 * points.size()) {
    for (int k = 0; k < points.size(); ++k) {
      const auto at = points.at(k).place(Side::i, structure.position());
      if (at[0] == 1 && at[1] == 1) middle.push_back(k);
      for (int c = 0; c < 2; ++c) lambda[2 * k + c] = 10.0 + 3.0 * static_cast<double>(points.points()[k].id) - 7.0 * c;
    }
  }
  static std::unique_ptr<BlockSource<2>> stones() {
    BlockList<2> list;
    list.blocks = {block_of_cells(0, rectangle(0, 0, 2, 1)), block_of_cells(1, rectangle(0, 1, 1, 1)),
                   block_of_cells(2, rectangle(1, 1, 1, 1))};
    return make_source<2>(list);
  }
  static const std::vector<int>& numbered(std::vector<int>& list) {
    std::iota(list.begin(), list.end(), 0);
    return list;
  }
  /// Adds a force that runs round: from stone 0 to 1, from 1 to 2 and back.
  void turn(const Vector<2>& force) {
    for (int k : middle) {
      const auto& p = points.points()[k];
      const auto& joint = points.joints()[p.joint];
      const double sign = joint.block_i == 0 && joint.block_j == 2 ? -1 : 1;
      for (int c = 0; c < 2; ++c) lambda[2 * k + c] += sign * (force[0] * p.axis[c][0] + force[1] * p.axis[c][1]);
    }
  }
  std::vector<double> split(SharedFriction friction = SharedFriction::follows) {
    shared.split(freedom, friction, lambda);
    points.exchange().update(lambda, 2);
    return lambda;
  }
  std::vector<double> on_nodes() const {
    std::vector<double> nodal(2 * structure.nodes(), 0.0);
    add_contact_forces(points, {}, lambda, 1.0, nodal);
    return nodal;
  }
};

// Forces are some tens of newtons; what elimination and some sweeps leave of them is round-off.
constexpr double round_off = 1e-11;

TEUCHOS_UNIT_TEST(SharedForces, AreSplitInOneWay) {
  const auto comm = everyone();
  Three three(comm);
  TEST_ASSERT(!three.shared.any() || three.middle.size() == 3);
  const auto before = three.on_nodes();
  const auto once = three.split();
  TEST_COMPARE_FLOATING_ARRAYS(before, three.on_nodes(), round_off);
  three.turn({17, -5});
  const auto again = three.split();
  for (std::size_t i = 0; i < once.size(); ++i) TEST_COMPARE(std::abs(again[i] - once[i]), <=, 100 * round_off);
  // The least sum of force^2 / w does not change, to first order, along what runs round.
  for (int axis = 0; axis < 2 && three.middle.size() == 3 && three.shared.any(); ++axis) {
    const auto at = three.lambda;
    Vector<2> unit{};
    unit[axis] = 1;
    three.turn(unit);
    double slope = 0;
    for (int k : three.middle)
      for (int c = 0; c < 2; ++c)
        slope += at[2 * k + c] * (three.lambda[2 * k + c] - at[2 * k + c]) / three.points.points()[k].area;
    TEST_COMPARE(std::abs(slope), <=, 100 * round_off);
    three.lambda = at;
  }
}

TEUCHOS_UNIT_TEST(SharedForces, StayWithinTheLawWhereThatCanBe) {
  const auto comm = everyone();
  Three three(comm);
  three.split();
  // The joint between the two upper stones bears a little less in tension than the split that nothing bounds asks for.
  for (int k : three.middle) {
    const auto& joint = three.points.joints()[three.points.points()[k].joint];
    if (joint.block_i == 1) three.freedom[k].law.tension = -three.lambda[2 * k] - 1;
  }
  const auto before = three.on_nodes();
  const auto once = three.split();
  TEST_COMPARE_FLOATING_ARRAYS(before, three.on_nodes(), round_off);
  for (int k : three.middle) {
    if (three.shared.any()) TEST_COMPARE(once[2 * k], >=, -three.freedom[k].law.tension);
  }
  three.turn({-3, 8});
  const auto again = three.split();
  for (std::size_t i = 0; i < once.size(); ++i) TEST_COMPARE(std::abs(again[i] - once[i]), <=, 100 * round_off);
}

TEUCHOS_UNIT_TEST(SharedForces, AreToldByAPointThatIsOpenOrTwoThatSlip) {
  const auto comm = everyone();
  Three three(comm);
  const auto given = three.lambda;
  for (int k : three.middle)
    if (three.points.joints()[three.points.points()[k].joint].block_i == 1) three.freedom[k] = {};
  TEST_COMPARE_ARRAYS(three.split(), given);
  for (int k : three.middle) three.freedom[k] = {true, false, {0.6}, {0.6, 0.0, 0.0}};
  TEST_COMPARE_ARRAYS(three.split(), given);
}

TEUCHOS_UNIT_TEST(SharedForces, HeldFrictionShowsWaysThatItHides) {
  const auto comm = everyone();
  Three three(comm);
  // One upper stone slips on the lower one, the other only presses on it, and the joint between the two is open and
  // sticks along its height: forces that run round upwards would take friction along, which goes nowhere.
  for (int k : three.middle) {
    const auto& joint = three.points.joints()[three.points.points()[k].joint];
    if (joint.block_i == 1)
      three.freedom[k] = {false, true, {}, {0.0, infinity, infinity}};
    else if (joint.block_j == 1)
      three.freedom[k] = {true, false, {0.6}, {0.6, 0.0, infinity}};
    else
      three.freedom[k] = {true, false, {}, {0.0, 0.0, infinity}};
  }
  const auto given = three.lambda;
  TEST_COMPARE_ARRAYS(three.split(), given);
  const auto before = three.on_nodes();
  const auto once = three.split(SharedFriction::held_where_it_hides);
  TEST_COMPARE_FLOATING_ARRAYS(before, three.on_nodes(), round_off);
  double moved = 0;
  for (std::size_t i = 0; i < once.size(); ++i) moved = std::max(moved, std::abs(once[i] - given[i]));
  if (three.shared.any()) TEST_COMPARE(moved, >, 1e-3);
  three.turn({0, 9});
  const auto again = three.split(SharedFriction::held_where_it_hides);
  for (std::size_t i = 0; i < once.size(); ++i) TEST_COMPARE(std::abs(again[i] - once[i]), <=, 100 * round_off);
}

/// The same in space: at either end of the line where three stones meet, three points.
struct ThreeInSpace {
  std::unique_ptr<BlockSource<3>> source;
  Structure<3> structure;
  ContactPoints points;
  std::vector<int> cluster;
  SharedForces shared;
  std::vector<PointFreedom> freedom;
  std::vector<double> lambda;  // N

  explicit ThreeInSpace(const Comm& comm)
      : source(make_wall_in_space(stones())),
        structure(
            *source, share_of_owners(*source, {0, 0, 0}, comm->getRank()), {},
            [](const Block<3>&) {
              return Material{1e9, 0.2, 2000};
            },
            comm),
        points(*source, structure),
        cluster(structure.nodes()),
        shared(structure, points, Three::numbered(cluster), std::vector<char>(3 * structure.nodes(), 0),
               std::vector<char>(points.size(), 1)),
        freedom(points.size(), {true, true, {}, {0.0, infinity, infinity}}),
        lambda(3 * points.size()) {
    for (int k = 0; k < points.size(); ++k)
      for (int c = 0; c < 3; ++c) lambda[3 * k + c] = 10.0 + 3.0 * static_cast<double>(points.points()[k].id) - 7.0 * c;
  }
  static WallInSpaceParameters stones() {
    WallInSpaceParameters p;
    p.courses = 2;
    p.blocks_per_course = p.cells_up = p.cells_across = 1;
    return p;
  }
  bool meets(int k) const {
    const auto at = points.at(k).place(Side::i, structure.position());
    return at[0] == 0.25 && at[2] == 0.25;
  }
  /// Adds forces that run round from stone 0 to 1, to 2 and back.
  void turn(const Vector<3>& force) {
    for (int k = 0; k < points.size(); ++k) {
      if (!meets(k)) continue;
      const auto& p = points.points()[k];
      const auto& joint = points.joints()[p.joint];
      const double sign = joint.block_i == 0 && joint.block_j == 2 ? -1 : 1;
      for (int c = 0; c < 3; ++c) lambda[3 * k + c] += sign * dot(force, p.axis[c]);
    }
  }
  std::vector<double> on_nodes() const {
    std::vector<double> nodal(3 * structure.nodes(), 0.0);
    add_contact_forces(points, {}, lambda, 1.0, nodal);
    return nodal;
  }
};

TEUCHOS_UNIT_TEST(SharedForcesInSpace, AreSplitInOneWayWithinTheDiscOfFriction) {
  const Comm alone = Teuchos::rcp(new Teuchos::SerialComm<int>());
  ThreeInSpace three(alone);
  TEST_ASSERT(three.shared.any());
  const auto compare_with = [&](const std::vector<double>& once) {
    for (std::size_t i = 0; i < once.size(); ++i)
      TEST_COMPARE(std::abs(three.lambda[i] - once[i]), <=, 100 * round_off);
  };
  const auto before = three.on_nodes();
  three.shared.split(three.freedom, SharedFriction::follows, three.lambda);
  TEST_COMPARE_FLOATING_ARRAYS(before, three.on_nodes(), round_off);
  const auto unbound = three.lambda;
  three.turn({17, -5, 3});
  three.shared.split(three.freedom, SharedFriction::follows, three.lambda);
  compare_with(unbound);
  // Between the upper stones friction and cohesion bear a little less than the split that nothing bounds asks for, in a
  // direction that is no tangent.
  int bound = 0;
  for (int k = 0; k < three.points.size(); ++k)
    if (three.meets(k) && three.points.joints()[three.points.points()[k].joint].block_i == 1) {
      const double shear = std::hypot(unbound[3 * k + 1], unbound[3 * k + 2]);
      three.freedom[k].law = {0.5, 0.95 * shear - 0.5 * unbound[3 * k], infinity};
      ++bound;
    }
  TEST_EQUALITY(bound, 2);
  three.shared.split(three.freedom, SharedFriction::follows, three.lambda);
  TEST_COMPARE_FLOATING_ARRAYS(before, three.on_nodes(), round_off);
  const auto once = three.lambda;
  for (int k = 0; k < three.points.size(); ++k) {
    const auto& law = three.freedom[k].law;
    if (std::isfinite(law.cohesion))
      TEST_COMPARE(std::hypot(once[3 * k + 1], once[3 * k + 2]), <=, law.cohesion + law.friction * once[3 * k]);
  }
  three.turn({-3, 8, 2});
  three.shared.split(three.freedom, SharedFriction::follows, three.lambda);
  for (std::size_t i = 0; i < once.size(); ++i)
    TEST_COMPARE(std::abs(three.lambda[i] - once[i]), <=, 1e-4);  // the margin
}

TEUCHOS_UNIT_TEST(SharedForcesInSpace, AreLawfulWhereverSomeSplitIs) {
  const Comm alone = Teuchos::rcp(new Teuchos::SerialComm<int>());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> turned(-20, 20), spare(0.001, 1);
  for (int drawn = 0; drawn < 200; ++drawn) {
    ThreeInSpace three(alone);
    // Laws that one split keeps, far from the one that nothing bounds: some of them by little.
    three.turn({turned(random), turned(random), turned(random)});
    for (int k = 0; k < three.points.size(); ++k) {
      if (!three.meets(k)) continue;
      const double* const f = &three.lambda[3 * k];
      const double shear = std::hypot(f[1], f[2]);
      three.freedom[k].law = {0.7, std::max(0.0, shear * (1 + spare(random)) - 0.7 * f[0]),
                              std::max(0.0, -f[0]) + 20 * spare(random)};
    }
    three.shared.split(three.freedom, SharedFriction::follows, three.lambda);
    for (int k = 0; k < three.points.size(); ++k) {
      if (!three.meets(k)) continue;
      const double* const f = &three.lambda[3 * k];
      const auto& law = three.freedom[k].law;
      TEST_COMPARE(f[0], >=, -law.tension);
      TEST_COMPARE(std::hypot(f[1], f[2]), <=, law.cohesion + law.friction * f[0]);
    }
  }
}

}  // namespace
