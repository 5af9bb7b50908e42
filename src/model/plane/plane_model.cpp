#include "model/plane/plane_model.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "base/finite.hpp"
#include "blocks/assembly.hpp"
#include "blocks/supports.hpp"
#include "dynamics/load_steps.hpp"
#include "linalg/reduce.hpp"
#include "mesh/partition.hpp"
#include "model/loads_at_work.hpp"
#include "model/phase.hpp"
#include "model/scene_fit.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

Material material_of(const Scene& scene, const BlockSource<2>& source, const Block<2>& block) {
  Material m;
  for (const auto& [name, p] : scene.materials)
    if (in_set(source, block, p.blocks)) m = {p.young_modulus, p.poisson_ratio, p.density};
  return m;
}

std::vector<int> owners(const BlockSource<2>& source, const Teuchos::Comm<int>& comm) {
  std::vector<double> weight(source.block_count());
  for (BlockId b = 0; b < source.block_count(); ++b) weight[b] = 2.0 * source.node_count(b);
  return partition(source.graph(), weight, comm);
}

}  // namespace

PlaneModel::PlaneModel(const Scene& scene, const BlockSource<2>& source,
                       const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : Model(scene), source_(source) {
  {
    Phase phase("blocks");
    structure_ = std::make_unique<Structure<2>>(
        source, owners(source, *comm), scene.model,
        [&](const Block<2>& block) { return material_of(scene, source, block); }, comm);
  }
  {
    Phase phase("joints");
    points_ = std::make_shared<ContactPoints>(source, *structure_);
    hold_supports();
    find_never_tied(between_supports());
    set_families(scene);
    set_laws();
  }
  {
    Phase phase("loads");
    loads_ = std::make_shared<const LoadsAtWork>(scene, source, *structure_);
  }
  if (!only_time(scene.stages)) make_continuum();
}

PlaneModel::PlaneModel(const PlaneModel& at_rest, const BlockSystem& mass, const MidpointRule& rule, double tolerance)
    : Model(at_rest, rule.mass_factor(), tolerance), source_(at_rest.source_) {
  VOUSSOIR_EXPECT(mass.nodes() == at_rest.structure().nodes() && "mass: of the structure at rest");
  const auto& rest = *at_rest.structure_;
  structure_ = std::make_unique<Structure<2>>(rest.with_matrices([&](int b) {
    return sum(rule.stiffness_factor(), *rest.blocks()[b].stiffness, rule.mass_factor(), *mass.nodes_of(b).stiffness);
  }));
  set_local_stiffness(&mass, rule);
  make_continuum();
}

std::unique_ptr<Model> PlaneModel::of_time_step(const BlockSystem& mass, const MidpointRule& rule,
                                                double tolerance) const {
  return std::unique_ptr<Model>(new PlaneModel(*this, mass, rule, tolerance));
}

std::unique_ptr<const BlockSystem> PlaneModel::mass() const {
  Phase phase("blocks");
  return std::make_unique<const Structure<2>>(structure_->with_matrices([&](int b) {
    const auto& block = structure_->blocks()[b];
    auto mesh = block.mesh;  // around its first node, so that it is that of all blocks alike, to the last bit
    for (auto& x : mesh.position) x = x - block.mesh.position.front();
    return block_mass(mesh, block.material.density, structure_->model().thickness, settings_.time.mass);
  }));
}

double PlaneModel::wave_speed(int block) const {
  const auto& material = structure_->blocks()[block].material;
  return std::sqrt(plane_elasticity(material, structure_->model().plane)[0][0] / material.density);
}

double PlaneModel::passage(int block) const {
  double shortest = std::numeric_limits<double>::max();
  const auto& mesh = structure_->blocks()[block].mesh;
  for (const auto& cell : mesh.cells)
    for (int i = 0; i < cell.count; ++i) {
      const auto edge = mesh.position[cell.node[(i + 1) % cell.count]] - mesh.position[cell.node[i]];
      shortest = std::min(shortest, norm(edge) / wave_speed(block));
    }
  return shortest;
}

void PlaneModel::set_families(const Scene& scene) {
  const auto& blocks = structure_->blocks();
  auto& joints = points_->joints();
  for (auto& joint : joints) {
    const auto& i = blocks[joint.local_i].mesh;
    const auto& j = blocks[joint.local_j].mesh;
    joint.family = family_of(scene, source_, i, j);
    VOUSSOIR_EXPECT(joint.family >= 0 && "every joint of the mesh has a law");
  }
}

void PlaneModel::hold_supports() {
  held_.assign(2 * static_cast<std::size_t>(structure_->nodes()), 0);
  for (const auto& [name, support] : supports_)
    hold(*structure_, support, facet_set(source_, {support.on, support.blocks}), held_);
}

/// All points of a place two copies of which are held along an axis by different supports: a tie between the two may go
/// by others. Empty without such places.
std::vector<char> PlaneModel::between_supports() const {
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
    for (int c = 0; c < 2; ++c) {
      std::size_t first = 0;
      bool differ = false;
      for (int i = s.copies_start()[g]; i < s.copies_start()[g + 1]; ++i) {
        const auto of = holders[2 * s.copy()[i] + c];
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

double PlaneModel::stiffness_beside(int node) const {
  return structure_->blocks()[structure_->block_of_node()[node]].material.young_modulus * structure_->model().thickness;
}

double PlaneModel::follow(const std::vector<double>& displacement) {
  VOUSSOIR_EXPECT(displacement.size() == 2 * static_cast<std::size_t>(structure_->nodes()) &&
                  "displacement: of node copies");
  VOUSSOIR_EXPECT(all_finite(displacement) && "displacement: finite");
  Phase phase("blocks");
  ++arrangement_;
  const double turned = structure_->follow(displacement);
  points_->follow(*structure_);
  return turned;
}

/// The place about which a set of blocks turns when time begins [m]: given, or its mass centre. Collective.
Vector<2> PlaneModel::centre_of_rotation(const InitialVelocityParameters& given) const {
  const auto& s = *structure_;
  Vector<2> centre{given.about_x, given.about_y};
  if (given.rotation == 0) return s.middle();
  std::array<double, 3> mine{};  // moments of the mass about the middle of the structure, and the mass
  for (int n = 0; n < s.owned_blocks(); ++n) {
    const auto& b = s.blocks()[n];
    if (!in_set(source_, b.mesh, given.blocks)) continue;
    const auto volume = nodal_volumes(b.mesh, s.model().thickness);
    for (std::size_t i = 0; i < volume.size(); ++i) {
      const double mass = b.material.density * volume[i];
      mine[2] += mass;
      for (int c = 0; c < 2; ++c) mine[c] += mass * (b.mesh.position[i][c] - s.middle()[c]);
    }
  }
  const auto all = total_of_each(*s.comm(), mine);
  for (int c = 0; c < 2; ++c)
    if (std::isinf(centre[c])) centre[c] = s.middle()[c] + all[c] / all[2];
  return centre;
}

std::vector<double> PlaneModel::initial_velocities() const {
  const auto& s = *structure_;
  std::vector<double> v(2 * static_cast<std::size_t>(s.nodes()), 0.0);
  for (const auto& [name, given] : settings_.velocities) {
    const auto centre = centre_of_rotation(given);
    for (const auto& b : s.blocks()) {
      if (!in_set(source_, b.mesh, given.blocks)) continue;
      for (std::size_t i = 0; i < b.mesh.position.size(); ++i) {
        const auto arm = b.mesh.position[i] - centre;
        v[2 * (b.first_local + i)] = given.vx - given.rotation * arm[1];
        v[2 * (b.first_local + i) + 1] = given.vy + given.rotation * arm[0];
      }
    }
  }
  return v;
}

}  // namespace voussoir
