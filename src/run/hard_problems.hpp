// Contact problems that were hard, one file of the FCLib collection each: --fclib=hard.hdf5 makes hard-0001.hdf5, ...
//
// A problem was hard where the way that comes first did not close it (nonlinear/newton_report.hpp). It is written once
// it is solved as accurately as the scene asks, or given up; a rough solution of a selection that is thrown away shows
// only what to release.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <string>

#include "model/progress.hpp"
#include "scene/scene.hpp"

namespace voussoir {

class HardProblems {
 public:
  /// @param file     as the user gave it
  /// @param goes_on  files of an earlier part of the run may be there: their numbers go on
  /// Collective. Throws InputError where the name cannot be used, a file of that name is there, or joints of the scene
  /// are not dry: FCLib knows Coulomb's cone alone. Throws ResourceError where nothing can be written.
  HardProblems(const std::string& file, const Scene&, bool goes_on, const Teuchos::RCP<const Teuchos::Comm<int>>&);

  /// Writes one, and returns what there is to say of it. Collective.
  /// @param when  such as "stage 'push', load factor 1"
  std::string keep(const HardProblem&, const std::string& when);
  /// What there is to say at the end.
  std::string told() const;

 private:
  std::string name_of(int number) const;

  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  std::string before_, ending_;  ///< of names, around the number
  std::string scene_;
  int first_ = 1, next_ = 1;
};

}  // namespace voussoir
