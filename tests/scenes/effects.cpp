// Scenes of effects: what their supports carry, against sums by hand.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "scene/scene_reader.hpp"
#include "support/repository.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Force of the supports on the structure [N].
Vector<2> reaction(const Solution& s) {
  Vector<2> sum{};
  for (std::size_t i = 0; i < s.residual.size(); ++i)
    for (int c = 0; c < 2; ++c)
      if (s.held[i][c]) sum[c] += s.residual[i][c];
  return sum;
}

Scene scene_of(const std::string& name) { return read_scene(repository("/xml/") + name + ".xml"); }

// Newton stops at 1e-8 of the largest nodal force, of which there are some hundred.
constexpr double tolerance = 1e-6;

TEUCHOS_UNIT_TEST(RetainingWall, GivesSoilAndWaterToTheGround) {
  const double weight = 1.5 * 1.5 * 2000 * 9.81;
  const double vertical = 18e3 * 1.5 * 1.5 / 2 + 5e3 * 1.5;  // times K
  Experiment wall(scene_of("retaining-wall"));
  TEST_ASSERT(wall.advance({{"weight", 1}}));
  TEST_ASSERT(wall.advance({{"weight", 1}, {"soil at rest", 1}}));
  auto r = reaction(wall.solution());
  TEST_FLOATING_EQUALITY(r[0], -0.5 * vertical, tolerance);
  TEST_FLOATING_EQUALITY(r[1], weight, tolerance);
  TEST_ASSERT(wall.advance({{"weight", 1}, {"soil active", 1}, {"river", 1}, {"lift", 1}}));
  r = reaction(wall.solution());
  TEST_FLOATING_EQUALITY(r[0], -vertical / 3 + 1000 * 9.81 * 0.9 * 0.9 / 2, tolerance);
  TEST_FLOATING_EQUALITY(r[1], weight - 1000 * 9.81 * 0.9 * 1.5, tolerance);
}

TEUCHOS_UNIT_TEST(ArchUnderACart, GivesCrowdAndAxlesToItsSpringings) {
  Experiment arch(scene_of("arch-train"));
  TEST_ASSERT(arch.advance({{"weight", 1}}));
  const double weight = reaction(arch.solution())[1];
  TEST_ASSERT(arch.advance({{"weight", 1}, {"statue", 1}, {"crowd", 1}, {"cart at the quarter", 1}}));
  const auto r = reaction(arch.solution());
  TEST_FLOATING_EQUALITY(r[1], weight + 5e3 + 4 * 5e3 + 40e3 + 60e3, tolerance);
  TEST_COMPARE(std::abs(r[0]), <, tolerance * r[1]);
}

// Summer lifts the crown, winter lets it sink, and stones that only grow and shrink between rigid springings open
// joints on opposite sides: more joints are open than under the own weight.
TEUCHOS_UNIT_TEST(ArchThroughTheSeasons, RisesInSummerAndSinksInWinter) {
  Experiment arch(scene_of("arch-seasons"));
  const auto crown = [&arch] {
    const auto s = arch.solution();
    double highest = -1, sum = 0, count = 0;
    for (const auto& x : s.position) highest = std::max(highest, x[1]);
    for (std::size_t i = 0; i < s.position.size(); ++i)
      if (s.position[i][1] > highest - 1e-6) {
        sum += s.displacement[i][1];
        ++count;
      }
    return sum / count;
  };
  TEST_ASSERT(arch.advance({{"weight", 1}}));
  const double built = crown();
  for (const double warmth : {0.5, 1.0}) TEST_ASSERT(arch.advance({{"weight", 1}, {"warmth", warmth}}));
  const double summer = crown();
  for (const double warmth : {0.5, 0.0, -0.5, -1.0}) TEST_ASSERT(arch.advance({{"weight", 1}, {"warmth", warmth}}));
  const double winter = crown();
  // Between rigid springings a three-hinge arch of rise h rises by at least alpha dT h; here h = 3.3 m: 0.5 mm.
  TEST_COMPARE(summer - built, >, 20 * 8e-6 * 3.3);
  TEST_COMPARE(built - winter, >, 20 * 8e-6 * 3.3);
}

}  // namespace
