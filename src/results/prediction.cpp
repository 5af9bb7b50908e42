#include "results/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "base/text.hpp"
#include "base/words.hpp"
#include "joints/contact_points.hpp"
#include "results/effect_costs.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

// Measured on walls and on the bridge (src/run/README.md): linear solves of a load step by mode of selection,
// Krylov iterations of a solve, seconds of an iteration per unknown on one core, bytes per unknown.
constexpr int solves_in_time = 3;  // 1 to 4 on the small scenes of xml/ in time, 8 and more where many stones rattle
constexpr int solves_bonded = 3, solves_adaptive = 40, solves_all = 45;
// In space 6 to 10 of walls, 39 of a cross vault, adaptively and with every point (walls_in_space.csv, prediction.csv).
constexpr int solves_in_space = 18;
// Attempts at a load factor: 2 to 12 with an accuracy of 0.5 %. Those that collapse take hundreds of solves.
constexpr int attempts_at_load_factor = 14;
constexpr double round_off_of_steps = 1e-12;  // of a number of time steps, which is a quotient
constexpr double iterations_per_solve = 5, seconds_per_unknown = 4e-7, bytes_per_unknown = 2500;
constexpr double seconds_of_start = 0.4;  // of MPI, of reading and of writing
// Of a solve with contact in space, times the unknowns squared: systems are factored, which grows so in three
// dimensions (Lipton, Rose, Tarjan, SIAM J. Numer. Anal. 16 (1979) 346-358). Walls of 10 000 to 144 000 unknowns take
// 1 to 5 times as long.
constexpr double seconds_of_factors = 4e-10;

/// Makes the loads and applies them once in full: bytes they hold and seconds of a load step.
template <int dim>
void print_effect_costs(const Scene& scene, const BlockSource<dim>& source, const Structure<dim>& structure,
                        const ContactPoints& points, std::ostream& say) {
  const auto& comm = *structure.comm();
  const LoadsAtWork loads(scene, source, structure);
  const auto made = loads.costs(comm);
  std::map<std::string, double> factors;
  for (const auto& load : scene.loads) factors[load.name] = 1.0;
  BlockForces force(structure);
  std::vector<double> prescribed(force.of_nodes.size());
  loads.add(factors, 0.0, force, prescribed);
  say << "effects\n"
      << std::left << std::setw(20) << "" << std::right << std::setw(12) << "bytes" << std::setw(16) << "[s] per step"
      << "\n";
  int absent = 0;
  for (const auto& [name, cost] : effect_costs(scene, loads, structure, points.size())) {
    const auto before = made.find(name);
    if (!cost.in_play && cost.bytes == 0) {
      ++absent;
      continue;
    }
    say << "  " << std::left << std::setw(18) << name << std::right << std::setw(12) << cost.bytes;
    if (before != made.end()) say << std::setw(16) << std::setprecision(2) << cost.seconds - before->second.seconds;
    say << std::setprecision(6) << (cost.in_play ? "\n" : "   absent, but part of every contact point\n");
  }
  say << "  absent, without cost: " << counted(absent, "effect") << "\n";
}

std::string steps_text(int steps, const std::string& kind, int solves) {
  if (steps == 0) return "";
  return counted(steps, kind + " step") + " of about " + counted(solves, "linear solve") + (steps == 1 ? "" : " each") +
         "\n";
}

/// Of any material, and in equal shares.
template <int dim>
Structure<dim> structure_to_count(const Scene& scene, const BlockSource<dim>& source,
                                  const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  return Structure<dim>(
      source, share_out(source, *comm), scene.model,
      [](const Block<dim>&) {
        return Material{1.0, 0.0, 1.0};
      },
      comm);
}

int solves_of_step(SelectionMode mode, int dim) {
  if (mode == SelectionMode::bonded) return solves_bonded;
  if (dim == 3) return solves_in_space;
  return mode == SelectionMode::all ? solves_all : solves_adaptive;
}

/// Whether joints have a strength that they may lose, and are asked whether they do.
bool cracks(const Scene& scene) {
  if (scene.selection.mode == SelectionMode::bonded) return false;
  return std::any_of(scene.joints.begin(), scene.joints.end(), [](const Named<JointLawParameters>& joints) {
    const auto may_be_lost = [](double strength) { return strength > 0 && std::isfinite(strength); };
    return may_be_lost(joints.parameters.cohesion) || may_be_lost(joints.parameters.tension_strength);
  });
}

