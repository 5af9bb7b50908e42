#include "model/point_status.hpp"
#include "base/check.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"

#include <cmath>

namespace voussoir {

static_assert(static_cast<char>(PointStatus::open) == static_cast<char>(ContactStatus::open) &&
              static_cast<char>(PointStatus::stick) == static_cast<char>(ContactStatus::stick) &&
              static_cast<char>(PointStatus::slip) == static_cast<char>(ContactStatus::slip));

namespace {

/// What the law of a point is asked about.
struct Trial {
  PointLaw law;
  double normal = 0, shear = 0, bound = 0;  ///< [N] trial forces, and what friction bears
};

Trial trial_of(const Model& model, const ContactState& state, const PointField& gap, const PointField& slip_before,
               int k) {
  const int dim = model.components();
  const double sigma = model.local_stiffness()[k];
  Trial trial{law_now(model, state, gap[dim * k], k), state.lambda[dim * k] - sigma * gap[dim * k]};
  double q = 0;
  for (int c = 1; c < dim; ++c) {
    const double slipped = gap[dim * k + c] - (slip_before.empty() ? 0.0 : slip_before[dim * k + c]);
    const double force = state.lambda[dim * k + c] - sigma * slipped;
    q += force * force;
  }
  trial.shear = std::sqrt(q);
  trial.bound = friction_bound(trial.law, state.lambda[dim * k]);
  return trial;
}

void expect_of_points(const Model& model, const ContactState& state, const PointField& gap, const PointField& before) {
  VOUSSOIR_EXPECT(is_of_points(model, gap) && "gap: of points");
  VOUSSOIR_EXPECT((before.empty() || is_of_points(model, before)) && "slips before: of points, or none");
  VOUSSOIR_EXPECT(is_of_points(model, state.lambda) && "lambda: of points");
}

}  // namespace

std::vector<char> point_statuses(const Model& model, const ContactState& state, const PointField& gap,
                                 const PointField& slip_before) {
  expect_of_points(model, state, gap, slip_before);
  std::vector<char> status(model.points().size());
  for (int k = 0; k < model.points().size(); ++k) {
    const auto trial = trial_of(model, state, gap, slip_before, k);
    status[k] = static_cast<char>(judge(trial.law, trial.normal, trial.shear, trial.bound));
  }
  return status;
}

PointField slip_origins(const Model& model, const ContactState& state, const PointField& gap,
                        const PointField& slip_before) {
  expect_of_points(model, state, gap, slip_before);
  const int dim = model.components();
  PointField origins = slip_before;
  for (int k = 0; k < model.points().size() && !origins.empty(); ++k) {
    const auto trial = trial_of(model, state, gap, slip_before, k);
    if (state.selected[k] && trial.shear <= trial.bound) continue;
    for (int c = 1; c < dim; ++c) origins[dim * k + c] = gap[dim * k + c];
  }
  return origins;
}

}  // namespace voussoir
