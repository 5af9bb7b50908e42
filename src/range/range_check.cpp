#include "range/range_check.hpp"

#include "base/check.hpp"
#include "base/text.hpp"
#include "model/handed_over.hpp"
#include "model/phase.hpp"

namespace voussoir {

std::string at_time(const std::string& stage, double seconds) {
  return "stage '" + stage + "', " + formatted("%.6g s", seconds);
}

std::string at_factor(const std::string& stage, double factor) {
  return "stage '" + stage + "', " + formatted("load factor %.6g", factor);
}

std::string RangeCheck::beyond(const StepEnd& end) {
  expect_state(model_, end.state);
  VOUSSOIR_EXPECT(is_of_nodes(model_, end.load) && "load: of node copies");
  VOUSSOIR_EXPECT(
      (end.absent.empty() || end.absent.size() == static_cast<std::size_t>(model_.structure().local_blocks())) &&
      "absent: per block, or none");
  Phase phase("range");
  RangeFindings found;
  for (const auto& measure : measures_) found.add(measure(end));
  for (const auto& warning : found.warnings) warn_(warning);
  return found.out_of_range;
}

}  // namespace voussoir
