// One time step of the implicit midpoint rule with contact (dynamics/midpoint_rule.hpp): the load step of another
// structure, whose blocks have the matrix S and whose displacement is w, half that of the step.
//
//   closing   0 <= lambda _|_ g_n+1 >= 0, with g_n+1 = 2 (g(w) + g_n/2)       open at t_n
//             0 <= lambda _|_ g_n+1 - g_n >= 0                                closed at t_n (persistency)
#pragma once

#include <memory>

#include "dynamics/load_steps.hpp"
#include "step/adaptive_step.hpp"
#include "time/velocity_update.hpp"

namespace voussoir {

struct TimeStepReport {
  StepReport step;
  double elastic = 0, kinetic = 0;  ///< [J] at the end
  /// [J] of this step: work of loads and moved supports; losses
  double external_work = 0, friction = 0, fracture = 0, damping = 0;
  double work_within = 0;  ///< [J] of the external work, what is not the force of supports times their way
  double error = 0;        ///< [-] of the time step, relative, energy norm
  /// [N] of supports at held nodes, the mean of the step with what changes velocities at once; else zero to tolerance
  std::vector<double> reaction;
};

/// On anything but convergence the state after is that of the last attempt.
struct TimeStepResult {
  ContactState after;
  TimeStepReport report;
};

class DynamicStep {
 public:
  /// Builds mass matrices; at_rest must outlive it.
  /// @param progress  of its steps
  explicit DynamicStep(const Model& at_rest, std::shared_ptr<Progress> progress = std::make_shared<Progress>());

  /// What happens within its steps.
  const std::shared_ptr<Progress>& progress() const { return progress_; }

  /// Passage of a wave through the smallest cell of the structure [s]. Collective.
  double courant_time() const;
  /// Passage of a wave through the whole structure, in its softest material [s]. Collective.
  double crossing_time() const;
  double total_mass() const { return total_mass_; }  ///< [kg]
  /// Another factor of Rayleigh damping than the scene's [s], before the time step is set.
  void set_stiffness_damping(double beta) { rule_.stiffness_damping = beta; }
  /// Gives a state at rest velocities: those of the scene as time begins, or none where it goes on; joints whose sides
  /// differ in velocity are selected. Returns the kinetic energy given [J]. Collective.
  double begin(ContactState&, bool initial = true);
  /// Builds what depends on the time step, when it changed. Collective.
  void set_time_step(double);

  /// One time step, with the mean of the loads over it and the displacements of held components at its end. Collective.
  TimeStepResult take(const ContactState& before, const StepInput&);

  const std::vector<double>& mechanism() const { return step_->mechanism(); }
  const Model& step_model() const { return *model_; }

 private:
  /// The load step that a time step is, but for its matrix and its gaps.
  struct Midpoint {
    std::vector<double> load;  ///< [N] with inertia and the forces at the start
    std::vector<double> half;  ///< [m] half the way of held components
    double energy = 0;         ///< [J] at the start
  };

  void offset_gaps(const PointField& gap, const PointField& lambda);
  PointField offset_slips(const ContactState& before, const PointField& gap) const;
  Midpoint midpoint(const ContactState& before, const StepInput&) const;
  std::vector<double> displacement_at_end(const ContactState& before, const ContactState& mid) const;
  /// @param slips  that points of the step had at w = 0 [m]
  void wear_to_the_end(const ContactState& before, const PointField& slips, ContactState& mid) const;
  ContactState at_end(const ContactState& before, ContactState mid, const PointField& slips) const;
  bool update_velocities(ContactState&, const std::vector<double>& velocity_before, double closing, TimeStepReport&);
  void move_supports(ContactState&, const std::vector<double>& half, TimeStepReport&) const;
  void bear(const std::vector<double>& impulses, TimeStepReport&) const;
  double book(const ContactState& mid, const ContactState& before, const std::vector<double>& load,
              const std::vector<double>& effective, TimeStepReport&) const;
  VelocityJump bond_what_rests(ContactState&, const PointField& gap, double energy, double resting);
  double resting_speed(const ContactState&, double energy) const;
  double error(ContactState& after, const std::vector<double>& velocity_before, double energy) const;
  double total(double mine) const;

  const Model& at_rest_;
  std::unique_ptr<const BlockSystem> mass_;  ///< matrices [kg]
  VelocityUpdate velocities_;
  MidpointRule rule_;
  std::vector<double> mass_of_node_;  ///< [kg] per local node copy
  double total_mass_ = 0;
  std::shared_ptr<Progress> progress_;
  std::unique_ptr<Model> model_;  ///< of the time step
  std::unique_ptr<AdaptiveStep> step_;
};

/// The next step of a stage with a duration, for its loads.
StepInTime next_in_time(const LoadSteps&);

/// What a time step takes, for the next step of a stage with a duration: the mean of the loads, whose impulse is theirs
/// however long the step is.
void loads_of_time_step(const Model&, const LoadSteps&, std::vector<double>& load, std::vector<double>& prescribed);

/// Selects points that are tied where they have moved: load steps tie places, not increments.
void untie_what_moved(const Model&, ContactState&);

}  // namespace voussoir
