// Files of others, which are no part of the project: VOUSSOIR_STONES names the folder that holds them.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>
#include <utility>

#include "stones/filled_stones.hpp"
#include "stones/stone_files.hpp"
#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;

/// What a file holds, counted by other means (own clipping in Python, and OpenCASCADE).
struct Sample {
  std::string file;
  double unit, tolerance;
  std::size_t stones;
  int doubled;
  double volume;
  std::size_t facets;
  int warped;
  std::size_t pairs, joints;
  double area;
  std::size_t cells;
};

const std::vector<Sample> samples{
    {"compas_dem_crossvault.obj", 0.025, 1e-3, 184, 0, 55.0665, 1260, 0, 452, 488, 142.0179, 1508},
    {"compas_dem_dome.obj", 1, 5e-3, 90, 720, 37.0395, 900, 180, 250, 250, 72.4621, 900},
    {"compas_dem_wall.obj", 1, 1e-3, 38, 0, 4.3656, 228, 0, 60, 60, 14.6250, 336},
    {"compas_cra_bridge.json", 1, 1e-3, 16, 0, 0.9118, 157, 0, 21, 37, 3.0076, 173},
    {"compas_cra_shelf.json", 1, 1e-3, 11, 0, 0.3360, 71, 0, 18, 19, 0.4008, 103},
    {"compas_cra_type-b.json", 1, 1e-3, 3, 0, 7.6698, 21, 0, 3, 3, 2.9000, 21},
    {"oneleaf_stones", 1, 1e-3, 3, 0, 0.0053, 49, 0, 0, 0, 0.0, 49}};

std::size_t shared_cells(const Imprint& cut) {
  return static_cast<std::size_t>(std::count_if(cut.other.begin(), cut.other.end(), [](int c) { return c >= 0; })) / 2;
}

/// The folder, or "" and a word that nothing is tested.
std::string folder() {
  const char* named = std::getenv("VOUSSOIR_STONES");
  if (!named) std::cout << "skipped: VOUSSOIR_STONES names no folder with these files.\n";
  return named ? std::string(named) + "/" : "";
}

TEUCHOS_UNIT_TEST(Samples, HoldTheStonesAndJointsThatOthersCount) {
  const std::string place = folder();
  if (place.empty()) return;
  for (const auto& s : samples) {
    out << s.file << "\n";
    const auto mended = closed(read_stones(place + s.file, s.unit));
    TEST_EQUALITY(mended.stones.size(), s.stones);
    double inside = 0;
    int doubled = 0;
    for (const auto& stone : mended.stones) inside += volume(stone);
    for (const auto& repair : mended.repairs) doubled += repair.doubled;
    TEST_EQUALITY(doubled, s.doubled);
    TEST_FLOATING_EQUALITY(inside, s.volume, 1e-2 / s.volume < 1e-2 ? 1e-4 : 1e-2);  // of four digits
    const auto faceted = facets_of(mended.stones, s.tolerance);
    std::size_t facets = 0;
    int warped = 0;
    for (const auto& stone : faceted) facets += stone.facets.size(), warped += stone.warped;
    TEST_EQUALITY(facets, s.facets);
    TEST_EQUALITY(warped, s.warped);
    const auto found = find_joints(faceted, s.tolerance);
    TEST_EQUALITY(found.joints.size(), s.joints);
    TEST_COMPARE(std::abs(found.area() - s.area), <=, 1e-4 * s.area);
    std::set<std::array<int, 2>> pairs;
    for (const auto& joint : found.joints) pairs.insert(joint.stone);
    TEST_EQUALITY(pairs.size(), s.pairs);
    const auto again = test::through_stl(mended.stones);
    const auto faceted_again = facets_of(again, s.tolerance);
    std::size_t facets_again = 0;
    for (const auto& stone : faceted_again) facets_again += stone.facets.size();
    // Two triangles of a warped bed are farther from each other's plane than the bed is from its own: two joints of it.
    const auto found_again = find_joints(faceted_again, s.tolerance);
    TEST_COMPARE(std::abs(found_again.area() - s.area), <=, 1e-3 * s.area);
    if (s.warped == 0) {
      TEST_EQUALITY(facets_again, s.facets);
      TEST_EQUALITY(found_again.joints.size(), s.joints);
    }
    for (const double weld : {1.0, 3.0}) {
      const auto cut = imprinted(faceted, found, weld * s.tolerance);
      TEST_ASSERT(cut.faults.none());
      TEST_EQUALITY(cut.cells.size(), s.cells);
      TEST_EQUALITY(shared_cells(cut), s.joints);
    }
  }
}

