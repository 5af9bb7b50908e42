// Unilateral contact with Coulomb friction, cohesion and a tension cut-off at one contact point.
//
// Theory       P. Alart, A. Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991) 353-375.
// Conventions  Component 0 is normal, the others tangential. Compression positive. A force is the
//              traction times the point's share of the joint.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// Strength of one point, integrated over its share of the joint.
struct PointLaw {
  double friction = 0;  ///< [-] Coulomb's coefficient, may be infinite
  double cohesion = 0;  ///< [N] shear force borne without compression, may be infinite
  double tension = 0;   ///< [N] tensile force borne, may be infinite
};

/// Laws of many points. What no point of a rank has is not held: a scene without cohesion has no bytes for it.
class PointLaws {
 public:
  explicit PointLaws(std::size_t points = 0, const PointLaw& law = {}) : points_(points) {
    if (law.friction != 0 || law.cohesion != 0 || law.tension != 0)
      for (std::size_t k = 0; k < points; ++k) set(k, law);
  }
  std::size_t size() const { return points_; }
  PointLaw operator[](std::size_t k) const { return {at(friction_, k), at(cohesion_, k), at(tension_, k)}; }
  void set(std::size_t k, const PointLaw& law) {
    put(friction_, k, law.friction);
    put(cohesion_, k, law.cohesion);
    put(tension_, k, law.tension);
  }
  std::size_t bytes() const {
    return (friction_.capacity() + cohesion_.capacity() + tension_.capacity()) * sizeof(double);
  }

 private:
  static double at(const std::vector<double>& of, std::size_t k) { return of.empty() ? 0.0 : of[k]; }
  void put(std::vector<double>& of, std::size_t k, double value) const {
    if (of.empty() && value == 0) return;
    of.resize(points_);
    of[k] = value;
  }
  std::size_t points_;
  std::vector<double> friction_, cohesion_, tension_;  ///< as many as points, or none
};

/// What mortar gives way under a force, in series with contact: the law holds for gap + normal x p and slip +
/// tangential x q, which are those of the stones without the mortar between them. 0 where stone meets stone [m/N].
struct PointCompliance {
  double normal = 0;
  double tangential = 0;  ///< the same in all tangential directions

  double along(int component) const { return component == 0 ? normal : tangential; }
};

/// How a point resists in a linear system [N/m], 0 where it gives way: the derivative of its force by its motion.
///
///   change of p = -normal d_N - pull d_T        change of q = -coupling d_N - tangential d_T
///
/// In the plane there is one tangential direction, the first, in space there are two.
struct PointStiffness {
  double normal = 0;
  std::array<double, 3> tangential{};  ///< symmetric matrix: first tangent, mixed, second tangent
  std::array<double, 2> coupling{};    ///< tangential forces per normal gap: friction that follows the pressure
  std::array<double, 2> pull{};        ///< normal force per slip: tension strength that is lost on the way

  PointStiffness() = default;
  /// The same in all tangential directions; coupled along the first.
  PointStiffness(double along_normal, double along_tangents, double coupled = 0)
      : normal(along_normal), tangential{along_tangents, 0, along_tangents}, coupling{coupled, 0} {}

  /// Tangential stiffness, tangents counted from 0.
  double along(int row, int column) const { return tangential[row + column]; }
  bool resists_slip() const { return tangential[0] > 0 || tangential[2] > 0; }
  /// Whether it can slip along some tangent without a force.
  bool gives_way(int tangents) const {
    const double round_off = 1e-12 * (tangential[0] + tangential[2]) * (tangential[0] + tangential[2]);
    const double both = tangential[0] * tangential[2] - tangential[1] * tangential[1];
    return tangents == 1 ? !(tangential[0] > 0) : !(both > round_off);
  }
  /// Whether a system with it is not symmetric, or not positive.
  bool couples() const { return coupling[0] != 0 || coupling[1] != 0 || pull[0] != 0 || pull[1] != 0 || softens(); }
  /// Slides along a unit vector s of the tangents: friction follows the pressure, and the direction turns.
  /// @param follows  tangential force per normal gap
  /// @param across   stiffness against motion across s
  /// @param along    stiffness against motion along s, negative where cohesion is lost on the way
  /// @param pulls    normal force per slip along s
  void slide(const double* s, int tangents, double follows, double across, double along = 0, double pulls = 0) {
    for (int t = 0; t < tangents; ++t) {
      coupling[t] = s[t] * follows;
      pull[t] = s[t] * pulls;
    }
    tangential = {along * s[0] * s[0], 0, 0};
    if (tangents == 2)
      tangential = {across * s[1] * s[1] + along * s[0] * s[0], (along - across) * s[0] * s[1],
                    across * s[0] * s[0] + along * s[1] * s[1]};
  }
  /// Whether force falls as the point goes on, in some direction: then no energy of springs stands for it.
  bool softens() const {
    const double round_off = 1e-12 * (tangential[0] + tangential[2]) * (tangential[0] + tangential[2]);
    return normal < 0 || tangential[0] < 0 || tangential[2] < 0 ||
           tangential[0] * tangential[2] - tangential[1] * tangential[1] < -round_off;
  }
  /// What is left without directions that soften, and without the coupling: symmetric and not negative.
  PointStiffness springs() const {
    PointStiffness s;
    s.normal = std::max(0.0, normal);
    PointStiffness tangents = *this;
    tangents.normal = 0;
    if (!tangents.softens()) s.tangential = tangential;
    return s;
  }
  /// Gives way no more easily than that; what softens does so beside it.
  void hold(double along_normal, double along_tangents) {
    const auto held = [](double one, double other) { return std::max(one, other + std::min(0.0, one)); };
    normal = held(normal, along_normal);
    for (int t : {0, 2}) tangential[t] = held(tangential[t], along_tangents);
  }
  /// force [N] -= what it changes by along a motion [m], both [normal, tangents].
  void yield(const double* motion, int components, double* force) const {
    force[0] -= normal * motion[0];
    for (int t = 0; t + 1 < components; ++t) {
      force[0] -= pull[t] * motion[t + 1];
      force[t + 1] -= coupling[t] * motion[0];
      for (int u = 0; u + 1 < components; ++u) force[t + 1] -= along(t, u) * motion[u + 1];
    }
  }
};

