#include "stones/compas_places.hpp"

#include <cmath>
#include <utility>

#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

const CompasJson* member(const CompasJson& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? nullptr : &*found;
}

CompasMove move_of_matrix(const std::string& file, const CompasJson& transformation, const std::string& path) {
  const CompasJson* matrix = &inside_of(transformation);
  if (const auto* inner = member(*matrix, "matrix")) matrix = inner;
  CompasMove rows{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 4; ++c) {
      const bool there = matrix->is_array() && matrix->size() > r && (*matrix)[r].is_array() && (*matrix)[r].size() > c;
      rows[r][c] = compas_number(file, there ? &(*matrix)[r][c] : nullptr, path);
    }
  return rows;
}

bool is_mesh_of_compas(const CompasJson& value) { return member(value, "vertex") && member(value, "face"); }

const CompasJson* frame_of(const CompasJson& element) {
  const auto* frame = member(element, "frame");
  return frame && member(inside_of(*frame), "xaxis") ? frame : nullptr;
}

const CompasJson* transformation_of(const CompasJson& element) {
  const auto* found = member(element, "transformation");
  return found && found->is_structured() && !is_mesh_of_compas(inside_of(*found)) ? found : nullptr;
}

void add_children(const CompasJson& node, const std::vector<std::string>& parents, int depth,
                  std::map<std::string, std::vector<std::string>>& all) {
  const auto* children = member(inside_of(node), "children");
  // What is nested more deeply is refused where the file is read.
  if (!children || !children->is_array() || depth > deepest_compas) return;
  for (const auto& child : *children) {
    auto of_child = parents;
    const auto* element = member(inside_of(child), "element");
    if (element && element->is_string()) {
      const auto guid = element->get<std::string>();
      all.emplace(guid, parents);
      of_child.insert(of_child.begin(), guid);
    }
    add_children(child, of_child, depth + 1, all);
  }
}

}  // namespace

Vector<3> moved(Vector<3> x, const CompasMoves& moves) {
  for (const auto& rows : moves) {
    const Vector<4> with_one{x[0], x[1], x[2], 1};
    x = {dot(rows[0], with_one), dot(rows[1], with_one), dot(rows[2], with_one)};
  }
  return x;
}

std::string compas_type(const CompasJson& object) {
  for (const char* key : {"dtype", "datatype"})
    if (const auto* type = member(object, key); type && type->is_string()) return type->get<std::string>();
  return "";
}

std::string compas_class(const CompasJson& object) {
  const std::string type = compas_type(object);
  return type.substr(type.find_last_of("/.") + 1);
}

const CompasJson& inside_of(const CompasJson& object) {
  for (const char* key : {"data", "value"})
    if (const auto* inside = member(object, key); inside && inside->is_structured()) return *inside;
  return object;
}

double compas_number(const std::string& file, const CompasJson* value, const std::string& path) {
  if (!value || !value->is_number() || !std::isfinite(value->get<double>()))
    refuse_stones(file, "at " + path + " a number is wanted", "Save the file anew by compas.json_dump");
  return value->get<double>();
}

Vector<3> compas_point(const std::string& file, const CompasJson& value, const std::string& path,
                       const Vector<3>& usual) {
  const CompasJson& point = inside_of(value);
  if (!point.is_structured()) compas_number(file, nullptr, path);
  Vector<3> x = usual;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string axis(1, static_cast<char>('x' + i));
    if (point.is_array())
      x[i] = compas_number(file, i < point.size() ? &point[i] : nullptr, path);
    else if (point.contains(axis))
      x[i] = compas_number(file, &point[axis], path);
  }
  return x;
}

CompasMove move_of_frame(const std::string& file, const CompasJson& frame, const std::string& path) {
  const CompasJson& inside = inside_of(frame);
  std::array<Vector<3>, 3> given{};
  const std::array<const char*, 3> keys{"point", "xaxis", "yaxis"};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto* value = member(inside, keys[k]);
    if (!value) compas_number(file, nullptr, path + " > " + keys[k]);
    given[k] = compas_point(file, *value, path + " > " + keys[k]);
  }
  const Vector<3> normal = cross(given[1], given[2]);
  // Axes along each other have no plane; 1e-9 is the sine of an angle that only round-off makes.
  if (!(norm(normal) > 1e-9 * norm(given[1]) * norm(given[2])))
    refuse_stones(file, "at " + path + " the axes of the frame lie along each other", "Correct the frame");
  const Vector<3> x = (1 / norm(given[1])) * given[1], z = (1 / norm(normal)) * normal, y = cross(z, x);
  CompasMove rows{};
  for (std::size_t r = 0; r < 3; ++r) rows[r] = {x[r], y[r], z[r], given[0][r]};
  return rows;
}

CompasMoves moves_of(const std::string& file, const CompasJson& element, const std::string& path) {
  CompasMoves moves;
  if (const auto* matrix = transformation_of(element))
    moves.push_back(move_of_matrix(file, *matrix, path + " > transformation"));
  if (const auto* frame = frame_of(element)) moves.push_back(move_of_frame(file, *frame, path + " > frame"));
  return moves;
}

CompasMoves moves_of_parent(const std::string& file, const CompasJson& element, const std::string& path) {
  if (const auto* frame = frame_of(element)) return {move_of_frame(file, *frame, path + " > frame")};
  return moves_of(file, element, path);
}

std::map<std::string, std::vector<std::string>> parents_in_tree(const CompasJson& model) {
  std::map<std::string, std::vector<std::string>> all;
  if (const auto* tree = member(model, "tree"))
    if (const auto* root = member(inside_of(*tree), "root")) add_children(*root, {}, 0, all);
  return all;
}

}  // namespace voussoir
