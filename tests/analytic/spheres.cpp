// Two spheres that touch: what Hertz says of their pressure, and Cattaneo and Mindlin of a force across them.
//
// Set-up    Near where they touch two equal spheres are two half spaces r^2 / (2 R) apart, 1 / R the sum of both
//           curvatures. Half of each is meshed by hexahedra, on the one side of the plane in which the force lies, as
//           far as B, eight radii of contact; where they touch, cells are a sixth of that radius. The foot is held;
//           the head comes down by a^2 / R, and then moves across.
// Expected  a^3 = 3 P R / (4 E*), p = 3 P / (2 pi a^2) sqrt(1 - r^2 / a^2), E* = E / (2 (1 - nu^2)); approach a^2 / R.
//           Under Q < mu P points farther out than c = a (1 - Q / (mu P))^(1/3) slip; within, the shear is
//           mu p(r) less that of a contact of radius c. The head moves by (3 mu P / (16 a)) 2 (2 - nu) / G
//           (1 - (1 - Q / (mu P))^(2/3)) and what the far parts of the blocks give way, which is in proportion to Q.
// Tolerance A cell for radii, 3 % of the pressure in the middle, 5 % of mu times it for the shear, which theory gives
//           without the slip across Q. The approach: what half spaces give way beyond the blocks, which is less than
//           (1 + nu) (3 - 2 nu) P / (2 pi E B) of each. The way across: 15 %, for slip spreads cell by cell; it is 13 %
//           with cells of a / 6, and 6 % with cells of a / 9.
// Sources   K. L. Johnson, Contact Mechanics (1985), sections 4.2, 7.2.
#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "linalg/reduce.hpp"
#include "mesh/block_list.hpp"
#include "model/space/space_model.hpp"
#include "scene/scene.hpp"
#include "step/adaptive_step.hpp"

namespace {

using namespace voussoir;

constexpr double radius = 1, wanted = 0.01;  // [m] R; a of the approach
constexpr double young = 10e9, poisson = 0.3, friction = 0.5;
constexpr double cell = wanted / 6, far = 8 * wanted;
const double pi = std::acos(-1.0);

/// Coordinates from 0 to `far`: cells of one size up to `fine`, then ever longer ones.
std::vector<double> graded(double fine) {
  std::vector<double> at{0};
  while (at.back() < fine - cell / 2) at.push_back(at.back() + cell);
  double length = cell;
  while (at.back() < far) at.push_back(std::min(far, at.back() + (length *= 1.6)));
  if (at.back() - at[at.size() - 2] < length / 2) at.erase(at.end() - 2);  // no sliver at the end
  return at;
}

enum Face { foot, head, middle };

/// The lower half space or the upper one.
Block<3> half_space(bool upper) {
  const auto along = graded(1.5 * wanted), depth = graded(wanted);
  std::vector<double> x(along.rbegin(), along.rend() - 1);
  for (auto& value : x) value = -value;
  x.insert(x.end(), along.begin(), along.end());
  std::vector<double> z(depth);
  if (!upper) {
    z.assign(depth.rbegin(), depth.rend());
    for (auto& value : z) value = -value;
  }
  const int nx = static_cast<int>(x.size()), ny = static_cast<int>(along.size()), nz = static_cast<int>(z.size());
  Block<3> block;
  block.id = upper;
  const auto node = [&](int i, int j, int k) { return (k * ny + j) * nx + i; };
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        block.position.push_back({x[i], along[j], z[k]});
        block.vertex.push_back(node(i, j, k + (upper ? nz - 1 : 0)));
      }
  for (int k = 0; k + 1 < nz; ++k)
    for (int j = 0; j + 1 < ny; ++j)
      for (int i = 0; i + 1 < nx; ++i) {
        const std::array<int, 4> below{node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)};
        Cell c;
        c.count = 8;
        for (int corner = 0; corner < 4; ++corner) {
          c.node[corner] = below[corner];
          c.node[corner + 4] = below[corner] + nx * ny;
        }
        block.cells.push_back(c);
        if (j == 0) block.facets.push_back({{c.node[0], c.node[1], c.node[5], c.node[4]}, 4, middle});
        if (!upper && k == 0) block.facets.push_back({{c.node[0], c.node[1], c.node[2], c.node[3]}, 4, foot});
        if (upper && k + 2 == nz) block.facets.push_back({{c.node[4], c.node[5], c.node[6], c.node[7]}, 4, head});
      }
  return block;
}

Scene scene_of_spheres() {
  Scene scene;
  scene.file = "spheres";
  MaterialParameters stone;
  stone.young_modulus = young;
  stone.poisson_ratio = poisson;
  scene.materials.push_back({"stone", stone});
  JointLawParameters dry;
  dry.friction_coefficient = friction;
  scene.joints.push_back({"dry", dry});
  for (const auto& [name, components] : {std::pair{"foot", "all"}, {"head", "all"}, {"middle", "y"}}) {
    SupportParameters support;
    support.on = name;
    support.components = components;
    scene.supports.push_back({name, support});
  }
  for (const char* axis : {"down", "across"}) {
    LoadParameters load;
    load.name = axis;
    auto& way = load.kind.emplace<SettlementParameters>();
    way.support = "head";
    (*axis == 'd' ? way.uz : way.ux) = *axis == 'd' ? -1 : 1;
    scene.loads.push_back(load);
  }
  scene.selection.mode = SelectionMode::all;
  return scene;
}

