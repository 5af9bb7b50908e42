// history.csv: one row per load step, written as the run goes.
#pragma once

#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include "base/energies.hpp"
#include "base/step_numbers.hpp"

namespace voussoir {

/// What a step found and what it cost; numbers are those of the whole structure, counts those of this step alone.
struct HistoryRow : StepNumbers {
  int step = 0;
  std::string stage;
  double load_factor = 0.0;                                ///< of the stage, 0..1
  double time = std::numeric_limits<double>::quiet_NaN();  ///< [s] at the end of a time step
  Energies energy;                    ///< [J] stored at the end of the step; all others since the start
  double imbalance = 0.0;             ///< [J] what the energy book cannot explain
  double imbalance_in_time = 0.0;     ///< [J] the part of it that arose in time steps
  double largest_displacement = 0.0;  ///< [m]
  double seconds = 0.0;
  std::vector<double> observed;  ///< a value for each further column
};

class History {
 public:
  /// Makes the file with its heading, and keeps the first `rows` rows of the file that is there: what a run wrote after
  /// its checkpoint is cut off. Collective; rank 0 writes. Throws ResourceError on all ranks.
  /// @param further  names of columns behind those that every history has; kept rows keep what they have of them
  History(std::string path, Teuchos::RCP<const Teuchos::Comm<int>> comm, int rows = 0,
          const std::vector<std::string>& further = {});
  /// On return the row is in the file. Collective; the row of rank 0 counts.
  void append(const HistoryRow&);

  /// First line of the file: the names of the columns, with units.
  static std::string heading(const std::vector<std::string>& further = {});

 private:
  void put(const std::string& line);

  std::string path_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  std::ofstream file_;
};

}  // namespace voussoir
