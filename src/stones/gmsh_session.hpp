// gmsh from its initialisation to its end, silent, in a process of its own.
#pragma once

#include <functional>
#include <string>

#include "base/child_process.hpp"

namespace voussoir {

class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Runs commands on a model of their own; returns what gmsh says of their failure, or "".
  std::string run(const std::function<void()>& commands);
};

/// gmsh ended by itself or crashed, not for want of memory, and nobody asked it to.
struct GmshCrash {
  std::string how;
};

/// What a child answers. Throws GmshCrash, or ResourceError where memory was short or the program is to stop.
std::string in_gmsh_child(ChildWork, const std::string& request);

}  // namespace voussoir
