// Drawings of CAD. A DXF is pairs of lines: what a value is, and the value. Read are closed polylines and circles of
// the model, on layers that are shown.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "base/text.hpp"
#include "drawings/curves.hpp"
#include "drawings/drawing_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

/// What of an entity is read, by its group codes.
enum Code {
  kind = 0,
  name = 2,
  layer = 8,
  x = 10,
  y = 20,
  radius = 40,
  bulge = 42,
  colour = 62,
  in_paper = 67,
  flags = 70
};
constexpr int header_variable = 9, extrusion_z = 230;

constexpr int closed = 1, net = 16, faces = 64, spline_frame = 16;  // of flags

/// [m] of $INSUNITS, the units of AutoCAD: inch, foot, mm, cm, m.
const std::map<int, double> units{{1, 0.0254}, {2, 0.3048}, {4, 1e-3}, {5, 1e-2}, {6, 1.0}};

struct Pair {
  int code = 0;
  std::string value;
  int line = 0;  ///< of the value
};

class DxfStones {
 public:
  DxfStones(const std::string& file, const std::string& contents) : file_(file) { read_pairs(contents); }

  DrawnFile read() {
    while (at_ < pairs_.size()) {
      const Pair begin = pairs_[at_++];
      if (begin.code != kind || begin.value != "SECTION" || at_ >= pairs_.size()) continue;
      const std::string section = pairs_[at_++].value;
      if (section == "HEADER") read_header();
      if (section == "TABLES") read_layers();
      if (section == "ENTITIES") read_entities();
    }
    for (const auto& [what, count] : unused_) drawn_.unused.push_back(std::to_string(count) + " " + what);
    add_holes();
    return std::move(drawn_);
  }

 private:
  void read_pairs(const std::string& contents) {
    if (contents.compare(0, 22, "AutoCAD Binary DXF\r\n\x1a") == 0 ||
        contents.compare(0, 18, "AutoCAD Binary DXF") == 0)
      refuse_stones(file_, "is a binary DXF", "Save it as an ASCII DXF");
    std::vector<std::string> lines;
    for (auto& text : split(contents, "\n")) lines.push_back(trimmed(text));
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    for (std::size_t k = 0; k + 1 < lines.size(); k += 2) {
      const auto code = whole_number_in(lines[k]);
      if (!code)
        refuse_stones(file_,
                      "line " + std::to_string(k + 1) + " has " + in_quotes(as_utf8(lines[k])) +
                          " where the code of a group is wanted",
                      "It is damaged, or no DXF: save it as an ASCII DXF");
      pairs_.push_back({*code, as_utf8(lines[k + 1]), static_cast<int>(k) + 2});
    }
    const bool ends = std::any_of(pairs_.begin(), pairs_.end(), [](const Pair& p) { return p.value == "ENTITIES"; });
    if (!ends) refuse_stones(file_, "has no section ENTITIES", "It is cut, or no DXF: save it as an ASCII DXF");
    if (pairs_.back().value != "EOF")
      refuse_stones(file_, "ends at line " + std::to_string(lines.size()) + " without EOF",
                    "It was cut when it was copied, or is damaged: save it anew");
  }

  /// Whether the section goes on.
  bool in_section() const {
    return at_ < pairs_.size() && !(pairs_[at_].code == kind && pairs_[at_].value == "ENDSEC");
  }

  void read_header() {
    for (; in_section(); ++at_)
      if (pairs_[at_].code == header_variable && pairs_[at_].value == "$INSUNITS" && at_ + 1 < pairs_.size())
        if (const auto found = units.find(whole_number_in(pairs_[at_ + 1].value).value_or(0)); found != units.end())
          drawn_.unit = found->second;
  }

  void read_layers() {
    while (in_section()) {
      const auto entity = next_entity();
      if (entity.front().value != "LAYER") continue;
      std::string called;
      bool hidden = false;
      for (const auto& p : entity) {
        if (p.code == name) called = p.value;
        if (p.code == flags) hidden = hidden || (whole(p) & 1) != 0;  // frozen
        if (p.code == colour) hidden = hidden || whole(p) < 0;        // off
      }
      if (hidden) hidden_.insert(called);
    }
  }

  /// The pairs from one that begins an entity to the next such.
  std::vector<Pair> next_entity() {
    std::vector<Pair> entity{pairs_[at_++]};
    while (at_ < pairs_.size() && pairs_[at_].code != kind) entity.push_back(pairs_[at_++]);
    return entity;
  }

  void read_entities() {
    while (in_section()) {
      auto entity = next_entity();
      const std::string what = entity.front().value;
      std::vector<std::vector<Pair>> vertices;
      if (what == "POLYLINE")
        while (in_section() && pairs_[at_].value == "VERTEX") vertices.push_back(next_entity());
      if (what == "SEQEND" || !is_shown(entity)) continue;
      if (what == "LWPOLYLINE" || what == "POLYLINE")
        add_polyline(entity, vertices);
      else if (what == "CIRCLE")
        add_circle(entity);
      else
        ++unused_[what];
    }
  }

  bool is_shown(const std::vector<Pair>& entity) {
    if (std::any_of(entity.begin(), entity.end(), [&](const Pair& p) { return p.code == in_paper && whole(p) == 1; }))
      return false;
    if (hidden_.count(layer_of(entity)) == 0) return true;
    ++unused_["of the hidden layer " + in_quotes(layer_of(entity))];
    return false;
  }

  static std::string layer_of(const std::vector<Pair>& entity) {
    for (const auto& p : entity)
      if (p.code == layer) return p.value;
    return "";
  }

  [[noreturn]] void refuse(const Pair& at, const std::string& why, const std::string& advice) const {
    refuse_stones(file_, "line " + std::to_string(at.line) + " " + why, advice);
  }