/// How far to trust seconds. A search for a load factor ends after two attempts or goes on for a dozen, of 5 to 600
/// solves; a load step in which cracks compete takes 3 to 260.
std::string trust(const Scene& scene, int dim, int load_steps) {
  if (load_steps > 0 && cracks(scene)) return " (within a factor of ten: how joints crack cannot be told)\n";
  return dim == 2 && !scene.load_factor.asked() ? " (within a factor of three)\n" : " (within a factor of five)\n";
}

/// The same blocks, of linear cells: corners are where they were, and no matrix of a stone is condensed, which takes as
/// long as a run.
template <int dim>
class OfLinearCells final : public BlockSource<dim> {
 public:
  explicit OfLinearCells(const BlockSource<dim>& source) : source_(source) {}
  BlockId block_count() const override { return source_.block_count(); }
  int node_count(BlockId b) const override { return source_.node_count(b); }
  Block<dim> block(BlockId b) const override {
    auto one = source_.block(b);
    one.curved.clear();
    return one;
  }
  std::vector<Neighbour> neighbours(BlockId b) const override { return source_.neighbours(b); }
  void bring(const std::vector<BlockId>& blocks, const Teuchos::Comm<int>& comm) const override {
    source_.bring(blocks, comm);
  }
  const SetNames& block_sets() const override { return source_.block_sets(); }
  const std::vector<std::string>& facet_sets() const override { return source_.facet_sets(); }

 private:
  const BlockSource<dim>& source_;
};

}  // namespace

template <int dim>
void place_loads(const Scene& scene, const BlockSource<dim>& source,
                 const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const OfLinearCells<dim> linear(source);
  const auto structure = structure_to_count(scene, linear, comm);
  const LoadsAtWork loads(scene, linear, structure);
}

template <int dim>
void predict(const Scene& scene, const BlockSource<dim>& source, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
             std::ostream& say) {
  const auto structure = structure_to_count(scene, source, comm);
  const ContactPoints points(source, structure);
  int load_steps = 0;
  int time_steps = 0;
  bool as_it_goes = false;
  for (const auto& stage : scene.stages) {
    if (!stage.dynamic())
      load_steps += stage.increments;
    else if (stage.time_step > 0)
      time_steps += static_cast<int>(std::ceil(stage.duration / stage.time_step * (1 - round_off_of_steps)));
    else
      as_it_goes = true;
  }
  if (scene.load_factor.asked()) load_steps += attempts_at_load_factor;
  const auto unknowns = static_cast<double>(dim * structure.total_nodes());
  const int solves = solves_of_step(scene.selection.mode, dim);
  say << counted(source.block_count(), "block") << ", " << counted(points.total_joints(), "joint") << ", "
      << counted(structure.total_nodes(), "node") << ", " << counted(dim * structure.total_nodes(), "unknown") << ", "
      << counted(points.total(), "candidate contact point") << "\n"
      << steps_text(load_steps, "load", solves);
  say << steps_text(time_steps, "time", solves_in_time);
  const std::string ranks = counted(comm->getSize(), "rank");
  const bool factored = dim == 3 && scene.selection.mode != SelectionMode::bonded;
  const double seconds_of_solve =
      iterations_per_solve * unknowns * seconds_per_unknown + (factored ? seconds_of_factors * unknowns * unknowns : 0);
  const auto seconds_of = [&](double count) { return count * seconds_of_solve / comm->getSize(); };
  const double all = load_steps * solves + time_steps * solves_in_time;
  if (as_it_goes)
    say << "time steps of stages that leave their length to the program: as many as it finds it needs, about "
        << three_digits(seconds_of(solves_in_time)) << " s each on " << ranks << "\n";
  say << "expected: " << all << " linear solves" << (as_it_goes ? " without those" : "") << ", "
      << unknowns * bytes_per_unknown / 1e6 << " MB in all, ";
  if (as_it_goes)
    say << "as long as those take: how many there are cannot be told\n";
  else
    say << three_digits(seconds_of_start + seconds_of(all)) << " s on " << ranks << trust(scene, dim, load_steps);
  print_effect_costs(scene, source, structure, points, say);
}

template void place_loads(const Scene&, const BlockSource<2>&, const Teuchos::RCP<const Teuchos::Comm<int>>&);
template void place_loads(const Scene&, const BlockSource<3>&, const Teuchos::RCP<const Teuchos::Comm<int>>&);
template void predict(const Scene&, const BlockSource<2>&, const Teuchos::RCP<const Teuchos::Comm<int>>&,
                      std::ostream&);
template void predict(const Scene&, const BlockSource<3>&, const Teuchos::RCP<const Teuchos::Comm<int>>&,
                      std::ostream&);

}  // namespace voussoir
