// Does a step that was solved stay within what the model can tell?
//
// Points pair what was drawn together, turns are small ones but in load steps with finite rotations, and stones that
// were drawn apart know nothing of each other. Measures (range/plane/measures, range/space/measures) tell when that is
// no longer so: slips beyond a cell, turns that move forces off the joints that bear them, stones that lie in each
// other. README.md of this folder, "The range of the model", gives the numbers that decide and their reasons.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/warning.hpp"
#include "model/contact_state.hpp"
#include "model/model.hpp"
#include "model/step_in_time.hpp"

namespace voussoir {

/// What is looked at: a state at the end of a step.
struct StepEnd {
  const ContactState& state;
  const std::vector<double>& load;  ///< [N] on node copies
  const std::vector<char>& absent;  ///< per local block; empty when all are there
  std::string when;                 ///< stage and load factor or time, for the reader
  StepInTime loads{};               ///< the loads by name; of a load step from its time to the same
  bool in_time = false;
  bool outlines = true;  ///< whether outlines of stones are compared too
};

/// Whether stones have been followed to where they have turned to, so that a turn is no small one.
inline bool is_followed(const Model& model, const StepEnd& end) {
  return !end.in_time && model.settings().rotations == Rotations::finite;
}

/// What a step leaves open; the same on every rank.
struct RangeFindings {
  Warnings warnings;         ///< no more than one of a kind: the worst place, and in how many others
  std::string out_of_range;  ///< why it would be a mistake to carry on; empty when it is none

  void add(const RangeFindings& more) {
    warnings.insert(warnings.end(), more.warnings.begin(), more.warnings.end());
    if (out_of_range.empty()) out_of_range = more.out_of_range;
  }
};

/// When a step ends, for the reader: "stage 'shaking', 0.654 s", "stage 'push', load factor 0.25".
std::string at_time(const std::string& stage, double seconds);
std::string at_factor(const std::string& stage, double);

/// Looks at a step in one respect. Collective.
using RangeMeasure = std::function<RangeFindings(const StepEnd&)>;

/// Looks at every step.
class RangeCheck {
 public:
  /// @param measures  of the model, in the order in which they are told
  /// @param warn      where warnings go
  RangeCheck(const Model& model, std::vector<RangeMeasure> measures, std::function<void(const Warning&)> warn)
      : model_(model), measures_(std::move(measures)), warn_(std::move(warn)) {}

  /// Warns of what a step leaves open; why it would be a mistake to carry on, empty when it is none. Collective.
  std::string beyond(const StepEnd&);

 private:
  const Model& model_;
  std::vector<RangeMeasure> measures_;
  std::function<void(const Warning&)> warn_;
};

}  // namespace voussoir
