// A node of weight 100 N on the ground, held by a spring of 1000 N/m along it, pushed by 50 N.
#pragma once

#include "nonlinear/patch.hpp"

namespace voussoir::test {

constexpr double weight = 100, push = 50, spring = 1000, stone = 1e6;

inline PatchPoint on_the_ground(double friction) {
  PatchPoint p;
  p.shares = {{0, 0, 1.0}, {1, 1, 1.0}};
  p.axis = {{{0, 1}, {-1, 0}}};
  p.law.friction = friction;
  p.local_stiffness = stone;
  return p;
}

inline PatchParts parts_of_slider(double friction) {
  PatchParts parts;
  parts.components = 2;
  parts.imbalance = {-push, weight};
  parts.start = {0, 0};
  parts.proximal_weight = {1e-6, 1e-6};
  parts.stiffness = {{0, 0, spring}, {1, 1, 1e-6}};
  parts.force_scale = weight;
  parts.length_scale = 1;
  parts.points = {on_the_ground(friction)};
  return parts;
}

inline Patch slider_on_the_ground(double friction) { return Patch(parts_of_slider(friction)); }

}  // namespace voussoir::test
