// GeoJSON (RFC 7946): polygons of features, in whatever plane coordinates they are.
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/text.hpp"
#include "drawings/drawing_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

using json = nlohmann::ordered_json;

/// Collections within collections: no program writes more.
constexpr int deepest_collection = 20;

class GeoJsonStones {
 public:
  explicit GeoJsonStones(const std::string& file) : file_(file) {}

  DrawnFile read(const json& root) {
    visit(root, {}, 0);
    number_namesakes();
    return std::move(drawn_);
  }

 private:
  /// Stones of one name are numbered, and are a set of that name.
  void number_namesakes() {
    std::map<std::string, int> count, number;
    for (const auto& stone : drawn_.stones) ++count[stone.name];
    for (auto& stone : drawn_.stones) {
      if (stone.name.empty() || count[stone.name] == 1) continue;
      stone.sets.push_back(stone.name);
      stone.name += " (" + std::to_string(++number[stone.name]) + ")";
    }
  }

  [[noreturn]] void refuse(const std::string& why, const std::string& advice) const {
    refuse_stones(file_, why, advice);
  }

  void visit(const json& value, const OutlinedStone& named, int depth) {
    if (depth > deepest_collection) refuse("nests collections more than 20 deep", "Export it anew");
    const std::string type = text_of(value, "type");
    if (type == "FeatureCollection" || type == "GeometryCollection") {
      const char* members = type == "FeatureCollection" ? "features" : "geometries";
      if (!value.contains(members) || !value[members].is_array())
        refuse("has a " + type + " without a list of " + members, "Export it anew");
      for (const auto& member : value[members]) visit(member, named, depth + 1);
    } else if (type == "Feature") {
      ++feature_;
      visit_feature(value, depth);
    } else if (type == "Polygon" || type == "MultiPolygon") {
      add_polygons(value, named, type == "MultiPolygon");
    } else if (type == "LineString" || type == "MultiLineString") {
      refuse(where() + " is a " + type + ", which is no closed outline",
             "Make it a Polygon, or leave it out where it is no stone");
    } else if (type == "Point" || type == "MultiPoint") {
      drawn_.unused.push_back(type + " of " + where());
    } else {
      refuse("has " + (type.empty() ? std::string("no type") : "the type " + in_quotes(type)) + " at " + where(),
             "GeoJSON has a FeatureCollection of features with Polygons (RFC 7946)");
    }
  }

  void visit_feature(const json& feature, int depth) {
    OutlinedStone stone;
    const auto properties = feature.find("properties");
    if (properties != feature.end() && properties->is_object()) {
      stone.name = text_of(*properties, "name");
      for (const char* key : {"set", "layer", "class"})
        if (const auto set = text_of(*properties, key); !set.empty()) {
          stone.sets = {set};
          break;
        }
    }
    if (stone.name.empty()) stone.name = text_of(feature, "id");
    const auto geometry = feature.find("geometry");
    if (geometry == feature.end() || !geometry->is_object()) {
      drawn_.unused.push_back(where() + " without geometry");
      return;
    }
    visit(*geometry, stone, depth + 1);
  }

  /// A member that is text or a number, as text.
  static std::string text_of(const json& object, const char* key) {
    if (!object.is_object()) return "";
    const auto found = object.find(key);
    if (found == object.end()) return "";
    if (found->is_string()) return as_utf8(found->get<std::string>());
    return found->is_number() ? found->dump() : "";
  }

  std::string where() const { return "feature " + std::to_string(feature_); }

  void add_polygons(const json& geometry, const OutlinedStone& named, bool several) {
    if (!geometry.contains("coordinates") || !geometry["coordinates"].is_array())
      refuse(where() + " has no list of coordinates", "Export it anew");
    const json& coordinates = geometry["coordinates"];
    const std::size_t count = several ? coordinates.size() : 1;
    for (std::size_t k = 0; k < count; ++k) {
      OutlinedStone stone = named;
      stone.origin = std::filesystem::path(file_).filename().string() + ", " + where();
      const json& rings = several ? coordinates[k] : coordinates;
      if (!rings.is_array() || rings.empty()) refuse(where() + " has a polygon without rings", "Export it anew");
      for (const auto& ring : rings) stone.loops.push_back(loop_of(ring));
      drawn_.stones.push_back(std::move(stone));
    }
  }

  DrawnLoop loop_of(const json& ring) const {
    DrawnLoop loop;
    if (!ring.is_array()) refuse(where() + " has a ring that is no list of positions", "Export it anew");
    for (const auto& position : ring) {
      Vector<2> x{};
      for (std::size_t i = 0; i < 2; ++i) {
        const bool there = position.is_array() && position.size() > i && position[i].is_number();
        if (!there || !std::isfinite(position[i].get<double>()))
          refuse(where() + " has no two numbers where a position is wanted (its number " +
                     std::to_string(loop.corners.size() + 1) + " in a ring)",
                 "A position is [x, y]");
        x[i] = position[i].get<double>();
      }
      loop.corners.push_back(x);
      loop.curved.push_back(0);
    }
    if (loop.corners.size() < 4 || norm(loop.corners.back() - loop.corners.front()) > 0)
      refuse(where() + " has a ring that is not closed" +
                 (loop.corners.empty() ? ""
                                       : " (it begins at " + place_of_drawing(loop.corners.front()) + " and ends at " +
                                             place_of_drawing(loop.corners.back()) + ")"),
             "End every ring with its first position again (RFC 7946, 3.1.6)");
    return loop;
  }

  std::string file_;
  int feature_ = 0;
  DrawnFile drawn_;
};

}  // namespace

DrawnFile read_geojson_stones(const std::string& file, const std::string& contents) {
  json root;
  try {
    root = json::parse(contents);
  } catch (const json::exception& error) {
    const std::string said = error.what();
    const auto from = said.find("] ");
    refuse_stones(file, "is no JSON: " + said.substr(from == std::string::npos ? 0 : from + 2), "Export it anew");
  }
  return GeoJsonStones(file).read(root);
}

}  // namespace voussoir
