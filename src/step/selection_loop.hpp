// Which points a step resolves as contact: equilibrium with those selected so far, the error of leaving the others
// tied, release of those that matter, until the error is small enough.
//
//   look      equilibrium with the selection; where there is none, all points are resolved before giving up
//   estimate  the error of ties, from what each violates where that decides, else by a linear solve
//   release   the points that matter; without an end where the error tells that there are none
//   finish    the equilibrium is accurate, and no stone hangs on ties alone
//
// Rounds that may be thrown away are solved roughly. Reasons and numbers: src/selection/README.md.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "model/contact_problem.hpp"
#include "model/model.hpp"
#include "model/progress.hpp"
#include "model/step.hpp"
#include "nonlinear/contact_solver.hpp"
#include "ties/error_estimate.hpp"
#include "ties/tie_balance.hpp"

namespace voussoir {

/// K u - f of each block alone [N]: what joints and supports bear.
std::vector<double> borne_by_joints(const BlockSystem&, const std::vector<double>& displacement,
                                    const std::vector<double>& load);

/// What the steps of a model share.
class SelectionTools {
 public:
  explicit SelectionTools(const Model& model) : model_(model), solver_(model.settings().solver), ties_(model) {}

  const Model& model() const { return model_; }
  TieCriterion& ties() { return ties_; }
  ContactProblem::Parts parts();
  /// The problem of a selection: that of the last one where it is the same, and stones stand where they stood.
  /// Collective.
  ContactProblem& problem(const std::vector<char>& selected, const ContactProblem::Asked&);
  /// Makes room.
  void forget_problem() { problem_.reset(); }

 private:
  const Model& model_;
  LinearSolver solver_;
  TieCriterion ties_;
  std::unique_ptr<ContactProblem> problem_;
  int arrangement_ = 0;  ///< of the stones, when it was made
};

class SelectionLoop {
 public:
  /// @param state  where the step starts; moved by the loop
  SelectionLoop(SelectionTools&, ContactState& state, const StepInput&, Progress&);

  /// Collective.
  StepReport run();
  /// Motion of the last solution that was none, on node copies, largest component 1; empty when there was none.
  const std::vector<double>& mechanism() const { return mechanism_; }

 private:
  static constexpr double unknown = std::numeric_limits<double>::infinity();

  /// What one round hands to the next.
  struct NextRound {
    double wanted = 0;          ///< [-] accuracy of its solution
    bool suffices = false;      ///< what it releases will matter little: a rough solution is made accurate at once
    bool from_before = true;    ///< it starts from the state before the step
    double root = unknown;      ///< of the decreases that releases would bring, in the round before
    double estimate = unknown;  ///< of the error, likewise; unknown where none was needed
  };
  /// What is seen of the ties of a solution.
  struct TiesSeen {
    std::vector<int> cluster;   ///< per local node copy; a point is tied when its nodes have the same cluster
    std::vector<double> borne;  ///< [N] by joints and supports
    TiedViolations violations;
    std::vector<double> decrease;  ///< [J] per owned point that releasing it would bring
    double root = 0;               ///< [-] of their sum, relative to the energy
    bool large = false;            ///< the root alone tells that the error is too large
  };

  const SofteningPoints* softening() const { return softening_ ? &*softening_ : nullptr; }
  Damage damage_at_start() const;
  Damage damage_before_round() const;
  void keep_damage(const ContactProblem&);
  void begin_with_all();
  bool look();
  bool find_equilibrium(const PointField* known_gap);
  void keep_if_hard(ContactProblem&, const TpetraVector& x, const NewtonReport&);
  void recover_ties();
  bool resolve_all();
  void find_violations();
  void estimate();
  void solve_for_error();
  bool too_rough();
  bool release();
  bool release_what_matters();
  bool finish();
  long long release_loose();

  bool in_time() const { return input_.in_time != nullptr; }
  bool all_selected() const { return selected() == model_.points().total(); }
  long long selected() const;
  bool looks_first() const;
  bool may_release() const;
  bool releases_rest() const;
  double energy() const;
  double root_of(const std::vector<double>& decrease) const;
  double root_of_rest() const;
  NewtonParameters way_of_solving() const;

  SelectionTools& tools_;
  const Model& model_;
  const SelectionParameters& selection_;
  const StepParameters& numbers_;
  const StepInput& input_;
  Progress& progress_;
  const PointLaws law_;               ///< with the strength that is left
  const double tolerance_, allowed_;  ///< [-] of equilibria; error of ties
  const ContactState before_;
  const long long selected_before_;
  const PointField known_gap_;                      ///< [m] before
  const std::optional<SofteningPoints> softening_;  ///< none where no joint can lose strength
  Damage damage_;                                   ///< that joints have by the last solution of this step
  StrengthIs strength_ = StrengthIs::held;          ///< of the last solve: once it has fallen it is held no more
  ContactState& state_;
  std::vector<double> displacement_;  ///< [m] and forces [N] of the last solution of this step
  PointField lambda_;
  NextRound next_;
  TiesSeen ties_seen_;
  StepReport report_;
  std::vector<double> mechanism_;
  /// What the solver came to with one selection, where somebody keeps what is hard.
  struct Hardness {
    long long selected = -1;
    bool hard = false;
    int solves = 0;
  } hardness_;
};

}  // namespace voussoir
