#include "simulation/saved_run.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include "base/digest.hpp"
#include "base/error.hpp"
#include "output/checkpoint.hpp"
#include "output/output_folder.hpp"
#include "output/safe_file.hpp"
#include "scene/scene_printer.hpp"
#include "simulation/phase.hpp"

namespace voussoir {
namespace {

constexpr int dim = 2;
constexpr int format = 5;  // of the file; raised when a value changes its meaning

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
  checkpoint.rows("broken", points, 1, state.broken);
  checkpoint.value("rest.error.ratio", state.rest.error.ratio);
  checkpoint.value("rest.error.root_known", state.rest.error.root_known);
  checkpoint.value("rest.error.root", state.rest.error.root);
  checkpoint.value("rest.error.travelled", state.rest.error.travelled);
  checkpoint.rows("rest.place", points, dim, state.rest.place);
  checkpoint.rows("rest.steps", points, 1, state.rest.steps);
  checkpoint.rows("rest.needed", points, 1, state.rest.needed);
  checkpoint.rows("rest.bonded", points, 1, state.rest.bonded);
  if (!model.scene().construction.empty()) {
    state.initial_gap.resize(model.points().size());
    checkpoint.rows("initial_gap", points, 1, state.initial_gap);
  }
  if (run.steps.finished() && run.load_factor) run.load_factor->keep(checkpoint, nodes, points, dim);
}

/// What must be the same before and after: the structure. Throws InputError on all ranks.
void check_identity(Checkpoint& checkpoint, const Model<dim>& model, const std::string& path) {
  const auto same = [&](const std::string& name, long long here, const std::string& what) {
    long long saved = here;
    checkpoint.value(name, saved);
    if (saved != here)
      throw InputError(path + ": is of another structure\n  because its " + what +
                       " differ from the scene's.\n  Give the scene it was computed from, or another --out=DIR.");
  };
  same("format", format, "format and that of this program");
  same("blocks", model.source().block_count(), "numbers of blocks");
  same("nodes", model.structure().total_nodes(), "numbers of nodes");
  same("points", model.points().total(), "numbers of contact points");
  same("geometry", geometry_digest(model.structure()), "places of nodes");
  for (const auto& [section, text] : section_texts(model.scene()))
    if (section == "model" || section == "materials" || section == "joints" || section == "supports")
      same("section." + section, static_cast<long long>(digest(text.data(), text.size())), section);
}

}  // namespace

SavedRun::SavedRun(const Model<2>& model, const std::string& folder)
    : model_(model), path_(folder + "/" + checkpoint_file) {}

void SavedRun::save(const RunState& run) {
  Phase phase("output");
  Checkpoint checkpoint(path_, model_.structure().comm(), Checkpoint::Way::save);
  check_identity(checkpoint, model_, path_);
  for (const auto& [section, text] : section_texts(model_.scene())) {
    auto number = static_cast<long long>(digest(text.data(), text.size()));
    checkpoint.value("section." + section, number);
  }
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
  Checkpoint checkpoint(path_, model_.structure().comm(), Checkpoint::Way::restore);
  check_identity(checkpoint, model_, path_);
  std::vector<std::string> changed;
  for (const auto& [section, text] : section_texts(model_.scene())) {
    long long saved = 0;
    checkpoint.value("section." + section, saved);
    if (saved != static_cast<long long>(digest(text.data(), text.size()))) changed.push_back(section);
  }
  keep_state(checkpoint, model_, run);
  std::string stage;
  checkpoint.value("load_steps.stage_name", stage);
  if (run.steps.finished() && stage.empty() && !run.load_factor)
    throw InputError(path_ + ": stands in a load factor analysis\n  but the scene asks for none.\n"
                     "  Give the section \"load factor\" again, or another --out=DIR.");
  if ((run.steps.finished() ? "" : run.steps.stage()) != stage)
    throw InputError(path_ + ": stands in stage '" + stage + "'\n  but the scene has " +
                     (run.steps.finished() ? "fewer stages." : "'" + run.steps.stage() + "' in its place.") +
                     "\n  Leave the stages up to that one as they were.");
  for (auto& [name, seconds] : run.seconds) checkpoint.value("seconds." + name, seconds);
  return changed;
}

void SavedRun::remove() const {
  on_first_rank(*model_.structure().comm(), [this] { std::filesystem::remove(path_); });
}

}  // namespace voussoir
