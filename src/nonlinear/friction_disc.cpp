#include "nonlinear/friction_disc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voussoir {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The least t > 0 at which x + t d is not positive any more.
double way_out_of(const SymmetricPair& x, const SymmetricPair& d) {
  double least = infinity;
  if (x.mixed == 0 && d.mixed == 0) {
    for (int j = 0; j < 2; ++j)
      if (d.diagonal[j] < 0) least = std::min(least, -x.diagonal[j] / d.diagonal[j]);
    return least;
  }
  // Where its determinant vanishes.
  const double square = d.diagonal[0] * d.diagonal[1] - d.mixed * d.mixed;
  const double slope = x.diagonal[0] * d.diagonal[1] + x.diagonal[1] * d.diagonal[0] - 2 * x.mixed * d.mixed;
  const double start = x.diagonal[0] * x.diagonal[1] - x.mixed * x.mixed;
  const double root = slope * slope - 4 * square * start;
  if (root < 0) return infinity;
  const double sum = -(slope + std::copysign(std::sqrt(root), slope)) / 2;
  for (const double t : {sum / square, start / sum})
    if (t > 0) least = std::min(least, t);
  return least;
}

}  // namespace

InDisc FrictionDisc::parts(const double* of) const {
  if (tangents_ == 1) return {axis_[0] * of[0], 0};
  return {axis_[0] * of[0] + axis_[1] * of[1], axis_[0] * of[1] - axis_[1] * of[0]};
}

void FrictionDisc::enter(int tangents, const double* q, const double* slip, const Start& start) {
  *this = {};
  tangents_ = tangents;
  bounded_ = std::isfinite(start.bound);
  if (!bounded_) return;
  const double size = tangents == 2 ? std::hypot(q[0], q[1]) : 0;
  if (size > 0) axis_ = {q[0] / size, q[1] / size};
  const auto force = parts(q), motion = parts(slip);
  w_ = {std::max(start.bound - force.along, start.least), std::max(start.bound + force.along, start.least)};
  const double half = std::sqrt(motion.along * motion.along + motion.across * motion.across) / 2;
  y_.diagonal = {half - motion.along / 2 + start.distance, half + motion.along / 2 + start.distance};
  y_.mixed = motion.across / 2;
}

void FrictionDisc::scale(double floor) {
  if (!bounded_) {
    t_ = {{1 / floor, 1 / floor}, 0};
    return;
  }
  const auto& y = y_.diagonal;
  const double product[] = {w_[0] * y[0], w_[1] * y[1]};
  const double root = std::sqrt(std::max(0.0, w_[0] * w_[1] * (y[0] * y[1] - y_.mixed * y_.mixed)));
  const double trace = std::sqrt(product[0] + product[1] + 2 * root);
  const double g[] = {(product[0] + root) / (trace * w_[0]), (product[1] + root) / (trace * w_[1])};
  g_.mixed = y_.mixed / trace;
  // Without a mixed part the two pairs stand alone.
  for (int j = 0; j < 2; ++j) g_.diagonal[j] = y_.mixed == 0 ? y[j] / w_[j] : g[j] * g[j];
  mixed_ = {2 * g[0] * g_.mixed, 2 * g_.mixed * g[1]};
  across_ = g[0] * g[1] + g_.mixed * g_.mixed;
  const double along = g_.diagonal[0] + g_.diagonal[1] - 2 * g_.mixed * g_.mixed + floor;
  const double across = 2 * across_ + floor, both = mixed_[1] - mixed_[0];
  t_.diagonal = {1 / (along - both * both / across), 1 / (across - both * both / along)};
  t_.mixed = -both / across * t_.diagonal[0];
}

std::array<double, 3> FrictionDisc::resistance() const {
  if (tangents_ == 1) return {t_.diagonal[0], 0, t_.diagonal[0]};
  const double c = axis_[0], s = axis_[1], along = t_.diagonal[0], across = t_.diagonal[1];
  return {c * c * along - 2 * c * s * t_.mixed + s * s * across, c * s * (along - across) + (c * c - s * s) * t_.mixed,
          s * s * along + 2 * c * s * t_.mixed + c * c * across};
}

