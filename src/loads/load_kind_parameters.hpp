// What every type of load tells a scene beside its keys.
//
// A type of load is a struct with
//   static constexpr const char* word;       the type in a scene, and the name of the effect
//   static constexpr const char* text;       one sentence for the reference
//   void declare(ParameterSection&);
//   std::string summary() const;             what stands at the head of a run
//   bool is_zero() const;                    true when it adds nothing, whatever its factor
// and, where it names any, the functions below.
#pragma once

#include <string>
#include <vector>

namespace voussoir {

class ParameterSection;

/// A set of the mesh that a load names.
struct SetOfLoad {
  std::string key, name;
  bool of_blocks = false;  ///< else of facets
};

/// A file that a load names; made absolute when the scene is read.
struct FileOfLoad {
  std::string key;
  std::string* file;
};

struct LoadKindParameters {
  std::vector<SetOfLoad> sets() const { return {}; }
  std::vector<FileOfLoad> files() { return {}; }
};

}  // namespace voussoir