/// A contact point: its distance from the middle, pressure and shear on its part of the joint [m, Pa], and its status.
struct Touch {
  double r, pressure, shear;
  PointStatus status;
};

class Spheres {
 public:
  Spheres()
      : scene_(scene_of_spheres()),
        source_(make_source(list())),
        model_(scene_, *source_, Tpetra::getDefaultComm()),
        step_((curve(), model_)),
        state_(step_.initial_state()) {}

  bool move(double down, double across) {
    std::vector<double> load, prescribed;
    model_.loads({{"down", down}, {"across", across}}, 0.0, load, prescribed);
    load_ = load;
    return advance(step_, state_, {load, prescribed}).converged();
  }
  /// Force of the whole spheres on the head [N], over all ranks.
  Vector<3> force() const {
    const auto residual = step_.residual(state_, load_);
    const auto& s = model_.structure();
    Vector<3> sum{};
    for (int i = 0; i < s.owned_nodes(); ++i)
      for (int c = 0; c < 3 && s.position()[i][2] > far - cell / 2; ++c) sum[c] += 2 * residual[3 * i + c];
    return total_of_each(*s.comm(), sum);
  }
  std::vector<Touch> touches() const {
    std::vector<Touch> all;
    for (int k = 0; k < model_.points().owned(); ++k) {
      const auto& p = model_.points().points()[k];
      const double* f = &state_.lambda[3 * static_cast<std::size_t>(k)];
      const double along = f[1] * p.axis[1][0] + f[2] * p.axis[2][0];
      all.push_back({at(k), f[0] / p.area, std::abs(along) / p.area, status_of(state_, k)});
    }
    return all;
  }

 private:
  static BlockList<3> list() {
    BlockList<3> list;
    list.facet_sets = {"foot", "head", "middle"};
    for (const bool upper : {false, true}) list.blocks.push_back(half_space(upper));
    return list;
  }
  double at(int point) const {
    const auto x = model_.points().at(point).place(Side::i, model_.structure());
    return std::hypot(x[0], x[1]);
  }
  void curve() {
    std::vector<double> gap;
    for (int k = 0; k < model_.points().size(); ++k) gap.push_back(at(k) * at(k) / (2 * radius));
    model_.set_initial_gap(gap);
  }

  Scene scene_;
  std::unique_ptr<BlockSource<3>> source_;
  SpaceModel model_;
  AdaptiveStep step_;
  ContactState state_;
  std::vector<double> load_;
};

/// Pressure of Hertz, relative to the largest.
double hertz(double r, double a) { return r < a ? std::sqrt(1 - r * r / (a * a)) : 0.0; }

TEUCHOS_UNIT_TEST(Spheres, PressAndRubAsHertzAndMindlinSay) {
  Spheres spheres;
  const double approach = wanted * wanted / radius;
  TEST_ASSERT(spheres.move(approach, 0));
  const double normal = std::abs(spheres.force()[2]);
  const double modulus = young / (2 * (1 - poisson * poisson));
  const double a = std::cbrt(3 * normal * radius / (4 * modulus)), largest = 3 * normal / (2 * pi * a * a);
  out << "P " << normal << " N, a " << a << " m, approach " << a * a / radius / approach << " of that told\n";
  const double beyond = 2 * (1 + poisson) * (3 - 2 * poisson) * normal / (2 * pi * young * far);
  TEST_COMPARE(a * a / radius, >, approach);
  TEST_COMPARE(a * a / radius, <, approach + beyond);
  for (const auto& t : spheres.touches()) {
    if (t.r < a - cell) TEST_ASSERT(t.status != PointStatus::open);
    if (t.r > a + cell) TEST_ASSERT(t.status == PointStatus::open);
    if (t.r < a - cell) TEST_COMPARE(std::abs(t.pressure / largest - hertz(t.r, a)), <=, 0.03);
  }

  // A small force sticks nearly everywhere; under three quarters of what slides at once two thirds of the radius stick.
  double way[2], force[2];
  for (const int k : {0, 1}) {
    way[k] = k == 0 ? 2e-6 : 4e-5;
    TEST_ASSERT(spheres.move(approach, way[k]));
    force[k] = std::abs(spheres.force()[0]);
  }
  const double share = force[1] / (friction * normal), c = a * std::cbrt(1 - share);
  out << "Q / (mu P) " << force[0] / (friction * normal) << " and " << share << "\n";
  TEST_ASSERT(share > 0.6 && share < 0.9);
  for (const auto& t : spheres.touches()) {
    if (t.r < c - cell) TEST_ASSERT(t.status == PointStatus::stick);
    if (t.r > c + cell && t.r < a - cell) TEST_ASSERT(t.status == PointStatus::slip);
    const double expected = hertz(t.r, a) - c / a * hertz(t.r, c);
    if (t.r < a - cell && std::abs(t.r - c) > cell)
      TEST_COMPARE(std::abs(t.shear / (friction * largest) - expected), <=, 0.05);
  }
  const double shear_modulus = young / (2 * (1 + poisson));
  const auto mindlin = [&](double q) {
    return 3 * friction * normal / (16 * a) * 2 * (2 - poisson) / shear_modulus *
           (1 - std::pow(1 - q / (friction * normal), 2.0 / 3));
  };
  const double found = way[1] / force[1] - way[0] / force[0];
  const double expected = mindlin(force[1]) / force[1] - mindlin(force[0]) / force[0];
  out << "softening of the contact by slip " << found << " m/N, " << expected << " expected\n";
  TEST_COMPARE(std::abs(found / expected - 1), <=, 0.15);
}

}  // namespace
