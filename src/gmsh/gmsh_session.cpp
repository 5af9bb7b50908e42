#include "gmsh/gmsh_session.hpp"

#include <gmsh.h>

#include <new>

namespace voussoir {

Gmsh::Gmsh() {
  gmsh::initialize(0, nullptr, false);  // no configuration files: the same mesh for every user
  gmsh::option::setNumber("General.Terminal", 0);
  // By default it throws where it meshes side by side, and what leaves a parallel region ends the program.
  gmsh::option::setNumber("General.AbortOnError", 1);
  gmsh::logger::start();
}

Gmsh::~Gmsh() {
  gmsh::logger::stop();
  gmsh::finalize();
}

std::vector<std::string> Gmsh::run(const std::function<void()>& commands) {
  bool failed = false;
  try {
    commands();
  } catch (const std::bad_alloc&) {  // is no fault of the input
    throw;
  } catch (...) {  // gmsh throws strings and ints; the reason is in its log
    failed = true;
  }
  std::vector<std::string> log, errors;
  gmsh::logger::get(log);
  gmsh::logger::stop();
  gmsh::logger::start();  // the next commands answer for themselves alone
  for (const auto& line : log)
    if (line.compare(0, 5, "Error") == 0) errors.push_back(line);
  if (failed && errors.empty()) errors.emplace_back("gmsh gives no reason");
  return errors;
}

std::string Gmsh::run_piece(const std::function<void()>& commands) {
  gmsh::model::add("piece");
  const auto errors = run(commands);
  gmsh::model::remove();
  return errors.empty() ? "" : errors.front();
}

void size_by_curvature() {
  constexpr double chords = 16;
  gmsh::option::setNumber("Mesh.MeshSizeMax", 1e22);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", chords);
}

}  // namespace voussoir
