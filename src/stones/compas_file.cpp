// JSON of COMPAS: whatever holds meshes. A mesh is an object with "vertex" and "face"; it is a stone unless it
// belongs to what two stones share (interfaces and contacts on the edges of a graph). Boxes and polyhedra are as
// simple, and of a network of cells each is a stone; any other shape that could be a stone is refused, since a
// structure without it would be another one.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "base/text.hpp"
#include "base/words.hpp"
#include "stones/compas_places.hpp"
#include "stones/stone_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

/// What is known of an object from those around it.
struct Around {
  std::string path, name;
  std::string given;      ///< the name that an element or a mesh says it has
  bool numbered = false;  ///< `name` is a number in a list, or a key that a machine made
  bool support = false;
  bool of_compas = false;  ///< the object is the data of one that COMPAS has written
  CompasMoves moves;
  int depth = 0;
};

/// Letters of a key that a machine made, which nobody can remember.
constexpr std::size_t letters_of_guid = 36;

bool is_mesh_data(const CompasJson& value) {
  return value.is_object() && value.contains("vertex") && value.contains("face");
}

/// The data of a CellNetwork: vertices and faces that cells share, which name theirs.
bool is_cell_network(const CompasJson& value) { return is_mesh_data(value) && value.contains("cell"); }

/// Where an element of a model, of any version, keeps its geometry; nothing for what is no element, such as meshes that
/// a user has called so.
const CompasJson* geometry_of(const CompasJson& object, std::string& key) {
  const auto has = [&](const char* name) {
    const auto found = object.find(name);
    return found != object.end() && !is_mesh_data(inside_of(*found));
  };
  if (!has("transformation") && !has("frame") && !has("features") && !has("is_support")) return nullptr;
  for (const char* name : {"geometry", "_geometry", "shape"})
    if (const auto found = object.find(name); found != object.end() && found->is_structured()) {
      key = name;
      return &*found;
    }
  return nullptr;
}

