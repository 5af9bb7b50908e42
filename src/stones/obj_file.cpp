// Wavefront OBJ: points, and faces of them in objects and groups.
#include <map>
#include <utility>

#include "base/text.hpp"
#include "base/words.hpp"
#include "stones/stone_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

class ObjReader {
 public:
  ObjReader(const std::string& file, const std::string& contents) : file_(file), lines_(file, contents) {}

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
    if (stones_.empty())
      refuse_stones(file_, "has no faces (lines that begin with f)",
                    "Export the stones as meshes, not as curves or surfaces of splines");
    for (auto& stone : stones_) keep_used_points(stone);
    return std::move(stones_);
  }

 private:
  void begin(const std::string& object, const std::string& group) {
    object_ = object;
    group_ = group;
  }

  StoneSurface& current() {
    const auto [known, is_new] = numbers_.emplace(std::make_pair(object_, group_), stones_.size());
    if (is_new) {
      stones_.emplace_back();
      const std::string name = trimmed(group_.empty() ? object_ : group_);
      stones_.back().name = name.empty() ? stem(file_) : name;
      stones_.back().origin = lines_.place();
    }
    return stones_[known->second];
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

  void keep_used_points(StoneSurface& stone) const {
    std::map<int, int> number;
    for (auto& face : stone.faces)
      for (int& point : face) {
        const auto [known, is_new] = number.emplace(point, static_cast<int>(stone.points.size()));
        if (is_new) stone.points.push_back(points_[point]);
        point = known->second;
      }
  }

  std::string file_, object_, group_;
  StoneLines lines_;
  Places points_;
  std::vector<StoneSurface> stones_;
  std::map<std::pair<std::string, std::string>, std::size_t> numbers_;
};

}  // namespace

std::vector<StoneSurface> read_obj(const std::string& file, const std::string& contents) {
  return ObjReader(file, contents).read();
}

}  // namespace voussoir
