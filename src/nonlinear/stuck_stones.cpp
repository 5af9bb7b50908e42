#include "nonlinear/stuck_stones.hpp"

#include <utility>

#include "linalg/reduce.hpp"
#include "linalg/sparse_lu.hpp"
#include "nonlinear/patch.hpp"

namespace voussoir {
namespace {

/// What became of the patches of all ranks.
struct Round {
  int solves = 0;
  bool at_rest = true;  ///< every patch came to rest
};

/// Solves the patches there are.
Round solve_round(PatchSource& source, const Teuchos::Comm<int>& comm, TpetraVector& x, PointField& lambda,
                  const PatchRequest& request, const MethodParameters& methods) {
  Round round;
  NewtonReport report;
  std::vector<SolvedPatch> solved;
  int failed = 0;
  for (auto& cut : source.cut(x, lambda, request)) {
    if (cut.parts.points.empty()) continue;
    const bool too_large = cut.parts.imbalance.size() > SparseLu::most_rows;
    Patch patch(std::move(cut.parts), methods);
    if (too_large || !patch.solve(request.tolerance, report))
      ++failed;
    else if (patch.passed_on() <= request.most)
      solved.push_back({cut.number, patch.displacement(), patch.solved_points(), patch.solved_border()});
  }
  source.put_back(solved, x, lambda);
  round.solves = total_over_ranks(comm, report.newton_iterations);
  round.at_rest = total_over_ranks(comm, failed) == 0;
  return round;
}

}  // namespace

int bring_to_rest(PatchSource& source, const Teuchos::Comm<int>& comm, TpetraVector& x, PointField& lambda,
                  const PatchRequest& request, const MethodParameters& methods) {
  const auto& numbers = methods.patches;
  if (!source.find_stuck(x, lambda, request.threshold)) return 0;
  int solves = 0;
  if (source.parts_together()) {
    if (source.group(true, numbers.largest_share / 2)) {
      const auto round = solve_round(source, comm, x, lambda, request, methods);
      solves += round.solves;
      if (round.at_rest) return solves;
    }
    source.part_no_more_together();
  }
  if (source.group(false, numbers.largest_share))
    solves += solve_round(source, comm, x, lambda, request, methods).solves;
  return solves;
}

}  // namespace voussoir
