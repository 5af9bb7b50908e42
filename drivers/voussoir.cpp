// voussoir: computes how a masonry structure behaves, from a scene in XML.

#include <Tpetra_Core.hpp>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "base/before_mpi.hpp"
#include "base/child_process.hpp"
#include "base/command_line.hpp"
#include "base/error.hpp"
#include "base/heap.hpp"
#include "base/leaks.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "linalg/agree.hpp"
#include "linalg/blas_memory.hpp"
#include "linalg/fail_together.hpp"
#include "output/hdf5_file.hpp"
#include "output/output_folder.hpp"
#include "run/simulation.hpp"
#include "run/stop_signals.hpp"
#include "scene/scene_printer.hpp"
#include "scene/scene_reader.hpp"
#include "statics/linear_programme.hpp"

namespace {

using namespace voussoir;

const char* const closing =
    R"(SIGTERM, SIGUSR1 and Ctrl-C save the state and stop, and leave what is known by then in interrupted.json;
so does the time of --at-most. A step that does not converge saves the state before it.
Exit codes: 0 done, 1 the program or a library has failed, 2 the input is wrong, 3 no convergence or out of range,
4 a resource is missing, 5 stopped by a signal or because the time was over.
)";

struct Arguments {
  std::string xml;
  std::vector<std::string> overrides;
  RunOptions run;
  bool quiet = false, trust = false;
  double at_most = 0;                       ///< [s] of the clock; 0: as long as it takes
  bool version = false, internals = false;  ///< to print instead of running
  std::string parameters;                   ///< the same: "plain" or "json", when they were asked for
  std::string help;                         ///< the same, when it was asked for
  bool prints() const { return version || !parameters.empty() || internals || !help.empty(); }
};

/// "90", "90s", "5min", "1.5 h" in seconds; nothing when it is no time above 0.
std::optional<double> duration_in(const std::string& text) {
  const auto unit = text.find_first_not_of("0123456789.");
  const auto number = number_in(trimmed(text.substr(0, unit)));
  if (!number || !(*number > 0)) return {};
  const auto word = unit == std::string::npos ? "s" : trimmed(text.substr(unit));
  for (const auto& [name, seconds] : {std::pair("s", 1.0), std::pair("min", 60.0), std::pair("h", 3600.0)})
    if (word == name) return *number * seconds;
  return {};
}

void declare(CommandLine& line, Arguments& a) {
  line.add("--xml", "FILE", a.xml, "the scene");
  line.add("--out", "DIR", a.run.folder, "where results go (default: out/<name of the scene>)");
  line.add_repeated("--set", "PATH=VALUE", a.overrides,
                    "change one parameter of the scene, such as selection/mode=all; may be repeated");
  line.add_flag("--overwrite", a.run.overwrite, "remove earlier results of DIR instead of keeping them beside");
  line.add_flag("--restart", a.run.restart,
                "go on with the run in DIR, interrupted or with further stages; without --xml, with its scene");
  line.add("--restart-from", "DIR2", a.run.restart_from,
           "go on with the run in DIR2, and leave that as it is: results go to DIR");
  line.add_flag("--trust", a.trust, "let a .geo run programs, and read and write other files, which is refused else");
  line.add_flag("--validate", a.run.validate, "check scene and mesh, then stop");
  line.add_flag("--dry-run", a.run.dry_run, "also count unknowns and predict the cost, then stop");
  line.add_flag("--limit-analysis", a.run.limit_analysis,
                "rigid limit analysis alone: can loads be balanced, up to which load factor, how does it fall");
  line.add(
      "--at-most", "TIME",
      [&](const std::string& text) {
        const auto seconds = duration_in(text);
        if (!seconds) line.refuse("--at-most", text, "must be a time above 0, such as 90s, 5min or 2h.");
        a.at_most = *seconds;
      },
      "end in so much time (90s, 5min, 2h) with what is known by then, ready to go on");
  line.add("--fclib", "FILE.hdf5", a.run.fclib,
           "write contact problems that were hard in the format of the FCLib collection: FILE-0001.hdf5, ...");
  line.add_flag("--print-parameters", "json", a.parameters,
                "print every parameter with unit, default and range, as a scene or for programs");
  line.add_flag("--print-internals", a.internals,
                "print every number that decides how a step is solved, for studies of the program itself");
  line.add_flag("--quiet", a.quiet, "say nothing but errors");
  line.add_flag("--verbose", a.run.verbose, "a line for every linear solve");
  line.add_flag("--version", a.version, "the version of the program");
}

void check(const Arguments& a) {
  if (a.run.restart && a.run.overwrite)
    throw InputError(
        "voussoir: --restart and --overwrite\n  contradict each other: one goes on with what the other "
        "removes.\n  Leave one of them out.");
  if (a.run.limit_analysis && (a.run.restart || !a.run.restart_from.empty()))
    throw InputError(
        "voussoir: --limit-analysis\n  has nothing to go on from: it asks what the scene draws.\n  "
        "Leave --restart out.");
  if (a.run.limit_analysis && !a.run.fclib.empty())
    throw InputError(
        "voussoir: --limit-analysis and --fclib\n  contradict each other: limit analysis solves linear programmes, "
        "which are no contact problems.\n  Leave one of them out.");
  if (a.run.restart && !a.run.restart_from.empty())
    throw InputError(
        "voussoir: --restart and --restart-from\n  contradict each other: one goes on in the folder of the "
        "run, the other leaves it as it is.\n  Leave one of them out.");
}

