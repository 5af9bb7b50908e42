// Walls in space built in memory and solved in process.
#pragma once

#include <Tpetra_Core.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "linalg/reduce.hpp"
#include "mesh/block_source.hpp"
#include "model/space/space_model.hpp"
#include "scene/scene.hpp"
#include "step/adaptive_step.hpp"
#include "support/scenes.hpp"

namespace voussoir::test {

/// A wall of stones of 10 GPa, 2000 kg/m3 and friction 0.6 on a ground that is held whole, with loads "weight" and
/// "push" along x, y and z [m/s2].
inline Scene wall_in_space_scene(const WallInSpaceParameters& wall, const Vector<3>& push = {}) {
  Scene scene = wall_scene(1);  // materials, joints and the weight
  scene.mesh.type = MeshType::wall_in_space;
  scene.mesh.wall_in_space = wall;
  scene.supports.clear();
  add_support(scene, wall.ground_height > 0 ? "ground" : "base", "all");
  scene.loads.resize(1);
  LoadParameters sideways;
  sideways.name = "push";
  auto& acceleration = sideways.kind.emplace<AccelerationParameters>();
  acceleration.ax = push[0];
  acceleration.ay = push[1];
  acceleration.az = push[2];
  scene.loads.push_back(sideways);
  return scene;
}

/// Block 0 is the ground, block 1 a prism of 1 x 0.6 x 2 m on it.
inline WallInSpaceParameters prism() {
  WallInSpaceParameters p;
  p.courses = p.blocks_per_course = 1;
  p.block_length = 1;
  p.thickness = 0.6;
  p.block_height = 2;
  p.bond = WallBond::stack;
  p.ground_height = 0.5;
  return p;
}

class ExperimentInSpace {
 public:
  explicit ExperimentInSpace(const Scene& scene)
      : scene_(scene),
        source_(make_block_source<3>(scene_.mesh, *Tpetra::getDefaultComm())),
        model_(scene_, *source_, Tpetra::getDefaultComm()),
        step_(model_),
        state_(step_.initial_state()) {
    model_.loads({}, 0.0, load_, prescribed_);
  }
  ExperimentInSpace(const ExperimentInSpace&) = delete;  // the model refers to the scene where it is

  /// One load step under load factors by name.
  StepReport advance(const std::map<std::string, double>& factors) {
    model_.loads(factors, 0.0, load_, prescribed_);
    return voussoir::advance(step_, state_, {load_, prescribed_});
  }
  /// Force of all supports on the structure [N], over all ranks.
  Vector<3> reaction() const {
    const auto residual = step_.residual(state_, load_);
    Vector<3> sum{};
    for (int i = 0; i < 3 * model_.structure().owned_nodes(); ++i)
      if (model_.held()[i]) sum[i % 3] += residual[i];
    return total_of_each(*model_.structure().comm(), sum);
  }
  /// Largest normal force of a point, and how far any is beyond friction mu [N]; over all ranks.
  std::array<double, 2> forces(double mu) const {
    std::array<double, 2> most{};
    for (int k = 0; k < model_.points().owned(); ++k) {
      const double* f = &state_.lambda[3 * k];
      most[0] = std::max(most[0], f[0]);
      most[1] = std::max(most[1], std::hypot(f[1], f[2]) - mu * f[0]);
    }
    return largest_of_each(*model_.structure().comm(), most);
  }

  const SpaceModel& model() const { return model_; }
  ContactState& state() { return state_; }
  const std::vector<double>& load() const { return load_; }
  AdaptiveStep& step() { return step_; }

 private:
  Scene scene_;
  std::unique_ptr<BlockSource<3>> source_;
  SpaceModel model_;
  AdaptiveStep step_;
  ContactState state_;
  std::vector<double> load_, prescribed_;
};

}  // namespace voussoir::test
