// Stones from the files people have: OBJ, STL, PLY, COMPAS, STEP.
#pragma once

#include <string>
#include <vector>

#include "base/warning.hpp"
#include "stones/surface.hpp"

namespace voussoir {

/// The stones of a file, or of all files of a folder in the order of their names, as they are written there.
///
/// OBJ       every object is a stone, or every closed group of an object or of a file without objects; statements of
///           one name go on with the same stone
/// STL       ascii (every solid is a stone) or binary (the file is one)
/// PLY       ascii or binary; the file is a stone
/// JSON      of COMPAS: meshes, boxes, polyhedra, cells of a CellNetwork, lists of them, an Assembly or a
///           BlockModel; each is a stone
/// STEP      every solid is a stone; the file says its unit, so that lengths are metres and `unit` is not used
///
/// Names of stones differ: one that comes in several files of a folder is that of the file instead, and what comes
/// several times all the same is numbered.
///
/// Throws InputError, naming file and line or byte, for what is no such file.
/// @param unit  [m] the length that the file calls 1, where it does not say so itself
/// @param warnings  takes what a user must know: files of a folder that are not read, names that were numbered
std::vector<StoneSurface> read_stones(const std::string& path, double unit, Warnings& warnings);
std::vector<StoneSurface> read_stones(const std::string& path, double unit);

/// Whether a file is of a kind that says its unit.
bool says_its_unit(const std::string& file);

/// The same of the contents of a file; `file` is for messages and names.
std::vector<StoneSurface> read_obj(const std::string& file, const std::string& contents);
std::vector<StoneSurface> read_stl(const std::string& file, const std::string& contents, Warnings& warnings);
std::vector<StoneSurface> read_ply(const std::string& file, const std::string& contents);
std::vector<StoneSurface> read_compas(const std::string& file, const std::string& contents);
/// By gmsh, in a process of its own, which reads the file. Plane faces are triangles between their corners; curved ones
/// are cut into chords of a sixteenth of a turn.
std::vector<StoneSurface> read_step(const std::string& file, const std::string& contents);

}  // namespace voussoir
