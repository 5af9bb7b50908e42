#include "run/hard_problems.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "base/words.hpp"
#include "linalg/agree.hpp"
#include "linalg/reduce.hpp"
#include "model/contact_problem.hpp"
#include "model/stated_problem.hpp"
#include "nonlinear/residuals.hpp"

namespace voussoir {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw InputError("voussoir: --fclib = " + file + "\n  " + why);
}

/// What FCLib cannot say of a joint; empty where there is nothing.
std::string beyond_coulomb(const JointLawParameters& law) {
  if (law.cohesion > 0) return "cohesion = " + six_digits(law.cohesion) + " [Pa]";
  if (law.tension_strength > 0) return "tension strength = " + six_digits(law.tension_strength) + " [Pa]";
  if (!std::isfinite(law.friction_coefficient)) return "friction coefficient = inf [-]";
  return "";
}

/// The number in a name such as hard-0012.hdf5; 0 where it is no such name.
int number_in_name(const std::string& name, const std::string& before, const std::string& ending) {
  if (name.size() <= before.size() + ending.size() || name.compare(0, before.size(), before) != 0 ||
      name.compare(name.size() - ending.size(), ending.size(), ending) != 0)
    return 0;
  const auto digits = name.substr(before.size(), name.size() - before.size() - ending.size());
  if (digits.size() < 4 || digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos) return 0;
  return std::stoi(digits);
}

/// The largest number there is; 0 where there is none.
int last_number(const fs::path& folder, const std::string& before, const std::string& ending) {
  int last = 0;
  for (const auto& entry : fs::directory_iterator(folder))
    last = std::max(last, number_in_name(entry.path().filename().string(), before, ending));
  return last;
}

std::string outcome_of(const HardProblem& hard) {
  const auto& report = hard.report;
  const auto solves = counted(hard.linear_solves, "linear solve");
  if (report.outcome == NewtonOutcome::converged)
    return "A solution was found in " + solves + ": imbalance " + formatted("%.1e", report.residual) +
           " and distance from Coulomb's law " + formatted("%.1e", report.complementarity) +
           " of the largest force, the latter as the projection on it with the stiffness of the stones at each point.";
  if (report.outcome == NewtonOutcome::collapse)
    return "No solution is given: in " + solves + " a motion was found along which the forces stay out of balance.";
  return "No solution is given: none was found in " + solves + ".";
}

FclibWords words_of(const std::string& scene, const HardProblem& hard, const std::string& when) {
  const bool in_time = hard.problem.parts().inertia;
  return {
      scene + ": " + when,
      "Masonry of elastic stones in contact, computed by voussoir " + std::string(version()) + " from " + scene + ", " +
          when +
          (in_time ? ", one time step: M has stiffness, inertia and damping" : ", one load step: M is stiffness") +
          ". v [m], H r and f [N]; u and w [m]: gap (> 0 open) and slip of stone j against stone i, normal first; "
          "r [N] compression positive. Supports are taken out of the unknowns. " +
          outcome_of(hard),
      std::string(in_time ? "M is symmetric and positive definite."
                          : "M is symmetric and positive semi-definite: each stone, or each group of stones whose "
                            "joints are not selected, that supports do not hold can move as a whole without a force.") +
          " Contact forces need not be unique, nor displacements of loose stones."};
}

}  // namespace

HardProblems::HardProblems(const std::string& file, const Scene& scene, bool goes_on,
                           const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : comm_(comm), scene_(scene.name) {
  for (const auto& joint : scene.joints)
    if (const auto beyond = beyond_coulomb(joint.parameters); !beyond.empty())
      refuse(file, "is asked for, but in " + scene.file + " joints > " + joint.name + " > " + beyond +
                       ",\n  and the format of FCLib knows Coulomb's friction alone, 0 <= mu < inf.\n  Leave --fclib "
                       "out, or make the joints dry.");
  const fs::path path(file);
  ending_ = path.extension().string();
  if (!path.has_filename() || path.stem().empty() || (ending_ != ".hdf5" && ending_ != ".h5"))
    refuse(file,
           "must be the name of a file that ends with .hdf5 or .h5; problems are numbered:\n  --fclib=hard.hdf5 "
           "writes hard-0001.hdf5, hard-0002.hdf5, ...");
  const auto folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const auto stem = path.stem().string() + "-";
  before_ = (path.has_parent_path() ? path.parent_path() / stem : fs::path(stem)).string();
  int last = 0;  // known to the first rank
  on_first_rank(*comm, [&] {
    std::error_code none;
    if (!fs::is_directory(folder, none))
      refuse(file, "names the folder " + folder.string() + ", which is not there.\n  Make it first.");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
      throw ResourceError("voussoir: --fclib = " + file + "\n  cannot be written because of: " + std::strerror(errno) +
                          ".\n  Give a folder that can be written to.");
    last = last_number(folder, stem, ending_);
    if (last > 0 && !goes_on)
      refuse(file, "would be numbered like " + before_ + "0001" + ending_ +
                       ", and problems of an earlier run are there up to " + name_of(last) +
                       ".\n  Give another name, or move them away: nothing is overwritten.");
  });
  first_ = next_ = largest_over_ranks(*comm, last) + 1;
}

std::string HardProblems::name_of(int number) const { return before_ + formatted("%04.0f", number) + ending_; }

std::string HardProblems::keep(const HardProblem& hard, const std::string& when) {
  const auto problem = stated(hard.problem, hard.x, hard.lambda);
  const auto size =
      counted(problem.m.columns, "unknown") + ", " + counted(problem.h.columns / problem.components, "contact point");
  if (entries_of(problem, *comm_) > std::numeric_limits<int>::max())
    return "  This contact problem was hard and is not written: FCLib counts entries of matrices in 32 bits (" + size +
           ").";
  const auto name = name_of(next_++);
  const bool solved = hard.report.outcome == NewtonOutcome::converged;
  write_fclib(name, problem, solved, words_of(scene_, hard, when), comm_);
  return "  This contact problem was hard: " + name + (solved ? "" : ", without a solution") + " (" + size + ").";
}

std::string HardProblems::told() const {
  const int count = next_ - first_;
  if (count == 0) return "No contact problem was hard: --fclib has nothing to write.";
  return counted(count, "contact problem was", "contact problems were") + " hard: " + name_of(first_) +
         (count == 1 ? "" : " to " + name_of(next_ - 1)) + ".";
}

}  // namespace voussoir
