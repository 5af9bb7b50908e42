#include "selection/rest_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void RestParameters::declare(ParameterSection& section) {
  section.add("longest wait", longest_wait, "-", at_least(1.0),
              "times the patience that a point which never stays bonded waits at most. Reason: each release costs a "
              "round");
  section.add("trusted after", trusted_after, "-", above(0.0),
              std::string("times the steps it had to rest after which a bonded point is trusted as at "
                          "first. ") +
                  no_reason);
  section.add("growth", growth, "-", above(0.0),
              std::string("growth of the indicator beyond which a computed error says nothing of it. ") + no_reason);
  section.add("margin", margin, "-", above(0.0),
              std::string("times the computed ratio that the error may be at most. ") + no_reason);
  section.add("distrust", distrust, "-", above(0.0),
              std::string("times the way of the indicator that is added to it. ") + no_reason);
  section.add("octaves", octaves, "-", between(1, 1000),
              "below the largest decrease in which the cut of bulk marking lies. Reason: 2^-60 is round-off");
  section.add("bisections", bisections, "-", between(1, 1000),
              "of these to find the cut. Reason: 60 2^-40 octaves is round-off");
}

}  // namespace voussoir
