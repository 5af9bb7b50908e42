// Wavefront OBJ: points, and faces of them in objects and groups.
//
// A stone is an object. Programs use the groups in it for many things: layers, which have one name in all objects, the
// sides of a stone, or, where the whole file is one object, the stones. Whether a group is closed tells them apart.
#include <map>
#include <utility>

#include "base/text.hpp"
#include "base/words.hpp"
#include "stones/repair.hpp"
#include "stones/stone_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

/// The faces of one group in one object, over the points of the file.
struct ObjPiece {
  std::string object, group, origin;
  std::vector<std::vector<int>> faces;
};

using ObjPieces = std::vector<const ObjPiece*>;

class ObjReader {
 public:
  ObjReader(const std::string& file, const std::string& contents)
      : file_(file), lines_(file, contents, LineRules::obj) {}

  std::vector<StoneSurface> read() {
    while (lines_.next()) {
      const std::string& word = lines_.words()[0];
      if (word == "v")
        points_.push_back(lines_.point(1));
      else if (word == "f")
        add_face();
      else if (word == "o")
        begin(lines_.text_from(1), "");
      else if (word == "g")
        begin(object_, lines_.text_from(1));
    }
    if (pieces_.empty())
      refuse_stones(file_, "has no faces (lines that begin with f)",
                    "Export the stones as meshes, not as curves or surfaces of splines");
    return stones();
  }

 private:
  void begin(const std::string& object, const std::string& group) {
    object_ = object;
    group_ = group;
  }

  ObjPiece& current() {
    const auto [known, is_new] = numbers_.emplace(std::make_pair(object_, group_), pieces_.size());
    if (is_new) pieces_.push_back({object_, group_, lines_.place(), {}});
    return pieces_[known->second];
  }

  void add_face() {
    std::vector<int> face;
    for (std::size_t k = 1; k < lines_.words().size(); ++k) face.push_back(point_of(lines_.words()[k]));
    if (face.size() < 3) lines_.refuse("has a face of " + counted(face.size(), "point"), "A face needs three");
    current().faces.push_back(std::move(face));
  }

  /// The number of a point from "7", "7/1/3" or "-1", the last point so far.
  int point_of(const std::string& word) const {
    const auto number = whole_number_in(word.substr(0, word.find('/')));
    const int count = static_cast<int>(points_.size());
    if (!number || *number == 0 || *number > count || *number < -count)
      lines_.refuse("names the point " + in_quotes(word) + ", of " + std::to_string(count) + " that come before it",
                    "Points are counted from 1 over the whole file, with -1 for the last one");
    return *number > 0 ? *number - 1 : count + *number;
  }

  std::vector<StoneSurface> stones() const {
    std::vector<ObjPieces> objects;
    std::map<std::string, std::size_t> number;
    for (const auto& piece : pieces_) {
      const auto [known, is_new] = number.emplace(piece.object, objects.size());
      if (is_new) objects.emplace_back();
      objects[known->second].push_back(&piece);
    }
    std::vector<char> whole;
    std::map<std::string, int> times;  // that a group is a stone
    for (const auto& pieces : objects) {
      whole.push_back(is_stone(pieces, objects.size() == 1));
      for (const auto* piece : pieces) times[piece->group] += whole.back() ? 0 : 1;
    }
    std::vector<StoneSurface> all;
    for (std::size_t k = 0; k < objects.size(); ++k) {
      if (whole[k]) all.push_back(stone_of(objects[k], objects[k][0]->object));
      for (const auto* piece : objects[k])
        if (!whole[k]) all.push_back(stone_of({piece}, name_of(*piece, times[piece->group] > 1)));
    }
    return all;
  }

  /// Whether an object is one stone: none of its groups is closed, or it has one alone. Where nothing is closed, the
  /// groups of a file's only object are probably stones with faults, and these are told by their names.
  bool is_stone(const ObjPieces& pieces, bool only) const {
    if (pieces[0]->object.empty()) return false;
    if (pieces.size() == 1) return true;
    for (const auto* piece : pieces)
      if (is_closed({piece})) return false;
    return !only || is_closed(pieces);
  }

  bool is_closed(const ObjPieces& pieces) const {
    auto stone = stone_of(pieces, "");
    weld(stone);
    return !stone.faces.empty() && open_edges(stone).none();
  }

  /// Of a group that is a stone. @param several  whether groups of other objects have its name
  static std::string name_of(const ObjPiece& piece, bool several) {
    if (piece.group.empty()) return piece.object;
    return several && !piece.object.empty() ? piece.object + " " + piece.group : piece.group;
  }

  /// With the points that the faces use.
  StoneSurface stone_of(const ObjPieces& pieces, const std::string& name) const {
    StoneSurface stone;
    stone.name = name.empty() ? stem(file_) : name;
    stone.origin = pieces[0]->origin;
    std::map<int, int> number;
    for (const auto* piece : pieces)
      for (auto face : piece->faces) {
        for (int& point : face) {
          const auto [known, is_new] = number.emplace(point, static_cast<int>(stone.points.size()));
          if (is_new) stone.points.push_back(points_[point]);
          point = known->second;
        }
        stone.faces.push_back(std::move(face));
      }
    return stone;
  }

  std::string file_, object_, group_;
  StoneLines lines_;
  Places points_;
  std::vector<ObjPiece> pieces_;
  std::map<std::pair<std::string, std::string>, std::size_t> numbers_;
};

}  // namespace

std::vector<StoneSurface> read_obj(const std::string& file, const std::string& contents) {
  return ObjReader(file, contents).read();
}

}  // namespace voussoir