/// Whether an object is a shape that could be a stone, by its class: what has no inside is none.
bool is_other_shape(const CompasJson& object) {
  static const std::set<std::string> without_inside{
      "Arc",        "Bezier",     "Circle",   "Curve",   "Ellipse",  "Frame",          "Hyperbola",   "Line",
      "Parabola",   "Plane",      "Point",    "Polygon", "Polyline", "NurbsCurve",     "Pointcloud",  "Projection",
      "Quaternion", "Reflection", "Rotation", "Scale",   "Shear",    "Transformation", "Translation", "Vector"};
  const std::string type = compas_type(object), name = compas_class(object);
  const auto ends_in = [&](const std::string& end) {
    return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  if (ends_in("Brep") || ends_in("Surface") || name == "VolMesh" || name == "CellNetwork") return true;
  const std::string module = "compas.geometry";
  return type.compare(0, module.size(), module) == 0 && without_inside.count(name) == 0;
}

class CompasReader {
 public:
  explicit CompasReader(const std::string& file) : file_(file) {}

  std::vector<StoneSurface> read(const CompasJson& root) {
    visit(root, {});
    if (stones_.empty())
      refuse_stones(file_, "holds no mesh (no object with \"vertex\" and \"face\")",
                    "Save the meshes of the stones, a list of them, an Assembly or a BlockModel by compas.json_dump");
    name_as_given();
    return std::move(stones_);
  }

 private:
  void visit(const CompasJson& value, Around around) {
    if (++around.depth > deepest_compas)
      refuse_stones(file_, "is nested more than 100 deep", "This is no file of COMPAS");
    if (value.is_array()) {
      for (std::size_t k = 0; k < value.size(); ++k) visit_child(value[k], std::to_string(k), true, around);
      return;
    }
    if (!value.is_object()) return;
    take_name(value, around);
    const std::string shape = compas_class(value);
    if (is_cell_network(value))
      add_cells(value, around);
    else if (is_mesh_data(value))
      add_mesh(value, around);
    else if (shape == "Box")
      add_box(inside_of(value), around);
    else if (shape == "Polyhedron")
      add_polyhedron(inside_of(value), around);
    else if (!is_mesh_data(inside_of(value)) && is_other_shape(value))
      refuse_shape(value, around);
    else
      visit_object(value, around);
  }

  void visit_object(const CompasJson& object, Around around) {
    if (const auto found = object.find("is_support"); found != object.end() && found->is_boolean())
      around.support = found->get<bool>();
    const auto own = moves_of(file_, object, around.path);
    around.moves.insert(around.moves.begin(), own.begin(), own.end());
    std::string key;
    if (const CompasJson* geometry = geometry_of(object, key)) {
      around.path += (around.path.empty() ? "" : " > ") + key;
      around.of_compas = true;
      return visit_wanted(*geometry, around);
    }
    if (object.contains("elements") && (object.contains("tree") || object.contains("graph")))
      return visit_elements(object, around);
    // In what COMPAS writes such members are interfaces, modifiers and shapes that change others; keys that a user
    // chose, and meshes themselves, are stones.
    const bool written = around.of_compas || object.contains("node") || object.contains("dtype");
    for (const auto& [name, child] : object.items())
      if (!(written && is_shared(name)) || is_mesh_data(inside_of(child))) visit_child(child, name, false, around);
  }

  /// Interfaces and contacts hold meshes of joints, modifiers and features shapes that are no stones.
  static bool is_shared(const std::string& key) {
    return key == "edge" || key == "interfaces" || key == "contacts" || key == "features" || key == "modifiers";
  }

  void visit_child(const CompasJson& child, const std::string& key, bool of_list, Around around) {
    if (!child.is_structured()) return;
    around.path += (around.path.empty() ? "" : " > ") + shortened(key, 20);
    around.of_compas = key == "data" || key == "value";
    // Words of the format name no stone; keys of nodes, elements and lists do.
    if (!around.of_compas && key != "block" && key != "geometry" && key != "_geometry") {
      around.name = key;
      around.given.clear();
      around.numbered = of_list || key.size() == letters_of_guid;
    }
    if (key == "block")
      visit_wanted(child, around);
    else
      visit(child, std::move(around));
  }

  /// Of an element, the outermost name counts; what nobody named is called as its class in some versions.
  static void take_name(const CompasJson& object, Around& around) {
    if (!around.given.empty()) return;
    const auto own = object.find("name"), attributes = object.find("attributes");
    if (own != object.end() && own->is_string() && *own != compas_class(object))
      around.given = own->get<std::string>();
    else if (attributes != object.end() && attributes->is_object() && attributes->contains("name") &&
             (*attributes)["name"].is_string())
      around.given = (*attributes)["name"].get<std::string>();
  }

  /// What must hold a stone, since it is the geometry of one.
  void visit_wanted(const CompasJson& geometry, const Around& around) {
    const std::size_t before = stones_.size();
    visit(geometry, around);
    if (stones_.size() == before) refuse_shape(geometry, around);
  }

  [[noreturn]] void refuse_shape(const CompasJson& shape, const Around& around) const {
    const std::string type = compas_type(shape);
    refuse_stones(file_,
                  "at " + (around.path.empty() ? "the top" : around.path) + " is " +
                      (type.empty() ? std::string("what holds no mesh") : "a shape of type " + type) +
                      ", and of shapes only meshes, boxes, polyhedra and cells of a CellNetwork are read",
                  "Make it a mesh by its to_mesh, or take it out, and save the file anew by compas.json_dump");
  }

  /// A model: its elements lie in each other as the tree says. Groups of elements and interfaces have no shape.
  void visit_elements(const CompasJson& model, const Around& around) {
    const auto parents = parents_in_tree(model);
    std::set<std::string> are_parents;
    for (const auto& [child, of_child] : parents) are_parents.insert(of_child.begin(), of_child.end());
    std::map<std::string, const CompasJson*> elements;
    for_each(model["elements"], [&](const std::string& key, const CompasJson& element) {
      elements.emplace(guid_of(key, element), &element);
    });
    const bool list = model["elements"].is_array();
    for_each(model["elements"], [&](const std::string& key, const CompasJson& element) {
      Around of_element = around;
      of_element.path += (around.path.empty() ? "" : " > ") + std::string("elements");
      const std::string own = guid_of(key, element);
      CompasMoves moves;
      if (const auto found = parents.find(own); found != parents.end())
        for (const auto& parent : found->second)
          if (const auto there = elements.find(parent); there != elements.end())
            for (const auto& move : moves_of_parent(file_, inside_of(*there->second), of_element.path + " > " + parent))
              moves.push_back(move);
      of_element.moves.insert(of_element.moves.begin(), moves.begin(), moves.end());
      const std::size_t before = stones_.size();
      visit_child(element, key, list, of_element);
      const std::string type = compas_class(element);
      const bool shapeless = are_parents.count(own) > 0 || type.find("Group") != std::string::npos ||
                             type.find("Interface") != std::string::npos;
      of_element.path += " > " + shortened(key, 20);
      if (stones_.size() == before && !shapeless) refuse_shape(element, of_element);
    });
  }

  static std::string guid_of(const std::string& key, const CompasJson& element) {
    const auto own = element.is_object() ? element.find("guid") : element.end();
    return own != element.end() && own->is_string() ? own->get<std::string>() : key;
  }

  void add_mesh(const CompasJson& mesh, const Around& around) {
    const auto usual = mesh.find("default_vertex_attributes");
    Vector<3> default_place{};
    if (usual != mesh.end() && usual->is_object())
      default_place = compas_point(file_, *usual, around.path + " > default_vertex_attributes");
    add_surface(mesh["vertex"], mesh["face"], "vertex", default_place, around);
  }

  /// Faces of no cell bound nothing and are no stones.
  void add_cells(const CompasJson& network, const Around& around) {
    const std::string path = around.path.empty() ? "the top" : around.path;
    if (!network["cell"].is_structured() || network["cell"].empty())
      refuse_stones(file_, "at " + path + " is a CellNetwork without cells",
                    "Give it cells, each a stone, or save its faces as meshes");
    const auto vertices = members_of(network["vertex"]), faces = members_of(network["face"]);
    for_each(network["cell"], [&](const std::string& key, const CompasJson& cell) {
      CompasJson mesh{{"vertex", CompasJson::object()}, {"face", CompasJson::object()}};
      if (network.contains("default_vertex_attributes"))
        mesh["default_vertex_attributes"] = network["default_vertex_attributes"];
      for (const auto& face : cell) {
        const auto found = faces.find(key_of(face));
        if (found == faces.end())
          refuse_stones(
              file_,
              "at " + path + " cell " + key + " names the face " + in_quotes(key_of(face)) + ", which is not there",
              "Save the file anew by compas.json_dump");
        mesh["face"][found->first] = *found->second;
        for (const auto& corner : *found->second)
          if (const auto at = vertices.find(key_of(corner)); at != vertices.end())
            mesh["vertex"][at->first] = *at->second;
      }
      Around of_cell = around;
      of_cell.path += (around.path.empty() ? "" : " > ") + std::string("cell > ") + key;
      of_cell.name += (around.name.empty() ? "" : " ") + std::string("cell ") + key;
      of_cell.numbered = false;
      add_mesh(mesh, of_cell);
    });
  }

  /// Of a member, as another one names it: by a number or a text.
  static std::string key_of(const CompasJson& name) { return name.is_string() ? name.get<std::string>() : name.dump(); }

  static std::map<std::string, const CompasJson*> members_of(const CompasJson& object) {
    std::map<std::string, const CompasJson*> members;
    for_each(object, [&](const std::string& key, const CompasJson& member) { members.emplace(key, &member); });
    return members;
  }

  void add_polyhedron(const CompasJson& shape, const Around& around) {
    if (!shape.is_object() || !shape.contains("vertices") || !shape.contains("faces"))
      refuse_stones(file_, "at " + around.path + " a polyhedron has no vertices and faces",
                    "Save the file anew by compas.json_dump");
    add_surface(shape["vertices"], shape["faces"], "vertices", {}, around);
  }

  /// About its frame, whose point is the middle.
  void add_box(const CompasJson& box, Around around) {
    Vector<3> half{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string key = std::string(1, static_cast<char>('x' + i)) + "size";
      half[i] = 0.5 * compas_number(file_, box.is_object() && box.contains(key) ? &box[key] : nullptr,
                                    around.path + " > " + key);
    }
    if (const auto frame = box.find("frame"); frame != box.end() && !frame->is_null())
      around.moves.insert(around.moves.begin(), move_of_frame(file_, *frame, around.path + " > frame"));
    CompasJson corners = CompasJson::array();
    for (int k = 0; k < 8; ++k)
      corners.push_back({k & 1 ? half[0] : -half[0], k & 2 ? half[1] : -half[1], k & 4 ? half[2] : -half[2]});
    const CompasJson faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    add_surface(corners, faces, "corners", {}, around);
  }

  void add_surface(const CompasJson& vertices, const CompasJson& faces, const std::string& word, const Vector<3>& usual,
                   const Around& around) {
    StoneSurface stone;
    stone.name = around.name.empty() ? stem(file_) : around.name;
    if (stone.name.size() == letters_of_guid) stone.name = std::to_string(stones_.size());
    stone.origin = std::filesystem::path(file_).filename().string() + (around.path.empty() ? "" : ", " + around.path);
    stone.support = around.support;
    std::map<std::string, int> number;
    for_each(vertices, [&](const std::string& key, const CompasJson& vertex) {
      number.emplace(key, static_cast<int>(stone.points.size()));
      const std::string path = around.path + " > " + word + " > " + key;
      stone.points.push_back(moved(compas_point(file_, vertex, path, usual), around.moves));
    });
    for_each(faces, [&](const std::string& key, const CompasJson& points) {
      std::vector<int> face;
      for (const auto& point : points) {
        const std::string name = key_of(point);
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
    if (stone.faces.empty())
      refuse_stones(file_, "at " + around.path + " is a mesh without faces", "Take it out, or give it its faces");
    stones_.push_back(std::move(stone));
    given_.push_back(around.numbered ? around.given : "");
  }

  /// Where the file has only numbers for stones, names that they say themselves take their place; one that others have
  /// too says nothing.
  void name_as_given() {
    std::map<std::string, int> times;
    for (const auto& name : given_) ++times[name];
    for (const auto& stone : stones_) ++times[stone.name];
    for (std::size_t k = 0; k < stones_.size(); ++k)
      if (!given_[k].empty() && times[given_[k]] == (given_[k] == stones_[k].name ? 2 : 1)) stones_[k].name = given_[k];
  }

  /// The members of an object, or of a list.
  template <class Visit>
  static void for_each(const CompasJson& members, Visit visit) {
    if (members.is_array())
      for (std::size_t k = 0; k < members.size(); ++k) visit(std::to_string(k), members[k]);
    else if (members.is_object())
      for (const auto& [key, value] : members.items()) visit(key, value);
  }

  std::string file_;
  std::vector<StoneSurface> stones_;
  std::vector<std::string> given_;  ///< per stone, where its own name is a number
};

/// A drawing in the plane (RFC 7946), which has another ending.
bool is_geojson(const CompasJson& root) {
  if (!root.is_object() || !root.contains("type")) return false;
  for (const auto& [type, member] : {std::pair("FeatureCollection", "features"), std::pair("Feature", "geometry"),
                                     std::pair("GeometryCollection", "geometries"), std::pair("Polygon", "coordinates"),
                                     std::pair("MultiPolygon", "coordinates")})
    if (root["type"] == type && root.contains(member)) return true;
  return false;
}

}  // namespace

std::vector<StoneSurface> read_compas(const std::string& file, const std::string& contents) {
  begin_of_text(file, contents);
  CompasJson root;
  try {
    root = CompasJson::parse(contents);
  } catch (const CompasJson::exception& error) {
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
