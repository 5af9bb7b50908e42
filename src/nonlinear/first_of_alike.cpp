#include "nonlinear/first_of_alike.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "linalg/reduce.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/stability_parameters.hpp"

namespace voussoir {

FirstOfAlike first_of_alike(const NonlinearProblem& problem, const std::vector<double>& field) {
  double largest = 0;
  for (int k = 0; k < problem.owned_points(); ++k) largest = std::max(largest, field[k]);
  largest = largest_over_ranks(problem, largest);
  FirstOfAlike found;
  if (largest == 0) return found;
  double lowest = std::numeric_limits<double>::infinity();
  std::map<int, int> first_in;  // of each joint
  for (int k = 0; k < problem.points(); ++k) {
    if (field[k] < (1 - StabilityParameters::share_error) * largest) continue;
    auto& first = first_in.emplace(problem.joint_of(k), k).first->second;
    if (problem.number_of(k) < problem.number_of(first)) first = k;
    if (k < problem.owned_points()) lowest = std::min(lowest, static_cast<double>(problem.number_of(k)));
  }
  found.number = static_cast<long long>(-largest_over_ranks(problem, -lowest));
  for (int k = 0; k < problem.points(); ++k)
    if (problem.number_of(k) == found.number) found.joint = problem.joint_of(k);
  int mine = 0;  // a joint is counted where its first point is owned
  for (const auto& [joint, first] : first_in) mine += first < problem.owned_points() ? 1 : 0;
  found.joints = total_over_ranks(*problem.map()->getComm(), mine);
  return found;
}

}  // namespace voussoir
