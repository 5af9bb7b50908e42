#include "joints/friction_of_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/dense.hpp"

namespace voussoir {
namespace {

// A millionth of the share is told by nobody. It takes ten to fifty rounds; where two places bear next to all, the
// motion turns about one of them and is found slowly: then what is told is too little by that millionth or a few.
constexpr double accuracy_of_share = 1e-6;
constexpr int most_rounds = 200;
// Where a motion turns about a place that place has no direction: below this share of the fastest it stands.
constexpr double stands = 1e-9;

/// Sideways motions, and a turn by the patch's radius of gyration [m].
using Motion = Vector<3>;

Vector<2> motion_at(const Vector<2>& arm, double radius, const Motion& motion) {
  return {motion[0] - motion[2] * arm[1] / radius, motion[1] + motion[2] * arm[0] / radius};
}

/// What resists motions like a viscous patch does, its resistance a force per speed at each place.
Matrix<3> resistance(const std::vector<Vector<2>>& arm, double radius, const std::vector<double>& weight) {
  Matrix<3> a{};
  for (std::size_t k = 0; k < arm.size(); ++k) {
    const Motion x{1, 0, -arm[k][1] / radius}, y{0, 1, arm[k][0] / radius};
    for (int r = 0; r < 3; ++r) a[r] = a[r] + weight[k] * (x[r] * x + y[r] * y);
  }
  return a;
}

}  // namespace

// Weiszfeld's iteration: friction as viscous resistance whose weights are bounds over speeds. Every motion gives a
// share from below, the forces of its viscous patch, which balance the load, one from above.
double friction_used(const std::vector<RubbingPlace>& places) {
  double total = 0;
  for (const auto& p : places) total += p.bound;
  if (!(total > 0)) return std::numeric_limits<double>::quiet_NaN();
  if (std::isinf(total)) return 0;
  Vector<2> centre{}, shear{};
  for (const auto& p : places) {
    centre = centre + (p.bound / total) * p.place;
    shear = shear + p.shear;
  }
  double square = 0, twist = 0;
  std::vector<Vector<2>> arm;
  std::vector<double> weight;
  for (const auto& p : places) {
    arm.push_back(p.place - centre);
    square += p.bound / total * dot(arm.back(), arm.back());
    twist += cross(arm.back(), p.shear);
    weight.push_back(p.bound / total);
  }
  const double radius = std::sqrt(square);
  if (!(radius > 0)) return norm(shear) / total;
  const Motion load{shear[0] / total, shear[1] / total, twist / radius / total};
  if (!(norm(load) > 0)) return 0;
  double share = 0;
  std::vector<double> speed(places.size());
  for (int round = 0; round < most_rounds; ++round) {
    const auto motion = solve_positive(resistance(arm, radius, weight), load);
    double above = 0, worn = 0, fastest = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      speed[k] = norm(motion_at(arm[k], radius, motion));
      fastest = std::max(fastest, speed[k]);
      if (!(places[k].bound > 0)) continue;
      worn += places[k].bound / total * speed[k];
      above = std::max(above, weight[k] * speed[k] * total / places[k].bound);
    }
    if (!(worn > 0)) return share;
    share = std::max(share, dot(load, motion) / worn);
    if (above - share <= accuracy_of_share * above) break;
    for (std::size_t k = 0; k < places.size(); ++k)
      weight[k] = places[k].bound / total / std::max(speed[k], stands * fastest);
  }
  return share;
}

}  // namespace voussoir
