#include "support/scenes.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dynamics/load_steps.hpp"
#include "linalg/gather.hpp"
#include "mesh/block_source.hpp"
#include "model/joint_strength.hpp"
#include "model/plane/plane_model.hpp"

namespace voussoir::test {
namespace {

constexpr WhyWhole of_a_test{"what a test looks at"};
constexpr double standard_gravity = 9.81;  // [m/s2], as in the reference solutions

Scene stone_scene() {
  Scene scene;
  scene.file = "scene built by a test";
  MaterialParameters stone;
  stone.young_modulus = 10e9;
  stone.poisson_ratio = 0.2;
  stone.density = 2000;
  scene.materials.push_back({"stone", stone});
  scene.joints.push_back({"dry", JointLawParameters{}});
  scene.selection.mode = SelectionMode::all;
  return scene;
}

LoadParameters self_weight() {
  LoadParameters weight;
  weight.name = "weight";
  auto& self_weight = weight.kind.emplace<SelfWeightParameters>();
  self_weight.gravity = standard_gravity;
  return weight;
}

StageParameters stage(const std::string& load) {
  StageParameters s;
  s.name = load;
  s.factors[load] = 1;
  return s;
}

/// What every rank knows of its own nodes and points.
struct NodeState {
  NodeId id;
  BlockId block;
  Vector<2> position, displacement, residual;
  std::array<char, 2> held;
};

}  // namespace

Scene wall_scene(int courses) {
  Scene scene = stone_scene();
  scene.mesh.type = MeshType::wall;
  scene.mesh.wall.courses = scene.mesh.wall.blocks_per_course = courses;
  add_support(scene, "base", "xy");
  scene.loads.push_back(self_weight());
  LoadParameters sideways;
  sideways.name = "sideways";
  auto& acceleration = sideways.kind.emplace<AccelerationParameters>();
  acceleration.ax = 0.15 * standard_gravity;
  scene.loads.push_back(sideways);
  scene.stages = {stage("weight"), stage("sideways")};
  return scene;
}

Scene arch_scene(int voussoirs) {
  Scene scene = stone_scene();
  scene.mesh.type = MeshType::arch;
  scene.mesh.arch.voussoirs = voussoirs;
  add_support(scene, "springing left", "xy");
  add_support(scene, "springing right", "xy");
  scene.loads.push_back(self_weight());
  LoadParameters spreading;
  spreading.name = "spreading";
  auto& settlement = spreading.kind.emplace<SettlementParameters>();
  settlement.support = "springing right";
  settlement.ux = 0.005;
  scene.loads.push_back(spreading);
  scene.stages = {stage("weight"), stage("spreading")};
  return scene;
}

std::vector<StageParameters> three_stages() {
  std::vector<StageParameters> stages;
  for (const char* name : {"first", "second", "third"}) {
    stages.emplace_back();
    stages.back().name = name;
    stages.back().factors["weight"] = 1;
  }
  return stages;
}

Scene gmsh_scene(const std::string& geo, double element_size, CellType cells) {
  Scene scene = stone_scene();
  scene.mesh.type = MeshType::gmsh;
  scene.mesh.gmsh.file = geo;
  scene.mesh.gmsh.element_size = element_size;
  scene.mesh.gmsh.cells = cells;
  return scene;
}

void set_increments(Scene& scene, int increments) { scene.stages.back().increments = increments; }

void add_support(Scene& scene, const std::string& on, const std::string& components) {
  SupportParameters support;
  support.on = on;
  support.components = components;
  scene.supports.push_back({on, support});
}

void add_gravity(Scene& scene, double ax, double ay) {
  LoadParameters load;
  load.name = "gravity";
  auto& acceleration = load.kind.emplace<AccelerationParameters>();
  acceleration.ax = ax;
  acceleration.ay = ay;
  scene.loads.push_back(load);
}

void add_pressure(Scene& scene, const std::string& on, double pressure) {
  LoadParameters load;
  load.name = "pressure on " + on;
  auto& traction = load.kind.emplace<TractionParameters>();
  traction.on = on;
  traction.pressure = pressure;
  scene.loads.push_back(load);
}

void apply_all_loads(Scene& scene) {
  StageParameters all;
  all.name = "all loads";
  for (const auto& load : scene.loads) all.factors[load.name] = 1;
  scene.stages = {all};
}

double Solution::largest_displacement() const {
  double size = 0;
  for (const auto& u : displacement) size = std::max(size, norm(u));
  return size;
}

double Solution::largest_force() const {
  double size = 0;
  for (const auto& p : points) size = std::max(size, std::abs(p.normal_force));
  return size;
}

long long Solution::selected() const {
  return std::count_if(points.begin(), points.end(), [](const auto& p) { return p.selected; });
}

Experiment::Experiment(const Scene& scene) : scene_(scene) {
  const auto comm = Tpetra::getDefaultComm();
  source_ = make_block_source<2>(scene_.mesh, *comm);
  model_ = std::make_unique<PlaneModel>(scene_, *source_, comm);
  step_ = std::make_unique<AdaptiveStep>(*model_);
  state_ = step_->initial_state();
  slip_before_ = state_.slip_origin;
  construction_ = std::make_unique<Construction>(scene_, *model_);
  model_->loads({}, 0.0, load_, prescribed_);
}

bool Experiment::advance(const std::map<std::string, double>& factors) {
  model_->loads(factors, 0.0, load_, prescribed_);
  construction_->restrict(state_, load_, prescribed_);
  slip_before_ = state_.slip_origin;
  last_ = voussoir::advance(*step_, state_, {load_, prescribed_});
  sum_.add(last_.newton);
  rounds_ += last_.selection_rounds;
  return last_.newton.outcome == NewtonOutcome::converged;
}

bool Experiment::advance(const std::string& stage, const std::map<std::string, double>& factors) {
  construction_->begin(stage, *model_, state_);
  return advance(factors);
}

bool Experiment::run() {
  LoadSteps steps(scene_.stages, scene_.load_steps);
  while (!steps.finished()) {
    if (!advance(steps.stage(), steps.factors())) return false;
    steps.accept();
  }
  return true;
}

Solution Experiment::solution() const {
  Solution all;
  all.last = last_;
  all.sum = sum_;
  all.rounds = rounds_;
  const auto& s = model_->structure();
  const auto& comm = *s.comm();
  const auto residual = step_->residual(state_, load_);
  std::vector<double> ku;
  s.apply_stiffness(state_.displacement, ku);
  std::vector<NodeState> nodes;
  double potential = 0;
  for (int i = 0; i < s.owned_nodes(); ++i) {
    NodeState n{};
    n.id = s.node_id()[i];
    n.block = s.blocks()[s.block_of_node()[i]].mesh.id;
    n.position = s.position()[i];
    for (int c = 0; c < 2; ++c) {
      n.displacement[c] = state_.displacement[2 * i + c];
      n.residual[c] = residual[2 * i + c];
      n.held[c] = model_->held()[2 * i + c];
      potential += n.displacement[c] * (ku[2 * i + c] / 2 - load_[2 * i + c]);
    }
    nodes.push_back(n);
  }
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, potential, Teuchos::outArg(all.potential));
  nodes = all_gather(nodes, comm, of_a_test);
  std::sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  for (const auto& n : nodes) {
    all.position.push_back(n.position);
    all.displacement.push_back(n.displacement);
    all.residual.push_back(n.residual);
    all.held.push_back(n.held);
    all.block_of_node.push_back(n.block);
  }

