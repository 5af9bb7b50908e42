// gmsh from its initialisation to its end, silent.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace voussoir {

class Gmsh {
 public:
  Gmsh();
  ~Gmsh();
  Gmsh(const Gmsh&) = delete;
  Gmsh& operator=(const Gmsh&) = delete;

  /// Runs commands. Returns the errors that gmsh tells, a line each; none: nothing failed.
  std::vector<std::string> run(const std::function<void()>& commands);

  /// Runs commands on a model of their own; returns the first error that gmsh tells, or "".
  std::string run_piece(const std::function<void()>& commands);
};

/// Cells as large as borders allow, but for curved faces, which are cut into 16 chords a full turn: they are off by a
/// hundredth of the radius.
void size_by_curvature();

}  // namespace voussoir
