// Drawings of CAD. A DXF is pairs of lines: what a value is, and the value. Read are closed polylines and circles of
// the model, on layers that are shown, and those of blocks where these are inserted.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "base/text.hpp"
#include "base/words.hpp"
#include "drawings/curves.hpp"
#include "drawings/drawing_files.hpp"
#include "drawings/dxf_text.hpp"
#include "drawings/transform.hpp"
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
/// Of an INSERT beside its name and place.
constexpr int x_scale = 41, y_scale = 42, turn_of_insert = 50, columns = 70, rows = 71, column_width = 44,
              row_height = 45;

constexpr int closed_flag = 1, net_flag = 16, faces_flag = 64, spline_frame_flag = 16, external_flag = 4;  // of flags

/// Blocks within blocks: no program writes more.
constexpr int deepest_block = 20;

/// [m] of $INSUNITS, the units of AutoCAD: inch, foot, mm, cm, m.
const std::map<int, double> units{{1, 0.0254}, {2, 0.3048}, {4, 1e-3}, {5, 1e-2}, {6, 1.0}};

/// What is drawn, and of a polyline in space its corners.
struct Entity {
  std::vector<DxfPair> pairs;
  std::vector<std::vector<DxfPair>> vertices{};
  const std::string& what() const { return pairs.front().value; }
};

struct DrawnBlock {
  Vector<2> base{};
  bool elsewhere = false;  ///< in another file
  std::vector<Entity> entities;
};

/// Where a block puts what it holds; of the drawing itself where it is drawn.
struct Placed {
  Transform transform;
  std::string layer{};                ///< of what is on layer 0 of the block
  std::vector<std::string> blocks{};  ///< around it
  std::string inserted{};             ///< for messages
};

class DxfStones {
 public:
  DxfStones(const std::string& file, const std::string& contents) : file_(file), text_(file, contents) {}

  DrawnFile read() {
    while (at_ < text_.pairs().size()) {
      const DxfPair begin = text_.pairs()[at_++];
      if (begin.code != kind || begin.value != "SECTION" || at_ >= text_.pairs().size()) continue;
      const std::string section = text_.pairs()[at_++].value;
      if (section == "HEADER") read_header();
      if (section == "TABLES") read_layers();
      if (section == "BLOCKS") read_blocks();
      if (section == "ENTITIES") read_entities();
    }
    for (const auto& [what, count] : unused_) drawn_.unused.push_back(std::to_string(count) + " " + what);
    add_holes();
    return std::move(drawn_);
  }

 private:
  /// Whether the section goes on.
  bool in_section() const {
    return at_ < text_.pairs().size() && !(text_.pairs()[at_].code == kind && text_.pairs()[at_].value == "ENDSEC");
  }

