#include "run/simulation.hpp"

#include <Teuchos_Time.hpp>
#include <optional>

#include "base/words.hpp"
#include "linalg/fail_together.hpp"
#include "model/loads_at_work.hpp"
#include "output/output_folder.hpp"
#include "range/input_warnings.hpp"
#include "results/effect_costs.hpp"
#include "run/run.hpp"
#include "run/scene_blocks.hpp"
#include "run/scene_file.hpp"
#include "scene/scene_printer.hpp"
#include "scene/scene_reader.hpp"

namespace voussoir {
namespace {

using Comm = Teuchos::RCP<const Teuchos::Comm<int>>;

/// What is wanted without a run; nothing where that is not all.
std::optional<RunSummary> only_looked_at(const Scene& scene, const RunOptions& options, const SceneBlocks& blocks,
                                         const Comm& comm, std::ostream& say) {
  if (!options.validate && !options.dry_run) return {};
  for (const auto& w : blocks.warnings(scene, comm)) say << in_words(w) << "\n";
  if (options.validate) {
    blocks.place_loads(scene, comm);
    say << "The scene is valid: " << counted(blocks.count(), "block") << ".\n";
  } else {
    blocks.predict(scene, comm, say);
  }
  return RunSummary{};
}

void say_sizes(const Model& model, std::ostream& say) {
  const int ranks = model.structure().comm()->getSize();
  say << counted(model.block_count(), "block") << ", " << counted(model.points().total_joints(), "joint") << ", "
      << counted(model.structure().total_nodes(), "node") << ", " << counted(model.points().total(), "contact point")
      << ", on " << counted(ranks, "rank") << "\n";
  for (const auto& remark : model.loads_at_work().remarks()) say << remark << "\n";
}

std::unique_ptr<HardProblems> hard_problems_of(const Scene& scene, const RunOptions& options, const Comm& comm) {
  if (options.fclib.empty()) return nullptr;
  return std::make_unique<HardProblems>(options.fclib, scene, options.restart, comm);
}

/// All steps, then what is told at the end, and of a run that was stopped what is known by then.
/// @param hard  where contact problems that were hard are kept; null where they are not
RunSummary run_to_the_end(Run& run, const Scene& scene, const Model& model, const std::string& folder,
                          HardProblems* hard, std::ostream& say) {
  if (hard) run.keep_hard_problems(*hard);
  const bool stopped = run.all_steps().outcome == Outcome::interrupted;
  run.write_joints(folder);
  auto summary = run.result();
  summary.seconds = run.seconds();
  summary.effects = effect_costs(scene, model);
  summary.partition = run.partition();
  const auto& comm = *model.structure().comm();
  summary.peak_memory = peak_memory_per_rank(comm);
  write_result_json(folder + "/" + (stopped ? interrupted_file : result_file), summary, comm);
  if (!stopped) run.end();
  if (hard) say << hard->told() << "\n";
  return summary;
}

}  // namespace

RunSummary run(const Scene& scene, const RunOptions& options, const Comm& comm, std::ostream& say) {
  Teuchos::Time clock("total", true);
  print_scene(say, scene, options.verbose);
  const auto blocks = blocks_of(scene, comm, options.trust);
  for (const auto& line : blocks->report()) say << "  " << line << "\n";
  if (const auto seen = only_looked_at(scene, options, *blocks, comm, say)) return *seen;
  const auto hard = hard_problems_of(scene, options, comm);
  const auto earlier = options.restart ? Earlier::go_on : options.overwrite ? Earlier::remove : Earlier::keep;
  std::optional<BranchedFolder> branched;
  if (!options.restart_from.empty()) branched.emplace(options.restart_from, options.folder, *comm);
  const OutputFolder folder(options.folder, earlier, *comm, files_read(scene));
  if (!folder.kept().empty()) say << "Earlier results were kept in " << folder.kept() << "\n";
  const bool goes_on = options.restart || branched;
  if (!goes_on) write_scene_file(scene, options.folder, *comm);
  write_drawing(blocks->picture(), options.folder, *comm);
  if (options.limit_analysis) return blocks->limit_analysis(scene, options.folder, comm, say);
  const auto modelled = blocks->modelled(scene, comm);
  auto& model = *modelled.model;
  say_sizes(model, say);
  Run run(scene, model, *modelled.appraisal, options, branched ? &*branched : nullptr, clock, say);
  if (run.nothing_left()) {
    say << "Nothing is left to compute, and nothing was changed: the run in " << options.folder
        << " has come to its end.\nGive a scene with further stages to go on, or leave --restart out to compute it "
           "again.\n";
    return {};
  }
  return fail_together(*comm, [&] {  // before the files of the run are closed, which takes all ranks
    for (const auto& warning : input_warnings(scene, model)) run.warn(warning);
    if (goes_on) write_scene_file(scene, options.folder, *comm);
    return run_to_the_end(run, scene, model, options.folder, hard.get(), say);
  });
}

}  // namespace voussoir
