// What every type of load tells a scene beside its keys.
//
// A type of load is a struct with
//   static constexpr const char* word;       the type in a scene, and the name of the effect
//   static constexpr const char* text;       one sentence for the reference
//   void declare(ParameterSection&);
//   std::string summary() const;             what stands at the head of a run
//   bool is_zero() const;                    true when it adds nothing, whatever its factor
// and, where it names any, what is below.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/rotation_parameters.hpp"
#include "base/tensor.hpp"

namespace voussoir {

class ParameterSection;

/// A set of the mesh that a load names.
struct SetOfLoad {
  std::string key, name;
  bool of_blocks = false;  ///< else of facets
};

/// Facets that a load acts on.
struct FacetsOfLoad {
  std::string on, blocks;
  /// Whether forces on the two sides of a joint add up, so that one load would act twice; else they balance.
  bool adds_up = false;
  /// Whether the load acts on a facet at all, by the corners of the box around it [m]: along x, across (nothing in the
  /// plane) and upwards. An upright facet has no extent along x.
  std::function<bool(const Vector<3>& low, const Vector<3>& high)> reaches = [](const auto&, const auto&) {
    return true;
  };
};

/// A file that a load names; made absolute when the scene is read.
struct FileOfLoad {
  std::string key;
  std::string* file;
};

struct LoadKindParameters {
  std::vector<SetOfLoad> sets() const { return {}; }
  std::vector<FileOfLoad> files() { return {}; }
  std::optional<FacetsOfLoad> facets() const { return {}; }
  /// What a scene gives it that means something in space alone.
  std::vector<KeyOfSpace> keys_of_space() const { return {}; }

 protected:
  /// The sets of a load on facets.
  static std::vector<SetOfLoad> sets_of(const std::string& on, const std::string& blocks) {
    if (blocks.empty()) return {{"on", on}};
    return {{"on", on}, {"blocks", blocks, true}};
  }
};

}  // namespace voussoir
