#include "run/saved_run.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/check.hpp"
#include "base/digest.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "linalg/agree.hpp"
#include "linalg/fail_together.hpp"
#include "linalg/reduce.hpp"
#include "model/carried_points.hpp"
#include "model/handed_over.hpp"
#include "model/phase.hpp"
#include "output/checkpoint.hpp"
#include "output/output_folder.hpp"
#include "output/safe_file.hpp"
#include "run/scene_changes.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

constexpr int format = 14;     // of the file; raised when a value changes its meaning
constexpr double near = 1e-9;  // [-] of the structure's size: places of one drawing, read twice, are one
constexpr double largest_number = std::numeric_limits<double>::max();

long long number_of(const std::string& text) { return static_cast<long long>(digest(text.data(), text.size())); }

InputError another_structure(const std::string& path, const std::string& what) {
  return InputError(path + ": is of another structure\n  because its " + what +
                    " differ from the scene's.\n  Give the scene it was computed from, or another --out=DIR.");
}

/// One number for parts that ranks have; a sum, so that ranks do not matter. Only its lower half is summed as a number,
/// or signs could overflow. Collective.
long long sum_of_digests(std::uint64_t here, const Teuchos::Comm<int>& comm) {
  return total_over_ranks(comm, static_cast<long long>(here & 0xffffffffu)) & 0xffffffff;
}

/// Of all nodes of the structure and their places.
template <int dim>
long long geometry_digest(const Structure<dim>& s) {
  std::uint64_t sum = 0;
  for (int i = 0; i < s.owned_nodes(); ++i) {
    const auto node = digest(&s.node_id()[i], sizeof(NodeId));
    sum += digest(s.drawn_position()[i].data(), dim * sizeof(double), node);
  }
  return sum_of_digests(sum, *s.comm());
}

/// Of the cells between them: a wall of triangles has the nodes of one of quadrilaterals.
template <int dim>
long long cells_digest(const Structure<dim>& s) {
  std::uint64_t sum = 0;
  for (int b = 0; b < s.owned_blocks(); ++b)
    for (const auto& cell : s.blocks()[b].mesh.cells)
      sum += digest(cell.node.data(), cell.count * sizeof(int), digest(&s.blocks()[b].mesh.id, sizeof(BlockId)));
  return sum_of_digests(sum, *s.comm());
}

/// Of the stones and edges in the sets of that name.
template <int dim>
long long sets_digest(const BlockSource<dim>& source, const Structure<dim>& s, const SetsAtWork& sets) {
  const auto add = [](const std::string& name, std::uint64_t start) { return digest(name.data(), name.size(), start); };
  std::uint64_t sum = 0;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& mesh = s.blocks()[b].mesh;
    const auto block = digest(&mesh.id, sizeof(BlockId));
    for (const int set : mesh.sets)
      if (const auto& name = source.block_sets()[set]; sets.of_blocks.count(name)) sum += add(name, block);
    for (const auto& facet : mesh.facets)
      if (const auto& name = source.facet_sets()[facet.set]; sets.of_facets.count(name))
        sum += add(name, digest(facet.node.data(), facet.count * sizeof(int), block));
  }
  return sum_of_digests(sum, *s.comm());
}

long long sets_digest(const Model& model, const SetsAtWork& sets) {
  return model.in_geometry([&](const auto& source, const auto& s) { return sets_digest(source, s, sets); });
}

LocalRows node_rows(const BlockSystem& s) {
  return {{s.node_id().begin(), s.node_id().end()}, s.owned_nodes(), s.total_nodes()};
}

/// Blocks, place and normal of points, as a checkpoint holds them.
struct PlaceRows {
  std::vector<int> blocks;
  std::vector<double> places;

  explicit PlaceRows(const std::vector<PointPlace>& of) {
    for (const auto& p : of) {
      blocks.insert(blocks.end(), {p.block_i, p.block_j});
      places.insert(places.end(), p.place.begin(), p.place.end());
      places.insert(places.end(), p.normal.begin(), p.normal.end());
    }
  }
  void keep(Checkpoint& checkpoint, const LocalRows& rows) {
    checkpoint.rows("points.blocks", rows, 2, blocks);
    checkpoint.rows("points.places", rows, 6, places);
  }
  std::vector<PointPlace> list() const {
    std::vector<PointPlace> all(blocks.size() / 2);
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k].block_i = blocks[2 * k];
      all[k].block_j = blocks[2 * k + 1];
      std::copy_n(&places[6 * k], 3, all[k].place.begin());
      std::copy_n(&places[6 * k + 3], 3, all[k].normal.begin());
    }
    return all;
  }
};

