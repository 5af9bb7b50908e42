#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "linalg/gather.hpp"
#include "loads/bearer.hpp"
#include "loads/common_keys.hpp"
#include "loads/facets.hpp"
#include "loads/load.hpp"

namespace voussoir {
namespace {

/// An edge of the deck from left to right, known on every rank.
struct DeckEdge {
  double x[2];      ///< [m] rising
  long long id[2];  ///< nodes
  int local[2];     ///< the same on this rank, -1 elsewhere
};

/// The same while the deck is put together.
struct EdgeOfStone {
  DeckEdge edge;
  BlockId stone;
};

constexpr double lightest_axle = 100;  // [N] of a handcart; less is kN or tonnes

// Ends of edges that meet: far above round-off, far below the length of an edge.
constexpr double meeting = 1e-9;  // of an edge

/// Every rank knows the whole deck, so that all agree on the one edge that an axle stands on.
class MovingTrain final : public Load<2> {
 public:
  MovingTrain(const MovingTrainParameters& p, const LoadSite<2>& site)
      : position_(p.position), speed_(p.speed), axle_load_(p.axle_load), behind_(p.behind) {
    const auto& s = site.structure;
    std::vector<EdgeOfStone> mine;
    for (const auto& e : edges_of_set(s, site.facet_set(p.on, p.blocks))) {
      if (e.node[0] >= s.owned_nodes() || e.x[0][0] == e.x[1][0]) continue;
      const int left = e.x[0][0] < e.x[1][0] ? 0 : 1;
      mine.push_back(
          {{{e.x[left][0], e.x[1 - left][0]}, {s.node_id()[e.node[left]], s.node_id()[e.node[1 - left]]}, {-1, -1}},
           s.blocks()[s.block_of_node()[e.node[0]]].mesh.id});
    }
    auto edges = all_gather(mine, *s.comm());
    std::sort(edges.begin(), edges.end(), [](const EdgeOfStone& a, const EdgeOfStone& b) {
      return std::make_pair(a.edge.x[0], a.edge.id[0]) < std::make_pair(b.edge.x[0], b.edge.id[0]);
    });
    std::map<BlockId, std::pair<double, double>> reach;  // of each stone along the deck [m]
    for (const auto& [edge, stone] : edges) {
      deck_.push_back(edge);
      ends_.insert(ends_.end(), {edge.x[0], edge.x[1]});
      const auto& [whole, first] = reach.try_emplace(stone, edge.x[0], edge.x[1]);
      if (!first) whole->second.second = std::max(whole->second.second, edge.x[1]);
    }
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    for (const auto& [stone, x] : reach) shortest_stone_ = std::min(shortest_stone_, x.second - x.first);
    look_for_several_stones(edges, site);
    std::map<long long, int> local;
    for (int i = 0; i < s.nodes(); ++i) local[s.node_id()[i]] = i;
    for (auto& e : deck_)
      for (int i = 0; i < 2; ++i)
        if (const auto it = local.find(e.id[i]); it != local.end()) e.local[i] = it->second;
  }

  void add(const std::vector<LoadMoment>& moments, std::vector<double>& force, std::vector<double>&) const override {
    for (const auto& [time, factor] : moments)
      for (std::size_t k = 0; k < axle_load_.size(); ++k) {
        const double x = place(k, time);
        const int below = edge_below(x);
        if (below < 0) continue;
        const DeckEdge& e = deck_[below];
        const double s = (x - e.x[0]) / (e.x[1] - e.x[0]);
        const double share[2] = {1 - s, s};
        for (int i = 0; i < 2; ++i)
          if (e.local[i] >= 0) force[2 * e.local[i] + 1] -= factor * axle_load_[k] * share[i];
      }
  }

  bool moves() const override { return speed_ != 0; }

  /// When an axle comes from one edge of the deck to the next, on to the deck or off it.
  void add_corners(double from, double to, std::vector<double>& times) const override {
    for (std::size_t k = 0; k < axle_load_.size() && moves(); ++k) {
      const auto [low, high] = std::minmax({place(k, from), place(k, to)});
      const auto begin = std::upper_bound(ends_.begin(), ends_.end(), low);
      for (auto x = begin; x != ends_.end() && *x < high; ++x) times.push_back(from + (*x - place(k, from)) / speed_);
    }
  }

  /// Half the time that an axle stands on the shortest stone, while one is on the deck.
  double resolution(double from, double to) const override {
    for (std::size_t k = 0; k < axle_load_.size() && moves() && !ends_.empty(); ++k) {
      const auto [low, high] = std::minmax({place(k, from), place(k, to)});
      if (low < ends_.back() && high > ends_.front()) return shortest_stone_ / std::abs(speed_) / 2;
    }
    return std::numeric_limits<double>::infinity();
  }

  std::size_t bytes() const override {
    return sizeof(*this) + (axle_load_.capacity() + behind_.capacity()) * sizeof(double) +
           deck_.capacity() * sizeof(DeckEdge) + ends_.capacity() * sizeof(double);
  }

  Warnings warnings() const override { return warnings_; }

