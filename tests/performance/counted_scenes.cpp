#include "performance/counted_scenes.hpp"

#include <Tpetra_Core.hpp>

#include "performance/count_table.hpp"

namespace voussoir::test {

bool TwoSteps::as_in_table(const std::string& row) const {
  const StepReport step = last();
  return test::as_in_table(
      row, {step.newton.newton_iterations, step.newton.krylov_iterations, step.cost.whole, step.newton.local_solves},
      out_);
}

bool whole_run(const std::string& row, const Scene& scene, Teuchos::FancyOStream& out, RunSummary& summary) {
  RunOptions options;
  options.folder = row;
  options.overwrite = true;
  Teuchos::oblackholestream nowhere;
  summary = run(scene, options, Tpetra::getDefaultComm(), nowhere);
  const bool as_told = as_in_table(
      row, {summary.linear_solves, summary.krylov_iterations, summary.factorised_whole, summary.patch_solves}, out);
  return as_told && summary.outcome == Outcome::equilibrium;
}

}  // namespace voussoir::test
