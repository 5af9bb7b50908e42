// Velocities after joints have closed within a time step.
//
// The midpoint rule leaves a point that closed with some relative velocity, whose sign then turns with every step, and
// its contact force with it; and it loses the energy lambda x gap of the closing. After Laursen and Love (2002)
// velocity jumps repair both: relative velocities of closed points become zero by normal impulses, and the energy this
// and the closing took returns as the least change along the way the impulse spreads behind the joint, as a vibration
// within bodies: resultants would be impulses of joints, which may not pull.
// Points that begin to stick lose their relative velocity to friction. Impulses come in pairs: momentum is kept.
//
// What ends relative velocities may pull: a point that has just closed was pushed away by up to twice what stops it. In
// the step its friction was that of this push. So friction follows to what presses in the end, and no impact is rubbed
// harder than it presses.
//
// Stones that strength holds together at a point are one there, as those that a tie holds: an impulse passes between
// them in every direction, and they vibrate as one.
//
// Supports bear what holds them at their velocities: these impulses are part of the force that a step tells of.
// Energies are those seen from the supports: where one moves its impulse does work, and what the kinetic energy loses
// but for that work is what was taken: it is never negative and the same for whoever moves, a stone on a bed or the bed
// under a stone.
// Reasons and numbers: dynamics/README.md.
#pragma once

#include <memory>

#include "model/contact_problem.hpp"
#include "model/model.hpp"
#include "time/velocity_projection.hpp"

namespace voussoir {

/// Largest normal force of selected points [N]. Collective.
double largest_force(const Model&, const ContactState&);

/// What a change of velocities adds to the book of a step.
struct VelocityJump {
  double friction = 0;  ///< [J] taken; below 0 where friction gives back more than it takes of what a step had taken
  std::vector<double> impulses;  ///< of supports [N s, node copies]; none where velocities were right
};

/// Adds what may be none. [N s]
void add_impulses(std::vector<double>& sum, const std::vector<double>& more, double factor = 1);

/// What friction did in a step.
struct Rubbed {
  double acted = 0;  ///< [s] for which the forces of the step acted
  double taken = 0;  ///< [J] that it took, of which it may give back
};

class VelocityUpdate {
 public:
  /// @param mass  the structure with the mass of its blocks in the place of their stiffness
  VelocityUpdate(const Model& at_rest, const BlockSystem& mass);
  ~VelocityUpdate();

  /// Collective.
  /// @param step     model of the time step
  /// @param state    displacement, velocity and forces at the end of the step; the velocity is changed
  /// @param lost     energy the closing of points took in this step [J]; 0 when none closed
  /// @param resting  relative velocity below which a point counts as resting [m/s]
  /// @param rubbed   what friction did in the step
  VelocityJump apply(const Model& step, ContactState& state, double lost, double resting, const Rubbed& rubbed);

  /// Points that may be tied: 1 where the two sides have no more relative motion than rest, or an energy that friction
  /// may take.
  /// @param energy  of the relative motion of a point [J]
  std::vector<char> calm(const ContactState&, double energy, double resting) const;
  /// Ends the relative velocities of tied points: the two nodes of a point that was tied in motion would swing against
  /// each other from step to step. Collective.
  VelocityJump settle(ContactState&, double resting);

  /// Forgets what depends on the model of a time step; to be called before that model goes.
  void forget();

  double kinetic_energy(const std::vector<double>& velocity) const { return product(velocity, velocity) / 2; }
  /// Work of impulses of supports [N s] that have the velocities that are given [m/s, node copies]. Collective.
  double work_of_supports(const std::vector<double>& impulses, const std::vector<double>& velocity) const;

 private:
  struct Spread;
  double product(const std::vector<double>& v, const std::vector<double>& w) const;
  using Supports = std::unique_ptr<const std::vector<double>>;  ///< [m/s] velocities there; none where none moves
  Supports moving_supports(const std::vector<double>& velocity) const;
  double work(const std::vector<double>& impulses, const Supports&) const;
  JumpImpulses project(std::vector<double>& velocity, std::vector<char> held, const std::vector<char>& apart);
  VelocityJump stop(std::vector<double>& velocity, const std::vector<char>& held, const std::vector<char>& apart);
  double fastest(const PointField& speed, const std::vector<char>& held) const;
  /// What meets: relative velocities [m/s], what is closed, and which points are not one.
  struct Impact {
    const PointField& speed;
    const std::vector<char>&closed, &apart;
  };
  /// Returns what presses, or pulls, beside the forces of the step.
  JumpImpulses rebound(const Model& step, ContactState&, const Impact&, double lost, double resting);
  PointField to_the_pressure(const ContactState&, const Impact&, const PointField& at_points, double acted) const;
  /// Friction follows what presses beside the forces of the step, but gives back no more energy than it took.
  VelocityJump follow_the_pressure(ContactState&, const Impact&, const PointField& at_points, const Rubbed&);
  /// A change of velocities with the impulses of supports that come with it.
  struct Way {
    std::vector<double> velocity, impulses;  ///< [m/s], [N s]
    PointField at_points;                    ///< [N s] what presses there, but for what has no resultant
  };
  Way spread(const Model& step, const PointField& lambda, const PointField& speed, const std::vector<char>& closed,
             double resting);
  Way within_bodies(Way) const;

  const Model& at_rest_;
  const BlockSystem& mass_;
  VelocityProjection projection_;
  LinearSolver solver_;
  std::unique_ptr<Spread> spread_;  ///< of the last selection and time step
};

}  // namespace voussoir
