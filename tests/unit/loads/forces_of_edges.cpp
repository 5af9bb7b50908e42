// What loads bring to quadratic triangles and tetrahedra all edges of which bend, those on loaded faces too.
//
// Set-up    A box of 0.8 x 0.6 x 1.2 m of cubes cut into tetrahedra, and its front of squares cut into triangles.
// Measured  The work of every load on a motion that is quadratic, against the integral of its tractions; forces that
//           hold a uniform stress, and one that goes linearly with depth; energies; sums and moments.
// Tolerance Sums of some thousand products of numbers near 1: 1e-12 of their size.
#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <functional>
#include <memory>

#include "blocks/block_forces.hpp"
#include "blocks/stresses.hpp"
#include "loads/load.hpp"
#include "loads/loads.hpp"
#include "mesh/block_list.hpp"
#include "unit/blocks/cut_boxes.hpp"

namespace {

using namespace voussoir;

constexpr double round_off = 1e-12, side = 0.2, thickness = 0.7;
const Vector<3> size{0.8, 0.6, 1.2};
const Material rock{2.5, 0.3, 1.5};
const std::vector<std::string> sets{"left", "right", "base", "top", "front", "back"};

/// Tags the edges or faces that all nodes of a side of the box have.
template <int dim>
void tag_sides(Block<dim>& block) {
  for (const auto& cell : block.cells)
    for (int left_out = 0; left_out <= dim; ++left_out)
      for (std::size_t set = 0; set < 2 * dim; ++set) {
        const int axis = set < 2 ? 0 : set < 4 ? dim - 1 : 1;
        const double at = set % 2 == 0 ? 0 : axis == dim - 1 ? size[2] : size[axis];
        TaggedFacet facet{{}, 0, static_cast<int>(set)};
        for (int k = 0; k <= dim; ++k)
          if (k != left_out && std::abs(block.position[cell.node[k]][axis] - at) < 1e-9)
            facet.node[facet.count++] = cell.node[k];
        if (facet.count == dim) block.facets.push_back(facet);
      }
}

template <int dim>
Block<dim> cells() {
  if constexpr (dim == 3)
    return test::box(0, {4, 3, 6}, side);
  else
    return test::rectangle_of_triangles(0, 4, 6, side);
}

/// One stone, no edge of which is straight.
template <int dim>
struct Stone {
  std::unique_ptr<BlockSource<dim>> source;
  Structure<dim> s;

  explicit Stone(Plane plane = Plane::strain) : source(made()), s(of(*source, plane)) {}

  static std::unique_ptr<BlockSource<dim>> made() {
    BlockList<dim> list;
    auto block = cells<dim>();
    block.facets.clear();
    tag_sides(block);
    list.blocks = {block};
    list.facet_sets = sets;
    list.quadratic = true;
    return make_source(std::move(list));
  }
  static Structure<dim> of(const BlockSource<dim>& source, Plane plane) {
    ModelParameters model;
    model.plane = plane;
    model.thickness = thickness;
    return Structure<dim>(
        source, {{0}, {}, {}}, model, [](const Block<dim>&) { return rock; },
        Teuchos::rcp(new Teuchos::SerialComm<int>));
  }

