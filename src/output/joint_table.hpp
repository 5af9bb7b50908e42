// joints.csv: what every joint carries at the end of a run in statics. src/output/joints.md explains the columns.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace voussoir {

/// A row; plain data, so that ranks can exchange it. Forces are those of block i on block j. Places and forces have
/// three components, in the plane too.
struct JointRow {
  int block_i = 0, block_j = 0;
  std::array<double, 3> middle{};       ///< [m]
  double extent = 0;                    ///< [m] length; in space area [m2]
  std::array<double, 3> force{};        ///< [N]
  double normal_force = 0, shear = 0;   ///< [N] compression positive; along the joint
  double twist = 0;                     ///< [N m] about its normal; none in the plane
  std::array<double, 3> through{};      ///< [m] where the resultant crosses the joint; NaN without compression
  double eccentricity = 0;              ///< [m] from the middle; NaN without compression
  double edge_margin = 0;               ///< [-] 0.5 in the middle, 0 at the edge; NaN without compression
  std::array<double, 3> edge{};         ///< [m] the place of the edge from which it counts; NaN without one
  double friction_margin = 0;           ///< [-] 1 without shear, 0 sliding; NaN where none could be borne
  std::array<double, 3> least_shear{};  ///< [m] middle of the side it is of; NaN without one
  double opening = 0;                   ///< [m] widest
  double damage = 0;                    ///< [-] share of its strength that is lost, mean over its length
  double pressing = 0;                  ///< [N] sum of what its points press with; not in the file
  int sides = 1;
  int hinge = 0, slides = 0;  ///< 0 or 1
};

/// Text of the file; a number that is not finite is an empty field.
/// @param components  2 in the plane, 3 in space
std::string joint_table(const std::vector<JointRow>&, int components);

}  // namespace voussoir
