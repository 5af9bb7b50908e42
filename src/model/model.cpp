#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/finite.hpp"
#include "base/text.hpp"
#include "blocks/assembly.hpp"
#include "blocks/supports.hpp"
#include "dynamics/load_steps.hpp"
#include "linalg/agree.hpp"
#include "linalg/reduce.hpp"
#include "mesh/partition.hpp"
#include "model/loads_at_work.hpp"
#include "model/phase.hpp"
#include "model/scene_fit.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

// Forces whose squares, down to the tolerances of solvers, stay within the numbers a computer holds. [N]
constexpr double smallest_force = 1e-130, largest_force = 1e130;

}  // namespace

Model::Model(const Scene& scene)
    : settings_(scene), file_(scene.file), families_(scene.joints), supports_(scene.supports) {}

Model::Model(const Model& at_rest, double inertia, double tolerance)
    : settings_(at_rest.settings_.of_time_step(tolerance)),
      file_(at_rest.file_),
      families_(at_rest.families_),
      supports_(at_rest.supports_),
      points_(at_rest.points_),
      loads_(at_rest.loads_),
      held_(at_rest.held_),
      never_tied_(at_rest.never_tied_),
      absent_(at_rest.absent_),
      law_(at_rest.law_),
      compliance_(at_rest.compliance_),
      softest_mortar_(at_rest.softest_mortar_),
      initial_gap_(at_rest.initial_gap_),
      softening_(at_rest.softening_),
      weakens_(at_rest.weakens_),
      inertia_(inertia) {
  VOUSSOIR_EXPECT(tolerance > 0 && tolerance < 1 && "tolerance: a share of the largest force");
}

std::string Model::block_name(BlockId block) const {
  const auto& s = structure();
  std::vector<std::string> name;
  if (const int here = s.local_block(block); here >= 0 && here < s.owned_blocks())
    name.push_back(in_geometry([&](const auto& source, const auto&) { return source.block(block).name; }));
  return first_texts(*s.comm(), name, 1).front();
}

void Model::make_continuum() {
  Phase phase("continuum");
  continuum_ = std::make_unique<Continuum>(structure(), *points_, held_, settings_.solver.muelu,
                                           settings_.internals.preconditioner, local_stiffness_);
}

void Model::set_laws() {
  law_ = PointLaws(points_->points().size());
  for (std::size_t k = 0; k < law_.size(); ++k) initial_gap_.push_back(joint_law(k).initial_gap);
  // Of the scene, not of the points here: every rank must come to the same.
  for (const auto& [name, law] : families_) {
    weakens_ |= std::max(law.cohesion, law.tension_strength) > 0 &&
                std::min(law.cohesion, law.tension_strength) < JointLawParameters::infinity;
    rubs_ |= law.friction_coefficient > 0 || law.cohesion > 0 || law.tension_strength > 0;
    softest_mortar_ = std::min({softest_mortar_, law.normal_stiffness, law.tangential_stiffness});
  }
  if (softest_mortar_ < JointLawParameters::infinity)
    for (std::size_t k = 0; k < law_.size(); ++k) {
      const double area = points_->points()[k].area;
      compliance_.push_back(
          {1 / (joint_law(k).normal_stiffness * area), 1 / (joint_law(k).tangential_stiffness * area)});
    }
  set_local_stiffness(nullptr, {});
  set_strengths();
  const bool closed = std::all_of(families_.begin(), families_.end(),
                                  [](const auto& joint) { return joint.parameters.initial_gap == 0; });
  if (closed) initial_gap_.clear();
}

const JointLawParameters& Model::joint_law(std::size_t point) const {
  return families_[points_->joints()[points_->points()[point].joint].family].parameters;
}

/// What stands open as drawn, or beside a stone that is not there, is not bonded: it can rub, no more.
bool Model::is_bonded(std::size_t point) const {
  return joined(static_cast<int>(point)) && joint_law(point).initial_gap == 0;
}

