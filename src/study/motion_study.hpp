// What a time step costs beside one of the same structure with every joint bonded, from rest to where much changes.
//
// A structure that stands is moved by its ground; all time steps of the scene are taken once bonded and once adaptive,
// in one process on one model. Seconds are those of the processor, slowest rank.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "model/plane/plane_model.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Means over the time steps of one run.
struct MotionRow {
  std::string family, mode;
  double size = 0;  ///< courses, or how many times finer the mesh is
  double peak = 0;  ///< [m/s2] of the ground
  int ranks = 1, steps = 0;
  long long blocks = 0, candidate_points = 0;
  double selected = 0;  ///< points, after a step
  double changed = 0;   ///< points that open, close, begin or cease to slip, are released or bonded in a step
  double seconds = 0, solves = 0, krylov = 0;  ///< of a step; solves with those of estimates
  double in_bonded = 0;                        ///< [-] seconds by those of a bonded step
  double krylov_in_bonded = 0;                 ///< [-]
  double estimate = 0;                         ///< [-] largest of all steps
  std::string outcome;                         ///< "done" or "not converged"
};

class MotionStudy {
 public:
  /// @param folder  exists; motions.csv and motions.json are written there after every scene
  MotionStudy(const std::string& folder, const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream& say);

  /// Runs a scene whose stages of time have fixed time steps bonded, then adaptive; a run ends at the first step that
  /// fails. Collective.
  /// @param peak  acceleration of the ground in that scene [m/s2]
  void add(const std::string& family, double size, double peak, Scene);
  const std::vector<MotionRow>& rows() const { return rows_; }

 private:
  void run(const Scene&, const PlaneModel&, MotionRow&) const;
  void say(const MotionRow&) const;
  void write() const;

  std::string folder_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  std::ostream& say_;
  std::vector<MotionRow> rows_;
};

}  // namespace voussoir