Arguments parse(const std::vector<std::string>& words) {
  Arguments a;
  CommandLine line("voussoir", "--xml=FILE [options], alone or under mpirun");
  declare(line, a);
  if (!line.read(words)) a.help = line.help(closing);
  if (a.prints()) return a;
  if (a.trust) a.run.trust = Trust::yes;
  check(a);
  const bool branch = !a.run.restart_from.empty();
  if (branch && a.xml.empty() && a.run.folder.empty())
    throw InputError("voussoir: --restart-from\n  needs a place for its results.\n  Give one with --out=DIR.");
  if (branch && a.xml.empty()) a.xml = a.run.restart_from + "/scene.xml";
  if (a.run.restart && a.xml.empty() && !a.run.folder.empty()) a.xml = a.run.folder + "/scene.xml";
  if (a.xml.empty()) throw InputError("voussoir: no scene given.\n  Give one with --xml=FILE.");
  if (a.run.folder.empty()) a.run.folder = "out/" + std::filesystem::path(a.xml).stem().string();
  return a;
}

/// The scene's text is read once and given to all ranks, so that all agree on what it says.
Scene read_on_all_ranks(const Arguments& a, const Teuchos::Comm<int>& comm) {
  std::vector<std::string> text(1);
  on_first_rank(comm, [&] { text[0] = scene_text(a.xml); });
  broadcast_strings(comm, text);
  return read_scene_from_text(text[0], a.xml, a.overrides);
}

/// What stands beside the words equilibrium and collapse.
std::string doubts(const Warnings& warnings) {
  if (warnings.empty()) return "";
  std::string text = " " + in_words(warnings.front());
  if (warnings.size() > 1) text += " And " + std::to_string(warnings.size() - 1) + " more in result.json.";
  return text;
}

int finish(const Arguments& a, const Scene& scene, const RunSummary& summary, std::ostream& say) {
  if (summary.scene.empty()) return exit_done;  // nothing was to be computed
  say << "\n";
  if (summary.outcome == Outcome::interrupted) {
    say << static_cast<char>(std::toupper(summary.message[0])) << summary.message.substr(1) << ".\n";
    if (summary.rigid)
      say << "This is in " << a.run.folder << "/" << interrupted_file << "; begin anew with more time for the rest\n";
    else
      say << "The state is saved; go on with\n  voussoir --xml=" << a.xml << " --out=" << a.run.folder
          << " --restart\n";
    return exit_interrupted;
  }
  if (summary.rigid)
    say << "Limit analysis: " << summary.message << "." << doubts(summary.warnings);
  else if (summary.outcome == Outcome::equilibrium)
    say << (summary.time > 0 ? "All stages done." : "Equilibrium under all loads.") << doubts(summary.warnings)
        << (summary.collapse ? " No collapse: " + summary.message + "." : "");
  if (summary.outcome == Outcome::collapse && !summary.rigid) {
    say << "Collapse: " << summary.message << "." << doubts(summary.warnings);  // as of joints that were not found
  }
  if (summary.outcome == Outcome::out_of_range) say << "Out of range: " << summary.message << ".";
  if (summary.outcome == Outcome::not_converged && !summary.rigid) say << "Not converged: " << summary.message << ".";
  say << " Results are in " << a.run.folder << "\n";
  if (summary.outcome == Outcome::equilibrium) return exit_done;
  const bool wanted = scene.load_steps.expect_collapse || summary.collapse;
  return summary.outcome == Outcome::collapse && wanted ? exit_done : exit_no_convergence;
}

void print(const Arguments& a) {
  if (!a.help.empty())
    std::cout << a.help;
  else if (a.version)
    std::cout << "voussoir " << version() << "\n";
  else if (!a.parameters.empty())
    a.parameters == "json" ? print_reference_as_json(std::cout) : print_reference(std::cout);
  else
    print_internals_reference(std::cout);
}

int run_program(std::vector<std::string> words) {
  const auto comm = Tpetra::getDefaultComm();
  broadcast_strings(*comm, words);  // mpirun may give each rank others
  std::ofstream nowhere;
  const bool first = comm->getRank() == 0;
  try {
    const auto a = parse(words);
    std::ostream& say = first && !a.quiet ? std::cout : nowhere;
    if (a.prints()) {
      if (first) print(a);
      return exit_done;
    }
    listen_for_stop_signals();
    end_child_processes_when(stop_wanted_here);
    end_linear_programmes_when(stop_wanted_here);
    if (a.at_most > 0) stop_within(a.at_most);
    reserve_blas_memory();
    const auto scene = read_on_all_ranks(a, *comm);
    if (scene.load_steps.at_most > 0) stop_within(scene.load_steps.at_most);
    return finish(a, scene, run(scene, a.run, comm, say), say);
  } catch (const InputError& error) {
    if (first) std::cerr << error.what() << "\n";
    return exit_input;
  } catch (const ConvergenceError& error) {
    if (first) std::cerr << error.what() << "\n";
    return exit_no_convergence;
  } catch (const ResourceError& error) {
    if (first) std::cerr << error.what() << "\n";
    return stop_wanted_here() ? exit_interrupted : exit_resource;
  } catch (...) {
    return end_unforeseen(*comm);
  }
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  before_mpi();
  int name_alone = 1;  // Kokkos would answer --help before we do
  leaks::ignore_from_here();
  Tpetra::ScopeGuard scope(&name_alone, &argv);
  leaks::watch_from_here();
  const int code = run_program({argv + 1, argv + argc});
  if (!Hdf5File::any_broken()) return leaks::found() ? EXIT_FAILURE : code;
  std::cout << std::flush;
  std::_Exit(code);
}
