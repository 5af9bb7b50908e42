// result.json, history.csv and the folder they lie in.
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <set>
#include <sstream>

#include <Teuchos_UnitTestHarness.hpp>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "linalg/agree.hpp"
#include "output/history.hpp"
#include "output/output_folder.hpp"
#include "output/result_json.hpp"
#include "output/safe_file.hpp"
#include "support/repository.hpp"
#include "unit/output/folders.hpp"

namespace voussoir {
namespace {

using namespace test;
namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void write(const std::string& path, const std::string& text) {
  if (world()->getRank() == 0) std::ofstream(path) << text;
  world()->barrier();
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string message_of_resource_error(const std::function<void()>& action) {
  try {
    action();
  } catch (const ResourceError& error) {
    return error.what();
  }
  return "";
}

/// A summary in which everything that is optional is present.
RunSummary complete_summary() {
  RunSummary run;
  run.scene = "xml/wall.xml";
  run.outcome = Outcome::collapse;
  run.message = "no equilibrium beyond this load";
  run.mechanism = MechanismSummary{7, "block 7", 0.25};
  run.statics =
      StaticsSummary{1, 0, 0.25, 0.5, {{2, 3, {1.0, 2.0, 0.0}, 1e-3}}, {}, {{"ground", {{0.0, 1e3}, {0.5, 0.0}}}}};
  run.collapse = CollapseSummary{{{"push", 1.0}}, 0.36, 0.38, true, {{0.36, "equilibrium", 20}}, 0.39, 0.37};
  run.rigid = RigidSummary{0.5, {{"ground", {{{-1e3, 1e3}, {0, 2e3}, {0, 3e3}}}}}, 3, 1.5, false, 2.0};
  run.effects = {{"friction", EffectSummary{true, 3, 0.125, 48}}};
  run.seconds = {{"total", 2.5}, {"assembly", 0.5}};
  run.peak_memory = {100.0, 150.0};
  return run;
}

/// "energy.friction_J" for every value; phases of "seconds" other than the total are the row "seconds.*", and
/// every effect is "effects.*".
void collect_keys(const Json& json, const std::string& prefix, std::set<std::string>& keys) {
  for (const auto& [key, value] : json.items()) {
    const std::set<std::string> free{"effects.", "collapse.pattern.", "statics.reactions.", "rigid.reactions."};
    const bool any = free.count(prefix) > 0 || (prefix == "seconds." && key != "total");
    const std::string name = prefix + (any ? "*" : key);
    keys.insert(name);
    if (value.is_object()) collect_keys(value, name + ".", keys);
  }
}

/// The words in backquotes in the first column of the table "result.json" of the README.
std::set<std::string> documented_keys() {
  std::istringstream readme(content(repository("/src/output/README.md")));
  std::set<std::string> keys;
  bool inside = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.rfind("## ", 0) == 0) inside = line == "## result.json";
    if (!inside || line.rfind("| ", 0) != 0) continue;
    const std::string first_column = line.substr(1, line.find('|', 1) - 1);
    for (std::size_t open = first_column.find('`'); open != std::string::npos;) {
      const std::size_t close = first_column.find('`', open + 1);
      keys.insert(first_column.substr(open + 1, close - open - 1));
      open = first_column.find('`', close + 1);
    }
  }
  return keys;
}

TEUCHOS_UNIT_TEST(ResultJson, HoldsExactlyTheKeysThatAreDocumented) {
  std::set<std::string> keys;
  collect_keys(Json::parse(result_json(complete_summary())), "", keys);
  const std::set<std::string> documented = documented_keys();
  for (const auto& key : keys)
    if (documented.count(key) == 0) TEST_EQUALITY_CONST(key, "(not in src/output/README.md)");
  for (const auto& key : documented)
    if (keys.count(key) == 0) TEST_EQUALITY_CONST(key, "(not in result.json)");
}

TEUCHOS_UNIT_TEST(ResultJson, KeepsValuesAndWritesNullForWhatIsNotFinite) {
  RunSummary run = complete_summary();
  run.energy.friction = 0.1;
  run.error_estimate = std::numeric_limits<double>::quiet_NaN();
  run.largest_penetration = std::numeric_limits<double>::infinity();
  run.unknowns = 5'000'000'000;  // does not fit into 32 bits
  const Json json = Json::parse(result_json(run));
  TEST_EQUALITY(json["energy"]["friction_J"].get<double>(), 0.1);
  TEST_ASSERT(json["error_estimate"].is_null());
  TEST_ASSERT(json["largest_penetration_m"].is_null());
  TEST_EQUALITY(json["unknowns"].get<long long>(), 5'000'000'000);
  TEST_EQUALITY(json["outcome"].get<std::string>(), "collapse");
  TEST_EQUALITY(json["effects"]["friction"]["bytes"].get<long long>(), 48);
  TEST_EQUALITY(json["effects"]["friction"]["in_play"].get<bool>(), true);
  TEST_EQUALITY(json["peak_memory_MB"].get<double>(), 150.0);
  TEST_EQUALITY(json["mechanism"]["largest_mover_block"].get<int>(), 7);
  TEST_EQUALITY(json["collapse"]["attempts"][0]["factor"].get<double>(), 0.36);
  TEST_EQUALITY(json["statics"]["widest_hinges"][0]["blocks"][1].get<int>(), 3);
  TEST_EQUALITY(json["statics"]["reactions"]["ground"]["y_N"].get<double>(), 1e3);
  TEST_EQUALITY(json["rigid"]["reactions"]["ground"]["most_y_N"].get<double>(), 2e3);
  run.collapse->upper = std::numeric_limits<double>::infinity();                       // nothing collapsed
  run.rigid->reactions["ground"][0].least = -std::numeric_limits<double>::infinity();  // a range without an end
  TEST_ASSERT(Json::parse(result_json(run))["rigid"]["reactions"]["ground"]["least_x_N"].is_null());
  TEST_ASSERT(Json::parse(result_json(run))["collapse"]["upper"].is_null());
}

TEUCHOS_UNIT_TEST(ResultJson, WhatWasNotSaidIsNotWritten) {
  const Json json = Json::parse(result_json(RunSummary{}));
  TEST_ASSERT(!json.contains("message"));
  TEST_ASSERT(!json.contains("mechanism"));
  TEST_ASSERT(!json.contains("collapse"));
  TEST_ASSERT(!json.contains("rigid"));
  TEST_ASSERT(!json.contains("statics"));
  TEST_EQUALITY(json["outcome"].get<std::string>(), "not_converged");
}

TEUCHOS_UNIT_TEST(ResultJson, IsWrittenWholeAndTheEarlierOneStaysWhenItCannotBe) {
  const std::string folder = fresh_folder("json");
  const std::string path = folder + "/result.json";
  write_result_json(path, complete_summary(), *world());
  TEST_EQUALITY(content(path), result_json(complete_summary()));
  TEST_ASSERT(!fs::exists(path + ".part"));

  // A folder in the place of the file beside: it cannot be opened, not even by root.
  world()->barrier();
  if (world()->getRank() == 0) fs::create_directory(path + ".part");
  world()->barrier();
  const std::string message = message_of_resource_error([&] { write_result_json(path, RunSummary{}, *world()); });
  TEST_ASSERT(contains(message, path + ": cannot be written"));
  TEST_EQUALITY(content(path), result_json(complete_summary()));
}

TEUCHOS_UNIT_TEST(PeakMemory, EveryRankKnowsThatOfAll) {
  const std::vector<double> memory = peak_memory_per_rank(*world());
  TEST_EQUALITY(static_cast<int>(memory.size()), world()->getSize());
  // This program with its libraries takes tens of MB: bytes or kB taken for MB would be far outside.
  for (const double megabytes : memory) TEST_ASSERT(megabytes > 1.0 && megabytes < 10'000.0);
}

TEUCHOS_UNIT_TEST(History, HasOneRowPerStepAndOneFieldPerColumn) {
  const std::string path = fresh_folder("history") + "/history.csv";
  History history(path, world());
  HistoryRow row;
  row.step = 3;
  row.stage = "push, \"west\"";
  row.load_factor = 0.1;
  row.newton_iterations = 12;
  row.error_estimate = std::numeric_limits<double>::quiet_NaN();
  row.largest_displacement = 1.0 / 3.0;
  history.append(row);
  row.stage = "push";
  history.append(row);
  world()->barrier();  // ranks other than the first read what it has flushed

  std::istringstream lines(content(path));
  std::string heading, first, second, rest;
  std::getline(lines, heading);
  std::getline(lines, first);
  std::getline(lines, second);
  TEST_EQUALITY(heading,
                "step,stage,load_factor,time_s,selected_points,open_points,stick_points,slip_points,selection_rounds,"
                "newton_iterations,linear_solves,failed_linear_solves,krylov_iterations,patch_solves,"
                "complementarity_residual,largest_penetration_m,error_estimate,"
                "elastic_J,kinetic_J,external_work_J,friction_J,fracture_J,damping_J,jump_J,removed_J,work_within_"
                "steps_J,imbalance_J,"
                "imbalance_in_time_J,largest_displacement_m,seconds");
  // A third in the shortest text that reads back as the same number; time and estimate, not numbers, are empty.
  TEST_EQUALITY(first,
                "3,\"push, \"\"west\"\"\",0.1,,0,0,0,0,0,12,0,0,0,0,0,0,,0,0,0,0,0,0,0,0,0,0,0,0.3333333333333333,0");
  TEST_EQUALITY(second, "3,push,0.1,,0,0,0,0,0,12,0,0,0,0,0,0,,0,0,0,0,0,0,0,0,0,0,0,0.3333333333333333,0");
  TEST_ASSERT(!std::getline(lines, rest));
}

TEUCHOS_UNIT_TEST(History, FurtherColumnsBearTheNamesOfTheUserAndKeptRowsStayUnderTheirNames) {
  const std::string path = fresh_folder("further") + "/history.csv";
  const std::string crown = "ux_m of a \"crown\",\nhigh", quarter = "ux_m of quarter";
  HistoryRow row;
  row.stage = "push, west";
  {
    History history(path, world(), 0, {crown, quarter});
    row.observed = {0.25, 0.5};
    history.append(row);
  }
  world()->barrier();
  const auto lines = [&] {
    std::istringstream text(content(path));
    std::vector<std::string> all;
    for (std::string line; std::getline(text, line);) all.push_back(line);
    return all;
  };
  TEST_EQUALITY(lines()[0], History::heading() + ",\"ux_m of a \"\"crown\"\", high\",ux_m of quarter");
  TEST_EQUALITY(lines()[1].substr(lines()[1].size() - 9), ",0.25,0.5");
  const std::string row_before = lines()[1];
  world()->barrier();
  {  // a run goes on with other places: the row kept has no value for the new one
    History history(path, world(), 1, {quarter, "ux_m of springing"});
    row.observed = {1.5, 2.5};
    history.append(row);
  }
  world()->barrier();
  TEST_EQUALITY(lines().size(), 3);
  TEST_EQUALITY(lines()[1], row_before.substr(0, row_before.size() - 9) + ",0.5,");
  TEST_EQUALITY(lines()[2].substr(lines()[2].size() - 8), ",1.5,2.5");
}

TEUCHOS_UNIT_TEST(History, AFileThatCannotBeWrittenIsNamedOnAllRanks) {
  const std::string folder = fresh_folder("no-history");
  const std::string path = folder + "/history.csv";
  if (world()->getRank() == 0) fs::create_directory(path);
  world()->barrier();
  TEST_ASSERT(contains(message_of_resource_error([&] { History(path, world()); }), path + ": cannot be written"));
}

TEUCHOS_UNIT_TEST(OutputFolder, IsMadeWithItsParents) {
  const std::string folder = fresh_folder("parents") + "/out/wall/";
  const std::string kept = OutputFolder(folder, Earlier::keep, *world()).kept();
  TEST_EQUALITY(kept, "");
  TEST_ASSERT(fs::is_directory(folder));
  TEST_ASSERT(fs::is_empty(folder));
}

TEUCHOS_UNIT_TEST(OutputFolder, AFinishedRunIsKeptUnderTheNextFreeNumber) {
  const std::string folder = fresh_folder("kept") + "/wall";
  for (const std::string run : {"first", "second"}) {
    OutputFolder(folder, Earlier::keep, *world()).kept();
    write(folder + "/result.json", run);
    write(folder + "/fields.h5", run);
  }
  const std::string kept = OutputFolder(folder + "/", Earlier::keep, *world()).kept();
  TEST_EQUALITY(kept, folder + ".2");
  TEST_EQUALITY(content(folder + ".1/fields.h5"), "first");
  TEST_EQUALITY(content(folder + ".2/result.json"), "second");
  TEST_ASSERT(fs::is_empty(folder));
}

TEUCHOS_UNIT_TEST(OutputFolder, WhatTheProgramHasNotMadeStaysWhereItIs) {
  const std::string folder = fresh_folder("beside") + "/wall";
  OutputFolder(folder, Earlier::keep, *world());
  for (const char* file : {"/result.json", "/scene.xml", "/notes.txt"}) write(folder + file, file);
  fs::create_directories(folder + "/photos");
  const std::string kept = OutputFolder(folder, Earlier::keep, *world()).kept();
  TEST_EQUALITY(kept, folder + ".1");
  TEST_EQUALITY(content(kept + "/result.json"), "/result.json");
  TEST_ASSERT(fs::exists(kept + "/scene.xml") && !fs::exists(kept + "/notes.txt"));
  TEST_EQUALITY(content(folder + "/notes.txt"), "/notes.txt");
  TEST_ASSERT(fs::exists(folder + "/photos") && !fs::exists(folder + "/result.json"));
  TEST_THROW(
      {
        const OutputFolder first(folder, Earlier::keep, *world());
        OutputFolder(folder, Earlier::keep, *world());
      },
      ResourceError);  // the lock is that of the folder that stayed
}

TEUCHOS_UNIT_TEST(OutputFolder, ASceneOfAnotherIsKeptThoughThereAreNoResults) {
  const std::string folder = fresh_folder("others") + "/wall";
  OutputFolder(folder, Earlier::keep, *world());
  write(folder + "/scene.xml", "another's");
  write(folder + "/notes.txt", "mine");
  if (world()->getRank() == 0) fs::create_directories(folder + "/pictures");
  world()->barrier();
  const std::string kept = OutputFolder(folder, Earlier::keep, *world()).kept();
  TEST_EQUALITY(content(kept + "/scene.xml"), "another's");
  TEST_ASSERT(fs::exists(folder + "/notes.txt") && fs::exists(folder + "/pictures") &&
              !fs::exists(folder + "/scene.xml"));
}

TEUCHOS_UNIT_TEST(OutputFolder, WhatARunReadsIsNotReplaced) {
  const std::string folder = fresh_folder("reads") + "/wall";
  OutputFolder(folder, Earlier::keep, *world());
  for (const std::string name : {"scene.xml", "drawing.svg", "joints.csv"}) {
    write(folder + "/" + name, "mine");
    const std::string input = folder + "/../wall/" + name;
    for (const auto earlier : {Earlier::keep, Earlier::remove}) {
      const auto message = message_of_resource_error([&] { OutputFolder(folder, earlier, *world(), {input}); });
      TEST_ASSERT(contains(message, "would have " + input + " replaced by a file of the results of the same name"));
    }
    TEST_EQUALITY(content(folder + "/" + name), "mine");
    world()->barrier();
    if (world()->getRank() == 0) fs::remove(folder + "/" + name);
    world()->barrier();
  }
  // Of another folder, or of another name.
  TEST_EQUALITY(OutputFolder(folder, Earlier::keep, *world(), {"scene.xml", folder + "/wall.xml"}).kept(), "");
}

TEUCHOS_UNIT_TEST(OutputFolder, OverwritingRemovesResultsAndNothingElse) {
  const std::string folder = fresh_folder("overwrite") + "/wall";
  OutputFolder(folder, Earlier::keep, *world()).kept();
  write(folder + "/result.json", "old");
  write(folder + "/fields.xdmf", "old");
  write(folder + "/notes.txt", "mine");
  const std::string kept = OutputFolder(folder, Earlier::remove, *world()).kept();
  TEST_EQUALITY(kept, "");
  TEST_ASSERT(!fs::exists(folder + "/result.json"));
  TEST_ASSERT(!fs::exists(folder + "/fields.xdmf"));
  TEST_EQUALITY(content(folder + "/notes.txt"), "mine");
  TEST_ASSERT(!fs::exists(folder + ".1"));
}

TEUCHOS_UNIT_TEST(OutputFolder, AFolderThatCannotBeMadeIsNamedOnAllRanks) {
  // A folder below a regular file cannot exist, not even for root.
  const std::string blocked = fresh_folder("blocked") + "/file";
  write(blocked, "not a folder");
  for (const auto earlier : {Earlier::keep, Earlier::remove}) {
    const std::string message =
        message_of_resource_error([&] { OutputFolder(blocked + "/wall", earlier, *world()).kept(); });
    TEST_ASSERT(contains(message, blocked + "/wall: cannot be written"));
    TEST_ASSERT(contains(message, "Not a directory"));
  }
}

TEUCHOS_UNIT_TEST(FirstRank, WhatItThrowsIsThrownOnAllRanks) {
  int calls = 0;
  on_first_rank(*world(), [&] { ++calls; });
  TEST_EQUALITY(calls, world()->getRank() == 0 ? 1 : 0);
  const std::string message =
      message_of_resource_error([] { on_first_rank(*world(), [] { throw ResourceError("why"); }); });
  TEST_EQUALITY(message, "why");
}

}  // namespace
}  // namespace voussoir
