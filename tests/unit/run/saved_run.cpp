// Checkpoints of whole runs that are whole and sealed but do not hold what a run needs: they are refused on all ranks.
#include "run/saved_run.hpp"
#include "linalg/agree.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "output/checkpoint.hpp"
#include "output/hdf5_file.hpp"
#include "output/safe_file.hpp"
#include "support/scenes.hpp"
#include "unit/output/folders.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// A wall under its weight, and what a run keeps of it.
struct Run {
  Experiment experiment{wall_scene(2)};
  LoadSteps steps{experiment.scene().stages, experiment.scene().load_steps};
  std::vector<double> load = std::vector<double>(experiment.state().displacement.size(), 0.0);
  TimeStepLevel level;
  Record record;
  std::map<std::string, double> seconds;

  RunState state() { return {steps, experiment.state(), load, level, record, seconds}; }
  SavedRun saved(const std::string& folder) const { return {experiment.scene(), experiment.model(), folder}; }
};

/// The checkpoint of one folder in another, sealed in all order, without one of its tables.
void copy_without(const std::string& table, const std::vector<std::string>& tables, const std::string& from,
                  const std::string& to) {
  on_first_rank(*world(), [&] {
    std::vector<std::string> kept = {"/run", "/texts"};
    for (const auto& t : tables)
      if (t != table) kept.push_back("/state/" + t);
    std::filesystem::create_directories(to);
    copy_hdf5(from + "/checkpoint.h5", to + "/checkpoint.h5", kept);
    seal_file(to + "/checkpoint.h5");
  });
}

TEUCHOS_UNIT_TEST(SavedRun, WithoutATableThatEveryRunHasIsRefused) {
  const std::string whole = fresh_folder("saved-run"), forged = fresh_folder("saved-run-forged");
  Run run;
  TEST_ASSERT(run.experiment.advance({{"weight", 1.0}}));
  run.saved(whole).save(run.state());
  const std::vector<std::string> tables = {"displacement", "load",   "lambda",        "slip_origin",
                                           "selected",     "status", "points.blocks", "points.places"};
  for (const auto& table : tables) {
    copy_without(table, tables, whole, forged);
    Run other;
    TEST_THROW(other.saved(forged).restore(other.state()), ResourceError);
  }
  copy_without("none", tables, whole, forged);  // the copy itself is no reason
  Run other;
  other.saved(forged).restore(other.state());
  TEST_COMPARE_ARRAYS(other.experiment.state().displacement, run.experiment.state().displacement);
  TEST_COMPARE_ARRAYS(other.experiment.state().lambda, run.experiment.state().lambda);
  TEST_COMPARE_ARRAYS(other.experiment.state().status, run.experiment.state().status);
}

// Words and counts that nothing could have saved so: whoever took them for an index would leave its table.
TEUCHOS_UNIT_TEST(SavedRun, WordsAndCountsOutsideTheirRangeAreRefusedOnAllRanks) {
  const std::string folder = fresh_folder("saved-run-ranges");
  const auto refused = [&](const auto& spoil) {
    Run run, other;
    if (!run.experiment.advance({{"weight", 1.0}})) return false;
    if (world()->getRank() == 0) spoil(run.experiment.state());  // what one rank owns
    run.saved(folder).save(run.state());
    try {
      other.saved(folder).restore(other.state());
    } catch (const ResourceError&) {
      return true;
    }
    return false;
  };
  TEST_ASSERT(!refused([](ContactState&) {}));
  TEST_ASSERT(refused([](ContactState& s) { s.status.front() = 4; }));
  TEST_ASSERT(refused([](ContactState& s) { s.status.front() = -1; }));
  TEST_ASSERT(refused([](ContactState& s) { s.selected.front() = 2; }));
  for (const auto table : {&Rest::steps, &Rest::needed, &Rest::bonded})
    for (const double wrong : {-1.0, 1e10}) {
      Run run, other;
      TEST_ASSERT(run.experiment.advance({{"weight", 1.0}}));
      auto& rest = run.experiment.state().rest;
      const auto points = run.experiment.state().status.size();
      rest.place.assign(2 * points, 0.0);
      for (auto* counts : {&rest.steps, &rest.needed, &rest.bonded}) counts->assign(points, 0.0);
      if (world()->getRank() == 0) (rest.*table).front() = wrong;
      run.saved(folder).save(run.state());
      TEST_THROW(other.saved(folder).restore(other.state()), ResourceError);
    }
}

/// A file that says that a collapse was found, and notes how many values are there before each table is read.
struct CollapseFound {
  std::map<std::string, std::size_t> values_before;

  template <class T>
  void value(const std::string&, T&) {}
  template <class T>
  void within(const std::string& name, T& number, double, double) {
    if (name == "load_factor.upper") number = 1;
  }
  template <class T>
  void rows(const std::string& name, const LocalRows&, int, std::vector<T>& values) {
    values_before[name] = values.size();
  }
};

// A table may be missing only where there are no values before.
TEUCHOS_UNIT_TEST(SavedRun, OfACollapseThatWasFoundNeedsItsMechanism) {
  LoadFactorAnalysis analysis{LoadFactorParameters{}};
  CollapseFound archive;
  analysis.keep(archive, LocalRows{{0, 1, 2}, 3, 3}, LocalRows{{0, 1}, 2, 2}, 2, true);
  TEST_EQUALITY_CONST(archive.values_before["load_factor.mechanism"], 6u);
  TEST_EQUALITY_CONST(archive.values_before["load_factor.failed.lambda"], 4u);
  TEST_EQUALITY_CONST(archive.values_before["load_factor.failed.selected"], 2u);
  TEST_EQUALITY_CONST(archive.values_before["load_factor.failed.opened"], 2u);
}

}  // namespace
