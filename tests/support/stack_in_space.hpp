// Four cubes of hexahedra in space, one on top of the other, the lowest held at its foot, and their model.
#pragma once

#include <Tpetra_Core.hpp>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "blocks/assembly.hpp"
#include "blocks/supports.hpp"
#include "mesh/block_list.hpp"
#include "mesh/partition.hpp"
#include "model/model.hpp"
#include "model/scene_fit.hpp"
#include "scene/scene.hpp"
#include "unit/blocks/cubes.hpp"

namespace voussoir::test {

constexpr int stones_of_stack = 4, cells_of_cube = 3;
constexpr double stack_gravity = 9.81, stack_weight = 2000 * stack_gravity;  // [m/s2], [N] of a cube of 1 m3

/// Stone of 1 GPa, nu = 0.2, 2000 kg/m3, friction as given, held at its foot.
inline Scene stack_scene(double friction, SelectionMode mode) {
  Scene scene;
  scene.file = "four cubes";
  MaterialParameters stone;
  stone.young_modulus = 1e9;
  stone.poisson_ratio = 0.2;
  stone.density = 2000;
  scene.materials.push_back({"stone", stone});
  JointLawParameters dry;
  dry.friction_coefficient = friction;
  scene.joints.push_back({"dry", dry});
  SupportParameters foot;
  foot.on = "foot";
  foot.components = "xyz";
  scene.supports.push_back({"foot", foot});
  scene.selection.mode = mode;
  scene.selection.largest_share = 1;  // of few beds, none is to be released with the others
  scene.time.mass = Mass::lumped;
  scene.output.fields = false;
  return scene;
}

inline std::unique_ptr<BlockSource<3>> stack_of_cubes() {
  BlockList<3> list;
  list.facet_sets = {"foot"};
  list.block_sets = {"top"};
  for (int storey = 0; storey < stones_of_stack; ++storey) list.blocks.push_back(cube(storey, cells_of_cube));
  for (const auto& cell : list.blocks.front().cells) {
    const auto& x = list.blocks.front().position;
    if (x[cell.node[0]][2] == 0)
      list.blocks.front().facets.push_back({{cell.node[0], cell.node[1], cell.node[2], cell.node[3]}, 4, 0});
  }
  list.blocks.back().sets = {0};
  return make_source(std::move(list));
}

class StackModel : public Model {
 public:
  /// @param velocity  [m/s] of the topmost stone as time begins
  StackModel(const Scene& scene, const BlockSource<3>& source, const Vector<3>& velocity)
      : Model(scene),
        source_(source),
        velocity_(velocity),
        structure_(
            source,
            partition(source.graph(), std::vector<double>(source.block_count(), 1.0), *Tpetra::getDefaultComm()),
            scene.model,
            [&](const Block<3>&) {
              const auto& p = scene.materials.front().parameters;
              return Material{p.young_modulus, p.poisson_ratio, p.density};
            },
            Tpetra::getDefaultComm()) {
    points_ = std::make_shared<ContactPoints>(source, structure_);
    hold_supports();
    find_never_tied({});
    for (auto& joint : points_->joints()) joint.family = 0;
    set_laws();
    make_continuum();
  }

  const Structure<3>& structure() const override { return structure_; }
  AnyGeometry geometry() const override { return Geometry<3>{source_, structure_}; }
  const BlockGraph& graph() const override { return source_.graph(); }
  double move_geometry(const std::vector<double>&) override { throw std::logic_error("rotations are small"); }
  std::unique_ptr<const BlockSystem> mass() const override {
    return std::make_unique<const Structure<3>>(structure_.with_matrices([&](int b) {
      const auto& block = structure_.blocks()[b];
      const auto volume = nodal_volumes(block.mesh);
      auto mass = *block.stiffness;
      for (int row = 0; row < mass.rows(); ++row)
        for (int k = mass.start[row]; k < mass.start[row + 1]; ++k)
          mass.value[k] = mass.column[k] == row ? block.material.density * volume[row / 3] : 0.0;
      return mass;
    }));
  }
  std::unique_ptr<Model> of_time_step(const BlockSystem& mass, const MidpointRule& rule,
                                      double tolerance) const override {
    return std::unique_ptr<Model>(new StackModel(*this, mass, rule, tolerance));
  }
  double wave_speed(int block) const override {
    const auto& m = structure_.blocks()[block].material;
    const double nu = m.poisson_ratio;
    return std::sqrt(m.young_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / m.density);
  }
  double passage(int block) const override { return 1.0 / cells_of_cube / wave_speed(block); }
  std::vector<double> initial_velocities() const override {
    return on_nodes([&](int stone) { return stone == stones_of_stack - 1 ? velocity_ : Vector<3>{}; });
  }

  /// A vector for every local node copy, by stone.
  template <class Value>
  std::vector<double> on_nodes(const Value& of_stone) const {
    std::vector<double> field;
    for (int n = 0; n < structure_.nodes(); ++n) {
      const auto value = of_stone(structure_.blocks()[structure_.block_of_node()[n]].mesh.id);
      field.insert(field.end(), value.begin(), value.end());
    }
    return field;
  }
  /// Nodal forces of an acceleration of all stones [N].
  std::vector<double> loads_of(const Vector<3>& acceleration) const {
    auto load = on_nodes([&](int) { return acceleration; });
    const auto volume = structure_.nodal_volumes();
    for (std::size_t i = 0; i < load.size(); ++i) load[i] *= 2000 * volume[i / 3];
    return load;
  }

 private:
  StackModel(const StackModel& at_rest, const BlockSystem& mass, const MidpointRule& rule, double tolerance)
      : Model(at_rest, rule.mass_factor(), tolerance),
        source_(at_rest.source_),
        structure_(at_rest.structure_.with_matrices([&](int b) {
          return sum(rule.stiffness_factor(), *at_rest.structure_.blocks()[b].stiffness, rule.mass_factor(),
                     *mass.nodes_of(b).stiffness);
        })) {
    set_local_stiffness(&mass, rule);
    make_continuum();
  }
  void hold_supports() override {
    held_.assign(3 * static_cast<std::size_t>(structure_.nodes()), 0);
    for (const auto& [name, support] : supports_)
      hold(structure_, support, facet_set(source_, {support.on, support.blocks}), held_);
  }
  double stiffness_beside(int node) const override {
    return structure_.blocks()[structure_.block_of_node()[node]].material.young_modulus / cells_of_cube;
  }

  const BlockSource<3>& source_;
  Vector<3> velocity_{};
  Structure<3> structure_;
};

}  // namespace voussoir::test
