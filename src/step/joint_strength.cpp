#include "step/joint_strength.hpp"

#include <algorithm>
#include <cmath>

namespace voussoir {

template <int dim>
void wear(const Model<dim>& model, const ContactState& before, ContactState& after, const PointField& gap,
          const PointField& slip) {
  if (model.softening().empty()) return;
  SofteningPoints points(model.law(), model.softening(), after.opened, before.slipped);
  for (int k = 0; k < model.points().size(); ++k) {
    if (!after.selected[k]) continue;
    double shear = 0, way = 0;
    const double sigma = model.local_stiffness()[k];
    for (int c = 1; c < dim; ++c) {
      const double trial = after.lambda[dim * k + c] - sigma * slip[dim * k + c];
      shear += trial * trial;
      way += slip[dim * k + c] * slip[dim * k + c];
    }
    points.wear_by(k, gap[dim * k], std::sqrt(way), after.lambda[dim * k], std::sqrt(shear), sigma);
    after.opened[k] = points.opened(k);
    after.slipped[k] = std::max(after.slipped[k], before.slipped[k] + points.way(k));
  }
}

template void wear<2>(const Model<2>&, const ContactState&, ContactState&, const PointField&, const PointField&);

}  // namespace voussoir