void Model::set_strengths() {
  if (weakens_) softening_.resize(law_.size());
  for (std::size_t k = 0; k < law_.size(); ++k) {
    const auto& joint = joint_law(k);
    const bool bonded = is_bonded(k);
    const double area = points_->points()[k].area;
    law_.set(k, {joint.friction_coefficient, bonded ? joint.cohesion * area : 0.0,
                 bonded ? joint.tension_strength * area : 0.0});
    if (weakens_) softening_[k] = bonded ? softening_of(k) : Softening{};
  }
}

/// Where the strength of a joint falls faster than the stones beside it can follow, its force jumps: no joint softens
/// faster than a share of what a point sees of them. One that has no energy of its own softens as fast as that.
Softening Model::softening_of(std::size_t k) const {
  constexpr double infinity = JointLawParameters::infinity;
  const double area = points_->points()[k].area;
  const auto& joint = joint_law(k);
  const double tension = joint.tension_strength * area, cohesion = joint.cohesion * area;  // [N]
  const bool exponential = joint.softening == SofteningShape::exponential;
  const auto rate = [&](double energy, double strength, double other, int component, bool& brittle) {
    const double lost = strength > 0 ? strength : other;  // what a mode without strength of its own takes
    if (!(lost > 0) || lost == infinity) return 0.0;
    const double c = compliance_.empty() ? 0.0 : compliance_[k].along(component), stone = local_stiffness_[k];
    const double steepest = settings_.internals.step.steepest_softening * stone / (1 + c * stone);
    const double fastest = (exponential ? 1 : 2) * steepest / lost;
    const double asked = energy > 0 ? lost / (energy * area) : infinity;
    brittle = asked > fastest;
    return std::min(fastest, asked);
  };
  Softening s;
  s.exponential = exponential;
  s.per_opening = rate(joint.fracture_energy, tension, cohesion, 0, s.brittle_opening);
  s.per_slip = rate(joint.shear_fracture_energy, cohesion, tension, 1, s.brittle_slip);
  return s;
}

/// Springs in series: the cells on both sides, each as stiff as Young's modulus times the thickness. In a time step the
/// inertia of the nodes stiffens them.
void Model::set_local_stiffness(const BlockSystem* mass, const MidpointRule& rule) {
  const int dim = components();
  std::vector<double> inertia(structure().nodes(), 0.0);
  if (mass) {
    std::vector<double> along_x(dim * inertia.size(), 0.0), weight;
    for (std::size_t i = 0; i < inertia.size(); ++i) along_x[dim * i] = 1;
    mass->apply_stiffness(along_x, weight);
    for (std::size_t i = 0; i < inertia.size(); ++i) inertia[i] = rule.mass_factor() * weight[dim * i];
  }
  const auto at_node = [&](int node) {
    return (mass ? rule.stiffness_factor() : 1.0) * stiffness_beside(node) + inertia[node];
  };
  const auto& numbers = settings_.internals.step;
  local_stiffness_.clear();
  for (int point = 0; point < points_->size(); ++point) {
    const auto p = points_->at(point);
    const double i = p.stiffness(Side::i, at_node), j = p.stiffness(Side::j, at_node);
    local_stiffness_.push_back(2 * i * j / (i + j));
    if (compliance_.empty()) continue;
    const auto& c = compliance_[local_stiffness_.size() - 1];
    const double softest = std::max(c.normal, c.tangential);
    double& k = local_stiffness_.back();
    if (softest > 0) k = std::max(k, std::min(numbers.beyond_mortar / softest, numbers.beyond_stone * k));
  }
}

std::vector<double> Model::gaps(const std::vector<double>& u) const {
  const int dim = components();
  VOUSSOIR_EXPECT(u.size() == static_cast<std::size_t>(dim) * structure().nodes() && "displacement: of node copies");
  std::vector<double> gap;
  relative_motions(*points_, u, gap);
  for (std::size_t k = 0; k < initial_gap_.size(); ++k) gap[dim * k] += initial_gap_[k];
  return gap;
}

std::vector<double> Model::gaps(const std::vector<double>& u, const std::vector<double>& lambda) const {
  const int dim = components();
  VOUSSOIR_EXPECT((compliance_.empty() || lambda.size() == dim * compliance_.size()) && "lambda: of points");
  auto gap = gaps(u);
  for (std::size_t k = 0; k < compliance_.size(); ++k)
    for (int c = 0; c < dim; ++c) gap[dim * k + c] += compliance_[k].along(c) * lambda[dim * k + c];
  return gap;
}

