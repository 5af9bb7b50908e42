// The slacks of friction of one point on the interior path, in the plane and in space.
//
// Forces within the disc |q| <= b are a symmetric matrix that is not negative, motions another one,
//
//   W = | b - q_a   q_c     |      Y = | y_0   y_x |      y_1 - y_0 = s_a,  2 y_x = s_c      W Y = nu 1
//       | q_c       b + q_a |          | y_x   y_1 |
//
// of the parts of friction q and slip s along an axis of the joint and across it. The determinant of W is b^2 - |q|^2,
// and W Y = nu 1 says s = -Y q with one scalar Y = 2 nu / (b^2 - |q|^2). With one tangent nothing lies across: both are
// diagonal, two pairs of numbers. W holds a bound and a friction of its own, which come to those of the point within a
// step; the axis is turned so that W is diagonal.
//
// A Newton step changes them by dY = nu W^-1 - Y - G dW G, where G W G = Y (Nesterov and Todd). So motion and force
// have a symmetric positive matrix between them, as for one tangent.
//
// Theory   Y. E. Nesterov, M. J. Todd, Math. Oper. Res. 22 (1997) 1-42; F. Alizadeh, D. Goldfarb, Math. Program. 95
//          (2003) 3-51 (a disc is a second-order cone, and the one of three dimensions a cone of matrices).
#pragma once

#include <array>

namespace voussoir {

/// A part along the axis of a disc and one across it.
struct InDisc {
  double along = 0, across = 0;
};
inline InDisc operator-(const InDisc& a, const InDisc& b) { return {a.along - b.along, a.across - b.across}; }
inline InDisc operator*(double s, const InDisc& a) { return {s * a.along, s * a.across}; }

/// A symmetric matrix of two rows.
struct SymmetricPair {
  std::array<double, 2> diagonal{};
  double mixed = 0;
};

class FrictionDisc {
 public:
  /// Where the path begins.
  struct Start {
    double bound;     ///< [N] infinite where nothing slips: then it is no disc, and what follows is that of a spring
    double least;     ///< [N] that the force keeps from it
    double distance;  ///< [m] that the motion keeps from none
  };
  /// Around a force within its bound [N] and a slip [m], per tangent.
  void enter(int tangents, const double* q, const double* slip, const Start&);

  /// Makes the derivative ready. Resists with no more than 1/floor.
  /// @param floor  [m/N]
  void scale(double floor);
  /// Resistance per tangent, as a symmetric matrix: first tangent, mixed, second tangent [N/m].
  std::array<double, 3> resistance() const;
  /// Friction [N] per tangent that a slip wanted [m] makes.
  std::array<double, 2> friction(const InDisc& wanted) const;
  /// Slip wanted per change of the pressure [m/N].
  /// @param follows  change of the bound with it [-]
  InDisc drag(double follows) const {
    return {follows * (g_.diagonal[1] - g_.diagonal[0]), follows * (mixed_[0] + mixed_[1])};
  }
  /// Slip [m] that a step wants, towards a barrier and with no more motion.
  /// @param q       [N], slip [m] of the point, per tangent
  /// @param bound   [N] of the point
  InDisc right_hand_side(const double* q, const double* slip, double bound, double barrier);
  /// Directions from the changes of friction per tangent and of the bound [N].
  void direct(const double* change, double wider);
  /// The step after which W or Y would not be positive any more; infinite where they stay.
  double way_out() const;
  void advance(double length);

  /// Diagonal of W Y [J].
  std::array<double, 2> products() const { return {w_[0] * y_.diagonal[0], w_[1] * y_.diagonal[1]}; }
  /// Whether the motion outweighs the force somewhere, with this stiffness [N/m] between them.
  bool slips(double stiffness) const {
    return bounded_ && (w_[0] < stiffness * y_.diagonal[0] || w_[1] < stiffness * y_.diagonal[1]);
  }
  /// Parts of what has one number per tangent.
  InDisc parts(const double* of_tangents) const;

 private:
  void turn(double mixed);

  int tangents_ = 1;
  bool bounded_ = false;
  std::array<double, 2> axis_{1, 0};  ///< per tangent
  std::array<double, 2> w_{};         ///< [N] of W, which is diagonal
  SymmetricPair y_;                   ///< [m]
  SymmetricPair dw_, dy_;
  std::array<double, 2> residual_{};  ///< [N] of W, and across
  double residual_across_ = 0;
  SymmetricPair g_;                ///< squares of G on its diagonal, G_01 [root of m/N]
  std::array<double, 2> mixed_{};  ///< 2 G_00 G_01, 2 G_01 G_11 [m/N]
  double across_ = 0;              ///< G_00 G_11 + G_01^2 [m/N]
  SymmetricPair t_;                ///< [N/m] resistance along, across, and of both
};

/// Cuts friction to a bound [N].
void hold_within(double bound, double* q, int tangents);

}  // namespace voussoir
