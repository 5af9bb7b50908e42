// The smallest wall without weight and, unless it is held, without supports, with lumped masses.
#pragma once

#include "blocks/assembly.hpp"
#include "model/plane/plane_model.hpp"
#include "support/tied_wall.hpp"

namespace voussoir::test {

/// A scene whose stones move for a second without weight, and without supports unless they are held.
inline Scene in_flight(Scene scene, bool held = false) {
  if (!held) scene.supports.clear();
  scene.loads.clear();
  StageParameters time;
  time.name = "flight";
  time.duration = 1;
  scene.stages = {time};
  return scene;
}

/// One stone of 0.5 m, two of 0.25 m on it side by side, all 0.25 m high, 2000 kg/m3.
struct FloatingWall {
  Experiment wall;
  const PlaneModel& model;
  Structure<2> mass;
  std::vector<double> mass_of_node;  ///< [kg] per local node copy

  explicit FloatingWall(bool held = false)
      : wall(in_flight(tied_wall(), held)), model(wall.model()), mass(model.structure().with_matrices([this](int b) {
          const auto& block = model.structure().blocks()[b];
          return block_mass(block.mesh, block.material.density, 1.0, Mass::lumped);
        })) {
    std::vector<double> along_x(2 * static_cast<std::size_t>(mass.nodes()), 0.0), weight;
    for (std::size_t i = 0; i < along_x.size(); i += 2) along_x[i] = 1;
    mass.apply_stiffness(along_x, weight);
    for (std::size_t i = 0; i < weight.size(); i += 2) mass_of_node.push_back(weight[i]);
  }
  /// Velocities on node copies: of each block a translation, and a turn about the origin.
  std::vector<double> velocity(const std::vector<std::array<double, 3>>& of_block) const {
    const auto& s = model.structure();
    std::vector<double> v;
    for (int n = 0; n < s.nodes(); ++n) {
      const auto& [vx, vy, turn] = of_block[s.blocks()[s.block_of_node()[n]].mesh.id];
      v.push_back(vx - turn * s.position()[n][1]);
      v.push_back(vy + turn * s.position()[n][0]);
    }
    return v;
  }
};

}  // namespace voussoir::test
