// The main program of every unit test. A test passes when it passes on all ranks and loses no memory.
#include <Teuchos_UnitTestRepository.hpp>
#include <Tpetra_Core.hpp>

#include "base/before_mpi.hpp"
#include "base/leaks.hpp"

int main(int argc, char* argv[]) {
  voussoir::before_mpi();
  voussoir::leaks::ignore_from_here();
  Tpetra::ScopeGuard scope(&argc, &argv);
  voussoir::leaks::watch_from_here();
  Teuchos::UnitTestRepository::setGloballyReduceTestResult(true);
  const bool failed = Teuchos::UnitTestRepository::runUnitTestsFromMain(argc, argv) != 0;
  const bool leaking = voussoir::leaks::found();
  return failed || leaking ? 1 : 0;
}
