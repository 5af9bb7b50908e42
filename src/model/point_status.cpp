#include "model/point_status.hpp"
#include "base/check.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"

#include <cmath>

namespace voussoir {

static_assert(static_cast<char>(PointStatus::open) == static_cast<char>(ContactStatus::open) &&
              static_cast<char>(PointStatus::stick) == static_cast<char>(ContactStatus::stick) &&
              static_cast<char>(PointStatus::slip) == static_cast<char>(ContactStatus::slip));

std::vector<char> point_statuses(const Model& model, const ContactState& state, const PointField& gap,
                                 const PointField& slip_before) {
  const int dim = model.components();
  VOUSSOIR_EXPECT(is_of_points(model, gap) && "gap: of points");
  VOUSSOIR_EXPECT((slip_before.empty() || is_of_points(model, slip_before)) && "slips before: of points, or none");
  VOUSSOIR_EXPECT(is_of_points(model, state.lambda) && "lambda: of points");
  std::vector<char> status(model.points().size());
  for (int k = 0; k < model.points().size(); ++k) {
    const auto law = law_now(model, state, gap[dim * k], k);
    const double sigma = model.local_stiffness()[k];
    const double normal = state.lambda[dim * k] - sigma * gap[dim * k];
    double q = 0;
    for (int c = 1; c < dim; ++c) {
      const double slipped = gap[dim * k + c] - (slip_before.empty() ? 0.0 : slip_before[dim * k + c]);
      const double trial = state.lambda[dim * k + c] - sigma * slipped;
      q += trial * trial;
    }
    status[k] = static_cast<char>(judge(law, normal, std::sqrt(q), friction_bound(law, state.lambda[dim * k])));
  }
  return status;
}

}  // namespace voussoir
