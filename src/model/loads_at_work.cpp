#include "model/loads_at_work.hpp"

#include <Teuchos_Time.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "linalg/reduce.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

/// Points and weights of Gauss on (0, 1), exact to the seventh degree: of a factor that goes linearly times a piece of
/// a sine, of a load that moves linearly, or of both.
constexpr std::array<std::array<double, 2>, 4> gauss{{{0.069431844202973712, 0.17392742256872693},
                                                      {0.33000947820757187, 0.32607257743127307},
                                                      {0.66999052179242813, 0.32607257743127307},
                                                      {0.93056815579702629, 0.17392742256872693}}};
// In a step with more pieces of sines than this they cancel to less than a ten thousandth: the rest is not looked at.
constexpr double most_pieces = 65536;

double factor_of(const std::map<std::string, double>& factors, const std::string& load) {
  const auto it = factors.find(load);
  return it == factors.end() ? 0.0 : it->second;
}

}  // namespace

template <int dim>
LoadsAtWork::LoadsAtWork(const Scene& scene, const BlockSource<dim>& source, const Structure<dim>& structure) {
  std::vector<std::pair<std::string, SupportParameters>> supports;
  for (const auto& support : scene.supports) supports.emplace_back(support.name, support.parameters);
  for (const auto& p : scene.loads) {
    const std::string where = scene.file + ": scene > loads > " + p.name;
    const Teuchos::Time clock("load", true);
    Named made{p.name, p.word(), TimeFunction(p.time_function, where, *structure.comm()), nullptr};
    made.load = make_load(p, LoadSite<dim>{structure, source, supports, where});
    made.seconds = clock.totalElapsedTime(true);
    loads_.push_back(std::move(made));
  }
}

void LoadsAtWork::add(const std::map<std::string, double>& factors, double time, BlockForces& force,
                      std::vector<double>& prescribed) const {
  VOUSSOIR_EXPECT(force.of_nodes.size() == prescribed.size() && "force and prescribed displacement: of one structure");
  for (const auto& n : loads_) {
    const auto it = factors.find(n.name);
    if (it == factors.end() || it->second == 0) continue;
    const Teuchos::Time clock("load", true);
    const double factor = it->second * n.time_function(time);
    if (factor != 0) n.load->add({{time, factor}}, force, prescribed);
    ++n.calls;
    n.seconds += clock.totalElapsedTime(true);
  }
}

bool LoadsAtWork::act(std::size_t load, const std::map<std::string, double>& factors, double time, const BlockSystem& s,
                      ActingLoad& acting) const {
  const Named& n = loads_[load];
  acting.name = n.name;
  acting.type = n.word;
  acting.factor = factor_of(factors, n.name) * n.time_function(time);
  acting.of_stones = n.load->of_stones();
  if (acting.factor == 0) return false;
  acting.force = BlockForces(s);
  acting.prescribed.assign(acting.force.of_nodes.size(), 0.0);
  n.load->add({{time, acting.factor}}, acting.force, acting.prescribed);
  return true;
}

/// The moments whose weighted sum is the mean of a load over a step: Gauss's points between the corners of its time
/// function and of its own motion.
std::vector<LoadMoment> LoadsAtWork::moments_of(const Named& n, double begin, double end, double from,
                                                double to) const {
  const double middle = (from + to) / 2;
  if (n.time_function.constant() && !n.load->moves()) return {{middle, (begin + end) / 2}};
  std::vector<double> corners{from, to};
  n.time_function.add_corners(from, to, corners);
  n.load->add_corners(from, to, corners);
  std::sort(corners.begin(), corners.end());
  std::vector<LoadMoment> moments;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const double whole = corners[k] - corners[k - 1];
    const double count = std::clamp(std::ceil(whole / n.time_function.smooth()), 1.0, most_pieces),
                 piece = whole / count;
    for (int i = 0; i < static_cast<int>(count) && piece > 0; ++i)
      for (const auto& [at, weight] : gauss) {
        const double time = corners[k - 1] + (i + at) * piece, share = (time - from) / (to - from);
        const double factor = (begin + share * (end - begin)) * n.time_function(time) * weight * piece / (to - from);
        if (factor != 0) moments.push_back({time, factor});
      }
  }
  return moments;
}

void LoadsAtWork::add_mean(const StepInTime& step, BlockForces& force) const {
  VOUSSOIR_EXPECT(step.from < step.to && "times of a step: ascending");
  VOUSSOIR_EXPECT(std::isfinite(step.from) && std::isfinite(step.to) && "times of a step: finite");
  std::vector<double> unused(force.of_nodes.size(), 0.0);  // supports go to where they are at the end of the step
  for (const auto& n : loads_) {
    const double begin = factor_of(step.begin, n.name), end = factor_of(step.end, n.name);
    if (begin == 0 && end == 0) continue;
    const Teuchos::Time clock("load", true);
    const auto moments = moments_of(n, begin, end, step.from, step.to);
    if (!moments.empty()) n.load->add(moments, force, unused);
    ++n.calls;
    n.seconds += clock.totalElapsedTime(true);
  }
}

