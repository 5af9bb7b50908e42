// Where the parts of a file of COMPAS lie: numbers, points, transformations and frames of its JSON, and the tree of a
// model, which nests elements.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

using CompasJson = nlohmann::ordered_json;  // stones in the order of the file

/// Nested more deeply than this no file of COMPAS is; far below what the stack of a process bears.
inline constexpr int deepest_compas = 100;

/// x -> A x + b, by rows of A with b behind them.
using CompasMove = std::array<Vector<4>, 3>;
/// Where a point of an element lies: its place in the element's own axes goes through the first, then the next.
using CompasMoves = std::vector<CompasMove>;

Vector<3> moved(Vector<3>, const CompasMoves&);

/// "compas.geometry/Box", or nothing for what COMPAS gives no type.
std::string compas_type(const CompasJson&);
/// "Box"
std::string compas_class(const CompasJson&);
/// What an object holds: its "data" ("value" of old files) where it has one, else itself.
const CompasJson& inside_of(const CompasJson&);

/// A finite number; refuses anything else, and nothing, by the path in the file.
double compas_number(const std::string& file, const CompasJson* value, const std::string& path);
/// Coordinates in a list, or by x, y and z. @param usual  those that are not written
Vector<3> compas_point(const std::string& file, const CompasJson&, const std::string& path,
                       const Vector<3>& usual = {0, 0, 0});

/// The axes of a frame, which are made orthogonal as COMPAS does it: from its own axes to those it lies in.
CompasMove move_of_frame(const std::string& file, const CompasJson& frame, const std::string& path);

/// How an element (or a model) lies in what is around it: by its transformation first, then by its frame, which older
/// versions of compas_model write. Meshes with these names are neither.
CompasMoves moves_of(const std::string& file, const CompasJson& element, const std::string& path);
/// How the children of an element lie by it: one that has a frame moves them by that alone.
CompasMoves moves_of_parent(const std::string& file, const CompasJson& element, const std::string& path);

/// Per element of a model (by guid) the guids of its parents in the tree, the innermost first.
std::map<std::string, std::vector<std::string>> parents_in_tree(const CompasJson& model);

}  // namespace voussoir