std::array<double, 2> FrictionDisc::friction(const InDisc& wanted) const {
  if (tangents_ == 1) return {t_.diagonal[0] * wanted.along, 0};
  const double along = t_.diagonal[0] * wanted.along + t_.mixed * wanted.across;
  const double across = t_.mixed * wanted.along + t_.diagonal[1] * wanted.across;
  return {axis_[0] * along - axis_[1] * across, axis_[1] * along + axis_[0] * across};
}

InDisc FrictionDisc::right_hand_side(const double* q, const double* slip, double bound, double barrier) {
  const auto force = parts(q), motion = parts(slip);
  if (!bounded_) return {-motion.along, -motion.across};
  const auto& y = y_.diagonal;
  residual_ = {bound - force.along - w_[0], bound + force.along - w_[1]};
  residual_across_ = force.across;
  for (int j = 0; j < 2; ++j) dy_.diagonal[j] = barrier / w_[j] - y[j];
  InDisc wanted;
  wanted.along = -motion.along + ((barrier - y[1] * residual_[1]) / w_[1] - (barrier - y[0] * residual_[0]) / w_[0]);
  if (tangents_ == 1) return wanted;
  // The squares of G are y / w less a part of the mixed one.
  const double mixed = g_.mixed * g_.mixed;
  wanted.along -= mixed * (1 + w_[1] / w_[0]) * residual_[0] - mixed * (1 + w_[0] / w_[1]) * residual_[1] +
                  (mixed_[1] - mixed_[0]) * residual_across_;
  wanted.across =
      -motion.across - (mixed_[0] * residual_[0] + mixed_[1] * residual_[1] + 2 * across_ * residual_across_);
  return wanted;
}

void FrictionDisc::direct(const double* change, double wider) {
  if (!bounded_) return;
  const auto dq = parts(change);
  dw_.diagonal = {residual_[0] + wider - dq.along, residual_[1] + wider + dq.along};
  dw_.mixed = residual_across_ + dq.across;
  const auto& d = dw_.diagonal;
  const double mixed = g_.mixed * g_.mixed;
  dy_.diagonal[0] -= g_.diagonal[0] * d[0] + (mixed_[0] * dw_.mixed + mixed * d[1]);
  dy_.diagonal[1] -= g_.diagonal[1] * d[1] + (mixed_[1] * dw_.mixed + mixed * d[0]);
  dy_.mixed = -y_.mixed - ((mixed_[0] * d[0] + mixed_[1] * d[1]) / 2 + across_ * dw_.mixed);
}

double FrictionDisc::way_out() const {
  return bounded_ ? std::min(way_out_of({w_, 0}, dw_), way_out_of(y_, dy_)) : infinity;
}

void FrictionDisc::advance(double length) {
  for (int j = 0; j < 2; ++j) {
    w_[j] += length * dw_.diagonal[j];
    y_.diagonal[j] += length * dy_.diagonal[j];
  }
  y_.mixed += length * dy_.mixed;
  if (dw_.mixed != 0) turn(length * dw_.mixed);
}

/// Turns the axis so that W with this mixed part is diagonal (Jacobi): by twice the angle of the matrices.
void FrictionDisc::turn(double mixed) {
  const double ratio = (w_[1] - w_[0]) / (2 * mixed);
  const double t = std::copysign(1.0, ratio) / (std::abs(ratio) + std::sqrt(1 + ratio * ratio));
  const double c = 1 / std::sqrt(1 + t * t), s = t * c;
  w_[0] -= t * mixed;
  w_[1] += t * mixed;
  const auto y = y_;
  y_.diagonal = {c * c * y.diagonal[0] - 2 * c * s * y.mixed + s * s * y.diagonal[1],
                 s * s * y.diagonal[0] + 2 * c * s * y.mixed + c * c * y.diagonal[1]};
  y_.mixed = c * s * (y.diagonal[0] - y.diagonal[1]) + (c * c - s * s) * y.mixed;
  const double by[] = {c * c - s * s, 2 * c * s};
  axis_ = {by[0] * axis_[0] - by[1] * axis_[1], by[0] * axis_[1] + by[1] * axis_[0]};
  const double size = std::hypot(axis_[0], axis_[1]);
  for (double& a : axis_) a /= size;
}

void hold_within(double bound, double* q, int tangents) {
  double size = 0;
  for (int t = 0; t < tangents; ++t) size += q[t] * q[t];
  size = std::sqrt(size);
  for (int t = 0; size > bound && t < tangents; ++t) q[t] = bound * (q[t] / size);
}

}  // namespace voussoir
