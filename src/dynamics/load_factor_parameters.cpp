#include "dynamics/load_factor_parameters.hpp"

#include "base/parameter_section.hpp"
#include "base/text.hpp"

namespace voussoir {

void LoadFactorParameters::declare(ParameterSection& section) {
  section.add_numbers("pattern", pattern, "-", any_number(),
                      "loads that are raised after the last stage: a load has its factor there, plus the load factor "
                      "times its share here; none = no load factor is sought");
  for (const auto& [load, share] : pattern)
    section.check(share != 0, "pattern > " + load, number_text(share), "must not be 0 (nothing would be raised)",
                  "Give 1, or leave the load out.");
  section.add("first factor", first, "-", above(0.0),
              "load factor tried first; doubled while the structure stands, each from the last equilibrium",
              "an attempt must raise something",
              "Small attempts follow the way of the loads more closely; they are cheap where the structure stands.");
  section.add("largest factor", largest, "-", above(0.0), "no larger load factor is tried",
              "a search must end somewhere");
  section.check(first <= largest, "largest factor", number_text(largest),
                "must be >= first factor = " + number_text(first), "Give a larger one, or a smaller first factor.");
  section.add("accuracy", accuracy, "-", between(1e-5, 0.5),
              "distance between a load factor that stands and one that collapses, relative to the latter",
              "below 1e-5 the tolerance of the solver decides, above 0.5 nothing is known");
}

}  // namespace voussoir
