// What a run leaves behind while it goes: fields.h5, history.csv, and the sums of result.json.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "dynamics/energy_book.hpp"
#include "output/fields_file.hpp"
#include "output/history.hpp"
#include "output/result_json.hpp"
#include "simulation/dynamic_step.hpp"

namespace voussoir {

/// How many selected points are open, stick and slip.
struct StatusCount {
  long long selected = 0, open = 0, stick = 0, slip = 0;
};

template <int dim>
class Recorder {
 public:
  /// Writes mesh and joints to folder/fields.h5, unless the scene wants no fields. Collective, like all its functions.
  Recorder(const Model<dim>&, const AdaptiveStep<dim>&, const std::string& folder);

  /// Books and writes a step that was solved.
  /// @param before, load_before  state and nodal loads at its start
  void record(const ContactState& before, const std::vector<double>& load_before, const ContactState& after,
              const std::vector<double>& load, const StepReport&, const std::string& stage, double load_factor,
              bool write_fields, double seconds);
  /// Strain that stresses do not see from the next step on, such as by heat [-, per local block; empty for none].
  void set_free_strain(std::vector<double> strain) { free_strain_ = std::move(strain); }
  /// Books and writes a time step that was solved.
  /// @param stage_share  of the stage reached;  @param time [s]
  void record(const ContactState& before, const ContactState& after, const TimeStepReport&, const std::string& stage,
              double stage_share, double time, bool write_fields, double seconds);
  /// Books the energy of the velocities that a structure is given. [J]
  void give(double kinetic) { energy_.give(kinetic); }
  /// Writes the motion a collapse begins with as a last step.
  void record_mechanism(const std::vector<double>& mechanism, const ContactState&, const std::string& stage,
                        double load_factor);

  const RunSummary& summary() const { return summary_; }
  RunSummary& summary() { return summary_; }
  const StatusCount& status() const { return count_; }

 private:
  void write_tables();
  std::vector<int> statuses(const ContactState&, const PointField& gap, const PointField& slip_before) const;
  void write_step(const ContactState&, const std::vector<double>& displacement, const std::vector<int>& status,
                  const std::string& stage, double load_factor, std::optional<double> time);
  void finish(const ContactState& before, const ContactState& after, const StepReport&, const std::string& stage,
              double load_factor, std::optional<double> time, bool write_fields, double seconds);
  void book(const ContactState& before, const std::vector<double>& load_before, const ContactState& after,
            const std::vector<double>& load);

  const Model<dim>& model_;
  const AdaptiveStep<dim>& step_;
  std::unique_ptr<FieldsFile> fields_;
  std::unique_ptr<History> history_;
  EnergyBook energy_;
  RunSummary summary_;
  StatusCount count_;
  std::vector<double> free_strain_;
  int written_ = 0;
};

extern template class Recorder<2>;

}  // namespace voussoir
