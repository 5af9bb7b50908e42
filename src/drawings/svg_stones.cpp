// Drawings of SVG: shapes of an XML tree, each with the transforms of those around it.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <utility>

#include "base/text.hpp"
#include "base/words.hpp"
#include "drawings/drawing_files.hpp"
#include "drawings/svg_path.hpp"
#include "drawings/transform.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

/// Groups within groups: no program writes more, and far less than the stack bears.
constexpr int deepest_group = 100;

Transform transform_of(const std::string& word, const std::vector<double>& n) {
  const auto at = [&](std::size_t k, double otherwise) { return k < n.size() ? n[k] : otherwise; };
  if (word == "matrix" && n.size() == 6) return {n[0], n[1], n[2], n[3], n[4], n[5]};
  if (word == "translate" && !n.empty()) return Transform::moved(n[0], at(1, 0));
  if (word == "scale" && !n.empty()) return Transform::scaled(n[0], at(1, n[0]));
  if (word == "rotate" && !n.empty()) {
    const auto to = Transform::moved(at(1, 0), at(2, 0)), back = Transform::moved(-at(1, 0), -at(2, 0));
    return to.after(Transform::turned(n[0]).after(back));
  }
  if (word == "skewX" && n.size() == 1) return {1, 0, std::tan(n[0] * std::acos(-1.0) / 180), 1, 0, 0};
  if (word == "skewY" && n.size() == 1) return {1, std::tan(n[0] * std::acos(-1.0) / 180), 0, 1, 0, 0};
  throw SvgFault{"has the transform " + in_quotes(shortened(as_utf8(word), 20)) + " with " +
                 counted(n.size(), "number") + ", which is none"};
}

/// "translate(1, 2) scale(3)", the last one first.
Transform transform_in(const std::string& text) {
  Transform all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('(', at), close = text.find(')', at);
    if (open == std::string::npos || close == std::string::npos || close < open) {
      if (text.find_first_not_of(" ,\t\r\n", at) == std::string::npos) break;
      throw SvgFault{"has a transform whose brackets do not close"};
    }
    std::string word = text.substr(at, open - at);
    word.erase(0, std::min(word.find_first_not_of(" ,\t\r\n"), word.size()));
    all = all.after(transform_of(trimmed(word), svg_numbers(text.substr(open + 1, close - open - 1))));
    at = close + 1;
  }
  return all;
}

/// What an element has from those around it.
struct Around {
  Transform transform;
  std::vector<std::string> sets;
  int depth = 0;
  std::string used_as{};    ///< name of what a `use` draws, of those around it too; empty where one has none
  bool used = false;        ///< within a `use`
  bool used_whole = false;  ///< which draws one shape
};

class SvgStones {
 public:
  SvgStones(const std::string& file, const std::string& contents) : file_(file), contents_(contents) {}

  DrawnFile read() {
    pugi::xml_document document;
    const auto result = document.load_buffer(contents_.data(), contents_.size());
    if (!result)
      refuse_stones(file_, "is no XML: line " + std::to_string(line_at(result.offset)) + ": " + result.description(),
                    "It was cut when it was copied, or is damaged: save it anew");
    const auto root = document.document_element();
    if (std::strcmp(local(root.name()), "svg") != 0)
      refuse_stones(file_, "has the root element " + in_quotes(as_utf8(root.name())) + ", which is no svg",
                    "Save the drawing as plain SVG");
    note_ids(root);
    visit(root, {});
    for (const auto& [what, count] : unused_) drawn_.unused.push_back(std::to_string(count) + " " + what);
    return std::move(drawn_);
  }

 private:
  static const char* local(const char* name) {
    const char* colon = std::strchr(name, ':');
    return colon ? colon + 1 : name;
  }
  long line_at(std::ptrdiff_t offset) const {
    const auto end =
        contents_.begin() + std::min<std::ptrdiff_t>(std::max<std::ptrdiff_t>(offset, 0), contents_.size());
    return 1 + std::count(contents_.begin(), end, '\n');
  }