/// Where a checkpoint has the points. One that is restored is known by its place, and has no row if it was not there.
/// Collective.
LocalRows point_rows(Checkpoint& checkpoint, const Model& model) {
  const auto& points = model.points();
  LocalRows rows{{}, points.owned(), points.total()};
  for (const auto& p : points.points()) rows.ids.push_back(p.id);
  const auto here = model.in_geometry([&](const auto&, const auto& s) { return places_of(points, s); });
  checkpoint.value("points", rows.total);
  if (checkpoint.saving()) {
    PlaceRows(here).keep(checkpoint, rows);
    return rows;
  }
  const auto& comm = *model.structure().comm();
  const auto bound = [&](long long rank) {
    return rows.total / comm.getSize() * rank + std::min(rank, rows.total % comm.getSize());
  };
  LocalRows even{{}, bound(comm.getRank() + 1) - bound(comm.getRank()), rows.total};
  for (long long k = 0; k < even.owned; ++k) even.ids.push_back(bound(comm.getRank()) + k);
  PlaceRows saved(std::vector<PointPlace>(even.ids.size()));
  saved.keep(checkpoint, even);
  rows.ids = same_places_over_ranks(here, saved.list(), bound(comm.getRank()), near * model.structure().size(), comm);
  return rows;
}

void keep_state(Checkpoint& checkpoint, const Model& model, const RunState& run) {
  run.steps.keep(checkpoint);
  run.time_step.keep(checkpoint);
  run.record.keep(checkpoint);
  run.state.fast_way.keep(checkpoint);
  const auto nodes = node_rows(model.structure()), points = point_rows(checkpoint, model);
  const int dim = model.components();
  auto& state = run.state;
  checkpoint.rows("displacement", nodes, dim, state.displacement);
  checkpoint.rows("velocity", nodes, dim, state.velocity);
  checkpoint.rows("acceleration", nodes, dim, state.acceleration);
  checkpoint.rows("acceleration before", nodes, dim, state.acceleration_before);
  checkpoint.value("largest_energy_J", state.largest_energy);
  checkpoint.rows("load", nodes, dim, run.load);
  each_list_of_points(state, dim, [&](const std::string& name, auto& list, int values, double most) {
    if (static_cast<const void*>(&list) == &state.initial_gap) return;  // below
    if (most < 0)
      checkpoint.rows(name, points, values, list);
    else
      checkpoint.rows_within(name, points, values, list, 0, most);
  });
  checkpoint.within("rest.error.ratio", state.rest.error.ratio, 0, largest_number);
  checkpoint.within("rest.error.root_known", state.rest.error.root_known, 0, largest_number);
  checkpoint.within("rest.error.root", state.rest.error.root, 0, largest_number);
  checkpoint.within("rest.error.travelled", state.rest.error.travelled, 0, largest_number);
  bool built = model.settings().builds;  // restored: that of the scene it was saved with
  checkpoint.value("built", built);
  if (built) {
    state.initial_gap.resize(model.points().size());
    checkpoint.rows("initial_gap", points, 1, state.initial_gap);
  }
  if (!model.settings().builds) state.initial_gap.clear();
  std::vector<char> begins;
  for (const auto row : points.ids) begins.push_back(row < 0);
  begin_points(begins, model.points(), state);
  bool searching = run.steps.finished() && run.load_factor && run.load_factor->begun();
  checkpoint.value("load_factor.begun", searching);
  if (searching && run.load_factor) run.load_factor->keep(checkpoint, nodes, points, dim, model.weakens());
}

std::string pattern_of(const Scene& scene) {
  std::string text;
  for (const auto& [load, share] : scene.load_factor.pattern) text += load + '=' + number_text(share) + '\n';
  return text;
}

