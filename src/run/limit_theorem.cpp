#include "run/limit_theorem.hpp"

namespace voussoir {

std::vector<double> loads_of_pattern(const Model& model, const std::map<std::string, double>& factors,
                                     const std::map<std::string, double>& pattern, double time) {
  auto raised = factors;
  for (const auto& [load, share] : pattern) raised[load] += share;
  std::vector<double> without, with, prescribed;
  model.loads(factors, time, without, prescribed);
  model.loads(raised, time, with, prescribed);
  for (std::size_t k = 0; k < with.size(); ++k) with[k] -= without[k];
  return with;
}

}  // namespace voussoir
