#include "model/model_of_blocks.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "base/check.hpp"
#include "base/finite.hpp"
#include "base/plane_and_space.hpp"
#include "blocks/assembly.hpp"
#include "blocks/supports.hpp"
#include "blocks/tetrahedron.hpp"
#include "dynamics/load_steps.hpp"
#include "linalg/reduce.hpp"
#include "mesh/block_share.hpp"
#include "model/loads_at_work.hpp"
#include "model/phase.hpp"
#include "model/scene_fit.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

template <int dim>
Material material_of(const Scene& scene, const BlockSource<dim>& source, const Block<dim>& block) {
  Material m;
  for (const auto& [name, p] : scene.materials)
    if (in_set(source, block, p.blocks)) m = {p.young_modulus, p.poisson_ratio, p.density, p.thickness};
  return m;
}

/// Whether a support of the scene holds a facet: held at its corners it is held between them too.
template <int dim>
std::function<bool(const Block<dim>&, const TaggedFacet&)> is_held(const Scene& scene, const BlockSource<dim>& source) {
  std::vector<FacetSet> sets;
  for (const auto& [name, support] : scene.supports) sets.push_back(facet_set(source, {support.on, support.blocks}));
  return [sets](const Block<dim>& block, const TaggedFacet& facet) {
    return std::any_of(sets.begin(), sets.end(), [&](const FacetSet& set) { return set.has(block, facet); });
  };
}

std::vector<double> cell_sizes(const Structure<3>& s) {
  std::vector<double> sizes;
  for (const auto& block : s.blocks()) {
    const auto more = cell_sizes(block.mesh);
    sizes.insert(sizes.end(), more.begin(), more.end());
  }
  return sizes;
}

}  // namespace