  void visit(const pugi::xml_node& element, Around around) {
    if (++around.depth > deepest_group) refuse_stones(file_, "nests groups more than 100 deep", "Save it anew");
    const std::string what = local(element.name());
    if (hides(element)) {
      if (what != "defs") ++unused_["hidden " + what];
      return;
    }
    try {
      around.transform = around.transform.after(transform_in(element.attribute("transform").value()));
      for (const auto& set : sets_of(element)) around.sets.push_back(set);
      if (what == "svg" || what == "g" || what == "a" || what == "switch") {
        for (const auto& child : element.children())
          if (child.type() == pugi::node_element) visit(child, around);
      } else if (what == "use") {
        use(element, around);
      } else if (is_shape(what)) {
        add_stone(element, around, loops_of(what, element));
      } else if (!is_description(what)) {
        ++unused_[as_utf8(what)];
      }
    } catch (const SvgFault& fault) {
      refuse(element, fault.why,
             "Close outlines by Z, hide what is no stone (display: none), and save the drawing as plain SVG");
    }
  }

  void note_ids(const pugi::xml_node& element) {
    if (const std::string id = element.attribute("id").value(); !id.empty()) by_id_.emplace(id, element);
    for (const auto& child : element.children())
      if (child.type() == pugi::node_element) note_ids(child);
  }

  /// What is drawn elsewhere once more: moved, with the classes of both. A symbol is a group that is drawn here alone.
  void use(const pugi::xml_node& element, Around around) {
    std::string link = element.attribute("href").value();
    if (link.empty()) link = element.attribute("xlink:href").value();
    const auto found = link.size() > 1 && link[0] == '#' ? by_id_.find(link.substr(1)) : by_id_.end();
    if (found == by_id_.end())
      throw SvgFault{"uses " + in_quotes(as_utf8(link)) + ", which is nothing of this drawing"};
    if (++copies_ > most_copies) throw SvgFault{"is the copy of more than 100000 that are drawn"};
    const auto& drawn = found->second;
    const std::string what = local(drawn.name());
    if ((what == "symbol" || what == "svg") && drawn.attribute("viewBox"))
      throw SvgFault{"uses a " + what + " with a viewBox, whose scale depends on the page"};
    around.transform = around.transform.after(Transform::moved(length(element, "x"), length(element, "y")));
    const std::string name = as_utf8(element.attribute("id").value());
    const bool named = !name.empty() && (!around.used || !around.used_as.empty());
    around.used_as = !named ? "" : around.used_as.empty() ? name : around.used_as + " " + name;
    around.used = true;
    around.used_whole = is_shape(what);
    if (what != "symbol") return visit(drawn, around);
    for (const auto& child : drawn.children())
      if (child.type() == pugi::node_element) visit(child, around);
  }

  static bool hides(const pugi::xml_node& element) {
    std::string style = element.attribute("style").value();
    style.erase(std::remove(style.begin(), style.end(), ' '), style.end());
    return std::strcmp(element.attribute("display").value(), "none") == 0 ||
           style.find("display:none") != std::string::npos;
  }
  static bool is_shape(const std::string& what) {
    for (const char* shape : {"path", "polygon", "polyline", "line", "rect", "circle", "ellipse"})
      if (what == shape) return true;
    return false;
  }
  static bool is_description(const std::string& what) {
    for (const char* word : {"defs", "symbol", "title", "desc", "metadata", "namedview", "style", "script"})
      if (what == word) return true;
    return false;
  }

  /// Words of class, and the name of a layer of Inkscape.
  static std::vector<std::string> sets_of(const pugi::xml_node& element) {
    std::vector<std::string> sets;
    for (const auto& word : split(trimmed(element.attribute("class").value()), " "))
      if (!word.empty()) sets.push_back(as_utf8(word));
    if (std::strcmp(element.attribute("inkscape:groupmode").value(), "layer") == 0)
      if (const std::string label = as_utf8(element.attribute("inkscape:label").value()); !label.empty())
        sets.push_back(label);
    return sets;
  }

  static double length(const pugi::xml_node& element, const char* key) {
    const std::string text = trimmed(element.attribute(key).value());
    if (text.empty()) return 0;
    const auto value = number_in(
        text.size() > 2 && text.compare(text.size() - 2, 2, "px") == 0 ? text.substr(0, text.size() - 2) : text);
    if (!value || !std::isfinite(*value))
      throw SvgFault{std::string("has ") + key + " = " + in_quotes(as_utf8(text)) +
                     ", which is no number of the drawing's own units"};
    return *value;
  }

