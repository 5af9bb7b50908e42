// Stones in space that are followed to where they have moved and turned.
#include <Teuchos_UnitTestHarness.hpp>
#include <set>

#include "blocks/structure.hpp"
#include "mesh/generators.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

std::unique_ptr<BlockSource<3>> wall() {
  WallInSpaceParameters p;
  p.courses = 3;
  p.blocks_per_course = 2;
  return make_wall_in_space(p);
}

Structure<3> wall_structure(const BlockSource<3>& source, Hexahedra hexahedra) {
  ModelParameters model;
  model.hexahedra = hexahedra;
  return Structure<3>(
      source, share_out(source, *everyone()), model,
      [](const Block<3>& b) {
        return Material{1e9 * (1 + b.id % 3), 0.2, 2000};
      },
      everyone());
}

// Stones far from where they were drawn, stretched along an edge and then turned about an axis along none.
TEUCHOS_UNIT_TEST(FollowedInSpace, StonesBearNoForcesAndStretchAsBefore) {
  for (const auto hexahedra : {Hexahedra::plain, Hexahedra::incompatible}) {
    const auto source = wall();
    auto s = wall_structure(*source, hexahedra);
    const Vector<3> centre{3, -1, 2}, direction{0.48, 0.6, 0.64};
    const auto moved = [&](const Rotation<3>& rotation, double stretch) {
      std::vector<double> u;
      for (const auto& x : s.drawn_position()) {
        auto arm = x - centre;
        arm[0] *= 1 + stretch;
        const auto motion = rotation(arm) + centre - x;
        u.insert(u.end(), motion.begin(), motion.end());
      }
      return u;
    };
    std::vector<double> small, forces;
    s.internal_forces(moved({}, 1e-4), small);
    double largest = 0;
    for (double f : small) largest = std::max(largest, std::abs(f));
    for (const double angle : {0.7, 2.9}) {
      const Rotation<3> rotation(direction, angle);
      s.move_to(moved(rotation, 0));
      s.internal_forces(moved(rotation, 0), forces);
      for (double f : forces) TEST_COMPARE(std::abs(f), <, 1e-9 * largest);
      TEST_COMPARE(s.move_to(moved(rotation, 0)), <, 1e-12);
      for (int b = 0; b < s.local_blocks(); ++b) TEST_COMPARE(s.turn(b).apart(rotation), <, 1e-12);

      s.move_to(moved(rotation, 1e-4));
      s.internal_forces(moved(rotation, 1e-4), forces);
      for (std::size_t i = 0; i < small.size(); i += 3) {
        const auto turned = rotation({small[i], small[i + 1], small[i + 2]});
        for (int c = 0; c < 3; ++c) TEST_COMPARE(std::abs(forces[i + c] - turned[c]), <, 1e-9 * largest);
      }
    }
  }
}

TEUCHOS_UNIT_TEST(FollowedInSpace, StonesThatHaveMovedAndNotTurnedAreAsTheyWere) {
  const auto source = wall();
  auto s = wall_structure(*source, Hexahedra::plain);
  const auto matrices = [&] {
    std::set<const LocalCsr*> all;
    for (const auto& b : s.blocks()) all.insert(b.stiffness.get());
    return all;
  };
  const auto before = matrices();
  std::vector<double> u;
  for (int i = 0; i < s.nodes(); ++i) u.insert(u.end(), {0.5, 0.25, -1});
  TEST_EQUALITY_CONST(s.move_to(u), 0.0);
  TEST_ASSERT(matrices() == before);
}

}  // namespace
