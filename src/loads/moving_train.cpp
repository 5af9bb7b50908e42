#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "loads/bearer.hpp"
#include "loads/common_keys.hpp"
#include "loads/deck.hpp"
#include "loads/facets.hpp"
#include "loads/load.hpp"

namespace voussoir {
namespace {

constexpr double lightest_axle = 100;  // [N] of a handcart; less is kN or tonnes

// Ends of edges that meet: far above round-off, far below the length of an edge.
constexpr double meeting = 1e-9;  // of an edge

/// A line of wheels and the deck below it. Every rank knows the whole deck, so that all agree on the one piece that a
/// wheel stands on.
template <int dim>
class LineOfWheels {
 public:
  /// @param load  [N] of each axle on this line
  LineOfWheels(const MovingTrainParameters& p, const LoadSite<dim>& site, double across, std::vector<double> load)
      : position_(p.position), speed_(p.speed), load_(std::move(load)), behind_(p.behind) {
    auto deck = pieces_of_deck(site.structure, site.facet_set(p.on, p.blocks), across);
    deck_ = std::move(deck.pieces);
    std::map<BlockId, std::pair<double, double>> reach;  // of each stone along the deck [m]
    for (const auto& piece : deck_) {
      ends_.insert(ends_.end(), piece.x.begin(), piece.x.end());
      const auto& [whole, first] = reach.try_emplace(piece.stone, piece.x[0], piece.x[1]);
      if (!first) whole->second.second = std::max(whole->second.second, piece.x[1]);
    }
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    for (const auto& [stone, x] : reach) shortest_stone_ = std::min(shortest_stone_, x.second - x.first);
    look_for_several_stones(site, deck.other_hand);
  }

  void add(const std::vector<LoadMoment>& moments, BlockForces& force) const {
    for (const auto& [time, factor] : moments)
      for (std::size_t k = 0; k < load_.size(); ++k) {
        const double x = place(k, time);
        const int below = piece_below(x);
        if (below < 0) continue;
        const DeckPiece& piece = deck_[below];
        const double s = (x - piece.x[0]) / (piece.x[1] - piece.x[0]);
        Vector<dim> down{};
        down[dim - 1] = -factor * load_[k];
        piece.local.template add<dim>((1 - s) * piece.share[0] + s * piece.share[1], down, force);
      }
  }

  /// When a wheel comes from one piece of the deck to the next, on to the deck or off it.
  void add_corners(double from, double to, std::vector<double>& times) const {
    for (std::size_t k = 0; k < load_.size() && speed_ != 0; ++k) {
      const auto [low, high] = std::minmax({place(k, from), place(k, to)});
      const auto begin = std::upper_bound(ends_.begin(), ends_.end(), low);
      for (auto x = begin; x != ends_.end() && *x < high; ++x) times.push_back(from + (*x - place(k, from)) / speed_);
    }
  }

  /// Half the time that a wheel stands on the shortest stone, while one is on the deck.
  double resolution(double from, double to) const {
    for (std::size_t k = 0; k < load_.size() && speed_ != 0 && !ends_.empty(); ++k) {
      const auto [low, high] = std::minmax({place(k, from), place(k, to)});
      if (low < ends_.back() && high > ends_.front()) return shortest_stone_ / std::abs(speed_) / 2;
    }
    return std::numeric_limits<double>::infinity();
  }

  std::size_t bytes() const {
    return (load_.capacity() + behind_.capacity() + ends_.capacity()) * sizeof(double) +
           deck_.capacity() * sizeof(DeckPiece);
  }
  const Warnings& warnings() const { return warnings_; }
  bool has_deck() const { return !deck_.empty(); }

 private:
  /// Where an axle is [m].
  double place(std::size_t axle, double time) const {
    return position_ + speed_ * time - (speed_ < 0 ? -1 : 1) * behind_[axle];
  }

  /// The piece a wheel stands on, -1 beside the deck.
  int piece_below(double x) const {
    const auto after =
        std::upper_bound(deck_.begin(), deck_.end(), x, [](double at, const DeckPiece& e) { return at < e.x[0]; });
    if (after == deck_.begin() || x > (after - 1)->x[1]) return -1;
    return static_cast<int>(after - deck_.begin()) - 1;
  }

