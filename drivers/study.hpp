// What the studies share: their command line, their picture, their exit codes.
#pragma once

#include <Tpetra_Core.hpp>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "base/before_mpi.hpp"
#include "base/error.hpp"
#include "base/heap.hpp"
#include "base/leaks.hpp"
#include "linalg/agree.hpp"
#include "linalg/fail_together.hpp"

namespace voussoir {

/// A word as the shell takes it for one.
inline std::string quoted(const std::string& word) {
  std::string text = "'";
  for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Python draws in a process of its own; a study without a picture is still a study.
/// @param script  "none" for no picture
inline void draw_picture(const std::string& script, const std::string& folder) {
  if (script == "none") return;
  const std::string command = "/usr/bin/python3 -B " + quoted(script) + " " + quoted(folder);
  std::cout << std::flush;
  if (std::system(command.c_str()) != 0)
    std::cerr << "The picture could not be drawn. The results are complete; draw them with\n  " << command << "\n";
}

/// The main program around a study; returns its exit code.
/// @param study  is given the words of the command line, the ranks, and where rank 0 narrates
inline int run_study(int argc, char** argv,
                     const std::function<void(const std::vector<std::string>&,
                                              const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream&)>& study) {
  before_mpi();
  keep_freed_memory();
  int name_alone = 1;  // Kokkos would answer --help before we do
  leaks::ignore_from_here();
  Tpetra::ScopeGuard scope(&name_alone, &argv);
  leaks::watch_from_here();
  const auto comm = Tpetra::getDefaultComm();
  std::ofstream nowhere;
  const bool first = comm->getRank() == 0;
  const auto failed = [first](const std::exception& error, int code) {
    if (first) std::cerr << error.what() << "\n";
    return code;
  };
  try {
    std::vector<std::string> words(argv + 1, argv + argc);
    broadcast_strings(*comm, words);  // mpirun may give each rank others
    study(words, comm, first ? std::cout : nowhere);
    return leaks::found() ? EXIT_FAILURE : exit_done;
  } catch (const InputError& error) {
    return failed(error, exit_input);
  } catch (const ConvergenceError& error) {
    return failed(error, exit_no_convergence);
  } catch (const ResourceError& error) {
    return failed(error, exit_resource);
  } catch (...) {
    return end_unforeseen(*comm);
  }
}

}  // namespace voussoir