double Model::mortar_energy(const std::vector<double>& lambda) const {
  const int dim = components();
  VOUSSOIR_EXPECT((compliance_.empty() || lambda.size() == dim * compliance_.size()) && "lambda: of points");
  double energy = 0;
  const auto owned = std::min<std::size_t>(compliance_.size(), points_->owned());
  for (std::size_t k = 0; k < owned; ++k)
    for (int c = 0; c < dim; ++c) energy += compliance_[k].along(c) * lambda[dim * k + c] * lambda[dim * k + c] / 2;
  return energy;
}

void Model::find_never_tied(const std::vector<char>& between) {
  never_tied_ = points_->untieable();
  if (!between.empty()) never_tied_.resize(between.size(), 0);
  for (std::size_t k = 0; k < between.size(); ++k) never_tied_[k] |= between[k];
}

void Model::set_absent(const std::vector<char>& absent) {
  const int dim = components();
  VOUSSOIR_EXPECT(absent.size() == static_cast<std::size_t>(structure().local_blocks()) && "absent: per local block");
  ++arrangement_;
  hold_supports();
  for (std::size_t i = 0; i < held_.size(); ++i)
    if (absent[structure().block_of_node()[i / dim]]) held_[i] = 1;
  if (absent_ == absent) return;
  absent_ = absent;
  set_strengths();
}

bool Model::joined(int point) const {
  if (absent_.empty()) return true;
  const auto& joint = points_->joint_of(point);
  return !absent_[joint.local_i] && !absent_[joint.local_j];
}

bool Model::bears(int point) const {
  return joined(point) && points_->at(point).may_part(held_, [](int node) { return node; });
}

void Model::loads(const std::map<std::string, double>& factors, double time, std::vector<double>& force,
                  std::vector<double>& prescribed) const {
  VOUSSOIR_EXPECT(std::isfinite(time) && "time: finite");
  for (const auto& [load, factor] : factors) VOUSSOIR_EXPECT(std::isfinite(factor) && "factors of loads: finite");
  BlockForces all(structure());
  prescribed.assign(all.of_nodes.size(), 0.0);
  loads_->add(factors, time, all, prescribed);
  force = handed_over(structure(), std::move(all));
  check_size(force);
}

double Model::inner_energy(const std::map<std::string, double>& factors, double time, const std::vector<double>& u,
                           const std::vector<char>& without) const {
  const auto& s = structure();
  const auto inner = loads_->inner_loads(factors, time, s);
  const bool none = inner.free_strain.empty() && inner.edge_force.empty();
  const double mine = none ? 0.0 : in_geometry([&](const auto&, const auto& blocks) {
    return voussoir::inner_energy(blocks, s.deformation(u), inner, without);
  });
  return total_over_ranks(*s.comm(), mine);
}

void Model::mean_loads(const StepInTime& step, std::vector<double>& force) const {
  VOUSSOIR_EXPECT(step.from < step.to && "times of a step: ascending");
  BlockForces all(structure());
  loads_->add_mean(step, all);
  force = handed_over(structure(), std::move(all));
  check_size(force);
}

/// Throws InputError on every rank alike.
void Model::check_size(const std::vector<double>& force) const {
  double largest = 0;
  for (const double f : force) largest = std::isfinite(f) ? std::max(largest, std::abs(f)) : largest_force;
  largest = largest_over_ranks(*structure().comm(), largest);
  if (largest == 0 || (largest > smallest_force && largest < largest_force)) return;
  throw InputError(file_ + ": scene > loads\n  " +
                   (largest < largest_force ? "press no node with more than " + six_digits(largest) + " N"
                                            : "press a node with " + number_text(largest_force) + " N or more") +
                   " (squares of such forces are beyond the numbers a computer holds, " + number_text(smallest_force) +
                   " to " + number_text(largest_force) +
                   " N can be computed).\n  Check densities, gravity and the factors of the loads.");
}

}  // namespace voussoir