/// Stiffness A of a law with mortar C in series: (1 + A C)^-1 A. The law holds for the motion of stones, of which a
/// force changes the mortar's part.
PointStiffness in_series(const PointStiffness&, const PointCompliance&, int components);

/// Largest tangential force under a normal force: cohesion + mu p, never negative.
template <class T>
T friction_bound(const PointLaw& law, const T& normal) {
  T bound(law.cohesion);
  if (normal > 0) bound += law.friction * normal;
  if (normal < 0 && std::isfinite(law.friction)) bound += law.friction * normal;
  return bound > 0 ? bound : T(0);
}

/// Round-off of a shear beside its bound. A force that was cut to its bound (the point is released, or slipped in the
/// step before) is there but for last bits of products, and those of its motion times the stiffness: a difference of
/// displacements, which may be a thousand times what the force stretches its stones by.
constexpr double shear_round_off = 1e-12;

/// Whether friction bears a shear, and more. One on its bound it does not, however a processor rounds it.
inline bool below_bound(double shear, double bound) { return shear < bound * (1 - shear_round_off); }

/// What a point does.
enum class ContactStatus : char { open, stick, slip };

/// What the law makes of a trial force, the force that the point would have if it resisted its motion elastically. The
/// one formula for a status.
///
/// Closed is what presses or pulls no more than the tension strength bears. Zero gap and zero force is closed: stones
/// that touch resist as soon as one of them moves. A closed point sticks where its shear is below the friction bound,
/// or where it has none although it could rub; where nothing rubs (no friction, no cohesion) it never sticks. One on
/// its bound slips, also before it has moved: there a force was cut off that was too large, or slip goes on; one that
/// pulls with its strength is closed likewise.
/// @param normal  [N] of the trial force
/// @param shear   [N] size of its tangential part
/// @param bound   [N] largest friction, of this force or of another: friction_bound()
inline ContactStatus judge(const PointLaw& law, double normal, double shear, double bound) {
  if (!(normal >= -law.tension * (1 + shear_round_off))) return ContactStatus::open;
  const bool rubs = law.friction > 0 || law.cohesion > 0;
  return below_bound(shear, bound) || (rubs && shear == 0) ? ContactStatus::stick : ContactStatus::slip;
}

/// Nearest admissible normal force: not below the tensile strength.
template <class T>
T project_normal(const PointLaw& law, const T& normal) {
  return normal > -law.tension ? normal : T(-law.tension);
}

/// Nearest tangential force with |q| <= bound.
template <std::size_t n, class T>
std::array<T, n> project_tangential(const std::array<T, n>& q, double bound) {
  const T size = norm(q);
  if (size <= bound) return q;
  return T(bound / size) * q;
}

/// Nearest admissible force, normal part first: the tangential one is held to the friction that this bears.
template <std::size_t n>
std::array<double, n> nearest_lawful(const PointLaw& law, std::array<double, n> force) {
  force[0] = project_normal(law, force[0]);
  std::array<double, n - 1> q;
  for (std::size_t c = 1; c < n; ++c) q[c - 1] = force[c];
  q = project_tangential(q, friction_bound(law, force[0]));
  for (std::size_t c = 1; c < n; ++c) force[c] = q[c - 1];
  return force;
}

/// Distance of a force from the admissible set, normal part first (as the projection of the contact law).
template <std::size_t n>
double violation(const PointLaw& law, const std::array<double, n>& force) {
  const double normal = project_normal(law, force[0]);
  std::array<double, n - 1> q;
  for (std::size_t c = 1; c < n; ++c) q[c - 1] = force[c];
  const double bound = friction_bound(law, normal);
  const double excess = norm(q) > bound ? norm(q) - bound : 0.0;
  return std::sqrt((normal - force[0]) * (normal - force[0]) + excess * excess);
}

}  // namespace voussoir
