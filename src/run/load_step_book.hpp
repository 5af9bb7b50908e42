// What one load step adds to the energy book.
//
// Along the way of a step, which nobody knows, the law of contact says that normal forces do no work and that friction
// takes force times slip. The force is that of the end of the step, as the return mapping of the solver has it
// (joints/friction_work.hpp). Loads and reactions do the work of their mean, which is exact where stones only deform.
// Where a point slips the mean is wrong: its force goes to its bound first, and only there it slips, so the mean of the
// bounds at start and end stands in its place. A stone that is pushed to and fro costs force times way, however long
// a step is, and a load that grows from nothing costs half of what friction at its end would.
//
// What is left is the imbalance: slips under a pressure that changes within the step (the bound at its end less the
// mean of bounds), pressure of joints that open or close within it, and turns of stones so far that the mean of two
// reactions is not the one between. It tells how far work and loss may be off, and goes with the size of the steps.
#pragma once

#include "dynamics/energy_book.hpp"
#include "step/adaptive_step.hpp"

namespace voussoir {

/// Opened before a load step is solved, where stones stand at its start; closed after it.
template <int dim>
class LoadStepBook {
 public:
  /// @param before, load_before  state and nodal loads [N] at the start; both must outlive the book
  LoadStepBook(const Model<dim>&, const AdaptiveStep<dim>&, const ContactState& before,
               const std::vector<double>& load_before);

  /// Collective.
  /// @param after, load  state and nodal loads [N] at the end, where stones stand now
  EnergyOfStep close(const ContactState& after, const std::vector<double>& load) const;
  const ContactState& before() const { return before_; }

 private:
  struct OfPoints {
    double friction = 0, fracture = 0;
    double held = 0;     ///< that open joints would give back
    double to_work = 0;  ///< that the mean of forces leaves out of the work of loads and reactions
  };
  OfPoints of_points(const ContactState& after) const;
  void add_fracture(const ContactState& after, const PointField& gap, int k, OfPoints&) const;

  const Model<dim>& model_;
  const AdaptiveStep<dim>& step_;
  const ContactState& before_;
  const std::vector<double>& load_before_;
  std::vector<double> reaction_before_;  ///< [N]
  PointField gap_before_;                ///< [m] of stones, gap and slip along the axes of the start
};

extern template class LoadStepBook<2>;

}  // namespace voussoir
