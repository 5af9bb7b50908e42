#include "run/saved_run.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>

#include "base/digest.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "output/checkpoint.hpp"
#include "output/output_folder.hpp"
#include "output/safe_file.hpp"
#include "scene/scene_printer.hpp"
#include "step/phase.hpp"

namespace voussoir {
namespace {

constexpr int dim = 2;
constexpr int format = 11;  // of the file; raised when a value changes its meaning

long long number_of(const std::string& text) { return static_cast<long long>(digest(text.data(), text.size())); }

InputError another_structure(const std::string& path, const std::string& what) {
  return InputError(path + ": is of another structure\n  because its " + what +
                    " differ from the scene's.\n  Give the scene it was computed from, or another --out=DIR.");
}

/// One number for all nodes of the structure and their places; a sum, so that ranks do not matter.
long long geometry_digest(const Structure<dim>& s) {
  std::uint64_t sum = 0;
  for (int i = 0; i < s.owned_nodes(); ++i) {
    const auto node = digest(&s.node_id()[i], sizeof(NodeId));
    sum += digest(s.drawn_position()[i].data(), dim * sizeof(double), node);
  }
  // Only the lower half is summed over ranks as a number, or signs could overflow.
  const auto mine = static_cast<long long>(sum & 0xffffffffu);
  long long all = 0;
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all & 0xffffffff;
}

LocalRows node_rows(const Structure<dim>& s) {
  return {{s.node_id().begin(), s.node_id().end()}, s.owned_nodes(), s.total_nodes()};
}

LocalRows point_rows(const ContactPoints<dim>& points) {
  LocalRows rows{{}, points.owned(), points.total()};
  for (const auto& p : points.points()) rows.ids.push_back(p.id);
  return rows;
}

void keep_state(Checkpoint& checkpoint, const Model<dim>& model, const RunState& run) {
  run.steps.keep(checkpoint);
  run.time_step.keep(checkpoint);
  run.record.keep(checkpoint);
  run.state.fast_way.keep(checkpoint);
  const auto nodes = node_rows(model.structure()), points = point_rows(model.points());
  auto& state = run.state;
  checkpoint.rows("displacement", nodes, dim, state.displacement);
  checkpoint.rows("velocity", nodes, dim, state.velocity);
  checkpoint.rows("acceleration", nodes, dim, state.acceleration);
  checkpoint.rows("acceleration before", nodes, dim, state.acceleration_before);
  checkpoint.value("largest_energy_J", state.largest_energy);
  checkpoint.rows("load", nodes, dim, run.load);
  checkpoint.rows("lambda", points, dim, state.lambda);
  checkpoint.rows("slip_origin", points, dim, state.slip_origin);
  checkpoint.rows("selected", points, 1, state.selected);
  checkpoint.rows("opened", points, 1, state.opened);
  checkpoint.rows("slipped", points, 1, state.slipped);
  checkpoint.rows("status", points, 1, state.status);
  checkpoint.value("rest.error.ratio", state.rest.error.ratio);
  checkpoint.value("rest.error.root_known", state.rest.error.root_known);
  checkpoint.value("rest.error.root", state.rest.error.root);
  checkpoint.value("rest.error.travelled", state.rest.error.travelled);
  checkpoint.rows("rest.place", points, dim, state.rest.place);
  checkpoint.rows("rest.steps", points, 1, state.rest.steps);
  checkpoint.rows("rest.needed", points, 1, state.rest.needed);
  checkpoint.rows("rest.bonded", points, 1, state.rest.bonded);
  bool built = !model.scene().construction.empty();  // restored: that of the scene it was saved with
  checkpoint.value("built", built);
  if (built) {
    state.initial_gap.resize(model.points().size());
    checkpoint.rows("initial_gap", points, 1, state.initial_gap);
  }
  if (model.scene().construction.empty()) state.initial_gap.clear();
  bool searching = run.steps.finished() && run.load_factor && run.load_factor->begun();
  checkpoint.value("load_factor.begun", searching);
  if (searching && run.load_factor) run.load_factor->keep(checkpoint, nodes, points, dim, model.weakens());
}

/// What of a scene made the state at the end of its first stages: their loads and times, and which blocks were there.
std::string past(const Scene& scene, std::size_t stages) {
  std::string text;
  for (std::size_t k = 0; k < stages; ++k) {
    const auto& stage = scene.stages[k];
    text += stage.name + '\n' + number_text(stage.duration) + (stage.at_once ? " at once\n" : "\n");
    for (const auto& [load, factor] : stage.factors) text += load + '=' + number_text(factor) + '\n';
  }
  const auto when = [&](const std::string& name) {
    for (std::size_t k = 0; k < stages; ++k)
      if (scene.stages[k].name == name) return std::to_string(k);
    return std::string(name.empty() ? "" : "later");
  };
  for (const auto& [name, c] : scene.construction) {
    const auto there = when(c.appears) + " to " + when(c.disappears);
    // Blocks that go in a later stage have been there like all others.
    if (there != " to " && there != " to later") text += c.blocks + ": " + there + '\n';
  }
  return text;
}

std::string pattern_of(const Scene& scene) {
  std::string text;
  for (const auto& [load, share] : scene.load_factor.pattern) text += load + '=' + number_text(share) + '\n';
  return text;
}

/// What lies behind a run must be as it was: the stages it has passed, and the pattern of a search that has begun.
/// Throws InputError on all ranks.
void check_past(Checkpoint& checkpoint, const Scene& scene, const std::string& path) {
  const std::string other_way = "\n  Leave the stages up to that one as they were.";
  int stages = 0;
  checkpoint.value("load_steps.stage", stages);
  const auto passed = static_cast<std::size_t>(stages);
  std::string stage;
  checkpoint.value("load_steps.stage_name", stage);
  if (passed > scene.stages.size() || (passed == scene.stages.size() && !stage.empty()))
    throw InputError(path + ": stands " + (stage.empty() ? "at the end of its stages" : "in stage '" + stage + "'") +
                     "\n  but the scene has fewer stages." + other_way);
  if (!stage.empty() && scene.stages[passed].name != stage)
    throw InputError(path + ": stands in stage '" + stage + "'\n  but the scene has '" + scene.stages[passed].name +
                     "' in its place." + other_way);
  long long digest_of_past = 0;
  checkpoint.value("past", digest_of_past);
  if (passed > 0 && digest_of_past != number_of(past(scene, passed)))
    throw InputError(path + ": has passed the stages up to '" + scene.stages[passed - 1].name +
                     "'\n  but the scene has others in their place (their names, loads, factors, durations or blocks "
                     "differ).\n  Leave them as they were; stages that follow may be changed and added.");
  bool searching = false;
  checkpoint.value("load_factor.begun", searching);
  if (!searching) return;
  if (!scene.load_factor.asked())
    throw InputError(path +
                     ": stands in a load factor analysis\n  but the scene asks for none.\n  Give the section "
                     "\"load factor\" again, or another --out=DIR.");
  long long pattern = 0;
  checkpoint.value("load_factor.pattern", pattern);
  const bool longer = passed < scene.stages.size();
  if (longer || pattern != number_of(pattern_of(scene)))
    throw InputError(path + ": stands in a load factor analysis\n  but the scene has another " +
                     (longer ? "stage before it, '" + scene.stages[passed].name + "'" : std::string("pattern")) +
                     ".\n  Compute the stages in a scene without load factor; then start this scene and others from "
                     "their end with --restart-from.");
}

/// Names of the sections that a scene had when it was saved and has not, or otherwise, now; those of the structure must
/// be the same. Throws InputError on all ranks.
std::vector<std::string> keep_sections(Checkpoint& checkpoint, const Scene& scene, const std::string& path) {
  const auto here = section_texts(scene);
  std::string names;  // a scene prints only the sections it has
  for (const auto& [section, text] : here) names += section + '\n';
  checkpoint.value("sections", names);
  std::vector<std::string> changed;
  std::set<std::string> missing;
  for (const auto& [section, text] : here) missing.insert(section);
  for (const auto& section : split(names, "\n")) {
    if (section.empty()) continue;
    const auto found = here.find(section);
    const long long now = found == here.end() ? 0 : number_of(found->second);
    long long saved = now;
    checkpoint.value("section." + section, saved);
    if (saved != now || found == here.end()) changed.push_back(section);
    missing.erase(section);
  }
  changed.insert(changed.end(), missing.begin(), missing.end());
  for (const auto& section : changed)
    if (section == "model" || section == "materials" || section == "joints" || section == "supports")
      throw another_structure(path, section);
  return changed;
}

/// What must be the same before and after: the structure. Throws InputError on all ranks.
void check_identity(Checkpoint& checkpoint, const Model<dim>& model, const std::string& path) {
  const auto same = [&](const std::string& name, long long here, const std::string& what) {
    long long saved = here;
    checkpoint.value(name, saved);
    if (saved != here) throw another_structure(path, what);
  };
  same("format", format, "format and that of this program");
  same("blocks", model.source().block_count(), "numbers of blocks");
  same("nodes", model.structure().total_nodes(), "numbers of nodes");
  same("points", model.points().total(), "numbers of contact points");
  same("geometry", geometry_digest(model.structure()), "places of nodes");
}

}  // namespace

std::string words_of(const RunState& run, const std::vector<std::string>& changed) {
  std::ostringstream text;
  text << "Going on after step " << run.record.summary.steps;
  if (!run.steps.finished())
    text << ", stage '" << run.steps.stage() << "' at " << run.steps.reached() << "\n";
  else if (run.load_factor)
    text << ", load factor " << run.load_factor->search().lower() << "\n";
  else
    text << ", the end of all stages\n";
  for (const auto& section : changed) text << "  changed since the run was saved: " << section << "\n";
  return text.str();
}

SavedRun::SavedRun(const Model<2>& model, const std::string& folder, const std::string& from)
    : model_(model),
      path_(folder + "/" + checkpoint_file),
      source_((from.empty() ? folder : from) + "/" + checkpoint_file) {}

void SavedRun::save(const RunState& run) {
  Phase phase("output");
  Checkpoint checkpoint(path_, model_.structure().comm(), Checkpoint::Way::save);
  check_identity(checkpoint, model_, path_);
  keep_sections(checkpoint, model_.scene(), path_);
  auto behind = number_of(past(model_.scene(), run.steps.passed())), pattern = number_of(pattern_of(model_.scene()));
  checkpoint.value("past", behind);
  checkpoint.value("load_factor.pattern", pattern);
  std::string stage = run.steps.finished() ? "" : run.steps.stage();
  checkpoint.value("load_steps.stage_name", stage);
  for (auto [name, seconds] : run.seconds) checkpoint.value("seconds." + name, seconds);
  keep_state(checkpoint, model_, run);
  checkpoint.publish();
  clock_.reset();
  clock_.start(true);
  steps_since_ = 0;
}

void SavedRun::save_when_due(const RunState& run) {
  const auto& output = model_.scene().output;
  // The clock of one rank, so that all agree.
  int due = output.checkpoint_seconds > 0 && clock_.totalElapsedTime(true) >= output.checkpoint_seconds;
  Teuchos::broadcast(*model_.structure().comm(), 0, &due);
  ++steps_since_;
  if (due || (output.checkpoint_every > 0 && steps_since_ >= output.checkpoint_every)) save(run);
}

std::vector<std::string> SavedRun::restore(const RunState& run) const {
  Phase phase("output");
  Checkpoint checkpoint(source_, model_.structure().comm(), Checkpoint::Way::restore);
  check_identity(checkpoint, model_, source_);
  const auto changed = keep_sections(checkpoint, model_.scene(), source_);
  check_past(checkpoint, model_.scene(), source_);
  keep_state(checkpoint, model_, run);
  for (auto& [name, seconds] : run.seconds) checkpoint.value("seconds." + name, seconds);
  return changed;
}

void SavedRun::remove() const {
  on_first_rank(*model_.structure().comm(), [this] { std::filesystem::remove(path_); });
}

}  // namespace voussoir