/// Stages that a run has passed must be there as they were, by name and order. Throws InputError on all ranks.
Passed passed_stages(Checkpoint& checkpoint, const Scene& scene, const std::string& path) {
  const std::string other_way = "\n  Leave the stages up to that one as they were.";
  Passed passed;
  int stages = 0;
  double reached = 0;
  checkpoint.within("load_steps.stage", stages, 0, std::numeric_limits<int>::max());
  checkpoint.within("load_steps.reached", reached, 0, 1);
  checkpoint.value("load_factor.begun", passed.searching);
  passed.stages = static_cast<std::size_t>(stages);
  std::string stage;
  checkpoint.value("load_steps.stage_name", stage);
  passed.in_stage = !stage.empty() && reached > 0;
  if (passed.stages > scene.stages.size() || (passed.stages == scene.stages.size() && !stage.empty()))
    throw InputError(path + ": stands " + (stage.empty() ? "at the end of its stages" : "in stage '" + stage + "'") +
                     "\n  but the scene has fewer stages." + other_way);
  if (!stage.empty() && scene.stages[passed.stages].name != stage)
    throw InputError(path + ": stands in stage '" + stage + "'\n  but the scene has '" +
                     scene.stages[passed.stages].name + "' in its place." + other_way);
  std::vector<std::string> names;
  checkpoint.texts("stages passed", names);
  for (std::size_t k = 0; k < std::min(names.size(), passed.stages); ++k)
    if (names[k] != scene.stages[k].name)
      throw InputError(path + ": has passed stage '" + names[k] + "'\n  but the scene has '" + scene.stages[k].name +
                       "' in its place." + other_way);
  return passed;
}

/// The pattern of a search that has begun must be as it was. Throws InputError on all ranks.
void check_search(Checkpoint& checkpoint, const Scene& scene, const Passed& passed, const std::string& path) {
  if (!passed.searching) return;
  if (!scene.load_factor.asked())
    throw InputError(path +
                     ": stands in a load factor analysis\n  but the scene asks for none.\n  Give the section "
                     "\"load factor\" again, or another --out=DIR.");
  long long pattern = 0;
  checkpoint.value("load_factor.pattern", pattern);
  const bool longer = passed.stages < scene.stages.size();
  if (longer || pattern != number_of(pattern_of(scene)))
    throw InputError(path + ": stands in a load factor analysis\n  but the scene has another " +
                     (longer ? "stage before it, '" + scene.stages[passed.stages].name + "'" : std::string("pattern")) +
                     ".\n  Compute the stages in a scene without load factor; then start this scene and others from "
                     "their end with --restart-from.");
}

constexpr char end_of_path = '\t';  // no key of a scene holds it

std::vector<std::string> lines_of(const SceneValues& values) {
  std::vector<std::string> lines;
  for (const auto& [path, value] : values) lines.push_back(path + end_of_path + value);
  return lines;
}

SceneValues values_of(const std::vector<std::string>& lines) {
  SceneValues values;
  for (const auto& line : lines) {
    const auto end = std::min(line.find(end_of_path), line.size());
    values.emplace_back(line.substr(0, end), line.substr(std::min(end + 1, line.size())));
  }
  return values;
}

/// What a file holds, as a number, however it is called and wherever it lies. Collective.
std::string content_of(const std::string& file, const Teuchos::Comm<int>& comm) {
  auto number = static_cast<long long>(no_bytes_digest);
  if (comm.getRank() == 0) {
    std::ifstream in(file, std::ios::binary);
    char part[1 << 16];
    auto sum = no_bytes_digest;
    while (in.read(part, sizeof part), in.gcount() > 0) sum = digest(part, static_cast<std::size_t>(in.gcount()), sum);
    number = static_cast<long long>(sum);
  }
  Teuchos::broadcast(comm, 0, Teuchos::outArg(number));
  std::ostringstream text;
  text << "a file with digest " << std::hex << static_cast<std::uint64_t>(number);
  return text.str();
}

