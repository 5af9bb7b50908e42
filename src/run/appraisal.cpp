#include "run/appraisal.hpp"

#include "model/handed_over.hpp"
#include "results/largest_mover.hpp"
#include "results/support_reactions.hpp"

namespace voussoir {

std::string Appraisal::words_of(const std::vector<double>& mechanism, bool) const {
  return largest_mover(model_, mechanism).name + " moves most";
}

StaticsSummary Appraisal::statics(const AdaptiveStep& step, const ContactState& state, const std::vector<double>& load,
                                  const std::string&) const {
  expect_state(model_, state);
  StaticsSummary sum;
  sum.components = model_.components();
  sum.reactions = support_reactions(model_, step.residual(state, load));
  return sum;
}

}  // namespace voussoir
