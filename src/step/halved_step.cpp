#include "step/halved_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"

namespace voussoir {
namespace {

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  return largest;
}

/// Whether one list is a multiple of the other, up to the round-off of a sum of loads.
bool is_multiple(const Teuchos::Comm<int>& comm, const std::vector<double>& one, double factor,
                 const std::vector<double>& other) {
  constexpr double round_off = 64 * std::numeric_limits<double>::epsilon();
  double off = 0;
  for (std::size_t i = 0; i < one.size(); ++i) off = std::max(off, std::abs(one[i] - factor * other[i]));
  return largest_over_ranks(comm, off) <= round_off * largest_over_ranks(comm, largest_of(other));
}

/// Multiples of a solution from rest are solutions, as long as stones stand where they stood.
bool is_homogeneous(const Model& model, const ContactState& before, bool at_the_start) {
  const bool opens = largest_of(model.initial_gap()) > 0;
  const double moved = std::max(largest_of(before.displacement), largest_of(before.lambda));
  const bool mine = opens || model.weakens() || moved > 0;
  return !any_of_ranks(*model.structure().comm(), mine) && at_the_start;
}

}  // namespace

bool half_asks_the_same(const Model& model, const Construction& construction, const LoadSteps& steps,
                        const ContactState& before, const std::vector<double>& load,
                        const std::vector<double>& prescribed, bool at_the_start) {
  VOUSSOIR_EXPECT(!steps.finished() && "a step of a stage has failed");
  VOUSSOIR_EXPECT(is_of_nodes(model, load) && is_of_nodes(model, prescribed) && "load and supports: of node copies");
  LoadSteps half = steps;
  if (!half.halve()) return false;
  std::vector<double> half_load, half_prescribed;
  model.loads(half.factors(), half.time(), half_load, half_prescribed);
  construction.restrict(before, half_load, half_prescribed);
  const auto& comm = *model.structure().comm();
  const auto alike = [&](double factor) {
    return is_multiple(comm, half_load, factor, load) && is_multiple(comm, half_prescribed, factor, prescribed);
  };
  return alike(1.0) || (is_homogeneous(model, before, at_the_start) && alike(half.target() / steps.target()));
}

}  // namespace voussoir
