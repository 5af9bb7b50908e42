// Stones and joints as turned stones are judged by: places, turns, and how forces lie to centres. In three components,
// in the plane too.
#pragma once

#include <array>
#include <vector>

#include "base/dense.hpp"
#include "model/model_of_blocks.hpp"
#include "range/range_check.hpp"

namespace voussoir {

/// Sum of places times forces, row by row: what a small turn makes of the moment of forces that keep their directions.
using Virial = Matrix<3>;

inline void add_virial(const Vector<3>& arm, const Vector<3>& force, Virial& sum) {
  for (int a = 0; a < 3; ++a) sum[a] = sum[a] + arm[a] * force;
}

struct StoneRecord {
  BlockId block;
  bool held;
  Vector<3> centre, turn;       ///< [m] of mass as drawn; [rad]
  Vector<3> load, load_moment;  ///< [N], [N m] about the centre
  Virial virial;                ///< [N m] about the centre, of the loads that do not turn with the stone
};

struct JointRecord {
  BlockId block_i, block_j;
  Vector<3> middle;               ///< [m] as drawn
  std::array<Vector<3>, 3> axis;  ///< normal from i to j, and tangents: in space those of the least rectangle around it
  double area;                    ///< [m2], in the plane its length [m]
  std::array<double, 2> half;     ///< [m] half its length along the two tangents; in the plane the first alone
  Vector<3> force;                ///< [N] on block j
  Virial virial_i, virial_j;      ///< [N m] of its forces about the centres of the two
  double presses;                 ///< [N] sum of what its points bear
  double friction;                ///< [-]; infinite where a strength bears as well
};

/// How far a local block has turned [rad].
Vector<3> turn_of(const Structure<2>&, int block, const std::vector<double>& displacement);
Vector<3> turn_of(const Structure<3>&, int block, const std::vector<double>& displacement);

/// Of this rank: stones that are there, and joints.
template <int dim>
std::vector<StoneRecord> stones_here(const ModelOfBlocks<dim>&, const StepEnd&);
template <int dim>
std::vector<JointRecord> joints_here(const ModelOfBlocks<dim>&, const StepEnd&);

}  // namespace voussoir
