// A contact problem as a file of the FCLib collection: what other solvers of friction read.
//
//   M v = H r + f,   u = H^T v + w,   0 <= r_N _|_ u_N >= 0,   |r_T| <= mu r_N and against u_T
//
// Format   V. Acary, M. Bremond, T. Koziara, F. Perignon, FCLIB: a collection of discrete 3D frictional contact
//          problems, INRIA technical report 444 (2014): the global problem, without equations between velocities.
// Signs    those of src/README.md, "Contact": of the components of a point the first is normal; u_N > 0 is open,
//          r_N > 0 presses. Units are attributes of the tables.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <string>
#include <vector>

namespace voussoir {

/// Columns of this rank of a sparse matrix of all ranks; every column has one owner.
struct SparseColumns {
  long long rows = 0, columns = 0;  ///< of all ranks
  std::vector<long long> column;    ///< numbers of those of this rank, ascending
  std::vector<int> entries;         ///< how many each has
  std::vector<int> row;             ///< of entries, column by column, ascending in each
  std::vector<double> value;        ///< of entries
};

/// What this rank has of a contact problem: unknowns are columns of M, components of forces columns of H.
struct FclibProblem {
  int components = 2;           ///< of a force: 2 in the plane, 3 in space
  SparseColumns m, h;           ///< [N/m]; [-]
  std::vector<double> f, v;     ///< [N]; [m] of the columns of M
  std::vector<double> w, u, r;  ///< [m]; [m]; [N] of the columns of H
  std::vector<double> mu;       ///< [-] of every point, which is as many columns of H as there are components
};

/// What is said of it.
struct FclibWords {
  std::string title, description, math_info;
};

/// Entries of M, the larger of the two matrices. Numbers of FCLib are ints: with more than these it cannot hold them.
/// Collective.
long long entries_of(const FclibProblem&, const Teuchos::Comm<int>&);

/// Writes a new file, first beside its name, so that none is ever half there. Collective; throws ResourceError.
/// @param solved  whether v, u and r are a solution to be written
void write_fclib(const std::string& file, const FclibProblem&, bool solved, const FclibWords&,
                 const Teuchos::RCP<const Teuchos::Comm<int>>&);

}  // namespace voussoir
