// What steps take and find, in numbers of the whole structure: the one list of them. history.csv, result.json,
// checkpoints and the sums of a run follow from it. A further number is one line here, and the one that counts it
// (model/step_counts.hpp).
#pragma once

#include <algorithm>
#include <string>

namespace voussoir {

/// How the number of a run follows from those of its steps.
enum class OverSteps {
  last,    ///< as the last step leaves it
  sum,     ///< work, also that of attempts which failed, were halved or were tried in vain
  largest  ///< of all steps
};

// type, member, name in files with its unit, over steps. A name with a dot stands in an object of result.json, and has
// no column in history.csv.
#define VOUSSOIR_STEP_NUMBERS(number)                                                                              \
  number(long long, selected_points, "selected_points", last) /* points by status, at the end of the step */       \
      number(long long, open_points, "open_points", last) number(long long, stick_points, "stick_points", last)    \
          number(long long, slip_points, "slip_points", last)                                                      \
              number(long long, selection_rounds, "selection_rounds", sum)                                         \
                  number(long long, newton_iterations, "newton_iterations", sum)                                   \
                      number(long long, linear_solves, "linear_solves", sum) /* with those of error estimates */   \
      number(long long, failed_linear_solves, "failed_linear_solves", sum)   /* short of the accuracy asked for */ \
      number(long long, krylov_iterations, "krylov_iterations", sum)                                               \
          number(long long, patch_solves, "patch_solves", sum)         /* systems of patches of blocks */          \
      number(long long, factorised, "factorisations.made", sum)        /* preconditioners, for a linear solve */   \
      number(long long, factorised_whole, "factorisations.whole", sum) /* systems that were factored whole */      \
      number(long long, levels_built, "factorisations.levels", sum)    /* of block motions, in place of factors */ \
      number(long long, levels_refused, "factorisations.levels_refused", sum)       /* which did not converge */   \
      number(long long, factors_reused, "factorisations.reused", sum)               /* factors used again */       \
      number(double, complementarity_residual, "complementarity_residual", largest) /* [-] */                      \
      number(double, largest_penetration, "largest_penetration_m", largest)                                        \
          number(double, error_estimate, "error_estimate", largest) /* [-] relative, energy norm */

struct StepNumbers {
#define VOUSSOIR_MEMBER(type, member, name, over) type member = 0;
  VOUSSOIR_STEP_NUMBERS(VOUSSOIR_MEMBER)
#undef VOUSSOIR_MEMBER

  /// Goes on with a step that stands.
  void add_step(const StepNumbers&);
  /// Goes on with what an attempt took that does not stand: what it found counts for nothing.
  void add_work(const StepNumbers&);
};

/// Calls act(member, name, over, value of each of the numbers) in the order of the list. A member is named as in
/// StepNumbers; numbers are StepNumbers or made of them.
template <class Act, class... Numbers>
void each_number(const Act& act, Numbers&... numbers) {
#define VOUSSOIR_ACT(type, member, name, over) act(#member, std::string(name), OverSteps::over, numbers.member...);
  VOUSSOIR_STEP_NUMBERS(VOUSSOIR_ACT)
#undef VOUSSOIR_ACT
}

inline void StepNumbers::add_step(const StepNumbers& step) {
  each_number(
      [](const char*, const std::string&, OverSteps over, auto& all, const auto& more) {
        all = over == OverSteps::last ? more : over == OverSteps::sum ? all + more : std::max(all, more);
      },
      *this, step);
}

inline void StepNumbers::add_work(const StepNumbers& attempt) {
  each_number(
      [](const char*, const std::string&, OverSteps over, auto& all, const auto& more) {
        if (over == OverSteps::sum) all += more;
      },
      *this, attempt);
}

}  // namespace voussoir
