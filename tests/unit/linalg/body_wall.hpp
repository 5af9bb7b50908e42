// Rigid bodies in a square, coupled by the springs of joints: the matrix of their motions, and parts of it on ranks.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "linalg/shared_system.hpp"
#include "unit/linalg/systems.hpp"

namespace voussoir::test {

/// Bodies of 1 m x 1 m, `wide` in a course, the lowest on the ground. Each has two motions along axes and a turn.
class BodyWall {
 public:
  static constexpr int modes = 3;
  struct Joint {
    long long below, above;  ///< bodies; below -1: the ground
    bool lies;
  };

  /// @param open   share of the joints that are open, by lot
  /// @param loose  every so many-th body has open joints only; 0: none
  /// @param used   ranks that own bodies, the first ones
  BodyWall(int wide, int high, double open = 0, int loose = 0, int used = 1 << 20)
      : wide_(wide), bodies_(static_cast<long long>(wide) * high), open_(open), loose_(loose) {
    ranks_ = std::min(everyone()->getSize(), used);
    const int rank = everyone()->getRank();
    first_ = rank < ranks_ ? start(rank) : bodies_;
    end_ = rank < ranks_ ? start(rank + 1) : bodies_;
    for (long long b = 0; b < bodies_; ++b) {
      if (b >= wide) joints_.push_back({b - wide, b, true});
      if (b < wide) joints_.push_back({-1, b, true});
      if (b % wide > 0) joints_.push_back({b - 1, b, false});
    }
    number_unknowns();
  }
  long long size() const { return modes * bodies_; }
  const Teuchos::RCP<const TpetraMap>& map() const { return map_; }
  const SharedSystem::Unknowns& unknowns() const { return unknowns_; }
  const SharedSystem::Bodies& bodies() const { return given_; }

  BodyMotions motions() const {
    BodyMotions m{modes, Teuchos::rcp(new TpetraMultiVector(map_, modes)),
                  Teuchos::rcp(new TpetraMultiVector(
                      Teuchos::rcp(new TpetraMap(Tpetra::global_size_t(bodies_), end_ - first_, 0, everyone())), 2))};
    fill(given_.rigid, *m.near_null);
    fill(given_.place, *m.coordinates);
    return m;
  }
  /// Upper triangle in this rank's numbers, of the joints whose upper body it owns.
  LocalCsr part(double scale = 1) const {
    std::map<std::pair<int, int>, double> entries;
    const int known = static_cast<int>(unknowns_.number.size());
    for (int k = 0; k < known; ++k) entries[{k, k}] = 0;
    for (const auto& joint : joints_) {
      if (joint.above < first_ || joint.above >= end_) continue;
      each_entry(joint, [&](long long row, long long column, double value) {
        const int i = local(row), j = local(column);
        if (i <= j) entries[{i, j}] += scale * value;
      });
    }
    LocalCsr part;
    auto e = entries.begin();
    for (int k = 0; k < known; ++k) {
      for (; e != entries.end() && e->first.first == k; ++e) {
        part.column.push_back(e->first.second);
        part.value.push_back(e->second);
      }
      part.start.push_back(static_cast<int>(part.column.size()));
    }
    return part;
  }
  Teuchos::RCP<TpetraMatrix> matrix() const {
    std::map<std::pair<long long, long long>, double> entries;
    for (long long k = modes * first_; k < modes * end_; ++k) entries[{k, k}] = 0;
    for (const auto& joint : joints_)
      each_entry(joint, [&](long long row, long long column, double value) {
        if (row >= modes * first_ && row < modes * end_) entries[{row, column}] += value;
      });
    auto a = Teuchos::rcp(new TpetraMatrix(map_, 5 * modes));
    for (const auto& [at, value] : entries)
      a->insertGlobalValues(at.first, Teuchos::tuple<GlobalOrdinal>(at.second), Teuchos::tuple<double>(value));
    a->fillComplete();
    return a;
  }

