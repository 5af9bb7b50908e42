#include "model/joint_strength.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.hpp"
#include "base/components.hpp"
#include "base/text.hpp"
#include "joints/crack_work.hpp"
#include "joints/damage.hpp"
#include "joints/friction_work.hpp"
#include "model/handed_over.hpp"

namespace voussoir {

void wear(const Model& model, const ContactState& before, ContactState& after, const PointField& gap,
          const PointField& slip) {
  const int dim = model.components();
  if (model.softening().empty()) return;
  VOUSSOIR_EXPECT(is_of_points(model, gap) && "gap: of points");
  VOUSSOIR_EXPECT(is_of_points(model, slip) && "slip: of points");
  VOUSSOIR_EXPECT(is_per_point(model, before.slipped) && is_per_point(model, after.opened) && "wear: per point");
  for (int k = 0; k < model.points().size(); ++k) {
    if (!after.selected[k] || !model.bears(k)) continue;
    double shear = 0, way = 0;
    const double sigma = model.local_stiffness()[k];
    for (int c = 1; c < dim; ++c) {
      const double trial = after.lambda[dim * k + c] - sigma * slip[dim * k + c];
      shear += trial * trial;
      way += slip[dim * k + c] * slip[dim * k + c];
    }
    const SofteningPoint point{model.law()[k], model.softening()[k], {after.opened[k], before.slipped[k]}};
    const auto worn = wear(point, {after.opened[k]}, StrengthIs::falling,
                           {gap[dim * k], std::sqrt(way), after.lambda[dim * k], std::sqrt(shear), sigma});
    after.opened[k] = worn.damage.opened;
    after.slipped[k] = std::max(after.slipped[k], before.slipped[k] + worn.damage.way);
  }
}

namespace {

template <int dim>
EnergyOfStep loss_of(const Model& model, const ContactState& before, const ContactState& mid, int k, double opening,
                     const PointField& gap) {
  EnergyOfStep loss;
  std::array<double, dim - 1> force, slip;
  for (int c = 1; c < dim; ++c) {
    force[c - 1] = mid.lambda[dim * k + c];
    slip[c - 1] = 2 * gap[dim * k + c];
  }
  const double normal = mid.lambda[dim * k], stiffness = model.local_stiffness()[k];
  const auto& whole = model.law()[k];
  if (model.softening().empty()) {
    loss.friction = friction_work(friction_bound(whole, normal), force, slip, stiffness);
    return loss;
  }
  const auto& softening = model.softening()[k];
  const JointWear start{before.opened[k], before.slipped[k]}, end{mid.opened[k], mid.slipped[k]};
  const auto law = weaken(whole, softening, start, gap[dim * k] + opening, norm(slip) / 2).law;
  const double taken = friction_work(friction_bound(law, normal), force, slip, stiffness);
  const double by_cohesion = taken > 0 ? std::min(taken, law.cohesion * norm(slip)) : 0.0;
  loss.friction = taken - by_cohesion;
  // What the forces of the step take; where it bends sharply that may be less than the law takes, never less than none.
  loss.fracture = std::max(0.0, by_cohesion - 2 * std::min(0.0, normal) * (gap[dim * k] - opening) +
                                    held_energy(whole, softening, start, 2 * opening) -
                                    held_energy(whole, softening, end, 2 * gap[dim * k]));
  return loss;
}

}  // namespace

EnergyOfStep loss_in_time(const Model& model, const ContactState& before, const ContactState& mid, int k,
                          double opening, const PointField& gap) {
  return with_components(model.components(),
                         [&](auto dim) { return loss_of<dim>(model, before, mid, k, opening, gap); });
}

double held_by_joints(const Model& model, const ContactState& state) {
  const int dim = model.components();
  if (model.softening().empty()) return 0;
  const auto gap = model.gaps(state.displacement);
  double energy = 0;
  for (int k = 0; k < model.points().owned(); ++k) energy += held_by_joint(model, state, gap[dim * k], k);
  return energy;
}

Warnings lost_on_the_way(double damage, const std::string& when) {
  return {
      {"lost_on_the_way", "the structure", when, damage,
       "no equilibrium was found that follows from the last one while cracks grow little by little: a joint has lost " +
           three_digits(100 * damage) +
           " % of its strength more than where it stands now asks for, as in a jump; take more increments if where "
           "cracks run matters"}};
}

Warnings unstable(double excess, const std::string& stones, const std::string& when) {
  return {{"unstable", "joint " + stones, when, excess,
           "the equilibrium is one that a structure does not stay in: joints soften faster than the stones beside them "
           "follow, by " +
               six_digits(excess) +
               " of both together, most at this joint, and no other one was found on the way down from it within the "
               "solves that finding it took; of "
               "cracks that open side by side one would run on and the others close, or the structure would move on; "
               "take more increments, or more fracture energy if that was meant"}};
}

Warnings one_of_alike(int joints, const std::string& stones, const std::string& when) {
  return {
      {"one_of_alike", "joint " + stones, when, static_cast<double>(joints),
       "of " + std::to_string(joints) +
           " joints that had come equally far this one was let crack first, being the first by number, and those that "
           "need not follow stay whole: nothing tells which; drawn in another order it may be another of them, and "
           "what comes next hangs on which"}};
}

Warnings passed_in_time(double seconds, const std::string& when) {
  return {{"passed_in_time", "the structure", when, seconds,
           "no equilibrium was found that follows from the last one in statics: let go in time, with inertia and with "
           "damping that grows with stiffness, the structure came to rest within " +
               six_digits(seconds) + " s; what its joints lost on that way they lost in motion"}};
}

}  // namespace voussoir
