// What accuracy costs: the same scene computed again and again, with more and more contact points, and on finer and
// finer meshes, each run measured against the best one of its sweep.
//
// Selection, on the scene's own mesh: all points as the truth u, adaptive for each threshold, and bonded. Where the run
// with all points fails, the truth is that with threshold 0: no point it leaves bonded violates its law, so that it
// solves the same problem.
//   error in energy = sqrt(e.K e / u.K u), e = difference of the displacements, K = stiffness of the blocks alone,
//   so that a motion of whole blocks as rigid bodies is not an error by itself; the displacement error sees it.
// Element size, adaptive as the scene asks: meshes are not nested, so that displacements cannot be subtracted.
//   error in energy = sqrt(|E - E*| / E*), E* = elastic energy on the finest mesh solved. Where energy converges
//   from one side this is the energy norm of the difference (Galerkin orthogonality); elsewhere an indicator.
// In both, the displacement error is that of the largest displacement, relative.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "base/ids.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// One run of a study and what it is worth; unknown numbers are NaN.
struct AccuracyRow {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::string sweep;              ///< "selection" or "element size"
  std::string mode;               ///< "bonded", "adaptive" or "all"
  double threshold = unknown;     ///< [-] error tolerance of an adaptive run
  double element_size = unknown;  ///< [m] longest side of the cells, or as asked of gmsh
  long long blocks = 0;
  long long unknowns = 0;  ///< of the linear systems, after the last selection
  long long candidate_points = 0, selected_points = 0;
  double error_energy = unknown;        ///< [-]
  double error_displacement = unknown;  ///< [-]
  double estimate = unknown;            ///< [-] the program's own: the largest of all load steps
  double seconds = 0;                   ///< from mesh to solution, the slowest rank
  long long linear_solves = 0, krylov_iterations = 0;
  std::string outcome;                    ///< "equilibrium", "collapse", "not converged" or "refused"
  double last_estimate = unknown;         ///< [-] of the last load step
  double largest_displacement = unknown;  ///< [m]
  double energy = unknown;                ///< [J] elastic
};

class AccuracyStudy {
 public:
  /// @param folder  exists; accuracy.csv is written there after every run
  /// @param say     where rank 0 narrates
  AccuracyStudy(const Scene&, const std::string& folder, const Teuchos::RCP<const Teuchos::Comm<int>>&,
                std::ostream& say);

  /// Runs all points, each threshold, and none. Collective.
  void sweep_selection(const std::vector<double>& thresholds);
  /// Runs the scene with its element size multiplied by each factor, coarsest first. Collective.
  /// @param affordable  [-] unknowns; a mesh that would have more is left out
  void sweep_element_size(std::vector<double> factors, double affordable = std::numeric_limits<double>::infinity());

  const std::vector<AccuracyRow>& rows() const { return rows_; }

 private:
  /// Displacements of the owned nodes at the end, to be subtracted from those of other runs.
  struct Field {
    std::vector<NodeId> node;
    std::vector<double> displacement, position;
  };
  AccuracyRow run(const Scene&, Field* keep, const Field* truth) const;
  void begin(const std::string& what) const;
  void end(const AccuracyRow&) const;
  void write() const;

  const Scene& scene_;
  std::string folder_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  std::ostream& say_;
  std::vector<AccuracyRow> rows_;
};

/// The scene with cells `factor` times as long, as near as whole numbers of cells allow. Throws InputError for meshes
/// whose size is not ours to change.
Scene with_element_size(Scene, double factor);
/// Longest side of the cells a scene asks for [m]; NaN when its mesh does not say.
double element_size(const Scene&);

}  // namespace voussoir
