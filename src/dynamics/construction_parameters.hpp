// When blocks are there: built in one stage, taken away in another.
#pragma once

#include <string>

namespace voussoir {

class ParameterSection;

/// Blocks of a set are there from the beginning of one stage to the beginning of another.
struct ConstructionParameters {
  std::string blocks;      ///< a set of blocks
  std::string appears;     ///< stage that begins with them; empty: there from the start
  std::string disappears;  ///< stage that begins without them; empty: never
  void declare(ParameterSection&);
};

}  // namespace voussoir
