#include "stones/gmsh_session.hpp"

#include <gmsh.h>

#include <new>
#include <vector>

#include "base/error.hpp"

namespace voussoir {

GmshSession::GmshSession() {
  gmsh::initialize(0, nullptr, false);  // no configuration files: the same mesh for every user
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.AbortOnError", 1);  // else it throws where nobody can catch (mesh/gmsh_reader.cpp)
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

std::string in_gmsh_child(ChildWork work, const std::string& request) {
  return in_child_process(work, request, [](const ChildEnd& end) {
    if (end.by == ChildEnd::By::request) throw ResourceError("Stopped while gmsh meshed stones.\n  Begin again.");
    if (end.by == ChildEnd::By::memory)
      throw ResourceError("gmsh was ended " + end.time_and_size() +
                          "\n  because it wanted more for the stones than half of what is free on this machine.\n"
                          "  Give a larger mesh > stones > element size, or free memory.");
    throw GmshCrash{end.by == ChildEnd::By::signal ? "gmsh crashed (" + end.signal() + ")" : "gmsh ended by itself"};
  });
}

}  // namespace voussoir