TEUCHOS_UNIT_TEST(Samples, TheVaultHasItsPlateauFromSixTenthsOfAMillimetre) {
  const std::string place = folder();
  if (place.empty()) return;
  const auto vault = closed(read_stones(place + "compas_dem_crossvault.obj", 0.025)).stones;
  const auto counts = count_joints(vault, 1e-3);
  TEST_EQUALITY(counts[0].joints, 320);
  TEST_EQUALITY(counts[4].joints, 491);
  TEST_EQUALITY(counts[6].joints, 488);
  TEST_EQUALITY(counts[10].joints, 488);
  TEST_COMPARE(tolerance_on_plateau(counts), >=, 1e-3);
}

TEUCHOS_UNIT_TEST(Samples, AreMeshedWhole) {
  const std::string place = folder();
  if (place.empty()) return;
  for (const auto& s : samples) {
    StonesParameters p;
    p.file = place + s.file;
    p.unit = s.unit;
    p.joint_tolerance = s.tolerance;
    const auto structure = structure_of(p);
    const auto meshes = mesh_stones(structure);
    out << s.file << ": " << meshes.quality.nodes << " nodes, " << meshes.quality.cells << " cells, dihedral "
        << meshes.quality.least_dihedral << ", " << meshes.quality.flat << " below 5 degrees\n";
    TEST_EQUALITY(meshes.list.blocks.size(), s.stones);
    TEST_COMPARE(meshes.quality.least_dihedral, >, 1);
    TEST_EQUALITY(meshes.quality.of_hexahedra, s.file == "compas_dem_wall.obj" ? 38 : 0);
    // Warped faces of the dome are cut by shortest diagonals: 37.84 m3 where fans about their means hold 37.04.
    const double inside = s.warped > 0 ? 37.84 : s.volume;
    TEST_COMPARE(std::abs(meshes.quality.volume - inside), <=, 1e-3 * inside + 5e-5);
  }
}

/// Stones of the files as somebody would measure them.
struct Measured {
  std::string file;
  double unit, noise, tolerance, weld;
  std::size_t joints;
};

TEUCHOS_UNIT_TEST(Samples, MeasuredOnesHaveTheJointsOfTheDrawnOnes) {
  const std::string place = folder();
  if (place.empty()) return;
  const std::vector<Measured> cases{{"compas_dem_crossvault.obj", 0.025, 1e-4, 1e-3, 3e-3, 488},
                                    {"compas_dem_crossvault.obj", 0.025, 5e-4, 2e-3, 1e-2, 488},
                                    {"compas_dem_crossvault.obj", 0.025, 2e-3, 8e-3, 2e-2, 488},
                                    {"compas_dem_dome.obj", 1, 2e-3, 8e-3, 2e-2, 250},
                                    {"compas_dem_wall.obj", 1, 2e-3, 8e-3, 1.2e-2, 60},
                                    {"compas_cra_bridge.json", 1, 2e-3, 8e-3, 1e-2, 37}};
  for (const auto& m : cases) {
    const auto stones = test::measured(closed(read_stones(place + m.file, m.unit)).stones, m.noise);
    const auto faceted = facets_of(stones, m.tolerance);
    const auto cut = imprinted(faceted, find_joints(faceted, m.tolerance), m.weld);
    TEST_ASSERT(cut.faults.none());
    TEST_EQUALITY(shared_cells(cut), m.joints);
  }
}

}  // namespace