  template <class Parameters>
  void add(const Parameters& p, BlockForces& to) const {
    LoadParameters load;
    load.kind = p;
    std::vector<double> prescribed(to.of_nodes.size(), 0.0);
    make_load(load, LoadSite<dim>{s, *source, {}, "tested"})->add({{0.0, 1.0}}, to, prescribed);
  }
  template <class Parameters>
  BlockForces under(const Parameters& p) const {
    BlockForces force(s);
    add(p, force);
    return force;
  }
};

template <int dim>
using Motion = std::function<Vector<dim>(const Vector<dim>&)>;

/// A quadratic motion: what nodes go, and how far edges bend.
template <int dim>
double work(const Stone<dim>& stone, const BlockForces& force, const Motion<dim>& motion) {
  const auto& mesh = stone.s.blocks()[0].mesh;
  double work = 0;
  for (std::size_t i = 0; i < mesh.position.size(); ++i)
    for (int c = 0; c < dim; ++c) work += force.of_nodes[dim * i + c] * motion(mesh.position[i])[c];
  for (std::size_t e = 0; e < mesh.curved.size(); ++e) {
    const auto &a = mesh.position[mesh.curved[e][0]], &b = mesh.position[mesh.curved[e][1]];
    const auto bend = motion(0.5 * (a + b)) - 0.5 * (motion(a) + motion(b));
    for (int c = 0; c < dim; ++c) work += force.of_edges[dim * e + c] * bend[c];
  }
  return work;
}

/// Integral from low to high along an axis, exact to the fifth degree.
double integral(double low, double high, const std::function<double(double)>& f) {
  const double middle = (low + high) / 2, half = (high - low) / 2, off = std::sqrt(0.6) * half;
  return half * (5 * f(middle - off) + 8 * f(middle) + 5 * f(middle + off)) / 9;
}

/// A motion of space every component of which has all quadratic terms; the plane sees it at y = 0, along x and z.
Vector<3> bent(double x, double y, double z) {
  return {1 + x - z + 2 * x * x - y * z + 0.5 * z * z + x * z, x * y - 2 * y + 3 * z * z - y * y,
          2 - x + 0.3 * z + x * x + 1.5 * y * y - 2 * z * z + x * z + x * y};
}
template <int dim>
Motion<dim> motion() {
  return [](const Vector<dim>& x) {
    if constexpr (dim == 3)
      return bent(x[0], x[1], x[2]);
    else {
      const auto u = bent(x[0], 0, x[1]);
      return Vector<2>{u[0], u[2]};
    }
  };
}
/// Integral across: over y in space, times the thickness in the plane.
template <int dim>
double across(const std::function<double(double)>& f, double from = 0, double to = size[1]) {
  return dim == 2 ? thickness * f(0) : integral(from, to, f);
}

/// Of a component over x from .. to at a height.
template <int dim>
double along_top(int component, double from = 0, double to = size[0], double y_from = 0, double y_to = size[1]) {
  return across<dim>(
      [&](double y) { return integral(from, to, [&](double x) { return bent(x, y, size[2])[component]; }); }, y_from,
      y_to);
}
/// Of the first component times a pressure that depends on the height, over a side.
template <int dim>
double along_side(double x, double top, const std::function<double(double)>& pressure) {
  return across<dim>(
      [&](double y) { return integral(0, top, [&](double z) { return bent(x, y, z)[0] * pressure(z); }); });
}
template <int dim>
double within(double top) {
  return across<dim>([&](double y) {
    return integral(0, top, [&](double z) { return integral(0, size[0], [&](double x) { return bent(x, y, z)[2]; }); });
  });
}

template <int dim>
void compare_works(Teuchos::FancyOStream& out, bool& success) {
  const Stone<dim> stone;
  const auto w = motion<dim>();
  TractionParameters press;
  press.on = "top";
  press.pressure = 3;
  press.tx = 2;
  TEST_FLOATING_EQUALITY(work(stone, stone.under(press), w), 2 * along_top<dim>(0) - 3 * along_top<dim>(2), round_off);
  CrowdParameters crowd;  // its ends cut cells
  crowd.on = "top";
  crowd.intensity = 5;
  crowd.x_from = 0.13;
  crowd.x_to = 0.55;
  crowd.y_from = 0.07;
  crowd.y_to = 0.5;
  TEST_FLOATING_EQUALITY(work(stone, stone.under(crowd), w), -5 * along_top<dim>(2, 0.13, 0.55, 0.07, 0.5), round_off);
  WaterPressureParameters water;
  water.on = "right";
  water.level = 0.71;
  water.density = 2;
  water.gravity = 3;
  TEST_FLOATING_EQUALITY(work(stone, stone.under(water), w),
                         -6 * along_side<dim>(size[0], 0.71, [](double z) { return 0.71 - z; }), round_off);
  EarthPressureParameters earth;
  earth.on = "left";
  earth.state = EarthPressureParameters::State::given;
  earth.given = 0.5;
  earth.unit_weight = 4;
  earth.surface = 0.93;
  earth.surcharge = 2;
  TEST_FLOATING_EQUALITY(work(stone, stone.under(earth), w),
                         0.5 * along_side<dim>(0, 0.93, [](double z) { return 4 * (0.93 - z) + 2; }), round_off);
  for (const double level : {0.71, 0.8, 2.0}) {
    BuoyancyParameters lift;
    lift.level = level;
    lift.density = 2;
    lift.gravity = 3;
    TEST_FLOATING_EQUALITY(work(stone, stone.under(lift), w), 6 * within<dim>(std::min(level, size[2])), round_off);
  }
  SelfWeightParameters weight;
  weight.gravity = 3;
  TEST_FLOATING_EQUALITY(work(stone, stone.under(weight), w), -4.5 * within<dim>(size[2]), round_off);
  MovingTrainParameters train;
  train.on = "top";
  train.axle_load = {3};
  train.behind = {0};
  train.position = 0.37;
  train.y = 0.23;
  TEST_FLOATING_EQUALITY(work(stone, stone.under(train), w), -3 * bent(0.37, dim == 3 ? 0.23 : 0, size[2])[2],
                         round_off);
}

TEUCHOS_UNIT_TEST(ForcesOfEdges, DoTheWorkOfTheirLoadOnWhatBendsInThePlane) { compare_works<2>(out, success); }
TEUCHOS_UNIT_TEST(ForcesOfEdges, DoTheWorkOfTheirLoadOnWhatBendsInSpace) { compare_works<3>(out, success); }

/// Stress of one sign and of a height: (xx, yy, xy) or (xx, xy, xz, yy, yz, zz).
template <int dim>
using StressAt = std::function<std::vector<double>(const Vector<dim>&)>;

/// Whether corners that go their exact way hold the forces, cells have the mean of the exact stress, and the energy
/// is that of it.
template <int dim>
void compare(const Stone<dim>& stone, BlockForces force, const Motion<dim>& exact, const StressAt<dim>& stress,
             double energy, Teuchos::FancyOStream& out, bool& success) {
  const auto& s = stone.s;
  std::vector<double> u, ku;
  for (const auto& x : s.position())
    for (const double c : exact(x)) u.push_back(c);
  s.apply_stiffness(u, ku);
  const InnerLoads inner{{}, force.of_edges};
  double largest = 0;
  for (const double f : force.of_nodes) largest = std::max(largest, std::abs(f));
  const auto handed = handed_over(s, std::move(force));
  for (std::size_t i = 0; i < ku.size(); ++i) TEST_COMPARE(std::abs(ku[i] - handed[i]), <=, round_off * largest);
  const auto found = cell_stresses(s, u, inner);
  const auto& mesh = s.blocks()[0].mesh;
  std::size_t at = 0;
  for (const auto& cell : mesh.cells) {
    Vector<dim> middle{};
    for (int k = 0; k <= dim; ++k) middle = middle + (1.0 / (dim + 1)) * mesh.position[cell.node[k]];
    for (const double exactly : stress(middle)) {
      TEST_COMPARE(std::abs(found[at] - exactly), <=, 1e-11);
      ++at;
    }
  }
  TEST_FLOATING_EQUALITY(s.elastic_energy(u) + inner_energy(s, u, inner, {}), energy, round_off);
}

TEUCHOS_UNIT_TEST(ForcesOfEdges, HoldAUniformStressInSpace) {
  const Stone<3> cube;
  const double p = 0.4, e = rock.young_modulus, nu = rock.poisson_ratio;
  TractionParameters press;
  press.pressure = p;
  BlockForces force(cube.s);
  for (const auto* on : {"left", "right"}) {
    press.on = on;
    cube.add(press, force);
  }
  compare<3>(
      cube, force,
      [&](const Vector<3>& x) {
        return Vector<3>{-p / e * x[0], nu * p / e * x[1], nu * p / e * x[2]};
      },
      [&](const Vector<3>&) { return std::vector<double>{-p, 0, 0, 0, 0, 0}; },
      p * p / e / 2 * size[0] * size[1] * size[2], out, success);
}

TEUCHOS_UNIT_TEST(ForcesOfEdges, HoldAUniformStressInThePlane) {
  const Stone<2> plate(Plane::stress);
  const double p = 0.4, e = rock.young_modulus, nu = rock.poisson_ratio;
  TractionParameters press;
  press.pressure = p;
  BlockForces force(plate.s);
  for (const auto* on : {"base", "top"}) {
    press.on = on;
    plate.add(press, force);
  }
  compare<2>(
      plate, force,
      [&](const Vector<2>& x) {
        return Vector<2>{nu * p / e * x[0], -p / e * x[1]};
      },
      [&](const Vector<2>&) {
        return std::vector<double>{0, -p, 0};
      },
      p * p / e / 2 * size[0] * size[2] * thickness, out, success);
}

// A stone as heavy as the water in which it floats bears the pressure of the water around: its strain goes linearly
// with depth, and its motion is quadratic.
TEUCHOS_UNIT_TEST(ForcesOfEdges, HoldThePressureOfDeepWater) {
  const Stone<3> cube;
  const double weight = 3, level = 2, c = weight * (1 - 2 * rock.poisson_ratio) / rock.young_modulus;
  WaterPressureParameters water;
  water.level = level;
  water.density = rock.density;
  water.gravity = weight / rock.density;
  SelfWeightParameters heavy;
  heavy.gravity = water.gravity;
  BlockForces force(cube.s);
  cube.add(heavy, force);
  for (const auto& on : sets) {
    water.on = on;
    cube.add(water, force);
  }
  const double squares = integral(0, size[2], [&](double z) { return (level - z) * (level - z); });
  compare<3>(
      cube, force,
      [&](const Vector<3>& x) {
        const double z = x[2];
        return -c * Vector<3>{(level - z) * x[0], (level - z) * x[1],
                              level * z - z * z / 2 + (x[0] * x[0] + x[1] * x[1]) / 2};
      },
      [&](const Vector<3>& x) {
        const double p = weight * (level - x[2]);
        return std::vector<double>{-p, 0, 0, -p, 0, -p};
      },
      1.5 * c * weight * squares * size[0] * size[1], out, success);
}

template <int dim>
void compare_heat(const Stone<dim>& stone, double free, double energy, Teuchos::FancyOStream& out, bool& success) {
  TemperatureParameters heat;
  heat.change = 100;
  heat.expansion = 1e-5;
  const auto force = stone.under(heat);
  std::vector<double> u, ku;
  for (const auto& x : stone.s.position())
    for (const double c : x) u.push_back(free * c);
  stone.s.apply_stiffness(u, ku);
  for (std::size_t i = 0; i < ku.size(); ++i) TEST_COMPARE(std::abs(ku[i] - force.of_nodes[i]), <=, 1e-16);
  const InnerLoads inner{{free}, force.of_edges};
  for (const double value : cell_stresses(stone.s, u, inner)) TEST_COMPARE(std::abs(value), <=, 1e-15);
  TEST_COMPARE(std::abs(stone.s.elastic_energy(u) + inner_energy(stone.s, u, inner, {}) - energy), <=, 1e-19);
}

// What swells freely stores nothing, but for what plane strain holds across: E e^2 / 2 of the volume.
TEUCHOS_UNIT_TEST(ForcesOfEdges, OfHeatStoreNothingInWhatSwellsFreely) {
  const double volume = size[0] * size[2] * thickness, e = 1e-3;
  compare_heat(Stone<3>(), e, 0, out, success);
  compare_heat(Stone<2>(Plane::stress), e, 0, out, success);
  compare_heat(Stone<2>(Plane::strain), (1 + rock.poisson_ratio) * e, rock.young_modulus * e * e / 2 * volume, out,
               success);
}

TEUCHOS_UNIT_TEST(ForcesOfEdges, HandOverNoForceAndNoMoment) {
  const Stone<3> cube;
  WaterPressureParameters water;
  water.on = "right";
  water.level = 0.71;
  auto force = cube.under(water);
  const auto before = force.of_nodes, after = handed_over(cube.s, std::move(force));
  Vector<3> sum{}, moment{};
  double largest = 0, changed = 0;
  for (int i = 0; i < cube.s.nodes(); ++i) {
    Vector<3> f{};
    for (int c = 0; c < 3; ++c) f[c] = after[3 * i + c] - before[3 * i + c];
    sum = sum + f;
    moment = moment + cross(cube.s.position()[i], f);
    changed = std::max(changed, norm(f));
    largest = std::max(largest, std::abs(before[3 * i]));
  }
  TEST_COMPARE(changed, >, 0.01 * largest);
  TEST_COMPARE(norm(sum) + norm(moment), <=, round_off * largest);
}

}  // namespace
