// minimum_thickness: the thinnest semicircular arch that stands under its own weight.
//
// Limit analysis brackets it by bisection: where no admissible forces balance the weight no equilibrium exists, by the
// static theorem. Elastic stones then answer just below and just above; only where friction that does not dilate asks
// for more thickness do they search on.
//
// The ring rests on two flat blocks that are held, so that it may open or slide at the springings as at any joint.
// Whether an arch stands does not depend on how stiff its stones are: contact forces act at nodes, those at intrados
// and extrados included, and gaps are linear in the displacements, so elastic stones find a thrust line wherever rigid
// ones have one. Their friction is Coulomb's, not the associated flow of limit analysis.
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/before_mpi.hpp"
#include "base/command_line.hpp"
#include "base/error.hpp"
#include "base/heap.hpp"
#include "base/leaks.hpp"
#include "base/words.hpp"
#include "linalg/fail_together.hpp"
#include "mesh/generators.hpp"
#include "model/plane/plane_model.hpp"
#include "run/rigid_limits.hpp"
#include "scene/scene.hpp"
#include "step/adaptive_step.hpp"

namespace {

using namespace voussoir;

struct Arguments {
  double friction = -1, tolerance = 1e-4, from = 0.04, to = 0.4;
  int voussoirs = 27, cells = 2;
  std::string help;  ///< to print instead of computing, when it was asked for
};

Arguments parse(const std::vector<std::string>& words) {
  Arguments a;
  CommandLine line("minimum_thickness", "--friction=MU [options]");
  line.add("--friction", "MU", a.friction, at_least(0), "friction coefficient of all joints [-]");
  line.add("--voussoirs", "N", a.voussoirs, at_least(3), "stones of the ring, the springings not counted (default 27)");
  line.add("--tolerance", "T", a.tolerance, at_least(1e-8), "accuracy of thickness / radius [-] (default 1e-4)");
  line.add("--from", "A", a.from, at_least(1e-3), "least thickness / radius to search [-] (default 0.04)");
  line.add("--to", "B", a.to, at_least(1e-3),
           "largest thickness / radius to search [-] (default 0.4); the first thickness that stands counts");
  line.add("--cells", "C", a.cells, at_least(1), "cells through the thickness (default 2)");
  if (!line.read(words)) {
    a.help = line.help(
        "Exit codes: 0 found, or shown that no thickness searched stands; 2 the input is wrong; 3 no convergence.\n");
    return a;
  }
  if (a.friction < 0) throw InputError("minimum_thickness: no friction given.\n  Give --friction=MU.");
  if (!(a.from < a.to && a.to < 2))
    throw InputError("minimum_thickness: --from = " + std::to_string(a.from) + ", --to = " + std::to_string(a.to) +
                     "\n  must be ascending and below 2 (the intrados would have no radius left).");
  return a;
}

/// A ring of radius 1 m whose stones weigh 20 kN/m3, on blocks as high as a cell.
Scene arch(const Arguments& a, double thickness) {
  Scene scene;
  scene.file = scene.name = "minimum_thickness";
  auto& mesh = scene.mesh;
  mesh.type = MeshType::arch;
  mesh.arch.radius = 1;
  mesh.arch.thickness = thickness;
  mesh.arch.voussoirs = a.voussoirs;
  mesh.arch.cells_radial = a.cells;
  mesh.arch.cells_along = 6;  // straight sides lie inside the arc: 2 cells would move the result by 0.1 %
  mesh.arch.pier_height = thickness / a.cells;
  mesh.arch.pier_courses = 1;
  MaterialParameters stone;
  stone.young_modulus = 10e9;  // as stone; 1 GPa and 1000 GPa find the same arches standing
  stone.density = 2000;
  scene.materials.push_back({"stone", stone});
  JointLawParameters joint;
  joint.friction_coefficient = a.friction;
  scene.joints.push_back({"dry", joint});
  for (const char* side : {"springing left", "springing right"}) {
    SupportParameters support;
    support.on = side;
    scene.supports.push_back({side, support});
  }
  LoadParameters weight;
  weight.name = "weight";
  scene.loads.push_back(weight);
  scene.selection.mode = SelectionMode::all;
  scene.newton.tolerance = 1e-8;  // of the largest force; 1e-6 lets arches stand that are 0.04 % too thin
  scene.newton.largest_iterations = 2000;
  return scene;
}

/// An arch of one thickness under its weight.
struct Weighed {
  Weighed(const Arguments& a, double thickness)
      : scene(arch(a, thickness)), source(make_arch(scene.mesh.arch)), model(scene, *source, Tpetra::getDefaultComm()) {
    model.loads({{"weight", 1.0}}, 0.0, load, prescribed);
  }
  Scene scene;
  std::unique_ptr<BlockSource<2>> source;
  PlaneModel model;
  std::vector<double> load, prescribed;
};

void report(double thickness, const char* answer, const std::string& by) {
  std::printf("t/R %.6f  %-14s  %s\n", thickness, answer, by.c_str());
}

/// What elastic stones do.
NewtonOutcome settled(const Arguments& a, double thickness) {
  Weighed weighed(a, thickness);
  AdaptiveStep step(weighed.model);
  auto state = step.initial_state();
  const auto solved = advance(step, state, {weighed.load, weighed.prescribed}).newton;
  const bool found = solved.outcome == NewtonOutcome::converged, falls = solved.outcome == NewtonOutcome::collapse;
  report(thickness,
         found   ? "stands"
         : falls ? "collapses"
                 : "undecided",
         "elastic stones, " + counted(solved.newton_iterations, "linear solve"));
  return solved.outcome;
}

bool stands(const Arguments& a, double thickness) {
  const auto outcome = settled(a, thickness);
  if (outcome == NewtonOutcome::not_converged)
    throw ConvergenceError("minimum_thickness: t/R = " + std::to_string(thickness) + ", friction " +
                           std::to_string(a.friction) + "\n  elastic stones found neither equilibrium nor collapse.");
  return outcome == NewtonOutcome::converged;
}

/// Whether admissible forces balance the weight. Where the programme cannot tell, elastic stones are asked.
bool forces_exist(const Arguments& a, double thickness) {
  const Weighed weighed(a, thickness);
  const auto verdict = RigidLimits(weighed.model, {nullptr, nullptr, weighed.load, {}}).bears(0).verdict;
  if (verdict != LimitVerdict::refused && verdict != LimitVerdict::unlimited) return stands(a, thickness);
  const bool exist = verdict == LimitVerdict::unlimited;
  report(thickness, exist ? "forces exist" : "no equilibrium", "limit analysis");
  return exist;
}

struct Bracket {
  double fails, stands;  ///< the same where the least thickness searched stands
};

/// The first thickness, as far as strides tell, at which a question is answered by yes.
template <class Question>
std::optional<Bracket> first_bracket(double from, double to, double tolerance, const Question& question) {
  // Thickness need not help without end where sliding decides, so the first thickness that stands is looked for.
  const double stride = 1.1;
  double low = from, high = from;
  while (!question(high)) {
    low = high;
    if (high >= to) return {};
    high = std::min(high * stride, to);
  }
  while (high - low > tolerance) {
    const double middle = (low + high) / 2;
    (question(middle) ? high : low) = middle;
  }
  return Bracket{low, high};
}

void search(const Arguments& a) {
  // The bracket of limit analysis and a margin on both sides, over which elastic stones stay within the tolerance.
  const double fine = a.tolerance / 10, aside = (a.tolerance - fine) / 2;
  const auto none = [&](const char* by) {
    std::printf("no equilibrium at any thickness searched, t/R = %g to %g, by %s\n", a.from, a.to, by);
  };
  const auto rigid = first_bracket(a.from, a.to, fine, [&](double t) { return forces_exist(a, t); });
  if (!rigid) return none("the static theorem");
  const bool least = rigid->fails == rigid->stands;
  if (!least) {
    std::printf("limit analysis: minimum t/R = %.6f\n", rigid->stands);
    const double below = std::max(a.from, rigid->fails - aside);
    if (settled(a, below) == NewtonOutcome::converged)
      throw ConvergenceError("minimum_thickness: t/R = " + std::to_string(below) +
                             "\n  elastic stones stand where the static theorem forbids it.");
  }
  const double above = least ? a.from : std::min(a.to, rigid->stands + aside);
  const auto elastic = first_bracket(above, a.to, a.tolerance, [&](double t) { return stands(a, t); });
  if (!elastic) return none("limit analysis and, where forces exist, by elastic stones");
  if (least && elastic->fails == elastic->stands)
    std::printf("stands at the least thickness searched, t/R = %g\n", a.from);
  else
    std::printf("minimum t/R = %.6f\n", elastic->stands);
}

int run_program(const std::vector<std::string>& words) {
  try {
    const auto a = parse(words);
    if (!a.help.empty())
      std::cout << a.help;
    else
      search(a);
    return exit_done;
  } catch (const InputError& error) {
    std::cerr << error.what() << "\n";
    return exit_input;
  } catch (const ConvergenceError& error) {
    std::cerr << error.what() << "\n";
    return exit_no_convergence;
  } catch (...) {
    return end_unforeseen(*Tpetra::getDefaultComm());
  }
}

}  // namespace

int main(int argc, char** argv) {
  before_mpi();
  keep_freed_memory();
  int name_alone = 1;  // Kokkos would answer --help before we do
  leaks::ignore_from_here();
  Tpetra::ScopeGuard scope(&name_alone, &argv);
  leaks::watch_from_here();
  const int code = run_program({argv + 1, argv + argc});
  return leaks::found() ? EXIT_FAILURE : code;
}
