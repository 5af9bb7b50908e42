// Scenes built in memory, solved in process, and their solutions gathered on every rank.
//
// W(n) and A(n) are the scenes of xml/wall.xml and xml/arch.xml with n courses or voussoirs.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/construction.hpp"
#include "model/plane/plane_model.hpp"
#include "scene/scene.hpp"
#include "step/adaptive_step.hpp"

namespace voussoir::test {

/// Running-bond wall W(n): own weight, then 0.15 g sideways. All points selected.
Scene wall_scene(int courses);
/// Semicircular arch A(n): own weight, then the right springing moves outward by 5 mm. All points selected.
Scene arch_scene(int voussoirs);
/// Stages "first", "second" and "third" of a scene that is built, under its weight throughout.
std::vector<StageParameters> three_stages();
/// A mesh of gmsh under no loads: stone of 10 GPa, nu = 0.2, 2000 kg/m3, friction 0.6. All points selected.
Scene gmsh_scene(const std::string& geo, double element_size, CellType);

/// Loads of the last stage, in so many equal steps.
void set_increments(Scene&, int increments);
void add_support(Scene&, const std::string& on, const std::string& components);
void add_gravity(Scene&, double ax, double ay);
void add_pressure(Scene&, const std::string& on, double pressure);
/// One stage that applies all loads of the scene in full.
void apply_all_loads(Scene&);

struct PointState {
  PointId id = 0;
  BlockId block_i = 0, block_j = 0;
  NodeId node_i = 0, node_j = 0;
  double area = 0;                                ///< [m2]
  Vector<2> position{}, normal{};                 ///< normal from block i to block j
  double normal_force = 0, tangential_force = 0;  ///< [N] on block j; the tangent is the normal turned by +90 degrees
  double gap = 0, slip = 0, slip_before = 0;      ///< [m]; slip before the last load step
  bool selected = false, broken = false;
};

/// The state after a load step, the same on every rank, in the numbers of the structure.
struct Solution {
  std::vector<Vector<2>> position;      ///< [m] per node
  std::vector<Vector<2>> displacement;  ///< [m] per node
  std::vector<Vector<2>> residual;      ///< [N] per node: reactions at held nodes, else zero to tolerance
  std::vector<std::array<char, 2>> held;
  std::vector<BlockId> block_of_node;
  std::vector<PointState> points;
  double potential = 0;  ///< [J] 1/2 u.K u - f.u
  StepReport last;       ///< report of the last load step
  NewtonReport sum;      ///< counts of all load steps
  int rounds = 0;        ///< of selection, all load steps

  double largest_displacement() const;
  double largest_force() const;
  long long selected() const;
};

/// A scene, its model and its state.
class Experiment {
 public:
  explicit Experiment(const Scene&);
  Experiment(const Experiment&) = delete;  // the model refers to the scene where it is

  /// One load step under load factors by name; false when it did not converge (see solution().last).
  bool advance(const std::map<std::string, double>& factors);
  /// The same in a stage of the scene, where blocks may appear and disappear.
  bool advance(const std::string& stage, const std::map<std::string, double>& factors);
  /// All stages, without halving; stops at the first step that does not converge.
  bool run();
  Solution solution() const;

  const Scene& scene() const { return scene_; }
  const PlaneModel& model() const { return *model_; }
  AdaptiveStep& step() { return *step_; }
  ContactState& state() { return state_; }
  const std::vector<double>& load() const { return load_; }
  const std::vector<double>& prescribed() const { return prescribed_; }

 private:
  Scene scene_;
  std::unique_ptr<BlockSource<2>> source_;
  std::unique_ptr<PlaneModel> model_;
  std::unique_ptr<AdaptiveStep> step_;
  ContactState state_;
  std::unique_ptr<Construction> construction_;
  PointField slip_before_;
  std::vector<double> load_, prescribed_;
  StepReport last_;
  NewtonReport sum_;
  int rounds_ = 0;
};

/// The solution of a scene; throws std::runtime_error when it has none.
Solution solved(const Scene&);

/// Largest difference of displacements, relative to the largest displacement of b.
double difference(const Solution& a, const Solution& b);

/// How far a solution is from the conditions of unilateral contact with friction, from displacement and forces alone.
/// Forces are relative to the largest normal force.
struct ContactErrors {
  double equilibrium = 0;  ///< [-] largest residual where nothing is held
  double penetration = 0;  ///< [m]
  double tension = 0;      ///< [-]
  double pressure_at_gap =
      0;                    ///< [-] largest normal force at a point open by more than 1e-9 of the largest displacement
  double outside_cone = 0;  ///< [-] largest |q| - mu p
  double slip_inside_cone = 0;  ///< [m] largest slip of the last step where |q| < mu p by 2e-8
  double slip_along_force = 0;  ///< [m] the same in the direction of q, where |q| > 2e-8
};
ContactErrors contact_errors(const Solution&, double friction);

}  // namespace voussoir::test
