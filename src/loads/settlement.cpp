#include "blocks/supports.hpp"
#include "loads/loads.hpp"

namespace voussoir {

template <>
void add_settlement<2>(const Structure<2>& s, const SettlementParameters& load, const SupportParameters& support,
                       int facet_set, double factor, std::vector<double>& displacement) {
  std::vector<char> moved(s.nodes(), 0);  // a node of two facets moves once
  for_each_node_on(s, facet_set, [&](int node) {
    if (moved[node]) return;
    moved[node] = 1;
    const auto& x = s.position()[node];
    const Vector<2> u{load.ux - load.rotation * (x[1] - load.about_y), load.uy + load.rotation * (x[0] - load.about_x)};
    for (int c = 0; c < 2; ++c)
      if (holds(support, c)) displacement[2 * node + c] += factor * u[c];
  });
}

}  // namespace voussoir
