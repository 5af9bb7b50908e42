// Rigid limit analysis: how much of a pattern of loads can be borne, told by equilibrium and the laws of joints alone.
//
// Static theorem: where no admissible forces balance the loads, no equilibrium exists, however stones deform and
// joints slide. A mechanism proves it: the loads gain more along it than any admissible force can absorb.
// Source  R. K. Livesley, Int. J. Numer. Methods Eng. 12 (1978) 1853-1871; for friction that does not dilate
//         M. Gilbert, C. Casapulla, H. M. Ahmed, Computers & Structures 84 (2006) 873-887.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "statics/admissible_forces.hpp"
#include "statics/joint_corners.hpp"
#include "statics/linear_programme.hpp"
#include "statics/rigid_structure.hpp"

namespace voussoir {

enum class LimitVerdict {
  limited,    ///< the factor is the largest that can be balanced
  unlimited,  ///< the largest factor asked can be balanced
  refused,    ///< the fixed loads, or those asked for, cannot be balanced
  unknown     ///< the programme was not solved, or its answer is not exact enough to prove anything
};

template <int dim>
struct LimitAnswer {
  LimitVerdict verdict = LimitVerdict::unknown;
  double factor = 0;                   ///< [-] of raised loads, by the power of the mechanism where there is one
  std::vector<Wrench<dim>> mechanism;  ///< per stone: velocities [m] and turns [rad], the largest motion 1 m; or none
  std::vector<Wrench<dim>> motion;     ///< the same without dilatancy, where that is possible (coulomb_motion.hpp)
  bool dilates = false;                ///< it is not: the motion is the mechanism
  std::optional<double> estimate;      ///< [-] of the factor without dilatancy, where the motion needed it
  std::vector<Vector<dim>> force;      ///< [N] per contact, normal and tangential, where loads are balanced
  double out_of_balance = 0;           ///< [-] of those forces, relative to the largest load of a stone
  int iterations = 0;                  ///< of the simplex method
  ProgrammeBasis basis;                ///< of its programme, where another of the same stones may begin
};

/// Range of a reaction over all admissible forces [N]; no numbers where it has no end.
struct ReactionRange {
  std::optional<double> least, most;
};

template <int dim>
class LimitAnalysis {
 public:
  explicit LimitAnalysis(RigidStructure<dim>);

  const RigidStructure<dim>& structure() const { return s_; }
  /// The largest factor of raised loads, up to a largest one, that can be balanced together with the fixed loads. In
  /// space no equilibrium exists above it.
  /// @param borne  the answer of largest_borne(largest), where it is known: there the programme begins, and it ends
  ///               where both are alike; in the plane the basis of any other answer
  LimitAnswer<dim> largest_factor(double largest, const LimitAnswer<dim>& borne = {}) const;
  /// The largest factor for which admissible forces are found that balance the loads, and these: in the plane that
  /// above, in space up to a thousandth less. No verdict where not even the fixed loads are.
  /// @param least  tell the forces with the least sum of normal forces, of those that balance a hair less: at the limit
  ///               any may stand for all
  LimitAnswer<dim> largest_borne(double largest, const ProgrammeBasis& begin = {}, bool least = false) const;
  /// Whether dry joints balance the raised loads alone. Then these can be raised without end wherever fixed loads are
  /// borne: forces of dry joints add up to forces of dry joints.
  bool borne_at_any_factor() const;
  /// Whether fixed loads and so much of the raised ones can be balanced.
  LimitAnswer<dim> bears(double factor) const;
  /// Whether it is proven that they cannot: refused, else unknown, at half the cost of bears() where they can.
  LimitAnswer<dim> refuses(double factor) const;
  /// Forces that balance loads with the resultants of all joints as near to the middle of their joints as can be: the
  /// share of every joint, from its edges, that they leave free, up to the largest one looked for. Dry flat joints
  /// alone can be narrowed. Of many such forces those with the least sum of normal forces.
  /// @param borne  the answer of bears(factor), where it is known: there the programmes begin
  LimitAnswer<dim> most_balanced(double factor, double* free_share, const LimitAnswer<dim>& borne = {}) const;
  /// Of all forces that balance loads those with the least sum of normal forces, since stones that hold each other may
  /// press on each other as much as one likes. No verdict where none are found, in space within pyramids inside cones.
  LimitAnswer<dim> least_pressed(double factor) const { return under_loads(factor).least_of_joints(1, {}, nullptr); }
  /// Whether stones stand in rows: each has two neighbours at most, or is held and has one, none of a row is its own
  /// neighbour's neighbour, and all joints are dry and flat. The share that forces leave free is then one of the
  /// depth of a row, and 1 / (1 - share) its geometric factor of safety.
  bool is_rows() const;
  /// Least and most of reactions over all admissible forces: per support, along x, y and z. In space over those of the
  /// pyramid around each cone, so that none is left out. What two supports hold of a stone has no end, since they can
  /// press against each other through it.
  /// @param supports  how many there are by name; a component that none of a support's nodes holds ranges from 0 to 0
  /// @param borne     the answer of bears(factor), where it is known: there the programmes begin
  std::vector<std::array<ReactionRange, dim>> reactions(int supports, double factor,
                                                        const LimitAnswer<dim>& borne = {}) const;
  /// Estimate of the largest factor where slip does not dilate: no bound on either side. Not there where its sequence
  /// of programmes does not settle, and not in space, where it does not for walls of a hundred stones.
  /// @param associated  the answer of largest_factor(largest), where it begins
  /// @param motion      where wanted: in which it falls there, the largest 1 m; what slides opens by a thousandth of
  ///                    what it would with dilatancy
  std::optional<double> without_dilatancy(double largest, const LimitAnswer<dim>& associated,
                                          std::vector<Wrench<dim>>* motion = nullptr) const;

