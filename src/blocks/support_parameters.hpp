// A support: facets of a set whose displacement is prescribed (zero, unless a settlement load moves it).
#pragma once

#include <string>

namespace voussoir {

class ParameterSection;

struct SupportParameters {
  std::string on;                  ///< a set of facets
  std::string components = "all";  ///< held components: their letters, or "all"
  std::string blocks = "";         ///< a set of blocks whose facets alone are meant; "" for all of the set
  void declare(ParameterSection&);
};

}  // namespace voussoir
