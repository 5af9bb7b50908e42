// Impulses that end relative velocities, by hand: with lumped masses the two nodes of a point meet at their mean.
#include "time/velocity_projection.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>
#include <map>

#include "linalg/reduce.hpp"
#include "model/plane/plane_model.hpp"
#include "unit/time/floating_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double solved = 1e-8;  // impulses are found to 1e-11 of their size

/// Points whose two nodes belong to no other point: what happens there is between the two.
std::vector<int> pairs_alone(const PlaneModel& model) {
  std::map<int, int> points_of_node;
  for (const auto& p : model.points().points())
    ++points_of_node[p.shares_i.first()], ++points_of_node[p.shares_j.first()];
  std::vector<int> alone;
  for (int k = 0; k < model.points().owned(); ++k) {
    const auto& p = model.points().points()[k];
    if (points_of_node[p.shares_i.first()] == 1 && points_of_node[p.shares_j.first()] == 1) alone.push_back(k);
  }
  return alone;
}

/// 1 for the normal, or for both components, of every point.
std::vector<char> held(const PlaneModel& model, bool both) {
  std::vector<char> all(2 * static_cast<std::size_t>(model.points().size()), 1);
  for (std::size_t i = 1; i < all.size(); i += 2) all[i] = both;
  return all;
}

TEUCHOS_UNIT_TEST(VelocityProjection, MassAtAPointIsThatOfItsTwoNodesInSeries) {
  const FloatingWall wall;
  const VelocityProjection projection(wall.model, wall.mass);
  for (int k = 0; k < wall.model.points().owned(); ++k) {
    const auto& p = wall.model.points().points()[k];
    const double series = 1 / (1 / wall.mass_of_node[p.shares_i.first()] + 1 / wall.mass_of_node[p.shares_j.first()]);
    TEST_FLOATING_EQUALITY(projection.mass(k, 0), series, 1e-13);
    TEST_FLOATING_EQUALITY(projection.mass(k, 1), series, 1e-13);
  }
}

TEUCHOS_UNIT_TEST(VelocityProjection, TwoNodesThatMeetGoOnWithTheirMeanAndTheOthersAsTheyWere) {
  const FloatingWall wall;
  VelocityProjection projection(wall.model, wall.mass);
  const auto before = wall.velocity({{1, 0, 0}, {0, -3, 0}, {0, -3, 0}});
  auto v = before;
  for (const double impulse :
       projection.apply(v, held(wall.model, false)).of_supports)  // no support is there to give any
    TEST_COMPARE(std::abs(impulse), <, 1e-9);
  const auto pairs = pairs_alone(wall.model);
  const long long found = static_cast<long long>(pairs.size());
  TEST_COMPARE(total_over_ranks(*wall.mass.comm(), found), >, 0);
  for (const int k : pairs) {
    const auto& p = wall.model.points().points()[k];
    const bool bed = std::abs(p.axis[0][1]) > 0.5;
    const double mi = wall.mass_of_node[p.shares_i.first()], mj = wall.mass_of_node[p.shares_j.first()];
    const double mean = (mi * before[2 * p.shares_i.first() + 1] + mj * before[2 * p.shares_j.first() + 1]) / (mi + mj);
    for (const int n : {p.shares_i.first(), p.shares_j.first()}) {
      if (bed) TEST_COMPARE(std::abs(v[2 * n + 1] - mean), <, 3 * solved);
      if (bed) TEST_COMPARE(std::abs(v[2 * n] - before[2 * n]), <, 3 * solved);  // normals alone are held
    }
  }
  std::vector<char> on_a_joint(wall.mass.nodes(), 0);
  for (const auto& p : wall.model.points().points())
    on_a_joint[p.shares_i.first()] = on_a_joint[p.shares_j.first()] = 1;
  for (int i = 0; i < 2 * wall.mass.owned_nodes(); ++i)
    if (!on_a_joint[i / 2]) TEST_EQUALITY(v[i], before[i]);
}

TEUCHOS_UNIT_TEST(VelocityProjection, EndsRelativeVelocitiesAndKeepsMomentum) {
  const FloatingWall wall;
  VelocityProjection projection(wall.model, wall.mass);
  auto v = wall.velocity({{1, 0, 0}, {0, -3, 0}, {2, 1, 0}});
  const auto momentum = [&] {
    double sum[2] = {0, 0};
    for (int i = 0; i < 2 * wall.mass.owned_nodes(); ++i) sum[i % 2] += wall.mass_of_node[i / 2] * v[i];
    return Vector<2>{total_over_ranks(*wall.mass.comm(), sum[0]), total_over_ranks(*wall.mass.comm(), sum[1])};
  };
  const auto before = momentum();
  projection.apply(v, held(wall.model, true));
  double fastest = 0;
  for (const double speed : relative_velocities(wall.model.points(), v)) fastest = std::max(fastest, std::abs(speed));
  TEST_COMPARE(largest_over_ranks(*wall.mass.comm(), fastest), <, 3 * solved);
  for (int c = 0; c < 2; ++c) TEST_COMPARE(std::abs(momentum()[c] - before[c]), <, 500 * solved);
  auto again = v;
  projection.apply(again, std::vector<char>(2 * static_cast<std::size_t>(wall.model.points().size()), 0));
  TEST_COMPARE_ARRAYS(again, v);  // where nothing is held nothing changes
}

}  // namespace
