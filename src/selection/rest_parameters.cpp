#include "selection/rest_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void RestParameters::declare(ParameterSection& section) {
  section.add(
      "longest wait", longest_wait, "-", at_least(1.0),
      "times the patience that a point which never stays bonded waits at most, and times the steps it had to rest "
      "after which a bonded point is trusted as at first. Reason: each release costs a round");
  section.add(
      "growth", growth, "-", above(0.0),
      "growth of the indicator beyond which a computed error says nothing of it, and times its way that is added to "
      "it. Reason: with a third of it every step asks for the error anew, with three times of it as many solves");
  section.add("margin", margin, "-", above(0.0),
              std::string("times the computed ratio that the error may be at most. ") + no_reason);
}

}  // namespace voussoir
