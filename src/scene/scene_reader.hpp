// From an XML file to a validated Scene.
//
// Everything wrong with a scene is an InputError that lists up to twenty problems, each with key, value, why and what
// to do. Reading is deterministic: ranks that are given the same text agree on the scene and on the error.
#pragma once

#include <string>
#include <vector>

#include "base/input_problems.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// The content of a scene file. One rank calls it and broadcasts the text. Throws InputError when there is none.
std::string scene_text(const std::string& file);

/// @param file      path of the text, for messages and to find the file of the mesh
/// @param overrides "path=value" from the command line, such as "selection/mode=all"
Scene read_scene_from_text(const std::string& text, const std::string& file,
                           const std::vector<std::string>& overrides = {});

/// Both of the above.
Scene read_scene(const std::string& file, const std::vector<std::string>& overrides = {});

/// Throws InputError when the scene names sets of blocks or facets the mesh does not have.
void check_names(const Scene&, const std::vector<std::string>& block_sets, const std::vector<std::string>& facet_sets);

/// Files and folders that a run of a scene reads: the scene itself, its mesh, records of its loads.
std::vector<std::string> files_read(const Scene&);

/// The sets of blocks that a scene names, each once.
std::vector<std::string> block_sets_named(const Scene&);

/// What no single section can see: missing sections, stages of unknown loads, the place of the mesh file. Fills
/// Scene::warnings. Part of reading.
void check_scene(Scene&, InputProblems&);

/// What it names that the dimension of its mesh has no room for: loads, components, keys of the plane. Part of that.
void check_dimension(Scene&, InputProblems&);

}  // namespace voussoir
