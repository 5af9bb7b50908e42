// Rigid limit analysis: how much of a pattern of loads can be borne, told by equilibrium and the laws of joints alone.
//
// Static theorem: where no admissible forces balance the loads, no equilibrium exists, however stones deform and
// joints slide. A mechanism proves it: the loads gain more along it than any admissible force can absorb.
// Source  R. K. Livesley, Int. J. Numer. Methods Eng. 12 (1978) 1853-1871; for friction that does not dilate
//         M. Gilbert, C. Casapulla, H. M. Ahmed, Computers & Structures 84 (2006) 873-887.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "statics/linear_programme.hpp"
#include "statics/rigid_structure.hpp"

namespace voussoir {

enum class LimitVerdict {
  limited,    ///< the factor is the largest that can be balanced
  unlimited,  ///< the largest factor asked can be balanced
  refused,    ///< the fixed loads, or those asked for, cannot be balanced
  unknown     ///< the programme was not solved, or its answer is not exact enough to prove anything
};

struct LimitAnswer {
  LimitVerdict verdict = LimitVerdict::unknown;
  double factor = 0;               ///< [-] of raised loads, by the power of the mechanism where there is one
  std::vector<Wrench> mechanism;   ///< per stone: velocities [m] and turn [rad], the largest motion 1 m; or none
  std::vector<Wrench> motion;      ///< the same without dilatancy, where that is possible (statics/coulomb_motion.hpp)
  bool dilates = false;            ///< it is not: the motion is the mechanism
  std::optional<double> estimate;  ///< [-] of the factor without dilatancy, where the motion needed it
  std::vector<Vector<2>> force;    ///< [N] per contact, normal and tangential, where loads are balanced
  double out_of_balance = 0;       ///< [-] of those forces, relative to the largest load of a stone
  int iterations = 0;              ///< of the simplex method
};

/// Range of a reaction over all admissible forces [N]; no numbers where it has no end.
struct ReactionRange {
  std::optional<double> least, most;
};

class LimitAnalysis {
 public:
  explicit LimitAnalysis(RigidStructure);

  const RigidStructure& structure() const { return s_; }
  /// The largest factor of raised loads, up to a largest one, that can be balanced together with the fixed loads.
  LimitAnswer largest_factor(double largest) const;
  /// Whether dry joints balance the raised loads alone. Then these can be raised without end wherever fixed loads are
  /// borne: forces of dry joints add up to forces of dry joints.
  bool borne_at_any_factor() const;
  /// Whether fixed loads and so much of the raised ones can be balanced.
  LimitAnswer bears(double factor) const;
  /// Forces that balance loads with the resultants of all joints as near to the middle of their joints as can be: the
  /// share of every joint, from its edges, that they leave free, up to the largest one looked for. Dry straight joints
  /// alone can be narrowed. Of many such forces those with the least sum of normal forces.
  LimitAnswer most_balanced(double factor, double* free_share) const;
  /// Whether stones stand in rows: each has two neighbours at most, or is held and has one, none of a row is its own
  /// neighbour's neighbour, and all joints are dry and straight. The share that forces leave free is then one of the
  /// depth of a row, and 1 / (1 - share) its geometric factor of safety.
  bool is_rows() const;
  /// Least and most of reactions over all admissible forces: per support, along x and y.
  /// @param supports  how many there are by name; a component that none of a support's nodes holds ranges from 0 to 0
  std::vector<std::array<ReactionRange, 2>> reactions(int supports, double factor) const;
  /// Estimate of the largest factor where slip does not dilate: no bound on either side. Not there where its sequence
  /// of programmes does not settle.
  /// @param associated  the answer of largest_factor(largest), where it begins
  /// @param motion      where wanted: in which it falls there, the largest 1 m; what slides opens by a thousandth of
  ///                    what it would with dilatancy
  std::optional<double> without_dilatancy(double largest, const LimitAnswer& associated,
                                          std::vector<Wrench>* motion = nullptr) const;

 private:
  struct Programme;
  /// What a mechanism proves: the factor of raised loads [-], and their power along it [N m].
  struct Bound {
    double factor, power;
  };
  void keep_ends_of_joints();
  Programme programme(double share_of_joints, bool sliding, double most) const;
  void add_forces_of_joints(Programme&, bool sliding, double most) const;
  void add_forces_of_supports(Programme&) const;
  void add_raised_loads(Programme&) const;
  LimitAnswer raised_up_to(double largest, double share_of_joints, bool* balanced_unraised,
                           ProgrammeBasis* basis = nullptr) const;
  LimitAnswer least_pressed(double share_of_joints, const ProgrammeBasis&) const;
  LimitAnswer in_motion(double largest, LimitAnswer) const;
  void tell_forces(const Programme&, const ProgrammeSolution&, double factor, LimitAnswer&) const;
  std::optional<Bound> bound_of(const std::vector<Wrench>& mechanism) const;
  LimitAnswer judge(const Programme&, const ProgrammeSolution&, double largest) const;
  /// The same structure under its fixed loads and a factor of the raised ones, all of them raised from nothing.
  LimitAnalysis under_loads(double factor) const;

  RigidStructure s_;
  std::vector<int> kept_;     ///< contacts that bear what all bear: the ends of dry straight joints, every other point
  std::vector<int> partner_;  ///< of a kept contact, the other end of its dry straight joint; -1
  double unit_ = 0;           ///< [N] largest load of a stone
  double raised_unit_ = 0;    ///< the same of the raised loads
};

}  // namespace voussoir
