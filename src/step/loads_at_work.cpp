#include "step/loads_at_work.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_Time.hpp>
#include <algorithm>
#include <limits>

namespace voussoir {

template <int dim>
LoadsAtWork<dim>::LoadsAtWork(const Scene& scene, const BlockSource<dim>& source, const Structure<dim>& structure)
    : blocks_(structure.blocks().size()) {
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

template <int dim>
void LoadsAtWork<dim>::add(const std::map<std::string, double>& factors, double time, std::vector<double>& force,
                           std::vector<double>& prescribed) const {
  std::fill(force.begin(), force.end(), 0.0);
  std::fill(prescribed.begin(), prescribed.end(), 0.0);
  for (const auto& n : loads_) {
    const auto it = factors.find(n.name);
    if (it == factors.end() || it->second == 0) continue;
    const Teuchos::Time clock("load", true);
    const double factor = it->second * n.time_function(time);
    if (factor != 0) n.load->add(factor, time, force, prescribed);
    ++n.calls;
    n.seconds += clock.totalElapsedTime(true);
  }
}

template <int dim>
std::vector<double> LoadsAtWork<dim>::free_strain(const std::map<std::string, double>& factors, double time) const {
  std::vector<double> strain;
  for (const auto& n : loads_) {
    const auto it = factors.find(n.name);
    if (!n.load->strains() || it == factors.end()) continue;
    strain.resize(blocks_, 0.0);
    n.load->add_free_strain(it->second * n.time_function(time), strain);
  }
  return strain;
}

template <int dim>
double LoadsAtWork<dim>::resolution() const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& n : loads_) shortest = std::min({shortest, n.load->resolution(), n.time_function.resolution()});
  return shortest;
}

template <int dim>
std::map<std::string, EffectSummary> LoadsAtWork<dim>::costs(const Teuchos::Comm<int>& comm) const {
  std::map<std::string, EffectSummary> costs;
  for (const auto& n : loads_) {
    const long long mine[2] = {n.calls, static_cast<long long>(n.load->bytes() + n.time_function.bytes())};
    long long all[2];
    double slowest = 0;
    Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, 2, mine, all);
    Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, n.seconds, Teuchos::outArg(slowest));
    auto& cost = costs[n.word];
    cost.in_play = true;
    cost.calls += all[0];
    cost.bytes += all[1];
    cost.seconds += slowest;
  }
  return costs;
}

template <int dim>
std::vector<std::string> LoadsAtWork<dim>::remarks() const {
  std::vector<std::string> lines;
  for (const auto& n : loads_)
    if (const auto remark = n.load->remark(); !remark.empty()) lines.push_back(n.name + ": " + remark);
  return lines;
}

template <int dim>
Warnings LoadsAtWork<dim>::warnings() const {
  Warnings all;
  for (const auto& n : loads_)
    for (const auto& warning : n.load->warnings()) all.push_back(warning);
  return all;
}

template class LoadsAtWork<2>;

}  // namespace voussoir
