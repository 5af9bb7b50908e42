// The checkpoint of a run: all it needs to go on from between two steps as if it had never stopped.
//
// Everything is stored by number of block, node and contact point, which do not depend on ranks. On the same number of
// ranks the continued run is equal to the last bit, on another number to the tolerance of the solver.
#pragma once

#include <Teuchos_Time.hpp>
#include <map>
#include <string>
#include <vector>

#include "dynamics/load_steps.hpp"
#include "dynamics/step_control.hpp"
#include "model/model.hpp"
#include "results/recorder.hpp"
#include "run/load_factor_analysis.hpp"
#include "scene/scene_values.hpp"

namespace voussoir {

class Checkpoint;

/// Where a run stands between two steps.
struct RunState {
  LoadSteps& steps;
  ContactState& state;
  std::vector<double>& load;  ///< [N] nodal loads at the end of the last step
  TimeStepLevel& time_step;
  Record& record;
  std::map<std::string, double>& seconds;     ///< by phase, of all earlier parts of the run
  LoadFactorAnalysis* load_factor = nullptr;  ///< where the scene asks for one
};

/// Where a run that was taken up goes on, and what of its scene has changed, in lines.
std::string words_of(const RunState&, const std::vector<std::string>& changed);

class SavedRun {
 public:
  /// Collective.
  /// @param folder  where it is saved
  /// @param from    where it is taken up from, when that is another folder
  SavedRun(const Scene&, const Model&, const std::string& folder, const std::string& from = "");

  /// Saves, whatever the time. Collective.
  void save(const RunState&);
  /// Saves when the scene asks for it after this step. Collective.
  void save_when_due(const RunState&);
  /// Takes a run up again. One that had come to its end goes on with the stages that follow. Collective; throws
  /// InputError when the checkpoint is of another structure or of another past (scene_changes.hpp).
  /// @return what of the scene has changed since it was saved and may
  std::vector<std::string> restore(const RunState&) const;
  /// The run has come to its end, and nobody wants to go on from there.
  void remove() const;

 private:
  void write(Checkpoint&, const RunState&) const;
  std::vector<std::string> read(Checkpoint&, const RunState&) const;

  const Scene& scene_;
  const Model& model_;
  std::string path_, source_;
  SceneValues values_;  ///< of the scene, with the content of the files its loads have read
  Teuchos::Time clock_{"since the last checkpoint", true};
  int steps_since_ = 0;
};

}  // namespace voussoir
