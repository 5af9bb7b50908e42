#include "loads/load.hpp"

#include <algorithm>

#include "blocks/condensed_edges.hpp"

namespace voussoir {

template <int dim>
FacetSet LoadSite<dim>::facet_set(const std::string& on, const std::string& blocks) const {
  return voussoir::facet_set(source, {on, blocks});
}

template <int dim>
bool LoadSite<dim>::in_block_set(const Block<dim>& block, const std::string& name) const {
  if (name == "all") return true;
  return std::any_of(block.sets.begin(), block.sets.end(), [&](int set) { return source.block_sets()[set] == name; });
}

double sum_of_factors(const std::vector<LoadMoment>& moments) {
  double sum = 0;
  for (const auto& moment : moments) sum += moment.factor;
  return sum;
}

template <int dim>
std::unique_ptr<Load<dim>> make_load(const LoadParameters& load, const LoadSite<dim>& site) {
  return std::visit([&](const auto& kind) { return make_load_of<dim>(kind, site); }, load.kind);
}

NodalPattern::NodalPattern(const std::vector<double>& unit) {
  const auto count =
      static_cast<std::size_t>(std::count_if(unit.begin(), unit.end(), [](double value) { return value != 0; }));
  index_.reserve(count);
  value_.reserve(count);
  for (std::size_t i = 0; i < unit.size(); ++i)
    if (unit[i] != 0) {
      index_.push_back(static_cast<int>(i));
      value_.push_back(unit[i]);
    }
}

template <int dim>
void PatternLoad<dim>::add(const std::vector<LoadMoment>& moments, std::vector<double>& force,
                           std::vector<double>& prescribed) const {
  pattern_.add(sum_of_factors(moments), of_ == Of::forces ? force : prescribed);
}

template <int dim>
BodyForce<dim>::BodyForce(const Structure<dim>& s, const std::vector<double>& unit, std::vector<double> per_volume)
    : PatternLoad<dim>(unit) {
  const auto& blocks = s.blocks();
  if (std::none_of(blocks.begin(), blocks.end(), [](const auto& b) { return b.edges != nullptr; })) return;
  std::vector<double> handed_over(unit.size(), 0.0);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Vector<dim> force;
    std::copy_n(per_volume.begin() + static_cast<long>(dim * b), dim, force.begin());
    hand_over_edges<dim>(blocks[b], force, handed_over);
  }
  of_edges_ = NodalPattern(handed_over);
  per_volume_ = std::move(per_volume);
}

template <int dim>
void BodyForce<dim>::add_body_force(double factor, std::vector<double>& force) const {
  for (std::size_t i = 0; i < per_volume_.size(); ++i) force[i] += factor * per_volume_[i];
}

template <int dim>
void hand_over_edges(const LocalBlock<dim>& block, const Vector<dim>& per_volume, std::vector<double>& force) {
  if (block.edges)
    block.edges->template hand_over<dim>(per_volume, &force[dim * static_cast<std::size_t>(block.first_local)]);
}

template void hand_over_edges(const LocalBlock<2>&, const Vector<2>&, std::vector<double>&);
template void hand_over_edges(const LocalBlock<3>&, const Vector<3>&, std::vector<double>&);

template struct LoadSite<2>;
template struct LoadSite<3>;
template class PatternLoad<2>;
template class PatternLoad<3>;
template class BodyForce<2>;
template class BodyForce<3>;
template std::unique_ptr<Load<2>> make_load<2>(const LoadParameters&, const LoadSite<2>&);
template std::unique_ptr<Load<3>> make_load<3>(const LoadParameters&, const LoadSite<3>&);

}  // namespace voussoir
