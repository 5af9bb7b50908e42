// cost_of_accuracy: computes one scene with more and more accuracy, and shows what each digit costs.
#include <algorithm>
#include <filesystem>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "base/command_line.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "drivers/study.hpp"
#include "linalg/agree.hpp"
#include "output/safe_file.hpp"
#include "scene/scene_reader.hpp"
#include "study/accuracy_study.hpp"

namespace {

using namespace voussoir;

const char* const closing =
    R"(Leaves DIR/accuracy.csv and its picture, DIR/accuracy.png and DIR/accuracy.svg.
Those of an earlier study are replaced.
Exit codes: 0 done, 2 the input is wrong, 3 no convergence, 4 a resource is missing.
)";

// A wall of this size takes minutes on one core.
constexpr double affordable_unknowns = 3e5;

struct Arguments {
  std::string xml, folder, draw = VOUSSOIR_SOURCE_DIR "/drivers/report/draw_accuracy.py";
  std::vector<std::string> overrides;
  std::vector<double> thresholds{0.3, 0.1, 0.03, 0.01, 0.003, 0.001}, sizes{2, 1, 0.5, 0.25};
  double affordable = affordable_unknowns;
  std::string help;  ///< to print instead of computing, when it was asked for
};

std::vector<double> numbers(const CommandLine& line, const std::string& option, const std::string& text, double below) {
  std::vector<double> values;
  if (text == "none") return values;
  for (const auto& word : split(text, ",")) {
    const auto value = number_in(trimmed(word));
    // Written so that NaN is refused.
    if (!value || !(*value > 0 && *value < below))
      line.refuse(option, text,
                  "must be numbers above 0 and below " + number_text(below) + " between commas, or none.");
    values.push_back(*value);
  }
  return values;
}

Arguments parse(const std::vector<std::string>& words) {
  Arguments a;
  CommandLine line("cost_of_accuracy", "--xml=SCENE [options], alone or under mpirun");
  line.add("--xml", "SCENE", a.xml, "the scene");
  line.add("--out", "DIR", a.folder, "where results go (default: out/cost-of-accuracy-<name of the scene>)");
  line.add_repeated("--set", "PATH=VALUE", a.overrides, "change one parameter of the scene; may be repeated");
  line.add(
      "--thresholds", "LIST", [&](const std::string& text) { a.thresholds = numbers(line, "--thresholds", text, 1); },
      "error tolerances of the adaptive runs (default: 0.3,0.1,0.03,0.01,0.003,0.001), or none");
  line.add(
      "--sizes", "LIST",
      [&](const std::string& text) {
        a.sizes = numbers(line, "--sizes", text, 1e3);  // no block is a thousand cells long
        a.affordable = std::numeric_limits<double>::infinity();
      },
      "factors on the element size of the scene (default: 2,1,0.5,0.25 as far as affordable), or none");
  line.add("--draw", "SCRIPT", a.draw,
           "what draws the picture (default: drivers/report/draw_accuracy.py of the source), or none");
  if (!line.read(words)) {
    a.help = line.help(closing);
    return a;
  }
  if (a.xml.empty()) throw InputError("cost_of_accuracy: no scene given.\n  Give one with --xml=FILE.");
  if (a.folder.empty()) a.folder = "out/cost-of-accuracy-" + std::filesystem::path(a.xml).stem().string();
  return a;
}

void study(const Arguments& a, const Teuchos::RCP<const Teuchos::Comm<int>>& comm, std::ostream& say) {
  const auto scene = read_scene(a.xml, a.overrides);
  // What cannot be refined is said before hours of computing.
  for (double factor : a.sizes) with_element_size(scene, factor);
  on_first_rank(*comm, [&] { std::filesystem::create_directories(a.folder); });
  AccuracyStudy accuracy(scene, a.folder, comm, say);
  if (!a.thresholds.empty()) accuracy.sweep_selection(a.thresholds);
  if (!a.sizes.empty()) accuracy.sweep_element_size(a.sizes, a.affordable);
  say << "\nResults are in " << a.folder << "/accuracy.csv\n";
}

void run_program(const std::vector<std::string>& words, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                 std::ostream& say) {
  const auto a = parse(words);
  if (!a.help.empty()) {
    say << a.help;
    return;
  }
  study(a, comm, say);
  if (comm->getRank() == 0) draw_picture(a.draw, a.folder);
}

}  // namespace

int main(int argc, char** argv) { return run_study(argc, argv, run_program); }
