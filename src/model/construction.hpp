// Construction stages: which blocks are there, and how joints are born and die.
//
// Blocks that are not there are held where they were, bear no load, and their joints stand so far open that they never
// close: no unknown moves for them and no force passes. A block is born without stress where the mesh draws it; its
// joints with blocks that have moved already are born closed and without slip. A block that disappears takes its energy
// along, and lets go of those that stay: what it holds of their motion until it is gone, it takes along as well.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/contact_problem.hpp"
#include "model/model.hpp"

namespace voussoir {

struct Scene;

class Construction {
 public:
  /// Of the scene that the model was built of.
  Construction(const Scene&, const Model&);

  /// Whether the scene builds anything: the same on all ranks.
  bool builds() const { return builds_; }

  /// Lets blocks appear and disappear as a stage wants them; nothing happens when they are as they should be. To be
  /// called before every step.
  void begin(const std::string& stage, Model&, ContactState&);
  /// Energy that left the structure with the blocks that were gone when the last step began [J]: their own, and what
  /// they took of the motion of the others as they let go, the mean of their force before and none after. Collective.
  /// @param start, after  states at the start and the end of that step
  double taken(const ContactState& start, const ContactState& after) const;
  /// 1 for each local block that stays out of that account, as it was not among those that were gone when the last step
  /// began; empty when a scene builds nothing.
  const std::vector<char>& stays() const { return stays_; }
  /// Forces on the others that those blocks let go of in that step [N, dim x local node copies]; empty without
  /// construction.
  const std::vector<double>& let_go() const { return let_go_; }
  /// Whether each local block is not there; empty when a scene builds nothing.
  const std::vector<char>& absent() const { return absent_; }
  /// Takes loads off blocks that are not there, and holds them where they are.
  void restrict(const ContactState&, std::vector<double>& force, std::vector<double>& prescribed) const;

 private:
  /// Whether both blocks of a point are there.
  bool joined(const Model&, int k) const;
  void take(const Model&, const ContactState&);
  /// Of points with a side that is not there [m]: nothing moves as far as the structure is large.
  double apart() const { return structure_.size(); }
  double drawn(int k) const { return drawn_gap_.empty() ? 0.0 : drawn_gap_[k]; }
  void part(int k, ContactState&) const;
  /// @param between  relative motion of the two sides so far [m]
  void give_birth(int k, bool can_be_tied, const Vector<3>& between, ContactState&) const;
  void close(int k, const Vector<3>& between, ContactState&) const;

  const BlockSystem& structure_;
  const bool builds_, all_selected_;
  std::map<std::string, std::vector<char>> absent_in_;  ///< by stage, per local block
  std::vector<double> drawn_gap_;  ///< [m] per point, of joints as the scene draws them; empty when all are closed
  std::vector<char> absent_;       ///< per local block; empty when a scene builds nothing
  std::vector<char> stays_;        ///< likewise: all but the blocks that disappeared as this step began
  double energy_gone_ = 0;         ///< [J] of the blocks of this rank that disappeared as this step began
  std::vector<double> let_go_;     ///< [N, dim x local node copies] with which they had held the others
};

}  // namespace voussoir
