// The state of a structure between two steps. It is a value: a step is given one and hands back another.
#pragma once

#include <vector>

#include "linalg/reduce.hpp"
#include "nonlinear/fast_way.hpp"
#include "nonlinear/nonlinear_problem.hpp"
#include "selection/rest.hpp"

namespace voussoir {

/// Gaps below this share of the structure's size are those of closed points: round-off, not a way to fall.
inline constexpr double closed_gap = 1e-13;

/// What a point does, in the numbers of fields.h5.
enum class PointStatus : char { open = 0, stick = 1, slip = 2, bonded = 3 };

/// The state of a structure between load steps, on this rank's node copies and points (ghosts included).
struct ContactState {
  std::vector<double> displacement;  ///< [m, dim x local node copies]
  PointField lambda;                 ///< [N]
  PointField slip_origin;            ///< [m] slip at the end of the last load step, normal 0; empty where nothing rubs
  std::vector<char> selected;        ///< per point
  std::vector<char> status;          ///< per point: a PointStatus, as point_status.hpp judged the end of the last step
  std::vector<double> opened;        ///< [m] per point: largest opening of a joint with strength; empty without such
  std::vector<double> slipped;       ///< [m] likewise: length of the way slipped
  std::vector<double> initial_gap;   ///< [m] per point: what construction adds to its gap; empty without construction
  std::vector<double> velocity;      ///< [m/s] like displacement; empty before time begins
  std::vector<double> acceleration;  ///< [m/s2] mean of the last time step, for errors; empty likewise
  std::vector<double> acceleration_before;  ///< [m/s2] of the time step before it
  double largest_energy = 0;                ///< [J] of the structure since time began, what that error is relative to
  FastWay fast_way;                         ///< what the nonlinear solver remembers
  Rest rest;                                ///< of points in time steps
};

/// What a point does; one that is not selected is held by ties.
inline PointStatus status_of(const ContactState& state, int k) {
  return state.selected[k] ? static_cast<PointStatus>(state.status[k]) : PointStatus::bonded;
}

/// Whether the state has velocities on any rank: those without blocks never have. Collective.
inline bool in_motion(const Teuchos::Comm<int>& comm, const ContactState& state) {
  return any_of_ranks(comm, !state.velocity.empty());
}

}  // namespace voussoir
