// Joints that lose their strength as they open and slip, beside closed forms.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <vector>

#include "support/repository.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double modulus = 10e9, tension = 5e4, cohesion = 1e5, opening_energy = 10, shear_energy = 50;  // [Pa, J/m2]
constexpr double friction = 0.6;

/// Two stones of 1 m x 1 m between plates that are moved: by 1 m apart and by 1 m along each other, times factors.
Scene between_plates(SofteningShape shape, double cell) {
  Scene scene = gmsh_scene(repository("/tests/hard/geo/two_stones.geo"), cell, CellType::quadrilateral);
  scene.mesh.gmsh.geometry = {{"width", 1}, {"height", 1}, {"angle", 0}};
  scene.newton.tolerance = 1e-10;
  scene.materials[0].parameters.young_modulus = modulus;
  scene.materials[0].parameters.poisson_ratio = 0;
  auto& law = scene.joints[0].parameters;
  law.friction_coefficient = friction;
  law.tension_strength = tension;
  law.cohesion = cohesion;
  law.fracture_energy = opening_energy;
  law.shear_fracture_energy = shear_energy;
  law.softening = shape;
  add_support(scene, "bottom", "xy");
  add_support(scene, "top", "xy");
  for (const bool up : {true, false}) {
    LoadParameters load;
    load.name = up ? "apart" : "along";
    auto& moved = load.kind.emplace<SettlementParameters>();
    moved.support = "top";
    (up ? moved.uy : moved.ux) = 1;
    scene.loads.push_back(load);
  }
  apply_all_loads(scene);
  return scene;
}

/// Traction [Pa] of an opening that grows.
double pull(SofteningShape shape, double gap) {
  if (shape == SofteningShape::linear) return std::max(0.0, tension * (1 - tension * gap / (2 * opening_energy)));
  return tension * std::exp(-tension * gap / opening_energy);
}

/// Opening [m] at which the stones, 1 m long each, make up for the rest of the way of the plates.
template <class Pull>
double opening(double apart, const Pull& traction) {
  double low = 0, high = apart;
  for (int halving = 0; halving < 200; ++halving) {
    const double gap = (low + high) / 2;
    (gap + 2 * traction(gap) / modulus < apart ? low : high) = gap;
  }
  return low;
}

TEUCHOS_UNIT_TEST(Softening, StonesThatArePulledApartFollowTheClosedForm) {
  for (const auto shape : {SofteningShape::linear, SofteningShape::exponential})
    for (const double cell : {1.0, 0.25}) {
      Experiment experiment(between_plates(shape, cell));
      double largest = 0;
      // Elastic, softening, back, closed under pressure, again beyond where it was, nearly lost.
      for (const double apart :
           {0.9 * 2 * tension / modulus, 6e-5, 1.5e-4, 8e-5, -2e-5, 4e-5, 1.5e-4, 2.5e-4, 3.9e-4}) {
        out << "apart " << apart << "\n";
        TEST_ASSERT(experiment.advance({{"apart", apart}}));
        const auto traction = [&](double gap) {
          return gap < largest ? pull(shape, largest) * gap / largest : pull(shape, gap);
        };
        const bool closed = apart < 0 || (largest == 0 && apart < 2 * tension / modulus);
        const double gap = closed ? 0 : opening(apart, traction);
        const double force = closed ? apart * modulus / 2 : traction(gap);
        largest = std::max(largest, gap);
        double carried = 0;
        for (const auto& p : experiment.solution().points) {
          carried -= p.normal_force;
          TEST_COMPARE(std::abs(p.gap - gap), <=, 1e-8 * 1e-4);
        }
        TEST_COMPARE(std::abs(carried - force), <=, 1e-8 * tension);
      }
    }
}

// At every point, whatever the others do: what is left of the cohesion at its own slip, and friction.
TEUCHOS_UNIT_TEST(Softening, StonesThatAreShearedBearWhatIsLeftOfTheCohesionAndFriction) {
  for (const auto shape : {SofteningShape::linear, SofteningShape::exponential})
    for (const double pressed : {0.0, -4e-5, -2e-4}) {  // none, 0.2 and 1 MPa
      Experiment experiment(between_plates(shape, 0.25));
      TEST_ASSERT(experiment.advance({{"apart", pressed}}));
      double force = 0;
      for (const double along : {2e-5, 5e-4, 2e-3, 0.2}) {
        TEST_ASSERT(experiment.advance({{"apart", pressed}, {"along", along}}));
        int slips = 0;
        force = 0;
        for (const auto& p : experiment.solution().points) {
          force += p.tangential_force;
          if (!(p.gap < 1e-12) || std::abs(p.slip) < 1e-9) continue;
          ++slips;
          const double way = cohesion * std::abs(p.slip) / shear_energy;
          const double left = shape == SofteningShape::linear ? std::max(0.0, 1 - way / 2) : std::exp(-way);
          const double bound = cohesion * p.area * left + friction * p.normal_force;
          TEST_COMPARE(std::abs(std::abs(p.tangential_force) - bound), <=, 1e-8 * cohesion);
        }
        if (along < 1e-4 || along > 1e-3) TEST_EQUALITY(slips > 0, along > 1e-3);
      }
      if (pressed < 0)  // all cohesion is lost: friction alone, under what presses
        TEST_COMPARE(std::abs(std::abs(force) - friction * -pressed * modulus / 2), <=, 0.05 * -pressed * modulus);
    }
}

// With more and more energy strength stays, with less and less it is lost at once.
TEUCHOS_UNIT_TEST(Softening, EndsInPerfectCohesionAndInBrittleness) {
  const auto carried = [](double energy) {
    Scene scene = between_plates(SofteningShape::linear, 0.5);
    scene.joints[0].parameters.fracture_energy = energy;
    Experiment experiment(scene);
    if (!experiment.advance({{"apart", 1e-4}})) return -1.0;
    double sum = 0;
    for (const auto& p : experiment.solution().points) sum -= p.normal_force;
    return sum;
  };
  TEST_FLOATING_EQUALITY(carried(1e9), tension, 1e-6);
  TEST_COMPARE(std::abs(carried(0)), <=, 1e-8 * tension);
  TEST_COMPARE(std::abs(carried(1e-9)), <=, 1e-8 * tension);
}

}  // namespace