template <int dim>
ModelOfBlocks<dim>::ModelOfBlocks(const Scene& scene, const BlockSource<dim>& source,
                                  const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : Model(scene), source_(source) {
  {
    Phase phase("blocks");
    structure_ = std::make_unique<Structure<dim>>(
        source, share_out(source, *comm), scene.model,
        [&](const Block<dim>& block) { return material_of(scene, source, block); }, comm, is_held(scene, source));
    if constexpr (dim == 3) cell_size_ = std::make_shared<const std::vector<double>>(cell_sizes(*structure_));
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

template <int dim>
ModelOfBlocks<dim>::ModelOfBlocks(const ModelOfBlocks& at_rest, const BlockSystem& mass, const MidpointRule& rule,
                                  double tolerance)
    : Model(at_rest, rule.mass_factor(), tolerance), source_(at_rest.source_), cell_size_(at_rest.cell_size_) {
  VOUSSOIR_EXPECT(mass.nodes() == at_rest.structure().nodes() && "mass: of the structure at rest");
  const auto& rest = *at_rest.structure_;
  const auto with_mass = [&](int b, const LocalCsr& stiffness) {
    return sum(rule.stiffness_factor(), stiffness, rule.mass_factor(), *mass.nodes_of(b).stiffness);
  };
  structure_ = std::make_unique<Structure<dim>>(
      rest.with_matrices([&](int b) { return with_mass(b, *rest.blocks()[b].stiffness); },
                         [&](int b) { return with_mass(b, *rest.blocks()[b].sparse); }));
  set_local_stiffness(&mass, rule);
  make_continuum();
}

template <int dim>
std::unique_ptr<Model> ModelOfBlocks<dim>::of_time_step(const BlockSystem& mass, const MidpointRule& rule,
                                                        double tolerance) const {
  return std::unique_ptr<Model>(new ModelOfBlocks(*this, mass, rule, tolerance));
}

template <int dim>
double ModelOfBlocks<dim>::move_geometry(const std::vector<double>& displacement) {
  VOUSSOIR_EXPECT(displacement.size() == dim * static_cast<std::size_t>(structure_->nodes()) &&
                  "displacement: of node copies");
  VOUSSOIR_EXPECT(all_finite(displacement) && "displacement: finite");
  Phase phase("blocks");
  ++arrangement_;
  const double turned = structure_->move_to(displacement);
  points_->turn_axes(*structure_, settings_.internals.step.negligible_turn);
  return turned;
}

template <int dim>
std::unique_ptr<const BlockSystem> ModelOfBlocks<dim>::mass() const {
  Phase phase("blocks");
  return std::make_unique<const Structure<dim>>(structure_->with_matrices([&](int b) {
    const auto& block = structure_->blocks()[b];
    auto mesh = block.mesh;  // around its first node, so that it is that of all blocks alike, to the last bit
    for (auto& x : mesh.position) x = x - block.mesh.position.front();
    return block_mass(mesh, block.material, structure_->model(), settings_.time.mass);
  }));
}

template <int dim>
double ModelOfBlocks<dim>::passage(int block) const {
  double shortest = std::numeric_limits<double>::max();
  const auto& mesh = structure_->blocks()[block].mesh;
  const auto look_at = [&](int a, int b) {
    shortest = std::min(shortest, norm(mesh.position[b] - mesh.position[a]) / wave_speed(block));
  };
  for (const auto& cell : mesh.cells) {
    const int around = dim == 2 ? cell.count : 4;  // corners of a face
    if (dim == 3 && cell.count == 4) {             // all corners of a tetrahedron are neighbours
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j) look_at(cell.node[i], cell.node[j]);
      continue;
    }
    for (int i = 0; i < cell.count; ++i) {
      const int face = i / around * around;
      look_at(cell.node[i], cell.node[face + (i + 1) % around]);
      if (dim == 3 && i < around) look_at(cell.node[i], cell.node[i + around]);
    }
  }
  return shortest;
}

template <int dim>
void ModelOfBlocks<dim>::set_families(const Scene& scene) {
  const auto& blocks = structure_->blocks();
  auto& joints = points_->joints();
  for (auto& joint : joints) {
    const auto& i = blocks[joint.local_i].mesh;
    const auto& j = blocks[joint.local_j].mesh;
    joint.family = family_of(scene, source_, i, j);
    VOUSSOIR_EXPECT(joint.family >= 0 && "every joint of the mesh has a law");
  }
}

template <int dim>
void ModelOfBlocks<dim>::hold_supports() {
  std::vector<SupportedFacets> all;
  for (const auto& [name, support] : supports_)
    all.push_back({support, facet_set(source_, {support.on, support.blocks})});
  held_ = held_by(*structure_, all);
}

/// All points of a place two copies of which are held along an axis by different supports: a tie between the two may go
/// by others. And those at nodes that are held along a normal. Empty without such places.
template <int dim>
std::vector<char> ModelOfBlocks<dim>::between_supports() const {
  const auto along_normal = [](const auto& support) { return support.parameters.along_normal(); };
  if (supports_.size() < 2 && std::none_of(supports_.begin(), supports_.end(), along_normal)) return {};
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
  for (const auto& [node, axes] : held_.frames()) apart[node] = 1;
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

/// The place about which a set of blocks turns when time begins [m]: given, or its mass centre. Collective.
template <int dim>
Vector<dim> ModelOfBlocks<dim>::centre_of_rotation(const InitialVelocityParameters& given) const {
  const auto& s = *structure_;
  auto centre = s.middle();
  if (given.turn.rotation == 0) return centre;
  std::array<double, dim + 1> mine{};  // moments of the mass about the middle of the structure, and the mass
  for (int n = 0; n < s.owned_blocks(); ++n) {
    const auto& b = s.blocks()[n];
    if (!in_set(source_, b.mesh, given.blocks)) continue;
    const auto volume = nodal_volumes(b.mesh, b.material, s.model());
    for (std::size_t i = 0; i < volume.size(); ++i) {
      const double mass = b.material.density * volume[i];
      mine[dim] += mass;
      for (int c = 0; c < dim; ++c) mine[c] += mass * (b.mesh.position[i][c] - s.middle()[c]);
    }
  }
  const auto all = total_of_each(*s.comm(), mine);
  auto turn = given.turn;
  for (int c = 0; c < dim; ++c) centre[c] += all[c] / all[dim];
  turn.set_middle(centre);
  return in_dimension<dim>(turn.about);
}

template <int dim>
std::vector<double> ModelOfBlocks<dim>::initial_velocities() const {
  const auto& s = *structure_;
  std::vector<double> v(dim * static_cast<std::size_t>(s.nodes()), 0.0);
  for (const auto& [name, given] : settings_.velocities) {
    const auto centre = centre_of_rotation(given);
    const auto direction = given.turn.direction();
    const auto along = in_dimension<dim>({given.vx, given.vy, given.vz});
    for (const auto& b : s.blocks()) {
      if (!in_set(source_, b.mesh, given.blocks)) continue;
      for (std::size_t i = 0; i < b.mesh.position.size(); ++i) {
        const auto there = along + given.turn.rotation * spin(direction, b.mesh.position[i] - centre);
        for (int c = 0; c < dim; ++c) v[dim * (b.first_local + i) + c] = there[c];
      }
    }
  }
  return v;
}

template class ModelOfBlocks<2>;
template class ModelOfBlocks<3>;

}  // namespace voussoir
