// Stones that move as one because ties hold them together, where no support holds any of them.
//
// A change of velocities without resultants leaves the momentum and the moment of momentum of every such body as they
// are: it is a vibration within them.
#pragma once

#include "base/dense.hpp"
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
  void find_turns(const Model&);
  void find_inertia();
  template <std::size_t n>
  std::vector<std::array<double, n>> totals(const std::vector<std::array<double, n>>& mine) const;
  Vector<3> turns_of(int body, const Vector<3>& moment) const;

  const BlockSystem& mass_;
  const int turns_;  ///< ways to turn: one in the plane, three in space
  /// Of the bodies that this rank has a block of, which all lists of bodies hold in this order: their first block.
  std::vector<long long> first_block_;
  std::vector<int> body_;  ///< per local block; -1 where a support holds it
  /// [m] velocity of node copies when bodies turn about their mass centres at 1 rad/s, by way to turn
  std::vector<std::vector<double>> turn_;
  std::vector<double> weight_;      ///< [kg] of bodies
  std::vector<Matrix<3>> inertia_;  ///< [kg m2] of bodies, about their mass centres
};

}  // namespace voussoir
