// JSON of COMPAS: whatever holds meshes. A mesh is an object with "vertex" and "face"; it is a stone unless it
// belongs to what two stones share (interfaces and contacts on the edges of a graph).
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/text.hpp"
#include "base/words.hpp"
#include "stones/stone_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

using json = nlohmann::ordered_json;  // stones in the order of the file

/// Where a point of an element lies: its place in the element's own axes goes through the first, then the next.
using Moves = std::vector<std::array<Vector<4>, 3>>;

/// What is known of an object from those around it.
struct Around {
  std::string path, name;
  bool support = false;
  Moves moves;
  int depth = 0;
};

/// Nested more deeply than this no file of COMPAS is; far below what the stack of a process bears.
constexpr int deepest = 100;

/// Letters of a key that a machine made, which nobody can remember.
constexpr std::size_t guid = 36;

class CompasReader {
 public:
  explicit CompasReader(const std::string& file) : file_(file) {}

  std::vector<StoneSurface> read(const json& root) {
    visit(root, {});
    if (stones_.empty())
      refuse_stones(file_, "holds no mesh (no object with \"vertex\" and \"face\")",
                    "Save the meshes of the stones, a list of them, an Assembly or a BlockModel by compas.json_dump");
    return std::move(stones_);
  }

 private:
  void visit(const json& value, Around around) {
    if (++around.depth > deepest) refuse_stones(file_, "is nested more than 100 deep", "This is no file of COMPAS");
    if (value.is_array()) {
      for (std::size_t k = 0; k < value.size(); ++k) visit_child(value[k], std::to_string(k), around);
    } else if (value.is_object() && value.contains("vertex") && value.contains("face")) {
      add_mesh(value, around);
    } else if (value.is_object()) {
      look_around(value, around);
      for (const auto& [key, child] : value.items())
        if (!is_shared(key)) visit_child(child, key, around);
    }
  }

  /// Interfaces and contacts hold meshes of joints, modifiers and features shapes that are no stones.
  static bool is_shared(const std::string& key) {
    return key == "edge" || key == "interfaces" || key == "contacts" || key == "features" || key == "modifiers";
  }

  void visit_child(const json& child, const std::string& key, Around around) {
    if (!child.is_structured()) return;
    around.path += (around.path.empty() ? "" : " > ") + shortened(key, 20);
    // Words of the format name no stone; keys of nodes, elements and lists do.
    if (key != "data" && key != "value" && key != "block" && key != "geometry" && key != "_geometry") around.name = key;
    visit(child, std::move(around));
  }

  void look_around(const json& object, Around& around) const {
    if (const auto found = object.find("is_support"); found != object.end() && found->is_boolean())
      around.support = found->get<bool>();
    const auto move = object.find("transformation");
    if (move == object.end() || !move->is_object() || !object.contains("geometry")) return;
    const json* matrix = &*move;
    for (const char* key : {"data", "matrix"})
      if (matrix->is_object() && matrix->contains(key)) matrix = &(*matrix)[key];
    std::array<Vector<4>, 3> rows{};
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 4; ++c) {
        const bool there =
            matrix->is_array() && matrix->size() > r && (*matrix)[r].is_array() && (*matrix)[r].size() > c;
        rows[r][c] = number_at(there ? &(*matrix)[r][c] : nullptr, around.path + " > transformation");
      }
    around.moves.insert(around.moves.begin(), rows);
  }

  double number_at(const json* value, const std::string& path) const {
    if (!value || !value->is_number() || !std::isfinite(value->get<double>()))
      refuse_stones(file_, "at " + path + " a number is wanted", "Save the file anew by compas.json_dump");
    return value->get<double>();
  }

  void add_mesh(const json& mesh, const Around& around) {
    StoneSurface stone;
    stone.name = around.name.empty() ? stem(file_) : around.name;
    if (stone.name.size() == guid) stone.name = std::to_string(stones_.size());
    stone.origin = std::filesystem::path(file_).filename().string() + (around.path.empty() ? "" : ", " + around.path);
    stone.support = around.support;
    std::map<std::string, int> number;
    const auto add_point = [&](const std::string& key, const json& vertex) {
      number.emplace(key, static_cast<int>(stone.points.size()));
      stone.points.push_back(moved(place_of(vertex, around.path + " > vertex > " + key), around.moves));
    };
    for_each(mesh["vertex"], add_point);
    for_each(mesh["face"], [&](const std::string& key, const json& points) {
      std::vector<int> face;
      for (const auto& point : points) {
        const std::string name = point.is_string() ? point.get<std::string>() : point.dump();
        const auto found = number.find(name);
        if (found == number.end())
          refuse_stones(
              file_,
              "at " + around.path + " face " + key + " names the vertex " + in_quotes(name) + ", which is not there",
              "Save the file anew by compas.json_dump");
        face.push_back(found->second);
      }
      if (face.size() < 3)
        refuse_stones(file_,
                      "at " + around.path + " face " + key + " has " + counted(face.size(), "vertex", "vertices"),
                      "A face needs three");
      stone.faces.push_back(std::move(face));
    });
    if (!stone.faces.empty()) stones_.push_back(std::move(stone));
  }

  /// The members of an object, or of a list.
  template <class Visit>
  static void for_each(const json& members, Visit visit) {
    if (members.is_array())
      for (std::size_t k = 0; k < members.size(); ++k) visit(std::to_string(k), members[k]);
    else if (members.is_object())
      for (const auto& [key, value] : members.items()) visit(key, value);
  }

  /// Coordinates that equal the default, zero, need not be written.
  Vector<3> place_of(const json& vertex, const std::string& path) const {
    Vector<3> x{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (vertex.is_array()) {
        x[i] = number_at(i < vertex.size() ? &vertex[i] : nullptr, path);
      } else if (vertex.is_object()) {
        const auto found = vertex.find(std::string(1, static_cast<char>('x' + i)));
        if (found != vertex.end()) x[i] = number_at(&*found, path);
      } else {
        number_at(nullptr, path);
      }
    }
    return x;
  }

  static Vector<3> moved(Vector<3> x, const Moves& moves) {
    for (const auto& rows : moves) {
      const Vector<4> with_one{x[0], x[1], x[2], 1};
      x = {dot(rows[0], with_one), dot(rows[1], with_one), dot(rows[2], with_one)};
    }
    return x;
  }

  std::string file_;
  std::vector<StoneSurface> stones_;
};

/// A drawing in the plane (RFC 7946), which has another ending.
bool is_geojson(const json& root) {
  if (!root.is_object() || !root.contains("type")) return false;
  for (const auto& [type, member] : {std::pair("FeatureCollection", "features"), std::pair("Feature", "geometry"),
                                     std::pair("GeometryCollection", "geometries"), std::pair("Polygon", "coordinates"),
                                     std::pair("MultiPolygon", "coordinates")})
    if (root["type"] == type && root.contains(member)) return true;
  return false;
}

}  // namespace

std::vector<StoneSurface> read_compas(const std::string& file, const std::string& contents) {
  json root;
  try {
    root = json::parse(contents);
  } catch (const json::exception& error) {
    const std::string said = error.what();
    refuse_stones(file, "is no JSON: " + said.substr(said.find("] ") == std::string::npos ? 0 : said.find("] ") + 2),
                  "It was cut when it was copied, or is damaged: save it anew by compas.json_dump");
  }
  if (is_geojson(root))
    refuse_stones(file,
                  "is GeoJSON, a drawing in the plane, where the ending .json stands for stones of COMPAS in space",
                  "Give it the ending .geojson");
  return CompasReader(file).read(root);
}

}  // namespace voussoir