  double number(const Pair& p) const {
    const auto value = number_in(p.value);
    if (!value || !std::isfinite(*value))
      refuse(p, "has " + in_quotes(p.value) + " where a number is wanted", "It is damaged: save it anew");
    return *value;
  }
  int whole(const Pair& p) const {
    const auto value = whole_number_in(p.value);
    if (!value)
      refuse(p, "has " + in_quotes(p.value) + " where a whole number is wanted", "It is damaged: save it anew");
    return *value;
  }

  /// The corners of a polyline, each with the bulge of the edge behind it.
  struct Outline {
    Polygon corners;
    std::vector<double> bulges;
    int flags = 0;
    bool mirrored = false;  ///< seen from behind: x runs to the left

    void take(const DxfStones& file, const Pair& p) {
      if (p.code == x) corners.push_back({file.number(p), 0}), bulges.push_back(0);
      if (p.code == y && !corners.empty()) corners.back()[1] = file.number(p);
      if (p.code == bulge && !bulges.empty()) bulges.back() = file.number(p);
    }
  };

  void add_polyline(const std::vector<Pair>& entity, const std::vector<std::vector<Pair>>& vertices) {
    Outline outline;
    for (const auto& p : entity) {
      if (p.code == flags) outline.flags = whole(p);
      if (p.code == extrusion_z) outline.mirrored = number(p) < 0;
      if (entity.front().value == "LWPOLYLINE") outline.take(*this, p);
    }
    if ((outline.flags & (net | faces)) != 0) {
      ++unused_["meshes"];
      return;
    }
    for (const auto& vertex : vertices) {
      const bool frame = std::any_of(vertex.begin(), vertex.end(),
                                     [&](const Pair& p) { return p.code == flags && (whole(p) & spline_frame) != 0; });
      for (const auto& p : vertex)
        if (!frame) outline.take(*this, p);
    }
    add_stone(entity, loop_of(entity, outline));
  }

  DrawnLoop loop_of(const std::vector<Pair>& entity, const Outline& outline) const {
    DrawnLoop loop;
    const auto& corners = outline.corners;
    if (corners.size() < 2)
      refuse(entity.front(), "is a polyline of " + std::to_string(corners.size()) + " points", "Delete it");
    double size = 0;
    for (const auto& c : corners) size = std::max(size, norm(c - corners[0]));
    const double apart = norm(corners.back() - corners[0]);
    constexpr double same = 1e-9;  // of its size: the last point is the first one, written again
    if ((outline.flags & closed) == 0 && apart > same * size)
      refuse(entity.front(),
             "begins a polyline on layer " + in_quotes(layer_of(entity)) + " that is not closed: its ends at " +
                 place_of_drawing(corners[0]) + " and " + place_of_drawing(corners.back()) + " are " +
                 six_digits(apart) + " apart",
             "Close it, or put it on a layer that is off or frozen where it is no stone");
    loop.corners.push_back(corners[0]);
    loop.curved.push_back(0);
    const std::size_t edges = (outline.flags & closed) != 0 ? corners.size() : corners.size() - 1;
    for (std::size_t k = 0; k < edges; ++k)
      add_bulge(loop, corners[k], corners[(k + 1) % corners.size()], outline.bulges[k]);
    loop.corners.pop_back();  // the first one again
    loop.curved.pop_back();
    if (outline.mirrored)
      for (auto& c : loop.corners) c[0] = -c[0];
    return loop;
  }

  void add_circle(const std::vector<Pair>& entity) {
    Vector<2> centre{};
    double size = 0;
    for (const auto& p : entity) {
      if (p.code == x) centre[0] = number(p);
      if (p.code == y) centre[1] = number(p);
      if (p.code == radius) size = number(p);
    }
    DrawnLoop loop;
    const double turn = 2 * std::acos(-1.0);
    add_arc(loop, centre, size, 0, turn, centre + Vector<2>{size, 0});
    add_stone(entity, std::move(loop));
  }

  void add_stone(const std::vector<Pair>& entity, DrawnLoop loop) {
    OutlinedStone stone;
    const std::string on = layer_of(entity);
    stone.origin = std::filesystem::path(file_).filename().string() + ", line " + std::to_string(entity.front().line);
    if (!on.empty() && on != "0") stone.sets = {on};  // 0 is where CAD puts what has no layer
    stone.loops.push_back(std::move(loop));
    std::string word = on;
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    (word == "holes" ? holes_ : drawn_.stones).push_back(std::move(stone));
  }

  /// Outlines of the layer "holes" go to the smallest stone around them.
  void add_holes() {
    for (auto& hole : holes_) {
      OutlinedStone* holder = nullptr;
      for (auto& stone : drawn_.stones) {
        const auto& outline = stone.loops[0].corners;
        if (!holds(outline, hole.loops[0].corners[0])) continue;
        if (!holder || std::abs(area(outline)) < std::abs(area(holder->loops[0].corners))) holder = &stone;
      }
      if (!holder)
        refuse_stones(file_,
                      "has at " + place_of_drawing(middle_of(hole)) + " a hole (" + hole.origin + ") in no stone",
                      "Draw it inside the outline of its stone, or on another layer than holes");
      holder->loops.push_back(std::move(hole.loops[0]));
    }
  }

  std::string file_;
  std::vector<Pair> pairs_;
  std::size_t at_ = 0;
  std::set<std::string> hidden_;  ///< layers
  std::map<std::string, int> unused_;
  std::vector<OutlinedStone> holes_;
  DrawnFile drawn_;
};

}  // namespace

DrawnFile read_dxf_stones(const std::string& file, const std::string& contents) {
  return DxfStones(file, contents).read();
}

}  // namespace voussoir
