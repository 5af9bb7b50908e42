// Solids of STEP files are stones.
#include <gmsh.h>

#include <Teuchos_UnitTestHarness.hpp>
#include <fstream>

#include "stones/stone_files.hpp"
#include "stones/stone_structure.hpp"
#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// A brick of 400 x 200 x 200 mm with half a one on it, beside a drum; lengths in the file are millimetres.
std::string step_file() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::model::occ::addBox(0, 0, 0, 400, 200, 200);
  gmsh::model::occ::addBox(100, 0, 200, 200, 200, 200);
  gmsh::model::occ::addCylinder(1000, 0, 0, 0, 0, 200, 100);
  gmsh::model::occ::synchronize();
  gmsh::write("stones.step");
  gmsh::finalize();
  return "stones.step";
}

TEUCHOS_UNIT_TEST(Step, SolidsAreStonesInMetres) {
  const auto stones = closed(read_stones(step_file(), 1)).stones;
  TEST_EQUALITY(stones.size(), 3u);
  TEST_FLOATING_EQUALITY(volume(stones[0]), 0.016, 1e-10);
  TEST_FLOATING_EQUALITY(volume(stones[1]), 0.008, 1e-10);
  TEST_EQUALITY(facets_of(stones[0], 1e-6).facets.size(), 6u);
  // A polygon of 16 corners in a circle has 0.974 of its area.
  TEST_FLOATING_EQUALITY(volume(stones[2]), 8 * std::sin(std::acos(-1.0) / 8) * 0.01 * 0.2, 0.02);
  TEST_EQUALITY(stones[0].curved, 0);
  TEST_EQUALITY(stones[2].curved, 1);
  StonesParameters p;
  p.file = "stones.step";
  const auto s = structure_of(p);
  TEST_EQUALITY(s.joints.joints.size(), 1u);
  TEST_FLOATING_EQUALITY(s.joints.area(), 0.04, 1e-10);
}

TEUCHOS_UNIT_TEST(Step, FilesSayTheirOwnUnit) {
  Warnings warnings;
  const auto stones = closed(read_stones(step_file(), 0.001, warnings)).stones;
  TEST_FLOATING_EQUALITY(volume(stones[0]), 0.016, 1e-10);
  TEST_EQUALITY(warnings.size(), 1u);
  TEST_EQUALITY(warnings.front().what, "unit_not_used");
}

TEUCHOS_UNIT_TEST(Step, WhatIsNoneIsRefused) {
  std::ofstream("none.step") << "this is no STEP file\n";
  TEST_ASSERT(holds(input_error([] { read_stones("none.step", 1); }), "mesh > stones > file = none.step"));
}

}  // namespace
