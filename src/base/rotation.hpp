// Rotations, however far: what takes a body elsewhere without straining it. In the plane an angle, in space a unit
// quaternion, of which half the way between two is found without asking about which axis.
//
// Theory  B. K. P. Horn, Closed-form solution of absolute orientation using unit quaternions, J. Opt. Soc. Am. A 4
//         (1987) 629-642.
#pragma once

#include <cmath>

#include "base/tensor.hpp"

namespace voussoir {

template <int dim>
class Rotation;

/// Of the plane, counter-clockwise.
template <>
class Rotation<2> {
 public:
  explicit Rotation(double angle = 0) : angle_(angle), cosine_(std::cos(angle)), sine_(std::sin(angle)) {}
  Vector<2> operator()(const Vector<2>& a) const {
    return {cosine_ * a[0] - sine_ * a[1], sine_ * a[0] + cosine_ * a[1]};
  }
  Rotation back() const { return Rotation(-angle_); }
  /// Along the axis, as long as the angle [rad].
  Vector<3> vector() const { return {0, 0, angle_}; }
  bool operator==(const Rotation& other) const { return angle_ == other.angle_; }
  /// [rad] from another one to this one, 0 to pi.
  double apart(const Rotation& other) const { return std::abs(way_from(other)); }
  /// The shorter way.
  Rotation halfway_to(const Rotation& other) const { return Rotation(angle_ - way_from(other) / 2); }

 private:
  double way_from(const Rotation& other) const {
    constexpr double full_turn = 6.283185307179586;
    return std::remainder(angle_ - other.angle_, full_turn);
  }

  double angle_, cosine_, sine_;
};

/// Of space, right-handed.
template <>
class Rotation<3> {
 public:
  Rotation() = default;
  /// @param direction  of length one
  Rotation(const Vector<3>& direction, double angle)
      : whole_(std::cos(angle / 2)), along_(std::sin(angle / 2) * direction) {}
  /// The rotation of a quaternion, of any length but 0.
  static Rotation of_quaternion(double whole, const Vector<3>& along) {
    Rotation r;
    const double size = std::copysign(std::sqrt(whole * whole + dot(along, along)), whole);
    r.whole_ = whole / size;
    r.along_ = (1 / size) * along;
    return r;
  }
  Vector<3> operator()(const Vector<3>& a) const {
    const auto across = 2.0 * cross(along_, a);
    return a + whole_ * across + cross(along_, across);
  }
  Rotation back() const { return of_quaternion(whole_, -1.0 * along_); }
  /// Along the axis, as long as the angle [rad], which is at most pi.
  Vector<3> vector() const {
    const double size = norm(along_);
    return size > 0 ? (std::copysign(2.0, whole_) * std::atan2(size, std::abs(whole_)) / size) * along_ : Vector<3>{};
  }
  bool operator==(const Rotation& other) const { return whole_ == other.whole_ && along_ == other.along_; }
  /// [rad] from another one to this one, 0 to pi.
  double apart(const Rotation& other) const {
    const auto between = other.whole_ * along_ - whole_ * other.along_ - cross(along_, other.along_);
    return 2 * std::atan2(norm(between), std::abs(whole_ * other.whole_ + dot(along_, other.along_)));
  }
  /// The shorter way.
  Rotation halfway_to(const Rotation& other) const {
    const double side = whole_ * other.whole_ + dot(along_, other.along_) < 0 ? -1.0 : 1.0;
    return of_quaternion(whole_ + side * other.whole_, along_ + side * other.along_);
  }

 private:
  double whole_ = 1;
  Vector<3> along_{};
};

/// By an angle about a direction of length one, which in the plane is that of the third axis.
template <int dim>
Rotation<dim> rotation_about(const Vector<3>& direction, double angle) {
  if constexpr (dim == 2)
    return Rotation<2>(angle);
  else
    return Rotation<3>(direction, angle);
}

/// Finds the rotation that takes arms nearest (least squares) to where motions take them, both counted from their
/// middles. What arms and what motions make of it is summed apart, so that a small turn keeps its digits beside long
/// arms.
template <int dim>
class NearestRotation {
 public:
  void add(const Vector<dim>& arm, const Vector<dim>& motion) {
    for (int a = 0; a < dim; ++a) {
      arms_[a] = arms_[a] + arm[a] * arm;
      motions_[a] = motions_[a] + arm[a] * motion;
    }
  }
  Rotation<dim> found() const;

 private:
  std::array<Vector<dim>, dim> arms_{}, motions_{};
};

template <>
Rotation<2> NearestRotation<2>::found() const;
template <>
Rotation<3> NearestRotation<3>::found() const;

}  // namespace voussoir
