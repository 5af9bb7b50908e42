// Which Krylov methods solve, and lists passed on verbatim to Belos and MueLu, whose manuals apply. How accurately a
// system is solved is no parameter: who asks for a solution knows what it needs.
#pragma once

#include <Teuchos_ParameterList.hpp>
#include <string>

namespace voussoir {

class ParameterSection;

struct SolverParameters {
  std::string method = "CG";                          ///< of Belos; must suit symmetric positive definite systems
  std::string unsymmetric_method = "FLEXIBLE GMRES";  ///< of Belos, for systems in which friction follows the pressure
  int largest_iterations = 2000;
  Teuchos::ParameterList belos;              ///< sublist "Belos": overrides what Voussoir sets
  Teuchos::ParameterList belos_unsymmetric;  ///< sublist "Belos unsymmetric"
  Teuchos::ParameterList muelu;              ///< sublist "MueLu": overrides what Voussoir sets
  void declare(ParameterSection&);
};

}  // namespace voussoir
