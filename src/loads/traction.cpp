#include "blocks/supports.hpp"
#include "loads/loads.hpp"

namespace voussoir {

template <>
void add_traction<2>(const Structure<2>& s, const TractionParameters& load, int facet_set, double factor,
                     std::vector<double>& force) {
  for (const auto& b : s.blocks()) {
    // The outward side of an edge is where the block is not: judged from the cell it belongs to.
    for (const auto& f : b.mesh.facets) {
      if (f.set != facet_set) continue;
      const auto& x0 = b.mesh.position[f.node[0]];
      const auto& x1 = b.mesh.position[f.node[1]];
      const auto along = x1 - x0;
      Vector<2> outward{along[1], -along[0]};
      for (const auto& cell : b.mesh.cells) {
        bool first = false, second = false;
        Vector<2> middle{};
        for (int i = 0; i < cell.count; ++i) {
          first |= cell.node[i] == f.node[0];
          second |= cell.node[i] == f.node[1];
          middle = middle + (1.0 / cell.count) * b.mesh.position[cell.node[i]];
        }
        if (first && second && dot(outward, middle - x0) > 0) outward = -1.0 * outward;
      }
      const double area = norm(along) * s.model().thickness;
      const auto normal = (1 / norm(outward)) * outward;
      const Vector<2> traction{load.tx - load.pressure * normal[0], load.ty - load.pressure * normal[1]};
      for (int i = 0; i < 2; ++i)  // linear shape functions: half to each end
        for (int c = 0; c < 2; ++c) force[2 * (b.first_local + f.node[i]) + c] += factor * traction[c] * area / 2;
    }
  }
}

}  // namespace voussoir
