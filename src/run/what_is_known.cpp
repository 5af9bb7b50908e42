#include "run/what_is_known.hpp"

#include "base/text.hpp"
#include "base/words.hpp"

namespace voussoir {
namespace {

std::string of_stages(const LoadSteps& steps) {
  if (steps.finished()) return "all stages are passed, and no load factor has been tried";
  std::string text = "stage '" + steps.stage() + "' ";
  if (steps.reached() == 0) {
    text += "has no step yet";
    if (steps.passed() > 0) text = "stage '" + steps.stages()[steps.passed() - 1].name + "' is passed, " + text;
  } else {
    text += "is passed to " + three_digits(100 * steps.reached()) + " %";
  }
  return steps.time() > 0 ? text + ", " + six_digits(steps.time()) + " s of motion" : text;
}

}  // namespace

std::string why_stopped(Stop why) {
  return why == Stop::signal ? "stopped by a signal" : "stopped because its time was over";
}

std::string what_is_known(Stop why, const LoadSteps& steps, const LoadFactorAnalysis* search,
                          const RunSummary& summary) {
  const bool factor = search && steps.finished() && !search->known().empty();
  return why_stopped(why) + " after " + counted(summary.steps, "step") + ": " +
         (factor ? search->known() : of_stages(steps));
}

}  // namespace voussoir
