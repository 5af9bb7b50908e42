// The augmented contact law over all selected points: trial forces, their projection, their derivative.
#pragma once

#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir {

/// What mortar gives way under a force [m/N]; 0 without mortar.
inline double compliance_of(const NonlinearProblem& problem, int point, int component) {
  return problem.compliance().empty() ? 0.0 : problem.compliance()[point].along(component);
}

/// Slip at the start of the load step [m]; 0 in the normal direction.
inline double slip_origin_of(const NonlinearProblem& problem, std::size_t at) {
  return problem.slip_origin().empty() ? 0.0 : problem.slip_origin()[at];
}

/// Stiffness with which the augmented law resists a gap or slip [N/m]: sigma, with mortar in series.
inline double stiffness_of(const NonlinearProblem& problem, int point, int component, double augmentation) {
  const double sigma = augmentation * problem.local_stiffness()[point];
  return problem.compliance().empty() ? sigma : sigma / (1 + sigma * problem.compliance()[point].along(component));
}

/// Gap, or slip from its origin, less what mortar gives way [m].
inline double motion_of(const NonlinearProblem& problem, int point, int component, const PointField& gap,
                        const PointField& lambda) {
  const std::size_t at = static_cast<std::size_t>(point) * problem.components() + component;
  return gap[at] - slip_origin_of(problem, at) + compliance_of(problem, point, component) * lambda[at];
}

/// Size of the tangential part [N].
double tangential_size(const PointField& force, int point, int components);

/// lambda - sigma (g - g_0 + c lambda), sigma in series with the mortar's 1/c, the slip measured from its origin.
void trial_forces(const NonlinearProblem&, const PointField& lambda, const PointField& gap, double augmentation,
                  PointField& trial);

/// The law of every point at some forces and gaps: with the strength that is left there of points that soften.
class CurrentLaws {
 public:
  /// @param strength  with its damage where joints soften
  explicit CurrentLaws(const NonlinearProblem& problem, Strength strength = {})
      : problem_(problem), strength_(strength) {}
  CurrentLaws(const NonlinearProblem& problem, Strength strength, const PointField& lambda, const PointField& gap)
      : CurrentLaws(problem, strength) {
    update(lambda, gap);
  }
  void update(const PointField& lambda, const PointField& gap);
  Strength strength() const { return strength_; }

  PointLaw operator[](int point) const {
    const auto* w = softened(point);
    return w ? w->law : problem_.law()[point];
  }
  /// With how it changes.
  WeakenedLaw at(int point) const {
    if (const auto* w = softened(point)) return *w;
    WeakenedLaw law;
    law.law = problem_.law()[point];
    law.pull = law.law.tension;
    return law;
  }
  /// Force [N] with which a point pulls where it is open; below 0 where one that pulls back would be pressed.
  double pull(int point) const {
    const auto* w = softened(point);
    return w ? w->pull : problem_.law()[point].tension;
  }
  /// Of a point that softens, else null.
  const WeakenedLaw* softened(int point) const {
    return weakened_.empty() || number_[point] < 0 ? nullptr : &weakened_[number_[point]];
  }

 private:
  const NonlinearProblem& problem_;
  Strength strength_;
  std::vector<int> number_;  ///< per point; -1 where it does not soften
  std::vector<WeakenedLaw> weakened_;
};

/// Damage of all points of this rank once they have opened and slipped as in a state.
struct WornPoints {
  Damage damage;
  bool by_far = false;  ///< one has broken off, overloaded by more than all that it had to lose
};
/// The problem has joints that soften.
WornPoints wear(const NonlinearProblem&, Strength, const PointField& lambda, const PointField& gap);

/// What points do in a linear solve: closed or not, directions of slip (0 where a point does not), how they resist.
struct PointStatuses {
  const std::vector<char>& closed;
  const PointField& sliding;
  const std::vector<PointStiffness>& resistance;
};

/// Splits forces that nothing tells apart in the one way that does not depend on how a solver came here. Collective.
void split_forces(const NonlinearProblem&, const CurrentLaws&, const PointStatuses&, PointField& lambda);

/// Gives a state that is in equilibrium the split of forces that is unique, where nothing else tells it: of points that
/// have not moved by more than what is left of one [N]. Collective.
void split_forces(const NonlinearProblem&, const CurrentLaws&, const PointField& gap, double left, PointField& lambda);

/// Largest tangential force of each point under the normal parts of some forces [N].
void friction_bounds(const NonlinearProblem&, const CurrentLaws&, const PointField& forces, std::vector<double>& bound);

/// Projection of trial forces on the admissible set with given friction bounds.
void project(const NonlinearProblem&, const CurrentLaws&, const PointField& trial, const std::vector<double>& bound,
             PointField& forces);

/// Which points resist in the next linear system.
void resistances(const NonlinearProblem&, const CurrentLaws&, const PointField& trial, const std::vector<double>& bound,
                 double augmentation, std::vector<PointStiffness>&);

}  // namespace voussoir
