#include "joints/crack_work.hpp"

#include <array>

#include "base/check.hpp"

namespace voussoir {
namespace {

constexpr double accuracy_of_integral = 1e-13;  // of an integral, relative to the largest value times the way
constexpr int most_halvings = 40;               // of a way on which a force bends sharply
constexpr double round_off_of_energy = 1e-9;    // of the energies in play: what such bends leave

/// Gauss's rule of five points.
template <class Function>
double rule(double from, double to, const Function& f) {
  constexpr double place[] = {0.5, 0.230765344947158, 0.769234655052842, 0.046910077030668, 0.953089922969332};
  constexpr double weight[] = {0.284444444444444, 0.239314335249683, 0.239314335249683, 0.118463442528095,
                               0.118463442528095};
  double sum = 0;
  for (int i = 0; i < 5; ++i) sum += weight[i] * f(from + (to - from) * place[i]);
  return sum * (to - from);
}

/// Halves an interval until the rule says the same of it and of its halves.
template <class Function>
double refined(double from, double to, double whole, double enough, int halvings, const Function& f) {
  const double middle = (from + to) / 2, low = rule(from, middle, f), high = rule(middle, to, f);
  if (halvings == 0 || std::abs(low + high - whole) <= enough) return low + high;
  return refined(from, middle, low, enough, halvings - 1, f) + refined(middle, to, high, enough, halvings - 1, f);
}

/// Integral over [0, 1] of a force that is smooth between the places given.
/// @param largest  [N] it can be
template <std::size_t n, class Function>
double integral(std::array<double, n> places, double largest, const Function& f) {
  for (double& at : places) at = at > 0 && at < 1 ? at : 0.0;  // also what is no number
  std::sort(places.begin(), places.end());
  double sum = 0, from = 0;
  for (std::size_t k = 0; k <= n; ++k) {
    const double to = k < n ? places[k] : 1.0;
    if (to > from) sum += refined(from, to, rule(from, to, f), accuracy_of_integral * largest, most_halvings, f);
    from = std::max(from, to);
  }
  return sum;
}

/// Where along a way from 0 to 1 something that changes sign does so; 0 where it does not.
template <class Function>
double crossing(double low, double high, const Function& f) {
  const bool below = f(low) < 0;
  if ((f(high) < 0) == below) return 0;
  while (true) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) return middle;
    ((f(middle) < 0) == below ? low : high) = middle;
  }
}

/// A point with a law that has been opened and slipped so far, [N] of its pull and of its cohesion.
struct Crack {
  const PointLaw& whole;
  const Softening& softening;

  double left(double strength, double opened, double slipped) const {
    return std::isfinite(strength) ? strength_left(strength, softening.damage(softening.kappa(opened, slipped))) : 0.0;
  }
  double pull(const JointWear& wear, double gap) const {
    if (!(gap > 0)) return 0;
    const double share = gap < wear.opened ? gap / wear.opened : 1.0;
    return share * left(whole.tension, std::max(wear.opened, gap), wear.slipped);
  }
  /// Of the cohesion beside a pull.
  double shear(double opened, double slipped, double pull) const {
    const double rubbing = std::isfinite(whole.friction) ? whole.friction * pull : 0.0;
    return std::max(0.0, left(whole.cohesion, opened, slipped) - rubbing);
  }
  /// [J] of the pull where strength falls with the opening alone.
  double envelope(double slipped, double from, double to) const {
    const auto at = [&](double share) { return from + share * (to - from); };
    const double lost =
        crossing(0, 1, [&](double share) { return softening.kappa(at(share), slipped) - softening.whole_kappa(); });
    if (!std::isfinite(whole.tension)) return 0;
    const auto pull = [&](double share) { return left(whole.tension, at(share), slipped); };
    return (to - from) * integral(std::array<double, 1>{lost}, whole.tension, pull);
  }
  double held(const JointWear& wear, double gap) const {
    if (!(gap > 0)) return 0;
    const double within = std::min(gap, wear.opened);
    const double triangle = pull(wear, within) * within / 2;
    return gap > wear.opened ? triangle + envelope(wear.slipped, wear.opened, gap) : triangle;
  }
};

}  // namespace

double held_energy(const PointLaw& whole, const Softening& softening, const JointWear& wear, double gap) {
  return Crack{whole, softening}.held(wear, gap);
}

CrackWork crack_work(const PointLaw& whole, const Softening& softening, const CrackEnd& from, const CrackEnd& to) {
  const Crack crack{whole, softening};
  const double most = from.wear.opened, slips = std::max(0.0, to.wear.slipped - from.wear.slipped);
  const double opens = to.gap - from.gap;
  const auto gap = [&](double share) { return from.gap + share * opens; };
  const auto slipped = [&](double share) { return from.wear.slipped + share * slips; };
  const auto opened = [&](double share) { return std::max(most, gap(share)); };
  const auto kappa = [&](double share) { return softening.kappa(opened(share), slipped(share)); };
  const auto pull = [&](double share) { return crack.pull({most, slipped(share)}, gap(share)); };
  const auto tension = [&](double share) {  // of a point that pulls and is closed too
    return gap(share) > 0 ? pull(share) : std::max(0.0, -from.normal - share * (to.normal - from.normal));
  };
  const auto bound = [&](double share) {
    const double all = crack.left(whole.cohesion, opened(share), slipped(share));
    return all - (std::isfinite(whole.friction) ? whole.friction * tension(share) : 0.0);
  };
  const double closed = -from.gap / opens, envelope = (most - from.gap) / opens;
  const double lost = crossing(0, 1, [&](double share) { return kappa(share) - crack.softening.whole_kappa(); });
  const double middle = closed > 0 && closed < 1 ? closed : 0.5;
  const std::array<double, 6> places{closed,
                                     envelope,
                                     lost,
                                     crossing(0, middle, bound),
                                     crossing(middle, 1, bound),
                                     from.normal / (from.normal - to.normal)};
  CrackWork work;
  const bool pulls = std::max(from.gap, to.gap) > 0 && opens != 0 && std::isfinite(whole.tension);
  if (pulls) work.pull = opens * integral(places, whole.tension, pull);
  if (slips > 0 && std::isfinite(whole.cohesion))
    work.cohesion = slips * integral(places, whole.cohesion,
                                     [&](double s) { return crack.shear(opened(s), slipped(s), tension(s)); });
  const double start = std::max(most, from.gap), end = std::max(most, to.gap);
  const double held_before = crack.held(from.wear, from.gap), held_after = crack.held(to.wear, to.gap);
  if (to.wear.opened > end) {
    const JointWear before{most, to.wear.slipped};
    work.pull += crack.held(before, end) - crack.held(before, to.gap) +
                 crack.envelope(to.wear.slipped, end, to.wear.opened) - crack.held(to.wear, to.wear.opened) +
                 held_after;
  }
  const double all = work.pull + work.cohesion, lost_energy = all - (held_after - held_before);
  VOUSSOIR_ENSURE(!(lost_energy < -round_off_of_energy * (std::abs(all) + held_before + held_after)));
  work.fracture = std::max(0.0, lost_energy);
  if (const double farthest = std::max(end, to.wear.opened); farthest > start) {
    work.peak_pull = crack.left(whole.tension, start, from.wear.slipped);
    work.opened = farthest - std::max(0.0, from.gap);
  }
  work.slipped = slips;
  return work;
}

}  // namespace voussoir
