// cost_of_accuracy: computes one scene with more and more accuracy, and shows what each digit costs.
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/safe_file.hpp"
#include "scene/scene_reader.hpp"
#include "simulation/accuracy_study.hpp"

namespace {

using namespace voussoir;

const char* const usage =
    R"(cost_of_accuracy --xml=SCENE [options], alone or under mpirun
  --xml=SCENE         the scene
  --out=DIR           where results go (default: out/cost-of-accuracy-<name of the scene>)
  --set PATH=VALUE    change one parameter of the scene; may be repeated
  --thresholds=LIST   error tolerances of the adaptive runs (default: 0.3,0.1,0.03,0.01,0.003,0.001), or none
  --sizes=LIST        factors on the element size of the scene (default: 2,1,0.5,0.25 as far as affordable), or none
  --draw=SCRIPT       what draws the picture (default: drivers/report/draw_accuracy.py of the source), or none
  --help
Leaves DIR/accuracy.csv and its picture, DIR/accuracy.png and DIR/accuracy.svg; those of an earlier study are replaced.
Exit codes: 0 done, 2 the input is wrong, 3 no convergence, 4 a resource is missing.
)";

// A wall of this size takes minutes on one core.
constexpr double affordable_unknowns = 3e5;

struct Arguments {
  std::string xml, folder, draw = VOUSSOIR_SOURCE_DIR "/drivers/report/draw_accuracy.py";
  std::vector<std::string> overrides;
  std::vector<double> thresholds{0.3, 0.1, 0.03, 0.01, 0.003, 0.001}, sizes{2, 1, 0.5, 0.25};
  double affordable = affordable_unknowns;
  bool help = false;
};

std::vector<double> numbers(const std::string& option, const std::string& text, double below) {
  std::vector<double> values;
  if (text == "none") return values;
  for (const auto& word : split(text, ",")) {
    const auto value = number_in(trimmed(word));
    // Written so that NaN is refused.
    if (!value || !(*value > 0 && *value < below))
      throw InputError("cost_of_accuracy: " + option + " = " + text + "\n  must be numbers above 0 and below " +
                       number_text(below) + " between commas, or none.\n  See cost_of_accuracy --help.");
    values.push_back(*value);
  }
  return values;
}

Arguments parse(const std::vector<std::string>& words) {
  Arguments a;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const auto equals = words[k].find('=');
    const std::string option = words[k].substr(0, equals);
    if (option == "--help") {
      a.help = true;
      return a;
    }
    static const std::vector<std::string> options{"--xml", "--out", "--set", "--thresholds", "--sizes", "--draw"};
    if (std::find(options.begin(), options.end(), option) == options.end())
      throw InputError("cost_of_accuracy: '" + option + "' is no option.\n  See cost_of_accuracy --help.");
    if (equals == std::string::npos && k + 1 == words.size())
      throw InputError("cost_of_accuracy: " + option + " needs a value.\n  See cost_of_accuracy --help.");
    const std::string value = equals == std::string::npos ? words[++k] : words[k].substr(equals + 1);
    if (option == "--xml") a.xml = value;
    if (option == "--out") a.folder = value;
    if (option == "--set") a.overrides.push_back(value);
    if (option == "--thresholds") a.thresholds = numbers(option, value, 1);
    if (option == "--draw") a.draw = value;
    if (option != "--sizes") continue;
    a.sizes = numbers(option, value, 1e3);  // no block is a thousand cells long
    a.affordable = std::numeric_limits<double>::infinity();
  }
  if (a.xml.empty()) throw InputError("cost_of_accuracy: no scene given.\n  Give one with --xml=FILE.");
  if (a.folder.empty()) a.folder = "out/cost-of-accuracy-" + std::filesystem::path(a.xml).stem().string();
  return a;
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Python draws in a process of its own; a study without a picture is still a study.
void draw(const Arguments& a) {
  if (a.draw == "none") return;
  const std::string command = "/usr/bin/python3 -B " + quoted(a.draw) + " " + quoted(a.folder);
  std::cout << std::flush;
  if (std::system(command.c_str()) != 0)
    std::cerr << "The picture could not be drawn. The results are complete; draw them with\n  " << command << "\n";
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

int run_program(const std::vector<std::string>& words) {
  const auto comm = Tpetra::getDefaultComm();
  std::ofstream nowhere;
  const bool first = comm->getRank() == 0;
  int code = exit_resource;
  std::string problem;
  try {
    const auto a = parse(words);
    if (a.help) {
      if (first) std::cout << usage;
      return exit_done;
    }
    study(a, comm, first ? std::cout : nowhere);
    if (first) draw(a);
    return exit_done;
  } catch (const InputError& error) {
    problem = error.what();
    code = exit_input;
  } catch (const ConvergenceError& error) {
    problem = error.what();
    code = exit_no_convergence;
  } catch (const ResourceError& error) {
    problem = error.what();
  }
  if (first) std::cerr << problem << "\n";
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  int name_alone = 1;  // Kokkos would answer --help before we do
  Tpetra::ScopeGuard scope(&name_alone, &argv);
  return run_program({argv + 1, argv + argc});
}