  /// Axles that stand on the joint of two stones or go along it, or pieces above each other: which stone bears them is
  /// chosen, not said. Those that move pass joints across their way in no time.
  /// @param other_hand  pieces beside those of the deck where the line runs along facets
  void look_for_several_stones(const LoadSite<dim>& site, const std::vector<DeckPiece>& other_hand) {
    const auto warn = [&](const std::string& place, const std::vector<BlockId>& stones, BlockId bearer) {
      if (warnings_.empty()) warnings_ = warning_of_bearer(site, "load_on_several_stones", place, stones, bearer);
    };
    double reached = -std::numeric_limits<double>::infinity();
    std::size_t last = 0;
    for (std::size_t k = 0; k < deck_.size(); ++k) {
      const auto& x = deck_[k].x;
      if (x[0] < reached - meeting * (x[1] - x[0]))
        warn("the deck at x = " + number_text(x[0]) + " m", {deck_[last].stone, deck_[k].stone}, deck_[k].stone);
      if (x[1] > reached) {
        reached = x[1];
        last = k;
      }
    }
    for (const auto& beside : other_hand) {
      const double middle = (beside.x[0] + beside.x[1]) / 2;
      const int along = piece_below(middle);
      if (speed_ != 0 && along >= 0 && deck_[along].stone != beside.stone)
        warn("the way of a wheel at x = " + number_text(middle) + " m", {deck_[along].stone, beside.stone},
             deck_[along].stone);
    }
    for (std::size_t k = 0; speed_ == 0 && k < behind_.size(); ++k) {
      const double x = position_ - behind_[k];
      const int below = piece_below(x);
      if (below < 0) continue;
      std::vector<BlockId> stones;
      for (const auto* pieces : {&std::as_const(deck_), &other_hand})
        for (const auto& piece : *pieces) {
          const double beyond = meeting * (piece.x[1] - piece.x[0]);
          if (x >= piece.x[0] - beyond && x <= piece.x[1] + beyond) stones.push_back(piece.stone);
        }
      warn("the deck below axle " + std::to_string(k + 1) + " at x = " + number_text(x) + " m", stones,
           deck_[below].stone);
    }
  }

  double position_, speed_;
  std::vector<double> load_, behind_;
  std::vector<DeckPiece> deck_;
  std::vector<double> ends_;                                         ///< [m] of pieces of the deck, rising
  double shortest_stone_ = std::numeric_limits<double>::infinity();  ///< [m] along the deck
  Warnings warnings_;
};

/// In the plane one line of wheels; in space two, a gauge apart, that share the load of each axle, or one.
template <int dim>
class MovingTrain final : public Load<dim> {
 public:
  MovingTrain(const MovingTrainParameters& p, const LoadSite<dim>& site) : moves_(p.speed != 0) {
    const int lines = dim == 3 && p.gauge > 0 ? 2 : 1;
    auto load = p.axle_load;
    for (double& axle : load) axle /= lines;
    for (int line = 0; line < lines; ++line) {
      const double across = p.y + (lines == 1 ? 0.0 : (line - 0.5) * p.gauge);
      wheels_.emplace_back(p, site, across, load);
      if (dim == 3 && !wheels_.back().has_deck())
        throw InputError(site.where + " > y = " + number_text(p.y) + " [m], gauge = " + number_text(p.gauge) +
                         " [m]\n  put wheels at y = " + number_text(across) + " m, where " + in_quotes(p.on) +
                         " has no facet below them.\n  Give the y of the middle of the track on the deck.");
    }
  }

  void add(const std::vector<LoadMoment>& moments, BlockForces& force, std::vector<double>&) const override {
    for (const auto& line : wheels_) line.add(moments, force);
  }
  bool moves() const override { return moves_; }
  void add_corners(double from, double to, std::vector<double>& times) const override {
    for (const auto& line : wheels_) line.add_corners(from, to, times);
  }
  double resolution(double from, double to) const override {
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& line : wheels_) shortest = std::min(shortest, line.resolution(from, to));
    return shortest;
  }
  std::size_t bytes() const override {
    std::size_t bytes = sizeof(*this);
    for (const auto& line : wheels_) bytes += line.bytes();
    return bytes;
  }
  Warnings warnings() const override {
    Warnings all;
    for (const auto& line : wheels_) all.insert(all.end(), line.warnings().begin(), line.warnings().end());
    return all;
  }

