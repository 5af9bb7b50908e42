// What a run that is taken up again may find changed in its scene, and what not.
//
// Everything a scene says is compared, key by key as its modules declare it, so a key that is new is compared too. What
// lies behind the run must be as it was: the structure, the stages that have begun with the loads that act in them, the
// times and blocks of these stages, places that are observed. All else may change, and the run says what did.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "scene/scene_values.hpp"

namespace voussoir {

/// How far a run has come in the stages of its scene.
struct Passed {
  std::size_t stages = 0;  ///< that are over
  bool in_stage = false;   ///< stands within the next one
  bool searching = false;  ///< for a load factor, after the last one
  std::size_t begun() const { return stages + in_stage; }
};

/// Loads that have acted: that have a factor in stages that have begun, or are raised by a search that has.
std::set<std::string> loads_at_work(const Scene&, const Passed&);

/// Names of sets of blocks and of facets on which what lies behind a run depends: materials, joints, supports, and what
/// loads that have acted name.
struct SetsAtWork {
  std::set<std::string> of_blocks, of_facets;
};
SetsAtWork sets_at_work(const Scene&, const Passed&);

/// Compares a scene with what a checkpoint was made with. Throws InputError that names every key that must not change.
/// @param path  of the checkpoint
/// @return what else has changed, a line for each key or new member
std::vector<std::string> scene_changes(const SceneValues& before, const SceneValues& now, const Scene&, const Passed&,
                                       const std::string& path);

}  // namespace voussoir
