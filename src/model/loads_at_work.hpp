// The loads a scene names, made for a structure: what they add at a load step, and what they cost.
//
// A type of load that a scene does not name is not here at all: it has no bytes and is never called.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "blocks/stresses.hpp"
#include "loads/load.hpp"
#include "loads/time_function.hpp"
#include "model/step_in_time.hpp"
#include "output/result_json.hpp"

namespace voussoir {

struct Scene;

/// A load of the scene as it acts at a moment.
struct ActingLoad {
  std::string name, type;
  double factor = 0;               ///< that of its stage times its function of time
  bool of_stones = false;          ///< acts on all of stones, and not on edges, faces or points of them
  BlockForces force;               ///< as it comes to nodes and edges, which have handed over nothing
  std::vector<double> prescribed;  ///< [m, components x local node copies]
};

class LoadsAtWork {
 public:
  /// Makes every load of the scene. Collective; throws InputError on every rank alike.
  template <int dim>
  LoadsAtWork(const Scene&, const BlockSource<dim>&, const Structure<dim>&);

  /// Adds forces and prescribed displacements [m] under load factors by name.
  void add(const std::map<std::string, double>& factors, double time, BlockForces& force,
           std::vector<double>& prescribed) const;
  /// Adds mean forces over a step of time: their impulse is exact however long the step is.
  void add_mean(const StepInTime&, BlockForces& force) const;
  /// Of the mean forces over a step of time, or of those at a time where it begins and ends, what turns with the stones
  /// [N, of nodes]: forces within them, in balance on each by itself, as what strains them freely and what edges that
  /// bend hand over. All else keeps its direction. Empty where there is none.
  std::vector<double> turning(const StepInTime&, const BlockSystem&) const;
  /// Each load that acts, by itself and in the order of the scene; the same loads on every rank.
  template <class Visit>
  void each_acting(const std::map<std::string, double>& factors, double time, const BlockSystem& s,
                   const Visit& visit) const {
    ActingLoad acting;
    for (std::size_t k = 0; k < loads_.size(); ++k)
      if (act(k, factors, time, s, acting)) visit(acting);
  }
  /// What of them acts within blocks, where stresses and energies see it.
  InnerLoads inner_loads(const std::map<std::string, double>& factors, double time, const BlockSystem&) const;

  /// [s] A time step that sees how all loads vary; infinite when none does.
  double resolution() const;
  /// [s] The shortest time in which a load that acts varies between two times, halved, and which it is.
  struct Shortest {
    double time = std::numeric_limits<double>::infinity();
    std::string load;
  };
  /// @param factors  loads that act, by name
  Shortest resolution(const std::map<std::string, double>& factors, double from, double to) const;

  /// Whether the time function of a load jumps between two times.
  bool jumps(const std::string& load, double from, double to) const;

  /// Costs so far by type of load: calls and bytes of all ranks, seconds of the slowest. Collective.
  std::map<std::string, EffectSummary> costs(const Teuchos::Comm<int>&) const;
  /// What loads have to say before a run, a line each: "earthquake: x record ...".
  std::vector<std::string> remarks() const;
  /// What the result will not vouch for because of them.
  Warnings warnings() const;

 private:
  struct Named {
    std::string name, word;  ///< in the scene; of its type
    TimeFunction time_function;
    std::unique_ptr<LoadOnNodes> load;
    mutable long long calls = 0;
    mutable double seconds = 0;
  };

  /// A load at a moment, written over; false when it does not act.
  bool act(std::size_t load, const std::map<std::string, double>& factors, double time, const BlockSystem&,
           ActingLoad&) const;
  std::vector<LoadMoment> moments_of(const Named&, double begin, double end, double from, double to) const;

  std::vector<Named> loads_;
};

extern template LoadsAtWork::LoadsAtWork(const Scene&, const BlockSource<2>&, const Structure<2>&);
extern template LoadsAtWork::LoadsAtWork(const Scene&, const BlockSource<3>&, const Structure<3>&);

}  // namespace voussoir