std::vector<double> LoadsAtWork::turning(const StepInTime& step, const BlockSystem& s) const {
  VOUSSOIR_EXPECT(step.from <= step.to && "times of a step: ascending");
  const auto acts = [&](const Named& n) {
    return factor_of(step.begin, n.name) != 0 || factor_of(step.end, n.name) != 0;
  };
  const auto turns = [&](const Named& n) { return acts(n) && (n.load->strains() || s.edges() > 0); };
  if (std::none_of(loads_.begin(), loads_.end(), turns)) return {};
  BlockForces within(s);
  std::vector<double> unused(within.of_nodes.size(), 0.0);
  for (const auto& n : loads_) {
    if (!turns(n)) continue;
    BlockForces force(s);
    const double begin = factor_of(step.begin, n.name), end = factor_of(step.end, n.name);
    if (step.from < step.to)
      n.load->add(moments_of(n, begin, end, step.from, step.to), force, unused);
    else
      n.load->add({{step.to, end * n.time_function(step.to)}}, force, unused);
    for (std::size_t i = 0; n.load->strains() && i < force.of_nodes.size(); ++i)
      within.of_nodes[i] += force.of_nodes[i];
    for (std::size_t i = 0; i < force.of_edges.size(); ++i) within.of_edges[i] += force.of_edges[i];
  }
  return handed_over(s, std::move(within));
}

InnerLoads LoadsAtWork::inner_loads(const std::map<std::string, double>& factors, double time,
                                    const BlockSystem& s) const {
  InnerLoads inner;
  if (s.edges() > 0) {
    BlockForces force(s);
    std::vector<double> unused(force.of_nodes.size(), 0.0);
    add(factors, time, force, unused);
    inner.edge_force = std::move(force.of_edges);
  }
  for (const auto& n : loads_) {
    const auto it = factors.find(n.name);
    if (it == factors.end() || !n.load->strains()) continue;
    inner.free_strain.resize(s.local_blocks(), 0.0);
    n.load->add_free_strain(it->second * n.time_function(time), inner.free_strain);
  }
  return inner;
}

double LoadsAtWork::resolution() const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& n : loads_) shortest = std::min({shortest, n.load->resolution(), n.time_function.resolution()});
  return shortest;
}

LoadsAtWork::Shortest LoadsAtWork::resolution(const std::map<std::string, double>& factors, double from,
                                              double to) const {
  VOUSSOIR_EXPECT(from <= to && "times: ascending");
  Shortest shortest;
  for (const auto& n : loads_) {
    if (factors.count(n.name) == 0) continue;
    const double own = std::min(n.load->resolution(from, to), n.time_function.resolution(from, to));
    if (own < shortest.time) shortest = {own, n.name};
  }
  return shortest;
}

bool LoadsAtWork::jumps(const std::string& load, double from, double to) const {
  VOUSSOIR_EXPECT(from <= to && "times: ascending");
  return std::any_of(loads_.begin(), loads_.end(),
                     [&](const Named& n) { return n.name == load && n.time_function.jumps(from, to); });
}

std::map<std::string, EffectSummary> LoadsAtWork::costs(const Teuchos::Comm<int>& comm) const {
  std::map<std::string, EffectSummary> costs;
  for (const auto& n : loads_) {
    const auto bytes = static_cast<long long>(n.load->bytes() + n.time_function.bytes());
    const auto [calls, all_bytes] = total_of_each(comm, std::array<long long, 2>{n.calls, bytes});
    auto& cost = costs[n.word];
    cost.in_play = true;
    cost.calls += calls;
    cost.bytes += all_bytes;
    cost.seconds += largest_over_ranks(comm, n.seconds);
  }
  return costs;
}

std::vector<std::string> LoadsAtWork::remarks() const {
  std::vector<std::string> lines;
  for (const auto& n : loads_)
    if (const auto remark = n.load->remark(); !remark.empty()) lines.push_back(n.name + ": " + remark);
  return lines;
}

Warnings LoadsAtWork::warnings() const {
  Warnings all;
  for (const auto& n : loads_)
    for (const auto& warning : n.load->warnings()) all.push_back(warning);
  return all;
}

template LoadsAtWork::LoadsAtWork(const Scene&, const BlockSource<2>&, const Structure<2>&);
template LoadsAtWork::LoadsAtWork(const Scene&, const BlockSource<3>&, const Structure<3>&);

}  // namespace voussoir
