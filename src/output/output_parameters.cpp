#include "output/output_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void OutputParameters::declare(ParameterSection& section) {
  section.add("fields", fields, "write fields.h5 and fields.xdmf");
  section.add("every", every, "-", between(1, 1e9), "write fields every so many load steps, and after the last one",
              "a step in between cannot be written");
  section.add("report", report, "draw report.html");
}

}  // namespace voussoir
