// What a run leaves behind while it goes: fields.h5, history.csv, and the sums of result.json.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

#include "dynamics/energy_book.hpp"
#include "model/model.hpp"
#include "model/step_counts.hpp"
#include "output/fields_file.hpp"
#include "output/history.hpp"
#include "output/result_json.hpp"
#include "results/load_step_book.hpp"
#include "results/observations.hpp"
#include "time/dynamic_step.hpp"

namespace voussoir {

/// What has been recorded so far: all that a checkpoint must keep of a recorder.
struct Record {
  EnergyBook energy;
  RunSummary summary;
  StepNumbers in_vain;  ///< work of attempts since the last step that stands, which takes them on
  int written = 0;      ///< steps in fields.h5

  template <class Archive>
  void keep(Archive& archive);
};

class Recorder {
 public:
  /// Writes mesh and joints to folder/fields.h5, unless the scene wants no fields. Collective, like all its functions.
  /// @param so_far  of an earlier run to go on with: its files are cut behind the steps recorded here
  Recorder(const Scene&, const Model&, const AdaptiveStep&, const std::string& folder, const Record& so_far = {});

  /// Books and writes a load step that was solved.
  /// @param book  opened before it was;  @param after, load  state and nodal loads [N] at its end
  void record(const LoadStepBook& book, const ContactState& after, const std::vector<double>& load, const StepReport&,
              const std::string& stage, double load_factor, bool write_fields, double seconds);
  /// What acts from the next step on: factors of loads by name, at a time.
  void set_loads(std::map<std::string, double> factors, double time) {
    factors_ = std::move(factors);
    time_of_loads_ = time;
  }
  /// Books and writes a time step that was solved.
  /// @param stage_share  of the stage reached;  @param time [s]
  void record(const ContactState& after, const TimeStepReport&, const std::string& stage, double stage_share,
              double time, bool write_fields, double seconds);
  /// Books the energy of the velocities that a structure is given. [J]
  void give(double kinetic) { record_.energy.give(kinetic); }
  /// Counts what an attempt took that does not stand, to the next step that does, or to the end of the run.
  void spend(const StepNumbers& work) { record_.in_vain.add_work(work); }
  void spend(const StepReport& report) { spend(numbers_of(report)); }
  /// The sums of the run with attempts that no step has followed.
  RunSummary result() const;
  /// Books what stones that are taken away take along. [J]
  void remove(double energy, double inner) { record_.energy.remove(energy, inner); }
  /// Writes forces that balance loads, of stones that do not move, as a step.
  void record_forces(const PointField& force, const std::string& stage, double load_factor);
  /// Writes the motion a collapse begins with as a last step. Its points open, slip or stick as the motion has them.
  void record_mechanism(const std::vector<double>& mechanism, const ContactState&, const std::string& stage,
                        double load_factor);

  /// Adds a warning to those of the run, and tells whether nobody has been told yet. The same on all ranks.
  bool warn(const Warning& w) { return add_warning(record_.summary.warnings, w); }

  const RunSummary& summary() const { return record_.summary; }
  RunSummary& summary() { return record_.summary; }
  Record& so_far() { return record_; }
  /// Whether fields of an earlier run could not be read, so that fields.h5 begins anew.
  bool fields_lost() const { return fields_lost_; }

 private:
  void write_tables();
  std::vector<int> statuses_of_motion(const PointField& opening) const;
  std::vector<double> stresses(const std::vector<double>& deformation) const;
  /// @param deformation  what of the displacement strains the stones
  void write_step(const ContactState&, const std::vector<double>& displacement, const std::vector<double>& deformation,
                  const std::vector<int>& status, const std::string& stage, double load_factor,
                  std::optional<double> time);
  void count(const std::vector<int>& status, StepNumbers&) const;
  double largest_displacement(const std::vector<double>& displacement) const;
  void add_to_sums(const StepNumbers&, double load_factor, double largest_displacement);
  void finish(const ContactState& after, const StepReport&, const std::string& stage, double load_factor,
              std::optional<double> time, const std::vector<double>& reaction, bool write_fields, double seconds);

  const Model& model_;
  const AdaptiveStep& step_;
  Observations observations_;
  std::unique_ptr<FieldsFile> fields_;
  std::unique_ptr<History> history_;
  std::map<std::string, double> factors_;
  double time_of_loads_ = 0;
  Record record_;
  bool fields_lost_ = false;
};

template <class Archive>
void Record::keep(Archive& archive) {
  constexpr double most_steps = 2e9, largest_count = 1e15;  // numbers that can be added to
  energy.keep(archive);
  each_number(
      [&](const char* member, const std::string&, OverSteps over, auto& value) {
        if (over == OverSteps::sum) archive.within(std::string("in_vain.") + member, value, 0, largest_count);
      },
      in_vain);
  archive.within("steps", summary.steps, 0, most_steps);
  archive.value("time_s", summary.time);
  each_number(
      [&](const char*, std::string name, OverSteps, auto& value) {
        std::replace(name.begin(), name.end(), '.', '_');
        if constexpr (std::is_integral_v<std::decay_t<decltype(value)>>)
          archive.within(name, value, 0, largest_count);
        else
          archive.value(name, value);
      },
      summary);
  archive.value("largest_displacement_m", summary.largest_displacement);
  archive.value("largest_displacement_time_s", summary.largest_displacement_time);
  archive.value("residual_displacement_m", summary.residual_displacement);
  archive.value("load_factor", summary.load_factor);
  archive.within("fields_written", written, 0, most_steps);
  constexpr double most_warnings = 1000;
  auto warnings = static_cast<long long>(summary.warnings.size());
  archive.within("warnings", warnings, 0, most_warnings);
  summary.warnings.resize(static_cast<std::size_t>(warnings));
  for (std::size_t k = 0; k < summary.warnings.size(); ++k) {
    const std::string name = "warning." + std::to_string(k);
    auto& w = summary.warnings[k];
    archive.value(name + ".what", w.what);
    archive.value(name + ".where", w.where);
    archive.value(name + ".when", w.when);
    archive.value(name + ".how_much", w.how_much);
    archive.value(name + ".text", w.text);
  }
  summary.energy = {energy.sums(), energy.imbalance(), energy.imbalance_in_time()};
}

}  // namespace voussoir