  const auto gap = step_->gaps(state_.displacement);
  for (int k = 0; k < model_->points().owned(); ++k) {
    const auto& p = model_->points().points()[k];
    const auto& joint = model_->points().joints()[p.joint];
    PointState q;
    q.id = p.id;
    q.block_i = joint.block_i;
    q.block_j = joint.block_j;
    q.node_i = s.node_id()[model_->points().at(k).main_node(Side::i)];
    q.node_j = s.node_id()[model_->points().at(k).main_node(Side::j)];
    q.area = p.area;
    q.position = model_->points().at(k).place(Side::i, s.position());
    q.normal = in_plane(p.axis[0]);
    q.normal_force = state_.lambda[2 * k];
    q.tangential_force = state_.lambda[2 * k + 1];
    q.gap = gap[2 * k];
    q.slip = gap[2 * k + 1];
    q.slip_before = slip_before_.empty() ? 0.0 : slip_before_[2 * k + 1];
    q.selected = state_.selected[k];
    q.broken = damage_of(*model_, state_, k) == 1;
    all.points.push_back(q);
  }
  all.points = all_gather(all.points, comm, of_a_test);
  std::sort(all.points.begin(), all.points.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return all;
}

Solution solved(const Scene& scene) {
  Experiment experiment(scene);
  if (!experiment.run()) throw std::runtime_error("no solution: " + experiment.solution().last.newton.reason);
  return experiment.solution();
}

double difference(const Solution& a, const Solution& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.displacement.size(); ++i)
    worst = std::max(worst, norm(a.displacement[i] - b.displacement[i]));
  return worst / b.largest_displacement();
}

ContactErrors contact_errors(const Solution& s, double friction) {
  constexpr double known = 2e-8;  // forces are known to 1e-8 of the largest
  ContactErrors e;
  const double force = s.largest_force(), open = 1e-9 * s.largest_displacement();
  for (std::size_t i = 0; i < s.residual.size(); ++i)
    for (int c = 0; c < 2; ++c)
      if (!s.held[i][c]) e.equilibrium = std::max(e.equilibrium, std::abs(s.residual[i][c]) / force);
  for (const auto& p : s.points) {
    const double bound = friction * std::max(p.normal_force, 0.0), q = p.tangential_force;
    const double slip = p.slip - p.slip_before;
    e.penetration = std::max(e.penetration, -p.gap);
    e.tension = std::max(e.tension, -p.normal_force / force);
    if (p.gap > open) e.pressure_at_gap = std::max(e.pressure_at_gap, p.normal_force / force);
    e.outside_cone = std::max(e.outside_cone, (std::abs(q) - bound) / force);
    if (std::abs(q) < bound - known * force) e.slip_inside_cone = std::max(e.slip_inside_cone, std::abs(slip));
    if (std::abs(q) > known * force) e.slip_along_force = std::max(e.slip_along_force, q > 0 ? slip : -slip);
  }
  return e;
}

}  // namespace voussoir::test
