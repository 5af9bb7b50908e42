#include "loads/load.hpp"

#include <algorithm>

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

Pattern::Pattern(const std::vector<double>& list) {
  const auto count =
      static_cast<std::size_t>(std::count_if(list.begin(), list.end(), [](double value) { return value != 0; }));
  index_.reserve(count);
  value_.reserve(count);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i] != 0) {
      index_.push_back(static_cast<int>(i));
      value_.push_back(list[i]);
    }
}

void Pattern::add(double factor, std::vector<double>& to) const {
  for (std::size_t k = 0; k < index_.size(); ++k) to[index_[k]] += factor * value_[k];
}

template <int dim>
PatternLoad<dim>::PatternLoad(const BlockForces& unit)
    : nodes_(unit.of_nodes), edges_(unit.of_edges), prescribed_({}) {}

template <int dim>
PatternLoad<dim>::PatternLoad(const std::vector<double>& unit) : nodes_({}), edges_({}), prescribed_(unit) {}

template <int dim>
void PatternLoad<dim>::add(const std::vector<LoadMoment>& moments, BlockForces& force,
                           std::vector<double>& prescribed) const {
  const double factor = sum_of_factors(moments);
  nodes_.add(factor, force.of_nodes);
  edges_.add(factor, force.of_edges);
  prescribed_.add(factor, prescribed);
}

template <int dim>
std::size_t PatternLoad<dim>::bytes() const {
  return sizeof(*this) + nodes_.bytes() + edges_.bytes() + prescribed_.bytes();
}

template struct LoadSite<2>;
template struct LoadSite<3>;
template class PatternLoad<2>;
template class PatternLoad<3>;
template class BodyForce<2>;
template class BodyForce<3>;
template std::unique_ptr<Load<2>> make_load<2>(const LoadParameters&, const LoadSite<2>&);
template std::unique_ptr<Load<3>> make_load<3>(const LoadParameters&, const LoadSite<3>&);

}  // namespace voussoir
