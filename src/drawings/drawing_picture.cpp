// The picture of a drawing: what was drawn under what is computed with.
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "base/words.hpp"
#include "drawings/plane_stones.hpp"

namespace voussoir {
namespace {

/// Of the picture [pixels]: its longer side.
constexpr double longer_side = 1200;

class Picture {
 public:
  explicit Picture(const PlaneStones& s) : s_(s) {
    low_ = high_ = s.snapped.points[0];
    const auto see = [&](const Vector<2>& x) {
      for (std::size_t i = 0; i < 2; ++i) low_[i] = std::min(low_[i], x[i]), high_[i] = std::max(high_[i], x[i]);
    };
    for (const auto& x : s.snapped.points) see(x);
    for (const auto& stone : s.stones)
      for (const auto& x : stone.loops[0].corners) see(x);
    scale_ = longer_side / std::max({high_[0] - low_[0], high_[1] - low_[1], 1e-300});
  }

  std::string svg() {
    const double w = scale_ * (high_[0] - low_[0]) + 40, h = scale_ * (high_[1] - low_[1]) + 70;
    text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(w) + " " + number(h) + "\" width=\"" +
            number(w) + "\" height=\"" + number(h) + "\">\n<title>" + xml_escaped(title()) +
            "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    outlines();
    moves();
    names();
    text_ += "<text x=\"20\" y=\"" + number(h - 18) + "\" font-family=\"sans-serif\" font-size=\"16\">" +
             xml_escaped(title()) + "</text>\n</svg>\n";
    return std::move(text_);
  }

 private:
  static std::string number(double x) { return formatted("%.2f", x); }
  std::string at(const Vector<2>& x) const {
    return number(20 + scale_ * (x[0] - low_[0])) + "," + number(20 + scale_ * (high_[1] - x[1]));
  }
  std::string title() const {
    return counted(s_.stones.size(), "stone") + " as drawn (red) and as computed with (black); snap " +
           three_digits(s_.snap) + " m moved corners by up to " + three_digits(s_.snapped.farthest) + " m (blue)";
  }

  void outlines() {
    text_ += "<g fill=\"#e8e2d6\" fill-rule=\"evenodd\" stroke=\"black\" stroke-width=\"1.2\">\n";
    for (const auto& loops : s_.snapped.loops) {
      text_ += "<path d=\"";
      for (const auto& loop : loops) {
        text_ += "M";
        for (const int p : loop) text_ += at(s_.snapped.points[p]) + " ";
        text_ += "Z";
      }
      text_ += "\"/>\n";
    }
    text_ += "</g>\n<g fill=\"none\" stroke=\"#d02020\" stroke-width=\"0.8\">\n";
    for (const auto& stone : s_.stones)
      for (const auto& loop : stone.loops) {
        text_ += "<path d=\"M";
        for (const auto& x : loop.corners) text_ += at(x) + " ";
        text_ += "Z\"/>\n";
      }
    text_ += "</g>\n";
  }

  /// Circles where corners moved, of the radius of the way that the farthest went, large enough to be seen.
  void moves() {
    if (s_.snapped.farthest == 0) return;
    const double seen = std::max(4.0, scale_ * s_.snapped.farthest);
    text_ += "<g fill=\"none\" stroke=\"#2050d0\">\n<circle cx=\"" + split(at(s_.snapped.moved_from), ",")[0] +
             "\" cy=\"" + split(at(s_.snapped.moved_from), ",")[1] + "\" r=\"" + number(2 * seen) +
             "\" stroke-width=\"2\"/>\n</g>\n";
  }

  void names() {
    text_ += "<g font-family=\"sans-serif\" text-anchor=\"middle\" fill=\"#404040\">\n";
    for (const auto& stone : s_.stones) {
      const auto& p = stone.loops[0].corners;
      const double room = scale_ * mean_width(p);
      const std::string name = shortened(stone.name, 24);
      const double letter = std::min(room, 1.6 * room / static_cast<double>(std::max<std::size_t>(name.size(), 2)) * 2);
      const auto place = split(at(middle_of(stone)), ",");
      text_ += "<text x=\"" + place[0] + "\" y=\"" + place[1] + "\" font-size=\"" + number(std::min(16.0, letter)) +
               "\">" + xml_escaped(name) + "</text>\n";
    }
    text_ += "</g>\n";
  }

  const PlaneStones& s_;
  Vector<2> low_{}, high_{};
  double scale_ = 1;
  std::string text_;
};

}  // namespace

std::string picture_of(const PlaneStones& s) { return Picture(s).svg(); }

}  // namespace voussoir
