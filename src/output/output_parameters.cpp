#include "output/output_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void OutputParameters::declare(ParameterSection& section) {
  section.add("fields", fields, "write fields.h5 and fields.xdmf");
  section.add("every", every, "-", between(1, 1e9), "write fields every so many load steps, and after the last one",
              "a step in between cannot be written");
  section.add("checkpoint every", checkpoint_every, "-", between(0, 1e9),
              "save the state every so many steps, to go on from it with --restart; 0 = by time alone",
              "a step in between cannot be saved");
  section.add("checkpoint seconds", checkpoint_seconds, "s", at_least(0),
              "save the state after a step when so much time has passed since the last one; 0 = by steps alone",
              "time does not run backwards");
  section.add("checkpoint at end", checkpoint_at_end,
              "keep the state in which the run ends, for further stages (--restart) and variants (--restart-from)");
  section.add("report", report, "draw report.html");
}

}  // namespace voussoir
