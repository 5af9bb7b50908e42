// A support: facets of a set whose displacement is prescribed (zero, unless a settlement load moves it).
#pragma once

#include <string>

namespace voussoir {

class ParameterSection;

struct SupportParameters {
  std::string on;                  ///< a set of facets
  std::string components = "all";  ///< held components: their letters, or "all", or "normal": across each facet
  std::string blocks = "";         ///< a set of blocks whose facets alone are meant; "" for all of the set
  bool along_normal() const { return components == "normal"; }
  /// Whether component c is held, "x" = 0, "y" = 1, "z" = 2; none of them along a normal.
  bool holds(int c) const {
    return components == "all" || (!along_normal() && components.find("xyz"[c]) != std::string::npos);
  }
  void declare(ParameterSection&);
};

}  // namespace voussoir
