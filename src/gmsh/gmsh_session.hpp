// gmsh from its initialisation to its end, silent.
#pragma once

#include <functional>
#include <string>

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

}  // namespace voussoir
