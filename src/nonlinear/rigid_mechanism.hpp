// Does a motion of the blocks as wholes lead nowhere? Told by kinematics alone: no stiffness enters, so that blocks may
// be as stiff as they like.
#pragma once

#include "nonlinear/nonlinear_problem.hpp"
#include "nonlinear/point_update.hpp"

namespace voussoir {

/// Whether forces that leave the structure out of balance stay as they are along a motion, as far as it goes: blocks
/// move as wholes, points that press neither close nor open, friction is spent against the slip. Collective.
///
/// @param motion     largest component 1
/// @param far        how far it goes [m]
/// @param allowance  change of a contact force that leaves the imbalance what it is [N]
bool is_rigid_mechanism(NonlinearProblem&, const CurrentLaws&, const TpetraVector& motion, const PointField& lambda,
                        const PointField& gap, double far, double allowance);

}  // namespace voussoir
