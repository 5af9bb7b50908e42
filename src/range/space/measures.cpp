#include "range/space/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "base/text.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

// A stone that has moved by a tenth of half its joint has turned and slipped by a tenth of what takes its force off the
// joint at most: forces are wrong by no more than that.
constexpr double worth_measuring = 0.1;

/// Half the width of the smallest joint [m], of the square that is as large; infinite without joints. Collective.
double smallest_half_joint(const Model& model) {
  const auto& points = model.points();
  std::vector<double> area(points.joints().size(), 0.0);
  for (int k = 0; k < points.owned(); ++k) area[points.points()[k].joint] += points.points()[k].area;
  double half = std::numeric_limits<double>::infinity();
  for (const double a : area)
    if (a > 0) half = std::min(half, std::sqrt(a) / 2);
  return least_over_ranks(*model.structure().comm(), half);
}

double size_of(const double* vector, int components) {
  double sum = 0;
  for (int c = 0; c < components; ++c) sum += vector[c] * vector[c];
  return std::sqrt(sum);
}

RangeFindings look_at_motions(const Model& model, const StepEnd& end, double half_joint) {
  const int n = model.components();
  const auto& comm = *model.structure().comm();
  double moved = 0;
  for (int node = 0; node < model.structure().owned_nodes(); ++node)
    moved = std::max(moved, size_of(&end.state.displacement[static_cast<std::size_t>(node) * n], n));
  moved = largest_over_ranks(comm, moved);
  if (!(moved > worth_measuring * half_joint)) return {};
  const auto gap = model.gaps(end.state.displacement, end.state.lambda);
  double slip = 0;
  for (int k = 0; k < model.points().owned(); ++k) {
    const std::size_t at = static_cast<std::size_t>(k) * n;
    if (end.state.lambda[at] > 0) slip = std::max(slip, size_of(&gap[at + 1], n - 1));
  }
  slip = largest_over_ranks(comm, slip);
  RangeFindings found;
  found.warnings.push_back(
      {"not_measured_in_space", "structure", end.when, moved,
       "stones have moved by up to " + three_digits(moved) + " m, joints that press have slipped by up to " +
           three_digits(slip) + " m, and the smallest joint is " + three_digits(2 * half_joint) +
           " m wide: whether forces have passed the edges of faces, stones have turned so far that they topple, or lie "
           "in each other is not measured in space; look at the motion before you rely on the result"});
  return found;
}

}  // namespace

std::vector<RangeMeasure> measures_in_space(const Model& model) {
  const auto half = std::make_shared<std::optional<double>>();
  return {[&model, half](const StepEnd& end) {
    if (!*half) *half = smallest_half_joint(model);
    return look_at_motions(model, end, **half);
  }};
}

}  // namespace voussoir
