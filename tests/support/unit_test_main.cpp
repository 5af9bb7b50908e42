// The main program of every unit test. A test passes when it passes on all ranks.
//
// In the debug build leaks are looked for between the start and the end of MPI: plug-ins it has unloaded by then take
// the only pointers to their memory with them, which is no leak of ours.
#include <Teuchos_UnitTestRepository.hpp>
#include <Tpetra_Core.hpp>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
static void ignore_allocations() { __lsan_disable(); }
static void watch_allocations() { __lsan_enable(); }
static bool has_leaks() { return __lsan_do_recoverable_leak_check() != 0; }
#else
static void ignore_allocations() {}
static void watch_allocations() {}
static bool has_leaks() { return false; }
#endif

int main(int argc, char* argv[]) {
  ignore_allocations();
  Tpetra::ScopeGuard scope(&argc, &argv);
  watch_allocations();
  Teuchos::UnitTestRepository::setGloballyReduceTestResult(true);
  const bool failed = Teuchos::UnitTestRepository::runUnitTestsFromMain(argc, argv) != 0;
  const bool leaking = has_leaks();
  return failed || leaking ? 1 : 0;
}
