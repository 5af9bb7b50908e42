// Stones of the plane that move as one because ties hold them together, where no support holds any of them.
//
// A change of velocities without resultants leaves the momentum and the moment of momentum of every such body as they
// are: it is a vibration within them.
#pragma once

#include "model/contact_problem.hpp"
#include "model/model.hpp"

namespace voussoir {

class FreeBodies {
 public:
  /// Collective.
  /// @param mass      the structure with the mass of its blocks in the place of their stiffness
  /// @param selected  points that tie nothing; the others make one body of two blocks
  FreeBodies(const Model&, const BlockSystem& mass, const std::vector<char>& selected);

  /// Takes from velocities [m/s, on node copies] the motions of bodies as wholes. Returns the momentum that all of them
  /// had together [N s]. Collective.
  Vector<3> remove_motion(std::vector<double>& velocity) const;

 private:
  const BlockSystem& mass_;
  std::vector<int> body_;        ///< per local block; -1 where a support holds it
  std::vector<double> turn_;     ///< [m] velocity of node copies when bodies turn about their mass centres at 1 rad/s
  std::vector<double> weight_;   ///< [kg] of bodies
  std::vector<double> inertia_;  ///< [kg m2] of bodies, about their mass centres
};

}  // namespace voussoir
