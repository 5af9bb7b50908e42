#include "range/input_warnings.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/text.hpp"
#include "base/words.hpp"
#include "linalg/agree.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
#include "model/loads_at_work.hpp"
#include "model/scene_fit.hpp"
#include "range/absent_stones.hpp"
#include "range/idle_loads.hpp"
#include "range/joint_sides.hpp"
#include "range/space/stiff_stones.hpp"
#include "range/support_warnings.hpp"
#include "scene/scene.hpp"
#include "scene/unusual_values.hpp"
#include "stones/stone_files.hpp"

namespace voussoir {
namespace {

constexpr WhyWhole of_laws{"numbers per law of a scene"};

// Largest stones laid in masonry are some 20 m long (Baalbek); beyond 50 m a drawing is in millimetres or centimetres.
constexpr double large_stone = 50;  // [m]
// Where even the largest stone is smaller than this, metres were taken for millimetres or centimetres.
constexpr double small_stone = 0.01;  // [m]

void append(Warnings& all, Warnings more) {
  for (auto& warning : more) all.push_back(std::move(warning));
}

/// How stones are drawn, and what they share where they touch.
std::string stone_word(int components) { return components == 2 ? "surface" : "volume"; }
std::string joint_word(int components) { return components == 2 ? "curve" : "surface"; }

void warn_of_no_joints(const Scene& scene, const Model& model, Warnings& all) {
  if (model.points().total() > 0 || scene.joints.empty()) return;
  const auto blocks = model.block_count();
  all.push_back({"no_joints", scene.file + ": scene > joints", "", static_cast<double>(blocks),
                 "the scene has laws for joints and the mesh has none: nothing can open or slip between its " +
                     counted(blocks, "block") + "; draw every stone as a " + stone_word(model.components()) +
                     " of its own, stones that touch sharing the " + joint_word(model.components()) + " between them"});
}

void warn_of_bonds(const Scene& scene, const Model& model, Warnings& all) {
  if (scene.selection.mode != SelectionMode::bonded || model.points().total() == 0) return;
  all.push_back({"bonded", scene.file + ": scene > selection > mode = bonded", "",
                 static_cast<double>(model.points().total()),
                 "no joint that is closed at first opens or slips: what stands so is a continuum, not an equilibrium "
                 "of stones"});
}

/// The longest side of the box around a block [m].
template <int dim>
double extent(const Block<dim>& block) {
  double longest = 0;
  for (int c = 0; c < dim; ++c) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& x : block.position) {
      low = std::min(low, x[c]);
      high = std::max(high, x[c]);
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

/// Which key says in what a mesh is drawn, and what to ask where stones have a size that none has.
struct UnitOfMesh {
  std::string key = "mesh", question = "; lengths of a scene are in metres";

  explicit UnitOfMesh(const MeshParameters& mesh) {
    if (!mesh.from_file()) return;
    const bool stones = mesh.type == MeshType::stones;
    const double unit = stones ? mesh.stones.unit : mesh.gmsh.unit;
    key = stones ? "mesh > stones > unit" : "mesh > gmsh > unit";
    if (stones && says_its_unit(mesh.stones.file)) {
      key = "mesh > stones > file";
      question = "; a STEP file says its own unit: is it the right one?";
      return;
    }
    question = "; is the file drawn in metres? If not say so by " + key + (stones ? "" : " = mm, cm or ft") +
               " (now: " + (unit == 1 ? "m" : number_text(unit) + " m") + ")";
  }
};

/// The longest stone, the first of those that are equally long, and how many are too long.
struct LongestStone {
  double size = -1;  ///< [m]
  std::string name;
  long long large = 0;
};

/// Collective.
template <int dim>
LongestStone longest_stone(const BlockSource<dim>& source, bool from_file, const Teuchos::Comm<int>& comm) {
  LongestStone mine;
  const auto look_at = [&](BlockId b) {
    const auto block = source.block(b);
    const double size = extent(block);
    mine.large += size > large_stone;
    if (size <= mine.size) return;
    mine.size = size;
    mine.name = block.name;
  };
  if (from_file) {
    const auto read = source.read_by(comm.getRank(), comm.getSize());
    for (BlockId b = read.from; b < read.to; ++b) look_at(b);
  } else if (comm.getRank() == 0) {  // generated stones are alike
    for (const BlockId b : {0, source.block_count() - 1}) look_at(b);
  }
  LongestStone all;
  all.size = largest_over_ranks(comm, mine.size);
  all.large = total_over_ranks(comm, mine.large);
  std::vector<std::string> names;
  if (mine.size == all.size) names.push_back(mine.name);
  all.name = first_texts(comm, names, 1).front();
  return all;
}

/// Collective.
template <int dim>
void warn_of_sizes(const Scene& scene, const BlockSource<dim>& source, const Teuchos::Comm<int>& comm, Warnings& all) {
  const bool from_file = scene.mesh.from_file();
  const auto longest = longest_stone(source, from_file, comm);
  const UnitOfMesh unit(scene.mesh);
  const std::string size = six_digits(longest.size) + " m";
  if (longest.large > 0)
    all.push_back(
        {"large_stones", scene.file + ": scene > " + unit.key, "", longest.size,
         longest.name + " is " + size + " long" +
             (longest.large > 1 && from_file ? " and " + counted(longest.large - 1, "more exceeds", "more exceed") + " "
                                             : ", more than ") +
             number_text(large_stone) + " m" + unit.question});
  else if (longest.size < small_stone)
    all.push_back({"small_stones", scene.file + ": scene > " + unit.key, "", longest.size,
                   "the largest stone, " + longest.name + ", is " + size + " long" + unit.question});
}

/// Stones beside others that share no facet with any: they stand alone, and nothing keeps them out of others.
/// Collective.
template <int dim>
void warn_of_lone_stones(const Scene& scene, const BlockSource<dim>& source, const Teuchos::Comm<int>& comm,
                         Warnings& all) {
  const auto read = source.read_by(comm.getRank(), comm.getSize());
  long long lone = 0;
  std::vector<std::string> first;
  for (BlockId b = read.from; b < read.to; ++b) {
    const auto beside = source.neighbours(b);
    if (std::any_of(beside.begin(), beside.end(), [](const auto& n) { return n.shared_vertices >= dim; })) continue;
    if (lone++ == 0) first.push_back(source.block(b).name);
  }
  lone = total_over_ranks(comm, lone);
  first = first_texts(comm, first, 1);
  if (lone == 0 || lone == source.block_count()) return;  // where all stand alone there are no joints, which is said
  const auto told = [](const Warning& w) { return w.what == "stones_without_joint"; };
  if (std::any_of(all.begin(), all.end(), told)) return;  // by the source, which knows how far they are from others
  all.push_back({"stones_without_joint", scene.file + ": scene > mesh", "", static_cast<double>(lone),
                 first.front() + (lone > 1 ? " and " + std::to_string(lone - 1) + " more share" : " shares") +
                     " no joint with any other stone: nothing passes between, and nothing keeps stones from moving "
                     "through each other; let stones that touch share the " +
                     joint_word(dim) + " between them"});
}

/// Laws that hold for no joint: for none of the mesh, or for none that later laws leave.
void warn_of_idle_laws(const Scene& scene, const Model& model, Warnings& all) {
  const auto& s = model.structure();
  if (model.points().total() == 0) return;
  const std::size_t laws = scene.joints.size();
  std::vector<long long> mine(2 * laws, 0);  // joints a law holds for; joints its sets name
  for (const Joint& joint : model.points().joints()) {
    if (joint.local_i >= s.owned_blocks()) continue;
    ++mine[joint.family];
    model.in_geometry([&](const auto& source, const auto& structure) {
      const auto& i = structure.blocks()[s.local_block(joint.block_i)].mesh;
      const auto& j = structure.blocks()[s.local_block(joint.block_j)].mesh;
      for (std::size_t f = 0; f < laws; ++f) mine[laws + f] += joins(source, scene.joints[f].parameters, i, j);
    });
  }
  const auto total = total_of_list(*s.comm(), mine, of_laws);
  for (std::size_t f = 0; f < laws; ++f) {
    const auto& law = scene.joints[f].parameters;
    const bool fallback = law.between == "all" && law.and_ == "all";  // needed, also where others hold everywhere
    const long long named = total[laws + f];
    if (total[f] > 0 || (fallback && named > 0)) continue;
    const std::string sets = in_quotes(law.between) + " and " + in_quotes(law.and_);
    all.push_back({"law_without_joint", scene.file + ": scene > joints > " + scene.joints[f].name, "",
                   static_cast<double>(named),
                   named == 0 ? "no joint of the mesh is between " + sets +
                                    ", so the law holds nowhere; look whether these stones share a " +
                                    joint_word(model.components())
                              : counted(named, "joint") + " between " + sets + (named == 1 ? " is" : " are") +
                                    " taken by later laws, so the law holds nowhere; put it behind them"});
  }
}

/// Fracture energies below what the stones can follow (Model::set_softening): the joint takes more than it was given.
void warn_of_raised_energies(const Scene& scene, const Model& model, Warnings& all) {
  const std::size_t laws = scene.joints.size();
  if (!model.weakens()) return;
  std::vector<double> mine(2 * laws, 0.0);  // [J/m2] the most that a point takes
  for (int k = 0; k < model.points().owned(); ++k) {
    const auto& p = model.points().points()[k];
    const int family = model.points().joints()[p.joint].family;
    const auto& law = scene.joints[family].parameters;
    const auto& rate = model.softening()[k];
    const auto raise = [&](int mode, double own, double other, double per_way) {
      const double strength = own > 0 ? own : other;  // as Model::set_softening
      if (per_way > 0) mine[2 * family + mode] = std::max(mine[2 * family + mode], strength / per_way);
    };
    raise(0, law.tension_strength, law.cohesion, rate.per_opening);
    raise(1, law.cohesion, law.tension_strength, rate.per_slip);
  }
  const auto most = largest_of_list(*model.structure().comm(), mine, of_laws);
  for (std::size_t i = 0; i < most.size(); ++i) {
    const auto& law = scene.joints[i / 2].parameters;
    const double asked = i % 2 == 0 ? law.fracture_energy : law.shear_fracture_energy;
    constexpr double round_off = 1e-12;
    if (!(asked > 0) || most[i] <= asked * (1 + round_off)) continue;
    all.push_back(
        {"raised_energy",
         scene.file + ": scene > joints > " + scene.joints[i / 2].name + " > " +
             (i % 2 == 0 ? "fracture energy" : "shear fracture energy"),
         "", most[i] / asked,
         number_text(asked) +
             " J/m2 is little beside what the stones give way by: as a joint without an energy it takes up to " +
             six_digits(most[i]) + " J/m2; finer cells need less"});
  }
}

/// What is drawn open bonds nothing (Model::set_strengths).
void warn_of_strength_over_gaps(const Scene& scene, Warnings& all) {
  for (const auto& [name, law] : scene.joints)
    if (law.initial_gap > 0 && std::max(law.cohesion, law.tension_strength) > 0)
      all.push_back({"strength_over_gap", scene.file + ": scene > joints > " + name + " > initial gap", "",
                     law.initial_gap,
                     "the joints stand open by " + number_text(law.initial_gap) +
                         " m at the start, and what does not touch is not bonded: their cohesion and tension strength "
                         "count for nothing, and where they close they rub; leave the gap out where mortar fills it"});
}

}  // namespace

template <int dim>
Warnings mesh_warnings(const Scene& scene, const BlockSource<dim>& source, const Teuchos::Comm<int>& comm) {
  Warnings all = source.warnings();
  append(all, scene.warnings);
  for (auto& warning : all) warning.where = scene.file + ": " + warning.where;
  append(all, unusual_values(scene));
  warn_of_sizes(scene, source, comm, all);
  warn_of_lone_stones(scene, source, comm, all);
  warn_of_strength_over_gaps(scene, all);
  append(all, warnings_of_sides(scene, source, comm));
  if constexpr (dim == 3) append(all, warnings_of_stiff_stones(scene, source, comm));
  return all;
}

template Warnings mesh_warnings(const Scene&, const BlockSource<2>&, const Teuchos::Comm<int>&);
template Warnings mesh_warnings(const Scene&, const BlockSource<3>&, const Teuchos::Comm<int>&);

Warnings input_warnings(const Scene& scene, const Model& model) {
  Warnings all;
  warn_of_no_joints(scene, model, all);
  warn_of_bonds(scene, model, all);
  append(all, model.in_geometry([&](const auto& source, const auto&) {
    return mesh_warnings(scene, source, *model.structure().comm());
  }));
  warn_of_idle_laws(scene, model, all);
  warn_of_raised_energies(scene, model, all);
  append(all, model.loads_at_work().warnings());
  append(all, warnings_of_idle_loads(scene, model));
  append(all, support_warnings(scene, model));
  append(all, warnings_of_absent_stones(scene, model));
  return all;
}

Warnings warnings_of_rigid_stones(const Scene& scene, const Model& model) {
  auto all = input_warnings(scene, model);
  const auto of_elastic_ones = [](const Warning& w) {
    for (const char* kind : {"bonded", "raised_energy", "one_cell_between_joints", "short_edges"})
      if (w.what == kind) return true;
    return false;
  };
  all.erase(std::remove_if(all.begin(), all.end(), of_elastic_ones), all.end());
  return all;
}

void forget_input_warnings(Warnings& warnings) {
  const auto of_input = [](const Warning& w) { return w.when.empty(); };
  warnings.erase(std::remove_if(warnings.begin(), warnings.end(), of_input), warnings.end());
}

}  // namespace voussoir
