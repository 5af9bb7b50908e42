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
#include "linalg/reduce.hpp"
#include "mesh/partition.hpp"
#include "model/phase.hpp"
#include "model/scene_fit.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

template <int dim>
Material material_of(const Scene& scene, const BlockSource<dim>& source, const Block<dim>& block) {
  Material m;
  for (const auto& [name, p] : scene.materials)
    if (in_set(source, block, p.blocks)) m = {p.young_modulus, p.poisson_ratio, p.density};
  return m;
}

template <int dim>
std::vector<int> owners(const BlockSource<dim>& source, const Teuchos::Comm<int>& comm) {
  std::vector<double> weight(source.block_count());
  for (BlockId b = 0; b < source.block_count(); ++b) weight[b] = dim * source.node_count(b);
  return partition(source.graph(), weight, comm);
}

// Forces whose squares, down to the tolerances of solvers, stay within the numbers a computer holds. [N]
constexpr double smallest_force = 1e-130, largest_force = 1e130;

}  // namespace

template <int dim>
Model<dim>::Model(const Scene& scene, const BlockSource<dim>& source,
                  const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : settings_(scene), file_(scene.file), families_(scene.joints), supports_(scene.supports), source_(source) {
  {
    Phase phase("blocks");
    structure_ = std::make_unique<Structure<dim>>(
        source, owners(source, *comm), scene.model,
        [&](const Block<dim>& block) { return material_of(scene, source, block); }, comm);
  }
  {
    Phase phase("joints");
    points_ = std::make_unique<ContactPoints>(source, *structure_);
    hold_supports();
    find_never_tied();
    set_laws(scene);
  }
  {
    Phase phase("loads");
    loads_ = std::make_unique<LoadsAtWork<dim>>(scene, source, *structure_);
  }
  if (only_time(scene.stages)) return;
  Phase phase("continuum");
  continuum_ = std::make_unique<Continuum<dim>>(*structure_, *points_, held_, scene.solver.muelu,
                                                scene.internals.preconditioner, local_stiffness_);
}

template <int dim>
Model<dim>::Model(const Model& at_rest, const Structure<dim>& mass, const MidpointRule& rule, double tolerance)
    : settings_(at_rest.settings_.of_time_step(tolerance)),
      file_(at_rest.file_),
      families_(at_rest.families_),
      supports_(at_rest.supports_),
      source_(at_rest.source_),
      points_(at_rest.points_),
      held_(at_rest.held_),
      never_tied_(at_rest.never_tied_),
      absent_(at_rest.absent_),
      law_(at_rest.law_),
      compliance_(at_rest.compliance_),
      softest_mortar_(at_rest.softest_mortar_),
      initial_gap_(at_rest.initial_gap_),
      softening_(at_rest.softening_),
      weakens_(at_rest.weakens_),
      inertia_(rule.mass_factor()) {
  VOUSSOIR_EXPECT(mass.nodes() == at_rest.structure().nodes() && "mass: of the structure at rest");
  VOUSSOIR_EXPECT(tolerance > 0 && tolerance < 1 && "tolerance: a share of the largest force");
  const auto& rest = *at_rest.structure_;
  structure_ = std::make_unique<Structure<dim>>(rest.with_matrices([&](int b) {
    return sum(rule.stiffness_factor(), *rest.blocks()[b].stiffness, rule.mass_factor(), *mass.blocks()[b].stiffness);
  }));
  set_local_stiffness(&mass, rule);
  Phase phase("continuum");
  continuum_ = std::make_unique<Continuum<dim>>(*structure_, *points_, held_, settings_.solver.muelu,
                                                settings_.internals.preconditioner, local_stiffness_);
}

template <int dim>
void Model<dim>::set_laws(const Scene& scene) {
  const auto& blocks = structure_->blocks();
  auto& joints = points_->joints();
  for (auto& joint : joints) {
    const auto& i = blocks[structure_->local_block(joint.block_i)].mesh;
    const auto& j = blocks[structure_->local_block(joint.block_j)].mesh;
    joint.family = family_of(scene, source_, i, j);
    VOUSSOIR_EXPECT(joint.family >= 0 && "every joint of the mesh has a law");
  }
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

template <int dim>
const JointLawParameters& Model<dim>::joint_law(std::size_t point) const {
  return families_[points_->joints()[points_->points()[point].joint].family].parameters;
}

/// What stands open as drawn, or beside a stone that is not there, is not bonded: it can rub, no more.
template <int dim>
bool Model<dim>::is_bonded(std::size_t point) const {
  return joined(static_cast<int>(point)) && joint_law(point).initial_gap == 0;
}

template <int dim>
void Model<dim>::set_strengths() {
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
template <int dim>
Softening Model<dim>::softening_of(std::size_t k) const {
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
template <int dim>
void Model<dim>::set_local_stiffness(const Structure<dim>* mass, const MidpointRule& rule) {
  std::vector<double> inertia(structure_->nodes(), 0.0);
  if (mass) {
    std::vector<double> along_x(dim * inertia.size(), 0.0), weight;
    for (std::size_t i = 0; i < inertia.size(); ++i) along_x[dim * i] = 1;
    mass->apply_stiffness(along_x, weight);
    for (std::size_t i = 0; i < inertia.size(); ++i) inertia[i] = rule.mass_factor() * weight[dim * i];
  }
  const auto at_node = [&](int node) {
    const auto& material = structure_->blocks()[structure_->block_of_node()[node]].material;
    return (mass ? rule.stiffness_factor() : 1.0) * material.young_modulus * structure_->model().thickness +
           inertia[node];
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

template <int dim>
std::vector<double> Model<dim>::gaps(const std::vector<double>& u) const {
  VOUSSOIR_EXPECT(u.size() == static_cast<std::size_t>(dim) * structure_->nodes() && "displacement: of node copies");
  std::vector<double> gap;
  relative_motions(*points_, u, gap);
  for (std::size_t k = 0; k < initial_gap_.size(); ++k) gap[dim * k] += initial_gap_[k];
  return gap;
}

template <int dim>
std::vector<double> Model<dim>::gaps(const std::vector<double>& u, const std::vector<double>& lambda) const {
  VOUSSOIR_EXPECT((compliance_.empty() || lambda.size() == dim * compliance_.size()) && "lambda: of points");
  auto gap = gaps(u);
  for (std::size_t k = 0; k < compliance_.size(); ++k)
    for (int c = 0; c < dim; ++c) gap[dim * k + c] += compliance_[k].along(c) * lambda[dim * k + c];
  return gap;
}

template <int dim>
double Model<dim>::mortar_energy(const std::vector<double>& lambda) const {
  VOUSSOIR_EXPECT((compliance_.empty() || lambda.size() == dim * compliance_.size()) && "lambda: of points");
  double energy = 0;
  const auto owned = std::min<std::size_t>(compliance_.size(), points_->owned());
  for (std::size_t k = 0; k < owned; ++k)
    for (int c = 0; c < dim; ++c) energy += compliance_[k].along(c) * lambda[dim * k + c] * lambda[dim * k + c] / 2;
  return energy;
}

template <int dim>
void Model<dim>::hold_supports() {
  held_.assign(static_cast<std::size_t>(dim) * structure_->nodes(), 0);
  for (const auto& [name, support] : supports_)
    hold(*structure_, support, facet_set(source_, {support.on, support.blocks}), held_);
}

template <int dim>
void Model<dim>::find_never_tied() {
  never_tied_ = points_->untieable();
  const auto between = between_supports();
  if (!between.empty()) never_tied_.resize(between.size(), 0);
  for (std::size_t k = 0; k < between.size(); ++k) never_tied_[k] |= between[k];
}

/// All points of a place two copies of which are held along an axis by different supports: a tie between the two may go
/// by others. Empty without such places.
template <int dim>
std::vector<char> Model<dim>::between_supports() const {
  if (supports_.size() < 2) return {};
  const auto& s = *structure_;
  constexpr std::size_t one_more = 1000003;  // a prime, so that sets of supports have numbers of their own
  std::vector<std::size_t> holders(held_.size(), 0);
  std::size_t number = 0;
  for (const auto& [name, support] : supports_) {
    std::vector<char> here(held_.size(), 0);
    hold(s, support, facet_set(source_, {support.on, support.blocks}), here);
    ++number;
    for (std::size_t i = 0; i < here.size(); ++i)
      if (here[i]) holders[i] = one_more * holders[i] + number;
  }
  std::vector<char> apart(s.nodes(), 0);
  for (std::size_t g = 0; g + 1 < s.copies_start().size(); ++g)
    for (int c = 0; c < dim; ++c) {
      std::size_t first = 0;
      bool differ = false;
      for (int i = s.copies_start()[g]; i < s.copies_start()[g + 1]; ++i) {
        const auto of = holders[dim * s.copy()[i] + c];
        if (first == 0) first = of;
        differ |= of != 0 && of != first;
      }
      for (int i = s.copies_start()[g]; differ && i < s.copies_start()[g + 1]; ++i) apart[s.copy()[i]] = 1;
    }
  std::vector<double> flag(points_->size(), 0.0);
  for (int k = 0; k < points_->owned(); ++k) flag[k] = points_->at(k).any([&](int node) { return apart[node] != 0; });
  const bool any = std::find(flag.begin(), flag.end(), 1.0) != flag.end();
  if (!any_of_ranks(*s.comm(), any)) return {};
  points_->exchange().update(flag, 1);
  return {flag.begin(), flag.end()};
}

template <int dim>
void Model<dim>::set_absent(const std::vector<char>& absent) {
  VOUSSOIR_EXPECT(absent.size() == structure_->blocks().size() && "absent: per local block");
  ++arrangement_;
  hold_supports();
  for (std::size_t i = 0; i < held_.size(); ++i)
    if (absent[structure_->block_of_node()[i / dim]]) held_[i] = 1;
  if (absent_ == absent) return;
  absent_ = absent;
  set_strengths();
}

template <int dim>
bool Model<dim>::joined(int point) const {
  if (absent_.empty()) return true;
  const auto& joint = points_->joint_of(point);
  return !absent_[joint.local_i] && !absent_[joint.local_j];
}

template <int dim>
double Model<dim>::follow(const std::vector<double>& displacement) {
  VOUSSOIR_EXPECT(displacement.size() == static_cast<std::size_t>(dim) * structure_->nodes() &&
                  "displacement: of node copies");
  VOUSSOIR_EXPECT(all_finite(displacement) && "displacement: finite");
  Phase phase("blocks");
  ++arrangement_;
  const double turned = structure_->follow(displacement);
  points_->follow(*structure_);
  return turned;
}

template <int dim>
void Model<dim>::loads(const std::map<std::string, double>& factors, double time, std::vector<double>& force,
                       std::vector<double>& prescribed) const {
  VOUSSOIR_EXPECT(std::isfinite(time) && "time: finite");
  for (const auto& [load, factor] : factors) VOUSSOIR_EXPECT(std::isfinite(factor) && "factors of loads: finite");
  force.resize(static_cast<std::size_t>(dim) * structure_->nodes());
  prescribed.resize(force.size());
  loads_->add(factors, time, force, prescribed);
  check_size(force);
}

template <int dim>
void Model<dim>::mean_loads(const StepInTime& step, std::vector<double>& force) const {
  VOUSSOIR_EXPECT(step.from < step.to && "times of a step: ascending");
  force.resize(static_cast<std::size_t>(dim) * structure_->nodes());
  loads_->add_mean(step, force);
  check_size(force);
}

/// Throws InputError on every rank alike.
template <int dim>
void Model<dim>::check_size(const std::vector<double>& force) const {
  double largest = 0;
  for (const double f : force) largest = std::isfinite(f) ? std::max(largest, std::abs(f)) : largest_force;
  largest = largest_over_ranks(*structure_->comm(), largest);
  if (largest == 0 || (largest > smallest_force && largest < largest_force)) return;
  throw InputError(file_ + ": scene > loads\n  " +
                   (largest < largest_force ? "press no node with more than " + number_text(largest) + " N"
                                            : "press a node with " + number_text(largest_force) + " N or more") +
                   " (squares of such forces are beyond the numbers a computer holds, " + number_text(smallest_force) +
                   " to " + number_text(largest_force) +
                   " N can be computed).\n  Check densities, gravity and the factors of the loads.");
}

template class Model<2>;

}  // namespace voussoir