 private:
  /// Where an axle is [m].
  double place(std::size_t axle, double time) const {
    return position_ + speed_ * time - (speed_ < 0 ? -1 : 1) * behind_[axle];
  }

  /// The edge an axle stands on, -1 beside the deck.
  int edge_below(double x) const {
    const auto after =
        std::upper_bound(deck_.begin(), deck_.end(), x, [](double at, const DeckEdge& e) { return at < e.x[0]; });
    if (after == deck_.begin() || x > (after - 1)->x[1]) return -1;
    return static_cast<int>(after - deck_.begin()) - 1;
  }

  /// Axles that stand on the joint of two stones, or edges above each other: which stone bears them is chosen, not
  /// said. Those that move pass joints in no time.
  void look_for_several_stones(const std::vector<EdgeOfStone>& edges, const LoadSite<2>& site) {
    const auto warn = [&](const std::string& place, const std::vector<BlockId>& stones, BlockId bearer) {
      if (warnings_.empty()) warnings_ = warning_of_bearer(site, "load_on_several_stones", place, stones, bearer);
    };
    double reached = -std::numeric_limits<double>::infinity();
    std::size_t last = 0;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto& x = edges[k].edge.x;
      if (x[0] < reached - meeting * (x[1] - x[0]))
        warn("the deck at x = " + number_text(x[0]) + " m", {edges[last].stone, edges[k].stone}, edges[k].stone);
      if (x[1] > reached) {
        reached = x[1];
        last = k;
      }
    }
    for (std::size_t k = 0; speed_ == 0 && k < behind_.size(); ++k) {
      const double x = position_ - behind_[k];
      const int below = edge_below(x);
      if (below < 0) continue;
      std::vector<BlockId> stones;
      for (const auto& [edge, stone] : edges) {
        const double beyond = meeting * (edge.x[1] - edge.x[0]);
        if (x >= edge.x[0] - beyond && x <= edge.x[1] + beyond) stones.push_back(stone);
      }
      warn("the deck below axle " + std::to_string(k + 1) + " at x = " + number_text(x) + " m", stones,
           edges[below].stone);
    }
  }

  double position_, speed_;
  std::vector<double> axle_load_, behind_;
  std::vector<DeckEdge> deck_;
  std::vector<double> ends_;                                         ///< [m] of edges of the deck, rising
  double shortest_stone_ = std::numeric_limits<double>::infinity();  ///< [m] along the deck
  Warnings warnings_;
};

}  // namespace

void MovingTrainParameters::declare(ParameterSection& section) {
  declare_facet_set(section, on, blocks);
  section.add("axle loads", axle_loads, "force of each axle [N] on the modelled thickness, downwards: \"80e3, 80e3\"",
              Presence::required, "Give a number for each axle, the first in front.");
  section.add("spacings", spacings, "distances [m] from each axle to the next: \"2.5\"");
  section.add("position", position, "m", any_number(), "x of the first axle at time 0, where static stages see it");
  section.add("speed", speed, "m/s", any_number().usually(0.001, 150),
              "along x; axles follow the first against its direction");
  const auto loads = numbers_in(axle_loads), distances = numbers_in(spacings);
  section.check(loads.has_value() && !loads->empty(), "axle loads", in_quotes(axle_loads), "must be numbers",
                "Write them like \"80e3, 80e3\"");
  const auto forwards = [](double d) { return d >= 0; };
  section.check(distances.has_value() && std::all_of(distances->begin(), distances->end(), forwards), "spacings",
                in_quotes(spacings), "must be numbers >= 0 (axles are counted from the front)",
                "Write them like \"2.5, 4\"");
  if (!loads || loads->empty() || !distances) return;
  section.check(distances->size() + 1 == loads->size(), "spacings", in_quotes(spacings),
                "must be one less than the " + std::to_string(loads->size()) + " axle loads",
                "Give the distance from each axle to the next");
  const auto weighs = [](double load) { return load == 0 || std::abs(load) >= lightest_axle; };
  section.expect(std::all_of(loads->begin(), loads->end(), weighs), "axle loads", in_quotes(axle_loads),
                 "has an axle of less than " + number_text(lightest_axle) + " N", "Are they given in newtons?");
  axle_load = *loads;
  behind.assign(1, 0.0);
  for (const double d : *distances) behind.push_back(behind.back() + d);
  behind.resize(axle_load.size());
}

std::string MovingTrainParameters::summary() const {
  return "moving train of axles " + axle_loads + " N at distances " + (spacings.empty() ? "-" : spacings) + " m on " +
         in_quotes(on) + ", first at x = " + number_text(position) + " m, speed " + number_text(speed) + " m/s";
}

std::optional<FacetsOfLoad> MovingTrainParameters::facets() const {
  FacetsOfLoad facets{on, blocks};
  facets.adds_up = true;
  facets.reaches = [](const Vector<2>& a, const Vector<2>& b) { return has_width(a, b); };
  return facets;
}

bool MovingTrainParameters::is_zero() const {
  return std::all_of(axle_load.begin(), axle_load.end(), [](double load) { return load == 0; });
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const MovingTrainParameters& p, const LoadSite<2>& site) {
  return std::make_unique<MovingTrain>(p, site);
}

}  // namespace voussoir
