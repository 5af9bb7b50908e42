// Paths of SVG 1.1, chapter 8; arcs by its appendix F.6.
#include "drawings/svg_path.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "base/rotation.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "drawings/curves.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

/// Letters and numbers, one after the other.
class Scanner {
 public:
  explicit Scanner(const std::string& text) : text_(text) {}

  bool at_end() {
    skip();
    return at_ >= text_.size();
  }
  bool at_letter() { return !at_end() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0; }
  char letter() { return text_[at_++]; }

  double number() {
    skip();
    const std::size_t begin = at_;
    if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
    digits();
    if (at_ < text_.size() && text_[at_] == '.') ++at_, digits();
    if (at_ + 1 < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      const std::size_t sign = text_[at_ + 1] == '+' || text_[at_ + 1] == '-' ? 2 : 1;
      if (at_ + sign < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_ + sign])) != 0)
        at_ += sign, digits();
    }
    const auto value = number_in(text_.substr(begin, at_ - begin));
    if (!value || !std::isfinite(*value))
      throw SvgFault{"has " + in_quotes(shortened(as_utf8(text_.substr(begin)), 20)) + " where a number is wanted"};
    return *value;
  }

  /// 0 or 1, which need no separator behind.
  bool flag() {
    skip();
    if (at_ >= text_.size() || (text_[at_] != '0' && text_[at_] != '1')) throw SvgFault{"has an arc without its flags"};
    return text_[at_++] == '1';
  }

 private:
  void skip() {
    while (at_ < text_.size() && (std::isspace(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == ','))
      ++at_;
  }
  void digits() {
    while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

class Path {
 public:
  explicit Path(const std::string& d) : in_(d) {}

  std::vector<SvgLoop> read() {
    char command = 0;
    while (!in_.at_end()) {
      if (in_.at_letter())
        command = in_.letter();
      else if (command == 0 || command == 'Z' || command == 'z')
        throw SvgFault{"has numbers where a letter of a path is wanted"};
      const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
      if (loops_.empty() && upper != 'M') throw SvgFault{"does not begin with M"};
      relative_ = command != upper;
      step(upper);
      previous_ = upper;
      if (upper == 'M') command = relative_ ? 'l' : 'L';  // what follows without a letter are lines
    }
    return std::move(loops_);
  }

 private:
  Vector<2> point() {
    const double x = in_.number(), y = in_.number();
    return relative_ ? at_ + Vector<2>{x, y} : Vector<2>{x, y};
  }
  DrawnLoop& loop() {
    if (loops_.back().closed) begin(at_);  // a path that goes on behind Z begins where the closed one did
    return loops_.back().loop;
  }
  void begin(const Vector<2>& x) {
    loops_.emplace_back();
    loops_.back().loop.corners.push_back(x);
    loops_.back().loop.curved.push_back(0);
    at_ = x;
  }
  void line_to(const Vector<2>& x) {
    DrawnLoop& to = loop();
    to.corners.push_back(x);
    to.curved.push_back(0);
    at_ = control_ = x;
  }
  void curve(const std::vector<Vector<2>>& control) {
    add_bezier(loop(), at_, control);
    control_ = control[control.size() - 2];
    at_ = control.back();
  }
  /// The control point of a smooth curve: that of the one before, turned about the point between.
  Vector<2> reflected(const std::string& commands) const {
    return commands.find(previous_) == std::string::npos ? at_ : 2.0 * at_ - control_;
  }

  void step(char command) {
    if (command == 'M') return begin(point());
    if (command == 'L') return line_to(point());
    if (command == 'H') return line_to({in_.number() + (relative_ ? at_[0] : 0), at_[1]});
    if (command == 'V') return line_to({at_[0], in_.number() + (relative_ ? at_[1] : 0)});
    if (command == 'A') return arc();
    if (command == 'Z') {
      loops_.back().closed = true;
      at_ = loops_.back().loop.corners.front();
      return;
    }
    std::vector<Vector<2>> control;
    if (command == 'S') control.push_back(reflected("CS"));
    if (command == 'T') control.push_back(reflected("QT"));
    const std::size_t wanted = command == 'C' || command == 'S' ? 3 : command == 'Q' || command == 'T' ? 2 : 0;
    if (wanted == 0) {
      const std::string letter(1, command);
      throw SvgFault{"has the letter " + in_quotes(relative_ ? in_small_letters(letter) : letter) +
                     ", which no path has"};
    }
    while (control.size() < wanted) control.push_back(point());
    curve(control);
  }

  void arc() {
    double rx = std::abs(in_.number()), ry = std::abs(in_.number());
    const double turned = in_.number() * std::acos(-1.0) / 180;
    const bool large = in_.flag(), sweep = in_.flag();
    const Vector<2> from = at_, to = point();
    if (rx == 0 || ry == 0 || norm(to - from) == 0) return line_to(to);
    const Rotation<2> back(-turned), forth(turned);
    const Vector<2> half = back(0.5 * (from - to));
    const double stretch = std::hypot(half[0] / rx, half[1] / ry);
    if (stretch > 1) rx *= stretch, ry *= stretch;
    const double a = half[0] / rx, b = half[1] / ry, squared = a * a + b * b;
    const double away = std::sqrt(std::max(0.0, 1 / squared - 1)) * (large == sweep ? -1 : 1);
    const Vector<2> unit_centre{away * b, -away * a};  // where the ellipse is a circle of radius 1
    const double first = std::atan2(b - unit_centre[1], a - unit_centre[0]);
    const double last = std::atan2(-b - unit_centre[1], -a - unit_centre[0]);
    const double turn = 2 * std::acos(-1.0);
    double angle = last - first;
    if (sweep && angle < 0) angle += turn;
    if (!sweep && angle > 0) angle -= turn;
    const Vector<2> centre = forth({rx * unit_centre[0], ry * unit_centre[1]}) + 0.5 * (from + to);
    DrawnLoop& into = loop();
    const std::size_t begin = into.corners.size();
    add_arc(into, {0, 0}, 1, first, first + angle, {0, 0});
    for (std::size_t k = begin; k < into.corners.size(); ++k)
      into.corners[k] = centre + forth({rx * into.corners[k][0], ry * into.corners[k][1]});
    into.corners.back() = to;
    at_ = control_ = to;
  }

  Scanner in_;
  std::vector<SvgLoop> loops_;
  Vector<2> at_{}, control_{};
  char previous_ = 0;
  bool relative_ = false;
};

}  // namespace

std::vector<double> svg_numbers(const std::string& text) {
  Scanner in(text);
  std::vector<double> numbers;
  while (!in.at_end()) numbers.push_back(in.number());
  return numbers;
}

std::vector<SvgLoop> loops_of_path(const std::string& d) { return Path(d).read(); }

SvgLoop loop_of_ellipse(const Vector<2>& centre, double rx, double ry) {
  SvgLoop ellipse;
  ellipse.closed = true;
  add_arc(ellipse.loop, {0, 0}, 1, 0, 2 * std::acos(-1.0), {1, 0});
  for (auto& x : ellipse.loop.corners) x = centre + Vector<2>{rx * x[0], ry * x[1]};
  ellipse.loop.curved.assign(ellipse.loop.corners.size(), 1);
  return ellipse;
}

}  // namespace voussoir