/// What must be the same before and after: the structure. Throws InputError on all ranks.
void check_identity(Checkpoint& checkpoint, const Model& model, const std::string& path) {
  const auto same = [&](const std::string& name, long long here, const std::string& what) {
    long long saved = here;
    checkpoint.value(name, saved);
    if (saved != here) throw another_structure(path, what);
  };
  same("format", format, "format and that of this program");
  same("blocks", model.block_count(), "numbers of blocks");
  same("nodes", model.structure().total_nodes(), "numbers of nodes");
  model.in_geometry([&](const auto&, const auto& structure) {
    same("geometry", geometry_digest(structure), "places of nodes");
    same("cells", cells_digest(structure), "cells");
  });
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
  for (const auto& line : changed) text << "  changed since the run was saved: " << line << "\n";
  return text.str();
}

SavedRun::SavedRun(const Scene& scene, const Model& model, const std::string& folder, const std::string& from)
    : scene_(scene),
      model_(model),
      path_(folder + "/" + checkpoint_file),
      source_((from.empty() ? folder : from) + "/" + checkpoint_file),
      values_(
          scene_values(scene, [&](const std::string& file) { return content_of(file, *model.structure().comm()); })) {}

void SavedRun::save(const RunState& run) {
  VOUSSOIR_EXPECT(is_of_nodes(model_, run.load) && "load: of node copies");
  Phase phase("output");
  const auto comm = model_.structure().comm();
  Checkpoint checkpoint(path_, comm, Checkpoint::Way::save);
  fail_together(*comm, [&] {  // before it is closed, which takes all ranks
    write(checkpoint, run);
    checkpoint.publish();
  });
  clock_.reset();
  clock_.start(true);
  steps_since_ = 0;
}

void SavedRun::write(Checkpoint& checkpoint, const RunState& run) const {
  check_identity(checkpoint, model_, path_);
  const Passed passed{run.steps.passed(), !run.steps.finished() && run.steps.reached() > 0,
                      run.steps.finished() && run.load_factor && run.load_factor->begun()};
  auto lines = lines_of(values_);
  checkpoint.texts("scene", lines);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < passed.stages; ++k) names.push_back(scene_.stages[k].name);
  checkpoint.texts("stages passed", names);
  auto sets = sets_digest(model_, sets_at_work(scene_, passed)), pattern = number_of(pattern_of(scene_));
  checkpoint.value("sets", sets);
  checkpoint.value("load_factor.pattern", pattern);
  std::string stage = run.steps.finished() ? "" : run.steps.stage();
  checkpoint.value("load_steps.stage_name", stage);
  for (auto [name, seconds] : run.seconds) checkpoint.value("seconds." + name, seconds);
  keep_state(checkpoint, model_, run);
}

void SavedRun::save_when_due(const RunState& run) {
  const auto& output = scene_.output;
  // The clock of one rank, so that all agree.
  int due = output.checkpoint_seconds > 0 && clock_.totalElapsedTime(true) >= output.checkpoint_seconds;
  Teuchos::broadcast(*model_.structure().comm(), 0, &due);
  ++steps_since_;
  if (due || (output.checkpoint_every > 0 && steps_since_ >= output.checkpoint_every)) save(run);
}

std::vector<std::string> SavedRun::restore(const RunState& run) const {
  Phase phase("output");
  const auto comm = model_.structure().comm();
  Checkpoint checkpoint(source_, comm, Checkpoint::Way::restore);
  return fail_together(*comm, [&] { return read(checkpoint, run); });
}

std::vector<std::string> SavedRun::read(Checkpoint& checkpoint, const RunState& run) const {
  check_identity(checkpoint, model_, source_);
  const auto passed = passed_stages(checkpoint, scene_, source_);
  check_search(checkpoint, scene_, passed, source_);
  std::vector<std::string> lines;
  checkpoint.texts("scene", lines);
  const auto changed = scene_changes(values_of(lines), values_, scene_, passed, source_);
  long long sets = 0;
  checkpoint.value("sets", sets);
  if (sets != sets_digest(model_, sets_at_work(scene_, passed)))
    throw another_structure(source_, "sets of blocks or edges");
  keep_state(checkpoint, model_, run);
  for (auto& [name, seconds] : run.seconds) checkpoint.value("seconds." + name, seconds);
  return changed;
}

void SavedRun::remove() const {
  on_first_rank(*model_.structure().comm(), [this] { std::filesystem::remove(path_); });
}

}  // namespace voussoir