  void read_header() {
    for (; in_section(); ++at_)
      if (text_.pairs()[at_].code == header_variable && text_.pairs()[at_].value == "$INSUNITS" &&
          at_ + 1 < text_.pairs().size())
        if (const auto found = units.find(whole_number_in(text_.pairs()[at_ + 1].value).value_or(0));
            found != units.end())
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
  std::vector<DxfPair> next_entity() {
    std::vector<DxfPair> entity{text_.pairs()[at_++]};
    while (at_ < text_.pairs().size() && text_.pairs()[at_].code != kind) entity.push_back(text_.pairs()[at_++]);
    return entity;
  }

  Entity read_entity() {
    Entity entity{next_entity()};
    if (entity.what() == "POLYLINE")
      while (in_section() && text_.pairs()[at_].value == "VERTEX") entity.vertices.push_back(next_entity());
    return entity;
  }

  void read_entities() {
    while (in_section()) add(read_entity(), {});
  }

  void read_blocks() {
    DrawnBlock* block = nullptr;
    while (in_section()) {
      auto entity = read_entity();
      if (entity.what() == "BLOCK") {
        block = &blocks_[in_small_letters(value_of(entity.pairs, name))];
        for (const auto& p : entity.pairs) {
          if (p.code == x) block->base[0] = number(p);
          if (p.code == y) block->base[1] = number(p);
          if (p.code == flags) block->elsewhere = (whole(p) & external_flag) != 0;
        }
      } else if (entity.what() == "ENDBLK") {
        block = nullptr;
      } else if (block) {
        block->entities.push_back(std::move(entity));
      }
    }
  }

  void add(const Entity& entity, const Placed& placed) {
    const auto& what = entity.what();
    if (what == "SEQEND" || !is_shown(entity.pairs, placed)) return;
    if (what == "LWPOLYLINE" || what == "POLYLINE")
      add_polyline(entity.pairs, entity.vertices, placed);
    else if (what == "CIRCLE")
      add_circle(entity.pairs, placed);
    else if (what == "INSERT")
      insert(entity.pairs, placed);
    else
      ++unused_[what];
  }

  /// The entities of a block as often as it is inserted: in rows and columns, scaled, turned and moved.
  void insert(const std::vector<DxfPair>& entity, const Placed& placed) {
    const auto called = value_of(entity, name);
    const auto found = blocks_.find(in_small_letters(called));
    const auto the_block = "inserts the block " + in_quotes(called);
    if (found == blocks_.end())
      refuse(entity.front(), the_block + ", which the file does not hold", "Save it anew, or delete it");
    const auto& block = found->second;
    if (block.elsewhere)
      refuse(entity.front(), the_block + ", which is in another file", "Bind it to the drawing (in CAD by XREF, Bind)");
    if (placed.blocks.size() >= deepest_block)
      refuse(entity.front(), the_block + " in blocks more than 20 deep", "Explode what holds itself");
    Vector<2> at{}, scale{1, 1}, apart{};
    double angle = 0, side = 1;
    int across = 1, up = 1;
    for (const auto& p : entity) {
      if (p.code == x) at[0] = number(p);
      if (p.code == y) at[1] = number(p);
      if (p.code == x_scale) scale[0] = number(p);
      if (p.code == y_scale) scale[1] = number(p);
      if (p.code == turn_of_insert) angle = number(p);
      if (p.code == columns) across = std::max(1, whole(p));
      if (p.code == rows) up = std::max(1, whole(p));
      if (p.code == column_width) apart[0] = number(p);
      if (p.code == row_height) apart[1] = number(p);
      if (p.code == extrusion_z && number(p) < 0) side = -1;  // seen from behind: x runs to the left
    }
    if (static_cast<long long>(across) * up > most_copies ||
        (copies_ += static_cast<long long>(across) * up) > most_copies)
      refuse(entity.front(), the_block + " more than 100000 times", "Give the stones alone");
    Placed inside{{},
                  layer_of(entity, placed),
                  placed.blocks,
                  " in the block " + in_quotes(called) + " of line " + std::to_string(entity.front().line)};
    inside.blocks.push_back(called);
    const auto outer = placed.transform.after(Transform::scaled(side, 1))
                           .after(Transform::moved(at[0], at[1]).after(Transform::turned(angle)));
    const auto inner = Transform::scaled(scale[0], scale[1]).after(Transform::moved(-block.base[0], -block.base[1]));
    for (int row = 0; row < up; ++row)
      for (int column = 0; column < across; ++column) {
        inside.transform = outer.after(Transform::moved(column * apart[0], row * apart[1])).after(inner);
        for (const auto& one : block.entities) add(one, inside);
      }
  }

  bool is_shown(const std::vector<DxfPair>& entity, const Placed& placed) {
    if (std::any_of(entity.begin(), entity.end(),
                    [&](const DxfPair& p) { return p.code == in_paper && whole(p) == 1; }))
      return false;
    const auto on = layer_of(entity, placed);
    if (hidden_.count(on) == 0) return true;
    ++unused_["of the hidden layer " + in_quotes(on)];
    return false;
  }

  static std::string value_of(const std::vector<DxfPair>& entity, int code) {
    for (const auto& p : entity)
      if (p.code == code) return p.value;
    return "";
  }

  /// What a block holds on layer 0 is on that on which it is inserted.
  static std::string layer_of(const std::vector<DxfPair>& entity, const Placed& placed) {
    const auto own = value_of(entity, layer);
    return (own.empty() || own == "0") && !placed.layer.empty() ? placed.layer : own;
  }
  [[noreturn]] void refuse(const DxfPair& at, const std::string& why, const std::string& advice) const {
    text_.refuse(at, why, advice);
  }
  double number(const DxfPair& p) const { return text_.number(p); }
  int whole(const DxfPair& p) const { return text_.whole(p); }

  /// The corners of a polyline, each with the bulge of the edge behind it.
  struct Outline {
    Polygon corners;
    std::vector<double> bulges;
    int flags = 0;
    bool mirrored = false;  ///< seen from behind: x runs to the left

    void take(const DxfStones& file, const DxfPair& p) {
      if (p.code == x) corners.push_back({file.number(p), 0}), bulges.push_back(0);
      if (p.code == y && !corners.empty()) corners.back()[1] = file.number(p);
      if (p.code == bulge && !bulges.empty()) bulges.back() = file.number(p);
    }
  };

  void add_polyline(const std::vector<DxfPair>& entity, const std::vector<std::vector<DxfPair>>& vertices,
                    const Placed& placed) {
    Outline outline;
    for (const auto& p : entity) {
      if (p.code == flags) outline.flags = whole(p);
      if (p.code == extrusion_z) outline.mirrored = number(p) < 0;
      if (entity.front().value == "LWPOLYLINE") outline.take(*this, p);
    }
    if ((outline.flags & (net_flag | faces_flag)) != 0) {
      ++unused_["meshes"];
      return;
    }
    for (const auto& vertex : vertices) {
      const bool frame = std::any_of(vertex.begin(), vertex.end(), [&](const DxfPair& p) {
        return p.code == flags && (whole(p) & spline_frame_flag) != 0;
      });
      for (const auto& p : vertex)
        if (!frame) outline.take(*this, p);
    }
    add_stone(entity, loop_of(entity, outline, placed), placed);
  }

  DrawnLoop loop_of(const std::vector<DxfPair>& entity, const Outline& outline, const Placed& placed) const {
    DrawnLoop loop;
    const auto& corners = outline.corners;
    if (corners.size() < 2) refuse(entity.front(), "is a polyline of " + counted(corners.size(), "point"), "Delete it");
    double size = 0;
    for (const auto& c : corners) size = std::max(size, norm(c - corners[0]));
    const double apart = norm(corners.back() - corners[0]);
    constexpr double same = 1e-9;  // of its size: the last point is the first one, written again
    if ((outline.flags & closed_flag) == 0 && apart > same * size)
      refuse(entity.front(),
             "begins a polyline on layer " + in_quotes(layer_of(entity, placed)) + " that is not closed: its ends at " +
                 place_of_drawing(corners[0]) + " and " + place_of_drawing(corners.back()) + " are " +
                 six_digits(apart) + " apart",
             "Close it, or put it on a layer that is off or frozen where it is no stone");
    loop.corners.push_back(corners[0]);
    loop.curved.push_back(0);
    const std::size_t edges = (outline.flags & closed_flag) != 0 ? corners.size() : corners.size() - 1;
    for (std::size_t k = 0; k < edges; ++k)
      add_bulge(loop, corners[k], corners[(k + 1) % corners.size()], outline.bulges[k]);
    loop.corners.pop_back();  // the first one again
    loop.curved.pop_back();
    if (outline.mirrored)
      for (auto& c : loop.corners) c[0] = -c[0];
    return loop;
  }

  void add_circle(const std::vector<DxfPair>& entity, const Placed& placed) {
    Vector<2> centre{};
    double size = 0;
    for (const auto& p : entity) {
      if (p.code == x) centre[0] = number(p);
      if (p.code == y) centre[1] = number(p);
      if (p.code == radius) size = number(p);
    }
    DrawnLoop loop;
    add_arc(loop, centre, size, 0, 2 * std::acos(-1.0), centre + Vector<2>{size, 0});
    add_stone(entity, std::move(loop), placed);
  }

  void add_stone(const std::vector<DxfPair>& entity, DrawnLoop loop, const Placed& placed) {
    OutlinedStone stone;
    const auto on = layer_of(entity, placed);
    stone.origin = std::filesystem::path(file_).filename().string() + ", line " + std::to_string(entity.front().line) +
                   placed.inserted;
    if (!on.empty() && on != "0") stone.sets = {on};  // 0 is where CAD puts what has no layer
    for (const auto& block : placed.blocks)
      if (block[0] != '*' && std::count(stone.sets.begin(), stone.sets.end(), block) == 0) stone.sets.push_back(block);
    if (!placed.blocks.empty())
      for (auto& corner : loop.corners) corner = placed.transform(corner);
    stone.loops.push_back(std::move(loop));
    (in_small_letters(on) == "holes" ? holes_ : drawn_.stones).push_back(std::move(stone));
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
  const DxfText text_;
  std::size_t at_ = 0;
  std::set<std::string> hidden_;              ///< layers
  std::map<std::string, DrawnBlock> blocks_;  ///< by name in small letters
  long long copies_ = 0;
  std::map<std::string, int> unused_;
  std::vector<OutlinedStone> holes_;
  DrawnFile drawn_;
};

}  // namespace

DrawnFile read_dxf_stones(const std::string& file, const std::string& contents) {
  return DxfStones(file, contents).read();
}

}  // namespace voussoir
