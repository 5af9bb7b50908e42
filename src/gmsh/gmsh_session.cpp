#include "gmsh/gmsh_session.hpp"

#include <gmsh.h>

#include <new>
#include <vector>

namespace voussoir {

GmshSession::GmshSession() {
  gmsh::initialize(0, nullptr, false);  // no configuration files: the same mesh for every user
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.AbortOnError", 1);  // else it throws where nobody can catch (gmsh_file.cpp)
  gmsh::logger::start();
}

GmshSession::~GmshSession() {
  gmsh::logger::stop();
  gmsh::finalize();
}

std::string GmshSession::run(const std::function<void()>& commands) {
  gmsh::logger::stop();
  gmsh::logger::start();
  gmsh::model::add("piece");
  bool failed = false;
  try {
    commands();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {  // gmsh throws strings and ints
    failed = true;
  }
  gmsh::model::remove();
  std::vector<std::string> log;
  gmsh::logger::get(log);
  for (const auto& line : log)
    if (line.compare(0, 5, "Error") == 0) return line;
  return failed ? "gmsh gives no reason" : "";
}

}  // namespace voussoir
