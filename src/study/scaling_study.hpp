// What the structure costs beside a continuum, as it grows.
//
// The yardstick is the continuum price T_c: one bonded linear solve on the same mesh in the same process, that is the
// stiffness of every block, the matrix of the continuum and its preconditioner, conjugate gradients to 1e-8. Each load
// step is told as a multiple of it. Seconds are those of the processor (of the slowest rank), which other programs on
// the machine disturb less than those of the clock; with several ranks they hold the time ranks wait for each other.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "base/step_numbers.hpp"
#include "linalg/system_cost.hpp"
#include "linalg/traffic.hpp"
#include "mesh/partition_quality.hpp"
#include "model/plane/plane_model.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// One bonded linear solve.
struct ContinuumPrice {
  double stiffness_seconds = 0, setup_seconds = 0, solve_seconds = 0;  ///< of the processor
  int krylov_iterations = 0;
  long long unknowns = 0;
  double seconds() const { return stiffness_seconds + setup_seconds + solve_seconds; }
};

/// Least of three times, one after the other, so that what disturbs one of them does not count. Collective.
/// @param load  nodal forces [N]
ContinuumPrice continuum_price(const PlaneModel&, const std::vector<double>& load,
                               const std::vector<double>& prescribed);

/// One load step of one run, and what it is worth in bonded solves.
struct ScalingRow : StepNumbers {
  std::string family, mode, stage;
  double size = 0;  ///< courses, voussoirs, or how many times finer the mesh is
  int ranks = 1, step = 0;
  long long blocks = 0, unknowns = 0, candidate_points = 0;
  ContinuumPrice price;
  double seconds = 0;  ///< of the processor, this load step
  int largest_krylov = 0;
  SystemCost cost;
  /// Per unknown, all ranks.
  double stiffness_bytes = 0, matrix_bytes = 0, block_bytes = 0, motion_bytes = 0, whole_bytes = 0;
  double peak_memory_MB = 0;  ///< of the process so far, largest rank
  PartitionQuality partition;
  double points_imbalance = 1;    ///< [-] selected points of a rank, largest over mean
  Traffic per_solve, per_krylov;  ///< busiest rank: linear solves with their set-up; Krylov iterations alone
  std::string outcome;            ///< "equilibrium", "collapse" or "not converged"

  double in_continua() const { return seconds / price.seconds(); }
  double krylov_in_continua() const {
    return static_cast<double>(krylov_iterations) / static_cast<double>(price.krylov_iterations);
  }
  double mean_krylov() const {
    return linear_solves > 0 ? static_cast<double>(krylov_iterations) / static_cast<double>(linear_solves) : 0.0;
  }
};

class ScalingStudy {
 public:
  /// @param folder  exists; scaling.csv and scaling.json are written there after every run
  /// @param say     where rank 0 narrates
  ScalingStudy(const std::string& folder, const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream& say);

  /// Runs a scene once in each mode, without halving steps; a run ends at the first step that fails. Collective.
  void add(const std::string& family, double size, Scene, const std::vector<SelectionMode>&);
  const std::vector<ScalingRow>& rows() const { return rows_; }

 private:
  void run(const Scene&, const PlaneModel&, ScalingRow);
  void say(const ScalingRow&) const;
  void write() const;

  std::string folder_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  std::ostream& say_;
  std::vector<ScalingRow> rows_;
};

/// The wall of a scene with n courses of n blocks.
Scene wall_of(Scene, int courses);
/// The arch of a scene with n voussoirs.
Scene arch_of(Scene, int voussoirs);

}  // namespace voussoir
