// Everything of a scene that stays the same through its load steps, on this rank, whatever its dimension. Where blocks
// come from and what their geometry makes of supports, mass and waves is told by model_of_blocks, which model/plane and
// model/space complete.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "blocks/held.hpp"
#include "blocks/support_parameters.hpp"
#include "dynamics/midpoint_rule.hpp"
#include "homogenisation/continuum.hpp"
#include "joints/contact_law.hpp"
#include "joints/joint_law_parameters.hpp"
#include "joints/softening.hpp"
#include "model/geometry.hpp"
#include "model/model_settings.hpp"
#include "model/step_in_time.hpp"

namespace voussoir {

class LoadsAtWork;

class Model {
 public:
  virtual ~Model() = default;

  /// How its steps are solved.
  const ModelSettings& settings() const { return settings_; }
  /// Selects points otherwise in steps that are made from here on: nothing else of the model depends on it.
  void set_selection(const SelectionParameters& selection) { settings_.selection = selection; }
  /// The scene's file, for messages.
  const std::string& file() const { return file_; }
  /// Laws by family of joints.
  const std::vector<Named<JointLawParameters>>& families() const { return families_; }
  const std::vector<Named<SupportParameters>>& supports() const { return supports_; }
  virtual const BlockSystem& structure() const = 0;
  /// The structure in its dimension, and the source of its blocks.
  virtual AnyGeometry geometry() const = 0;
  /// What a kernel that is a template of the dimension makes of them: kernel(source, structure).
  template <class Kernel>
  decltype(auto) in_geometry(const Kernel& kernel) const {
    return std::visit([&](const auto& of) -> decltype(auto) { return kernel(of.source, of.structure); }, geometry());
  }
  /// Of displacements: 2 in the plane, 3 in space.
  int components() const { return structure().components(); }
  /// Blocks that share vertices with one that this rank owns, all of which it knows.
  virtual std::vector<Neighbour> neighbours(BlockId) const = 0;
  /// In the whole structure, and what messages call one of them.
  BlockId block_count() const { return structure().total_blocks(); }
  /// As the first rank, which can be asked of all blocks, calls it. Collective.
  std::string block_name(BlockId) const;
  const ContactPoints& points() const { return *points_; }
  /// The bonded continuum; not there for the model at rest when a scene has no load steps.
  const Continuum& continuum() const { return *continuum_; }
  /// What supports prescribe of the displacement of local node copies.
  const Held& held() const { return held_; }
  /// 1 at points that are never tied: that are no pair of coincident nodes, or where different supports hold stones,
  /// which may part there, as one unknown cannot be where both supports are, or where a node is held along a normal,
  /// whose unknowns have axes of their own. Empty without such places.
  const std::vector<char>& never_tied() const { return never_tied_; }
  /// Stiffness a point sees in the cells beside it [N/m].
  const std::vector<double>& local_stiffness() const { return local_stiffness_; }
  /// Law of each point without damage. What is open as drawn, or beside a stone that is not there, has no strength.
  const PointLaws& law() const { return law_; }
  /// How points lose their strength; empty where no joint has any that can be lost.
  const std::vector<Softening>& softening() const { return softening_; }
  /// Some joint of the scene can lose its strength.
  bool weakens() const { return weakens_; }
  /// Some joint has friction or strength, so that it matters where a point has slipped to.
  bool rubs() const { return rubs_; }
  /// Mortar of each point; empty when no joint has any.
  const std::vector<PointCompliance>& compliance() const { return compliance_; }
  /// Stiffness of the softest mortar [Pa/m]; infinite when no joint has any. The same on every rank.
  double softest_mortar() const { return softest_mortar_; }
  /// Opening of each point at zero displacement [m]; empty when all joints are closed.
  const std::vector<double>& initial_gap() const { return initial_gap_; }
  /// Gap and slip of every point under a displacement [m], [points x components].
  std::vector<double> gaps(const std::vector<double>& displacement) const;
  /// The same less what mortar gives way under contact forces [N]: zero where a point sticks.
  std::vector<double> gaps(const std::vector<double>& displacement, const std::vector<double>& lambda) const;
  /// Energy in the mortar of the points of this rank [J].
  double mortar_energy(const std::vector<double>& lambda) const;
  /// Takes stones and joints to where a displacement has moved and turned them; the continuum, which preconditions,
  /// stays as drawn. Collective.
  /// @return the largest turn of a stone since the last time [rad]
  virtual double move_geometry(const std::vector<double>& displacement) = 0;
  void set_initial_gap(std::vector<double> gap) { initial_gap_ = std::move(gap); }
  /// Holds all of the blocks that are not there [per local block], and what supports hold; no joint bonds with them.
  void set_absent(const std::vector<char>& absent);
  /// 1 for local blocks that are not there; empty as long as all are.
  const std::vector<char>& absent() const { return absent_; }
  /// Whether both stones of a point are there.
  bool joined(int point) const;
  /// Whether a point can bear a force: both stones are there, and supports do not hold both sides.
  bool bears(int point) const;
  /// Another number wherever places or supports may have changed: what is made of them is to be made again.
  int arrangement() const { return arrangement_; }

