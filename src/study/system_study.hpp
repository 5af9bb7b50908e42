// How many iterations one block-level system takes, and what ranks send each other for it.
//
// Every point is selected. Joints are closed and stick with the stiffness of the cells beside them, but for a given
// share of joints that are open; stones may differ in stiffness, and resistances among points. The system under the
// loads of the last stage is solved by conjugate gradients to 1e-8. What is drawn by lot depends on numbers of blocks
// and points alone: the same system on any number of ranks.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "linalg/amg_preconditioner.hpp"
#include "linalg/traffic.hpp"
#include "mesh/partition_quality.hpp"
#include "scene/scene.hpp"
#include "study/processor_clock.hpp"

namespace voussoir {

struct SystemCase {
  std::string family;   ///< what grows from row to row
  double size = 0;      ///< courses, or how many times finer the cells are
  double contrast = 1;  ///< [-] half of the stones, drawn by lot, are so many times as stiff
  double open = 0;      ///< [-] share of joints that are open
  double spread = 1;    ///< [-] resistances of closed points: between 1 / spread and spread times the stiffness
};

struct SystemRow {
  SystemCase given;
  int dimension = 2, ranks = 1;
  long long blocks = 0, unknowns = 0, candidate_points = 0, entries = 0, coarse_unknowns = 0;
  int iterations = 0;
  double residual = 0;       ///< [-] of the solution, relative to the right-hand side
  double setup_seconds = 0;  ///< of the processor, slowest rank
  SecondsOfRanks solve;
  /// Of block motions, on one rank: one factorisation, and one solution.
  double motions_factor_seconds = 0, motions_solve_seconds = 0;
  /// Of levels of block motions, which several ranks may have in their place: one construction, and one cycle.
  double levels_build_seconds = 0, levels_cycle_seconds = 0;
  PartitionQuality partition;
  double points_imbalance = 1;                          ///< [-] selected points
  std::vector<MultigridLevel> levels, motion_levels;    ///< of the continuum, and of block motions where they have some
  std::array<Traffic, traffic_kinds> total, largest;    ///< over ranks, of this solve
  std::array<long long, traffic_kinds> largest_sent{};  ///< [bytes] one message or collective, over ranks
  long long motions_bytes = 0;                          ///< of the rank with most
  double bare_memory_MB = 0;                            ///< of the process before its first system, likewise
  double peak_memory_MB = 0;                            ///< of the process up to the end of the solve, likewise
};

class SystemStudy {
 public:
  /// @param folder  exists; systems.csv and systems.json are written there after every system
  SystemStudy(const std::string& folder, const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream& say);

  /// Builds and solves one system. Collective.
  void add(const SystemCase&, Scene);
  const std::vector<SystemRow>& rows() const { return rows_; }

 private:
  template <int dim>
  void add_in(const SystemCase&, Scene&);
  void say(const SystemRow&) const;
  void write() const;

  std::string folder_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  std::ostream& say_;
  double bare_memory_MB_;
  std::vector<SystemRow> rows_;
};

}  // namespace voussoir
