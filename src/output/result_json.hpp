// result.json: what a run found and what it cost, for programs.
// Every key is explained in the table "result.json" of src/output/README.md; a test compares the two.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>

#include "base/energies.hpp"
#include "base/step_numbers.hpp"
#include "base/warning.hpp"

namespace voussoir {

/// An interrupted run has no result.json yet. Out of range: the model cannot tell how it goes on.
enum class Outcome { equilibrium, collapse, not_converged, out_of_range, interrupted };

/// Energy book at the end of the run. [J]
struct EnergySummary : Energies {
  double imbalance = 0.0, imbalance_in_time = 0.0;
};

/// The motion a collapse begins with.
struct MechanismSummary {
  int largest_mover = -1;           ///< block
  std::string name;                 ///< of that block
  double largest_displacement = 0;  ///< [m]
  bool dilates = false;             ///< one of limit analysis in which what slides must lift
};

/// How far a pattern of loads could be raised.
struct CollapseSummary {
  struct Attempt {
    double factor = 0;
    std::string outcome;
    int linear_solves = 0;
  };
  std::map<std::string, double> pattern;  ///< share of each load
  double lower = 0;                       ///< [-] largest load factor that stands; not a number: none was tried
  double upper = 0;                       ///< [-] smallest that collapses; infinite when none was found
  bool sharp = true;                      ///< no factor between them was tried without a decision
  std::vector<Attempt> attempts;
  double certified = 0;  ///< [-] none can stand above it, by the static theorem; infinite: nothing is known
  double estimate = 0;   ///< [-] of rigid limit analysis without dilatancy; infinite: none
};

/// What rigid limit analysis alone says of the loads of a scene.
struct RigidSummary {
  struct Range {
    double least = 0, most = 0;  ///< [N] of a reaction; infinite where it has no end
  };
  double free_share = NAN;  ///< [-] of dry joints, from their edges, that forces can leave; not a number: not known
  std::map<std::string, std::array<Range, 3>> reactions;  ///< along x, y and z, by name of the support
  int components = 2;                                     ///< of reactions; 3 in space
  double borne = NAN;     ///< [-] factor of the pattern for which admissible forces are found; not a number: none asked
  bool at_least = false;  ///< more of the share was not looked for
  double factor = NAN;    ///< [-] Heyman's geometric factor of safety; not a number where the share tells none
};

/// Force of a support on the structure.
struct ReactionSummary {
  std::array<double, 3> force{};    ///< [N]
  std::array<double, 3> through{};  ///< [m] a point on its line of action, the nearest to the support's middle
};

/// What joints and supports carry at the end of a run in statics; all joints are in joints.csv.
struct StaticsSummary {
  struct Place {
    int block_i = -1, block_j = -1;
    std::array<double, 3> place{};  ///< [m] of a hinge its edge, of what slides the middle of the side
    double opening = 0;             ///< [m]
  };
  int hinges = 0, sliding_joints = 0;
  double least_edge_margin = 0, least_friction_margin = 0;  ///< [-]
  std::vector<Place> widest_hinges, first_sliding;          ///< no more than fifty of each
  std::map<std::string, ReactionSummary> reactions;         ///< by name of the support
  int components = 2;                                       ///< of places and reactions; 3 in space
};

/// How evenly ranks share the work; 0 and 1 on one rank.
struct PartitionSummary {
  double edge_cut = 0;            ///< [-] share of vertices common to two blocks that lie between ranks
  int neighbours = 0;             ///< of a rank, the most
  double unknowns_imbalance = 1;  ///< [-] of the busiest rank over the mean
  double selected_imbalance = 1;  ///< [-] likewise, points treated as contact at the end
};

/// An effect the program knows, and what it cost.
struct EffectSummary {
  bool in_play = false;  ///< the scene names it
  long long calls = 0;   ///< how often it was asked, all ranks
  double seconds = 0;    ///< to make and to ask it, slowest rank
  long long bytes = 0;   ///< held for it, all ranks
};

/// The same numbers on every rank, those of the whole structure; those of steps are over all of them.
struct RunSummary : StepNumbers {
  std::string scene;
  int ranks = 1;
  int blocks = 0;
  long long joints = 0, nodes = 0, unknowns = 0;
  long long candidate_points = 0;
  int steps = 0;
  double time = 0.0;                       ///< [s] of stages with duration
  double largest_displacement = 0.0;       ///< [m] largest of all steps
  double largest_displacement_time = 0.0;  ///< [s] when that was
  double residual_displacement = 0.0;      ///< [m] the largest of a node at the end
  EnergySummary energy;
  std::map<std::string, EffectSummary> effects;  ///< every effect the program knows
  PartitionSummary partition;
  std::map<std::string, double> seconds;  ///< per phase; the key "total" is the whole run
  std::vector<double> peak_memory;        ///< [MB] per rank
  Outcome outcome = Outcome::not_converged;
  double load_factor = 0.0;  ///< of the last stage, reached
  std::string message;       ///< why the run ended as it did; not written when empty
  Warnings warnings;         ///< what the result leaves open, of the input first
  std::optional<MechanismSummary> mechanism;
  std::optional<StaticsSummary> statics;    ///< of a run that ends in statics
  std::optional<CollapseSummary> collapse;  ///< when the scene asks for a load factor
  std::optional<RigidSummary> rigid;        ///< of a run that asks rigid limit analysis alone
};

/// Text of the file; a number that is not finite becomes null.
std::string result_json(const RunSummary&);

/// Writes the file whole or not at all. Collective; rank 0 writes. Throws ResourceError on all ranks.
void write_result_json(const std::string& path, const RunSummary&, const Teuchos::Comm<int>&);

/// [MB = 1e6 bytes] Largest resident memory so far of every rank, the same list on all. Collective.
std::vector<double> peak_memory_per_rank(const Teuchos::Comm<int>&);

}  // namespace voussoir