  /// Nodal forces [N] and prescribed displacements [m] under load factors by name of the load.
  /// @param time  [s] for loads with a time function; 0 as long as no dynamic stage has passed
  void loads(const std::map<std::string, double>& factors, double time, std::vector<double>& force,
             std::vector<double>& prescribed) const;
  /// Mean nodal forces [N] over a step of time.
  void mean_loads(const StepInTime&, std::vector<double>& force) const;
  /// What blocks store beside u.K u / 2 under loads at a time (blocks/inner_loads.hpp), over all ranks [J]. Collective.
  /// @param u        [m, components x local node copies]
  /// @param without  1 for each local block that does not count; empty for none
  double inner_energy(const std::map<std::string, double>& factors, double time, const std::vector<double>& u,
                      const std::vector<char>& without) const;
  /// The loads themselves, by name.
  const LoadsAtWork& loads_at_work() const { return *loads_; }
  /// Factor of the mass in the matrices of a time step [1/s2]; 0 of the model at rest.
  double inertia() const { return inertia_; }

  /// The structure with the mass of its blocks [kg] in the place of their stiffness.
  virtual std::unique_ptr<const BlockSystem> mass() const = 0;
  /// The model of one time step: blocks have the matrix S of the midpoint rule, the continuum is that of S, and points
  /// see it. Loads are those of the model at rest. Collective.
  /// @param mass  as of mass()
  /// @param tolerance  of Newton
  virtual std::unique_ptr<Model> of_time_step(const BlockSystem& mass, const MidpointRule&, double tolerance) const = 0;
  /// Of waves in a local block [m/s], and the passage of one through its smallest cell [s].
  virtual double wave_speed(int block) const = 0;
  virtual double passage(int block) const = 0;
  /// Velocities of node copies as time begins [m/s]: those of the scene.
  virtual std::vector<double> initial_velocities() const = 0;

 protected:
  Model(const Scene&);
  /// Of a time step: all but structure, local stiffness and continuum is that of the model at rest.
  Model(const Model& at_rest, double inertia, double tolerance);

  /// Once structure, points and what holds them are there: families of joints must be set.
  void set_laws();
  void find_never_tied(const std::vector<char>& between_supports);
  void set_local_stiffness(const BlockSystem* mass, const MidpointRule&);
  void make_continuum();
  virtual void hold_supports() = 0;
  /// Stiffness of the cells beside a node, at rest [N/m].
  virtual double stiffness_beside(int node) const = 0;

  ModelSettings settings_;
  std::string file_;
  std::vector<Named<JointLawParameters>> families_;
  std::vector<Named<SupportParameters>> supports_;
  std::shared_ptr<ContactPoints> points_;
  std::unique_ptr<Continuum> continuum_;
  std::shared_ptr<const LoadsAtWork> loads_;
  Held held_;
  int arrangement_ = 0;

 private:
  void set_strengths();
  Softening softening_of(std::size_t point) const;
  const JointLawParameters& joint_law(std::size_t point) const;
  bool is_bonded(std::size_t point) const;
  void check_size(const std::vector<double>& force) const;

  std::vector<char> never_tied_;
  std::vector<char> absent_;  ///< per local block; empty where nothing is built
  std::vector<double> local_stiffness_;
  PointLaws law_;
  std::vector<PointCompliance> compliance_;
  double softest_mortar_ = JointLawParameters::infinity;
  std::vector<double> initial_gap_;
  std::vector<Softening> softening_;
  bool weakens_ = false, rubs_ = false;
  double inertia_ = 0;
};

}  // namespace voussoir
