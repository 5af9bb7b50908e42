// Four cubes of hexahedra in space, one on top of the other, the lowest held at its foot.
#pragma once

#include <Tpetra_Core.hpp>
#include <memory>
#include <utility>

#include "mesh/block_list.hpp"
#include "model/space/space_model.hpp"
#include "scene/scene.hpp"
#include "unit/blocks/cubes.hpp"

namespace voussoir::test {

constexpr int stones_of_stack = 4;
constexpr double stack_gravity = 9.81, stack_weight = 2000 * stack_gravity;  // [m/s2], [N] of a cube of 1 m3

/// Stone of 1 GPa, nu = 0.2, 2000 kg/m3, held at its foot, with accelerations of 1 m/s2 of all stones as loads "x", "y"
/// and "z".
/// @param velocity  [m/s] of the topmost stone as time begins
inline Scene stack_scene(double friction, SelectionMode mode, const Vector<3>& velocity = {}) {
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
  foot.components = "all";
  scene.supports.push_back({"foot", foot});
  for (const char* axis : {"x", "y", "z"}) {
    LoadParameters load;
    load.name = axis;
    auto& acceleration = load.kind.emplace<AccelerationParameters>();
    (*axis == 'x' ? acceleration.ax : *axis == 'y' ? acceleration.ay : acceleration.az) = 1;
    scene.loads.push_back(load);
  }
  InitialVelocityParameters given;
  given.blocks = "top";
  given.vx = velocity[0];
  given.vy = velocity[1];
  given.vz = velocity[2];
  scene.velocities.push_back({"top", given});
  scene.selection.mode = mode;
  scene.selection.largest_share = 1;  // of few beds, none is to be released with the others
  scene.time.mass = Mass::lumped;
  return scene;
}

inline std::unique_ptr<BlockSource<3>> stack_of_cubes() {
  BlockList<3> list;
  list.facet_sets = {"foot"};
  list.block_sets = {"top"};
  for (int storey = 0; storey < stones_of_stack; ++storey) list.blocks.push_back(cube(storey, 3));
  auto& lowest = list.blocks.front();
  for (const auto& cell : lowest.cells)
    if (lowest.position[cell.node[0]][2] == 0)
      lowest.facets.push_back({{cell.node[0], cell.node[1], cell.node[2], cell.node[3]}, 4, 0});
  list.blocks.back().sets = {0};
  return make_source(std::move(list));
}

}  // namespace voussoir::test