 private:
  long long start(int rank) const { return bodies_ * rank / ranks_; }
  double x(long long body) const { return static_cast<double>(body % wide_); }
  double y(long long body) const { return static_cast<double>(body / wide_); }
  bool is_loose(long long body) const { return loose_ > 0 && body % loose_ == loose_ / 2; }
  bool is_open(const Joint& j) const {
    return is_loose(j.below) || is_loose(j.above) || 0.5 * (1 + noise(7 * j.above + (j.lies ? 1 : 2))) < open_;
  }
  int owner(long long body) const {
    int rank = 0;
    while (body >= start(rank + 1)) ++rank;
    return rank;
  }
  int local(long long number) const {
    return static_cast<int>(std::find(unknowns_.number.begin(), unknowns_.number.end(), number) -
                            unknowns_.number.begin());
  }

  /// Two springs along each axis at each of two points of a joint; entries are there where it is open too.
  template <class Act>
  void each_entry(const Joint& joint, const Act& act) const {
    const double px = x(joint.above) - (joint.lies ? 0 : 0.5), py = y(joint.above) - (joint.lies ? 0.5 : 0);
    for (const double along : {-0.4, 0.4})
      for (const int axis : {0, 1}) {
        const double at[2] = {px + (joint.lies ? along : 0), py + (joint.lies ? 0 : along)};
        const bool normal = (axis == 1) == joint.lies;
        const double stiffness = is_open(joint) ? 0 : normal ? 1 : 0.4;
        std::vector<std::pair<long long, double>> gap;
        for (const auto& [body, sign] : {std::pair(joint.above, 1.0), std::pair(joint.below, -1.0)}) {
          if (body < 0) continue;
          gap.emplace_back(modes * body + axis, sign);
          gap.emplace_back(modes * body + 2, sign * (axis == 0 ? y(body) - at[1] : at[0] - x(body)));
        }
        for (const auto& [row, a] : gap)
          for (const auto& [column, b] : gap) act(row, column, stiffness * a * b);
      }
  }
  void number_unknowns() {
    std::set<long long> others;
    for (const auto& joint : joints_)
      if (joint.above >= first_ && joint.above < end_ && joint.below >= 0 && joint.below < first_)
        others.insert(joint.below);
    const auto add = [&](long long body) {
      for (int m = 0; m < modes; ++m) {
        unknowns_.number.push_back(modes * body + m);
        unknowns_.owner.push_back(owner(body));
      }
    };
    for (long long b = first_; b < end_; ++b) add(b);
    unknowns_.owned = static_cast<int>(unknowns_.number.size());
    for (const long long b : others) add(b);
    given_.of_a_body = modes;
    given_.rigid.resize(modes);
    given_.place.resize(2);
    const double middle = 0.5 * wide_;
    for (long long b = first_; b < end_; ++b) {
      const double motions[modes][modes] = {{1, 0, 0}, {0, 1, 0}, {middle - y(b), x(b) - middle, 1}};
      for (int c = 0; c < modes; ++c) given_.rigid[c].insert(given_.rigid[c].end(), motions[c], motions[c] + modes);
      given_.place[0].push_back(x(b));
      given_.place[1].push_back(y(b));
    }
    map_ = Teuchos::rcp(
        new TpetraMap(Tpetra::global_size_t(size()), static_cast<std::size_t>(unknowns_.owned), 0, everyone()));
  }
  static void fill(const std::vector<std::vector<double>>& columns, TpetraMultiVector& vectors) {
    auto view = vectors.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (std::size_t i = 0; i < columns[c].size(); ++i) view(i, c) = columns[c][i];
  }

  int wide_, ranks_ = 1;
  long long bodies_, first_ = 0, end_ = 0;
  double open_;
  int loose_;
  std::vector<Joint> joints_;
  SharedSystem::Unknowns unknowns_;
  SharedSystem::Bodies given_;
  Teuchos::RCP<const TpetraMap> map_;
};

}  // namespace voussoir::test