  static SvgLoop polyline(const std::string& points, bool closed) {
    const auto numbers = svg_numbers(points);
    if (numbers.size() % 2 != 0) throw SvgFault{"has an odd number of coordinates"};
    SvgLoop loop;
    loop.closed = closed;
    for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) loop.loop.corners.push_back({numbers[k], numbers[k + 1]});
    loop.loop.curved.assign(loop.loop.corners.size(), 0);
    return loop;
  }

  std::vector<SvgLoop> loops_of(const std::string& what, const pugi::xml_node& e) const {
    if (what == "path") return loops_of_path(e.attribute("d").value());
    if (what == "polygon" || what == "polyline") return {polyline(e.attribute("points").value(), what == "polygon")};
    if (what == "line") throw SvgFault{"is a line, which is no closed outline"};
    if (what == "rect") {
      if (length(e, "rx") > 0 || length(e, "ry") > 0) throw SvgFault{"is a rect with round corners"};
      const double x = length(e, "x"), y = length(e, "y"), w = length(e, "width"), h = length(e, "height");
      SvgLoop loop;
      loop.closed = true;
      loop.loop.corners = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
      loop.loop.curved.assign(4, 0);
      return {loop};
    }
    const bool circle = what == "circle";
    return {loop_of_ellipse({length(e, "cx"), length(e, "cy")}, length(e, circle ? "r" : "rx"),
                            length(e, circle ? "r" : "ry"))};
  }

  /// The id; of what a `use` draws once more the id of that, behind which stands its own where a group was drawn: a
  /// stone has a name of its own. None where that would not be one.
  static std::string name_of(const pugi::xml_node& element, const Around& around) {
    const std::string own = as_utf8(element.attribute("id").value());
    if (!around.used) return own;
    if (around.used_as.empty() || around.used_whole) return around.used_as;
    return own.empty() ? "" : around.used_as + " " + own;
  }

  void add_stone(const pugi::xml_node& element, const Around& around, std::vector<SvgLoop> loops) {
    OutlinedStone named;
    named.name = name_of(element, around);
    named.origin =
        std::filesystem::path(file_).filename().string() + ", line " + std::to_string(line_at(element.offset_debug()));
    named.sets = around.sets;
    std::vector<DrawnLoop> outlines;
    for (auto& [loop, closed] : loops) {
      for (auto& x : loop.corners) x = around.transform(x);
      if (loop.corners.size() < 2) continue;  // a point that the pen was moved to
      double size = 0;
      for (const auto& x : loop.corners) size = std::max(size, norm(x - loop.corners[0]));
      const double apart = norm(loop.corners.back() - loop.corners[0]);
      if (!closed && apart > 1e-9 * size)
        throw SvgFault{"is not closed: its ends at " + place_of_drawing(loop.corners[0]) + " and " +
                       place_of_drawing(loop.corners.back()) + " are " + six_digits(apart) + " apart"};
      outlines.push_back(std::move(loop));
    }
    if (outlines.empty()) throw SvgFault{"has no outline"};
    for (auto& stone : stones_of_loops(named, std::move(outlines))) drawn_.stones.push_back(std::move(stone));
  }

  [[noreturn]] void refuse(const pugi::xml_node& element, const std::string& why, const std::string& advice) const {
    const std::string id = element.attribute("id").value();
    refuse_stones(file_,
                  "line " + std::to_string(line_at(element.offset_debug())) + ": the " + as_utf8(element.name()) + " " +
                      (id.empty() ? "without id" : in_quotes(as_utf8(id))) + " " + why,
                  advice);
  }

  std::string file_;
  const std::string& contents_;
  std::map<std::string, int> unused_;
  std::map<std::string, pugi::xml_node> by_id_;
  int copies_ = 0;
  DrawnFile drawn_;
};

}  // namespace

DrawnFile read_svg_stones(const std::string& file, const std::string& contents) {
  return SvgStones(file, contents).read();
}

}  // namespace voussoir