 private:
  struct Programme;
  struct Narrowing;
  /// Lines of round cones that were added to pyramids within them, by kept contact.
  using Lines = std::vector<std::pair<std::size_t, Generator<dim>>>;
  /// Of joints whose share bears, about their middle, with forces that end at a multiple of the largest load.
  struct Terms {
    double share_of_joints = 1;
    double most = std::numeric_limits<double>::infinity();
    Pyramid pyramid = Pyramid::around;
    bool sliding = false;  ///< friction with hardly any slope beside a bound on shear that the caller sets
    bool finer = true;     ///< pyramids are made finer where it matters
    bool least = false;    ///< forces that balance a hair less than the limit, with the least sum of normal forces
    std::optional<double> borne = {};  ///< [-] factor for which forces within the cones balance, where one is known
    double off_the_cone = RoundConeParameters::off_the_cone;  ///< [-] up to which pyramids are made finer
    int most_for_finer =
        std::numeric_limits<int>::max();  ///< iterations of the simplex method that finer ones may cost
    Lines* lines = nullptr;  ///< where wanted: to begin with, and those added since; the basis has them then
  };
  /// What a mechanism proves: the factor of raised loads [-], and their power along it [N m].
  struct Bound {
    double factor, power;
    double of_pyramids;  ///< [-] what pyramids would bear in the place of cones
  };
  Programme programme(const Terms&) const;
  void add_forces_of_joints(Programme&, const Terms&) const;
  void add_forces_of_supports(Programme&) const;
  void add_raised_loads(Programme&) const;
  ProgrammeSolution solve(Programme&, double largest, ProgrammeBasis&, std::optional<double> borne) const;
  bool make_finer(Programme&, const ProgrammeSolution&) const;
  bool cut_pyramid(Programme&, std::size_t kept, const std::vector<double>& x) const;
  bool cut_edge(Programme&, std::size_t kept, double angle) const;
  bool extend_pyramid(Programme&, std::size_t kept, const std::vector<Wrench<dim>>& motion) const;
  void add_line(Programme&, std::size_t kept, const Generator<dim>&) const;
  void add_generator(Programme&, std::size_t kept, const Generator<dim>&) const;
  ReactionRange ends_of(Programme&, const std::vector<Wrench<dim>>& borne) const;
  void bound_shear(Programme&, const std::vector<double>& presses) const;
  LimitAnswer<dim> raised_up_to(double largest, const Terms&, bool* balanced_unraised,
                                ProgrammeBasis* basis = nullptr) const;
  Terms around_cones(const LimitAnswer<dim>& borne) const;
  LimitAnswer<dim> with_forces(double largest, LimitAnswer<dim>) const;
  LimitAnalysis drawn_together(const std::vector<Vector<dim>>& force, double ratio) const;
  LimitAnswer<dim> borne_on_share(double share, int most_for_finer, Lines&, const ProgrammeBasis&) const;
  LimitAnswer<dim> least_of_joints(double share_of_joints, const ProgrammeBasis&, Lines*) const;
  void seek_least(Programme&) const;
  void tell_least(Programme&, LimitAnswer<dim>&) const;
  LimitAnswer<dim> in_motion(double largest, LimitAnswer<dim>) const;
  bool moves_what_bears_nothing(const LimitAnswer<dim>&, const std::vector<Wrench<dim>>& motion) const;
  void tell_forces(const Programme&, const ProgrammeSolution&, double factor, LimitAnswer<dim>&) const;
  std::optional<Bound> bound_of(const Programme&, const std::vector<Wrench<dim>>& mechanism) const;
  LimitAnswer<dim> judge(const Programme&, const ProgrammeSolution&, double largest) const;
  std::vector<Wrench<dim>> motion_of(const std::vector<double>& price) const;
  /// The same structure under its fixed loads and a factor of the raised ones, all of them raised from nothing.
  LimitAnalysis under_loads(double factor) const;

  RigidStructure<dim> s_;
  JointCorners corners_;
  double unit_ = 0;         ///< [N] largest load of a stone
  double raised_unit_ = 0;  ///< the same of the raised loads
};

}  // namespace voussoir
