#include "simulation/model.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "blocks/supports.hpp"
#include "mesh/partition.hpp"
#include "simulation/phase.hpp"
#include "simulation/scene_fit.hpp"

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

}  // namespace

template <int dim>
Model<dim>::Model(const Scene& scene, const BlockSource<dim>& source,
                  const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : scene_(scene), source_(source) {
  {
    Phase phase("blocks");
    structure_ = std::make_unique<Structure<dim>>(
        source, owners(source, *comm), scene.model,
        [&](const Block<dim>& block) { return material_of(scene, source, block); }, comm);
  }
  {
    Phase phase("joints");
    points_ = std::make_unique<ContactPoints<dim>>(source, *structure_);
    held_.assign(static_cast<std::size_t>(dim) * structure_->nodes(), 0);
    for (const auto& [name, support] : scene.supports) hold(*structure_, support, facet_set(support.on), held_);
    set_laws();
  }
  {
    Phase phase("loads");
    loads_ = std::make_unique<LoadsAtWork<dim>>(scene, source, *structure_);
  }
  Phase phase("continuum");
  continuum_ = std::make_unique<Continuum<dim>>(*structure_, *points_, held_, scene.solver.muelu);
}

template <int dim>
int Model<dim>::facet_set(const std::string& name) const {
  const auto& sets = source_.facet_sets();
  const auto it = std::find(sets.begin(), sets.end(), name);
  VOUSSOIR_CHECK(it != sets.end());
  return static_cast<int>(it - sets.begin());
}

template <int dim>
void Model<dim>::set_laws() {
  const auto& blocks = structure_->blocks();
  auto& joints = points_->joints();
  for (auto& joint : joints) {
    const auto& i = blocks[structure_->local_block(joint.block_i)].mesh;
    const auto& j = blocks[structure_->local_block(joint.block_j)].mesh;
    joint.family = family_of(scene_, source_, i, j);
  }
  for (const auto& p : points_->points()) {
    const auto& law = scene_.joints[joints[p.joint].family].parameters;
    law_.push_back({law.friction_coefficient, law.cohesion * p.area, law.tension_strength * p.area});
    brittle_ |= law.cohesion > 0 || law.tension_strength > 0;
    // Springs in series: the cells on both sides, each as stiff as Young's modulus times the thickness.
    const double ei = blocks[structure_->block_of_node()[p.node_i]].material.young_modulus;
    const double ej = blocks[structure_->block_of_node()[p.node_j]].material.young_modulus;
    local_stiffness_.push_back(2 * ei * ej / (ei + ej) * structure_->model().thickness);
  }
}

template <int dim>
void Model<dim>::loads(const std::map<std::string, double>& factors, double time, std::vector<double>& force,
                       std::vector<double>& prescribed) const {
  force.resize(static_cast<std::size_t>(dim) * structure_->nodes());
  prescribed.resize(force.size());
  loads_->add(factors, time, force, prescribed);
}

template class Model<2>;

}  // namespace voussoir
