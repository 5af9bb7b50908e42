#include "mesh/gmsh_failures.hpp"

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "mesh/lattice.hpp"

namespace voussoir {

void refuse_file(const std::string& file, const std::string& why, const std::string& advice) {
  refuse_mesh("gmsh > file", file, why, advice);
}

void require_file(const std::string& file) {
  const std::filesystem::path path = std::filesystem::absolute(file);
  if (!std::ifstream(path) || !std::filesystem::is_regular_file(path))
    refuse_file(file, "cannot be read (sought as " + path.string() + ").", "Correct the name or the folder.");
}

void refuse_end(const std::string& file, const ChildEnd& end) {
  using By = ChildEnd::By;
  const std::string when = end.time_and_size();
  if (end.by == By::request)
    throw ResourceError("Stopped while gmsh meshed " + file +
                        ", by a signal or because the time was over: nothing has been computed.\n  Begin again.");
  if (end.by == By::memory)
    throw ResourceError("gmsh was ended " + when + "\n  because it wanted more for " + file + " than " +
                        in_words(std::round(end.allowed / 1e8) / 10) +
                        " GB, half of what is free on this machine.\n  Give a larger element size (or the unit of the "
                        "drawing, mesh > gmsh > unit), or free memory.");
  if (end.by == By::itself)
    refuse_file(file,
                "made gmsh end by itself " + when + ", without a mesh (exit code " + std::to_string(end.number) + ").",
                "Look for Exit in the file, or in those it includes, and take it out.");
  if (end.number == SIGTERM || end.number == SIGINT || end.number == SIGHUP || end.number == SIGKILL)
    throw ResourceError("gmsh was ended by a signal (" + end.signal() + ") " + when + "\n  while it meshed " + file +
                        ": somebody sent it, or the kernel for want of memory.\n  Begin again.");
  refuse_file(file, "made gmsh crash (" + end.signal() + ") " + when + ".",
              "Open the file in gmsh itself; where it is damaged, save it anew in format 4.1.");
}

}  // namespace voussoir