 private:
  bool moves_;
  std::vector<LineOfWheels<dim>> wheels_;
};

}  // namespace

void MovingTrainParameters::declare(ParameterSection& section) {
  declare_facet_set(section, on, blocks);
  section.add("axle loads", axle_loads,
              "force of each axle [N], downwards, in the plane on the modelled thickness: \"80e3, 80e3\"",
              Presence::required, "Give a number for each axle, the first in front.");
  section.add("spacings", spacings, "distances [m] from each axle to the next: \"2.5\"");
  section.add("position", position, "m", any_number(), "x of the first axle at time 0, where static stages see it");
  section.add("speed", speed, "m/s", any_number().usually(0.001, 150),
              "along x; axles follow the first against its direction");
  section.add("y", y, "m", any_number(), "of the middle of the track in space");
  section.add("gauge", gauge, "m", at_least(0.0).usually(0.5, 5), "between the two wheels of an axle in space; 0: one",
              "a distance", "Railways have 1.435, lorries 2.");
  const auto loads = numbers_in(axle_loads), distances = numbers_in(spacings);
  section.check(loads.has_value() && !loads->empty(), "axle loads", in_quotes(axle_loads), "must be numbers",
                "Write them like \"80e3, 80e3\"");
  const auto forwards = [](double d) { return d >= 0; };
  section.check(distances.has_value() && std::all_of(distances->begin(), distances->end(), forwards), "spacings",
                in_quotes(spacings), "must be numbers >= 0 (axles are counted from the front)",
                "Write them like \"2.5, 4\"");
  if (!loads || loads->empty() || !distances) return;
  section.check(distances->size() + 1 == loads->size(), "spacings", in_quotes(spacings),
                "must be one less than the " + counted(loads->size(), "axle load"),
                "Give the distance from each axle to the next");
  const auto weighs = [](double load) { return load == 0 || std::abs(load) >= lightest_axle; };
  section.expect(std::all_of(loads->begin(), loads->end(), weighs), "axle loads", in_quotes(axle_loads),
                 "has an axle of less than " + number_text(lightest_axle) + " N", "Are they given in newtons?");
  axle_load = *loads;
  behind.assign(1, 0.0);
  for (const double d : *distances) behind.push_back(behind.back() + d);
  behind.resize(axle_load.size());
}

std::vector<KeyOfSpace> MovingTrainParameters::keys_of_space() const {
  std::vector<KeyOfSpace> keys;
  add_if_given(keys, "y", y, "m");
  add_if_given(keys, "gauge", gauge, "m");
  return keys;
}

std::string MovingTrainParameters::summary() const {
  return "moving train of axles " + axle_loads + " N at distances " + (spacings.empty() ? "-" : spacings) + " m on " +
         in_quotes(on) + ", first at x = " + number_text(position) + " m, speed " + number_text(speed) + " m/s" +
         (keys_of_space().empty() ? ""
                                  : ", on a track of " + number_text(gauge) + " m about y = " + number_text(y) + " m");
}

std::optional<FacetsOfLoad> MovingTrainParameters::facets() const {
  FacetsOfLoad facets{on, blocks};
  facets.adds_up = true;
  facets.reaches = [](const Vector<3>& low, const Vector<3>& high) {
    return has_width({low[0], low[2]}, {high[0], high[2]});
  };
  return facets;
}

bool MovingTrainParameters::is_zero() const {
  return std::all_of(axle_load.begin(), axle_load.end(), [](double load) { return load == 0; });
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const MovingTrainParameters& p, const LoadSite<2>& site) {
  return std::make_unique<MovingTrain<2>>(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const MovingTrainParameters& p, const LoadSite<3>& site) {
  return std::make_unique<MovingTrain<3>>(p, site);
}

}  // namespace voussoir
