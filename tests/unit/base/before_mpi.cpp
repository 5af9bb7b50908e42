#include "base/before_mpi.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace {

using voussoir::before_mpi;

/// Variables of the environment as a test sets them, and at its end as they were.
class Variables {
 public:
  Variables() {
    for (const char* name : names) {
      const char* value = std::getenv(name);
      was_.push_back(value ? std::optional<std::string>(value) : std::nullopt);
      ::unsetenv(name);
    }
  }
  ~Variables() {
    for (std::size_t k = 0; k < was_.size(); ++k)
      if (was_[k])
        ::setenv(names[k], was_[k]->c_str(), 1);
      else
        ::unsetenv(names[k]);
  }
  static std::string value(const char* name) {
    const char* found = std::getenv(name);
    return found ? found : "none";
  }

 private:
  static constexpr const char* names[] = {"OMPI_COMM_WORLD_SIZE",
                                          "PMIX_RANK",
                                          "PMI_RANK",
                                          "OMPI_COMM_WORLD_LOCAL_SIZE",
                                          "OMPI_MCA_pml",
                                          "OMPI_MCA_mpi_yield_when_idle",
                                          "OMPI_MCA_sharedfp",
                                          "OMPI_MCA_orte_create_session_dirs",
                                          "OMPI_MCA_ess_singleton_isolated"};
  std::vector<std::optional<std::string>> was_;
};

constexpr const char* yields = "OMPI_MCA_mpi_yield_when_idle";

TEUCHOS_UNIT_TEST(BeforeMpi, ASingleRankKeepsItsCore) {
  Variables variables;
  ::setenv(yields, "1", 1);
  before_mpi();
  TEST_EQUALITY(variables.value(yields), "0");
  ::setenv(yields, "1", 1);
  ::setenv("OMPI_COMM_WORLD_SIZE", "1", 1);
  before_mpi();
  TEST_EQUALITY(variables.value(yields), "0");
}

TEUCHOS_UNIT_TEST(BeforeMpi, RanksThatWaitForOthersDoAsTheyAreTold) {
  Variables variables;
  ::setenv(yields, "1", 1);
  ::setenv("OMPI_COMM_WORLD_SIZE", "2", 1);
  before_mpi();
  TEST_EQUALITY(variables.value(yields), "1");
  ::unsetenv("OMPI_COMM_WORLD_SIZE");
  ::setenv("PMIX_RANK", "0", 1);  // of a batch system
  before_mpi();
  TEST_EQUALITY(variables.value(yields), "1");
}

TEUCHOS_UNIT_TEST(BeforeMpi, RunsWithoutMpirunShareNoFolder) {
  constexpr const char* folders = "OMPI_MCA_orte_create_session_dirs";
  Variables variables;
  ::setenv("OMPI_COMM_WORLD_SIZE", "1", 1);
  before_mpi();
  TEST_EQUALITY(variables.value(folders), "none");
  ::unsetenv("OMPI_COMM_WORLD_SIZE");
  before_mpi();
  TEST_EQUALITY(variables.value(folders), "0");
}

TEUCHOS_UNIT_TEST(BeforeMpi, RanksOnOneMachineLookForNoNetwork) {
  constexpr const char* messages = "OMPI_MCA_pml";
  Variables variables;
  ::setenv("OMPI_COMM_WORLD_SIZE", "4", 1);
  before_mpi();
  TEST_EQUALITY(variables.value(messages), "none");
  ::setenv("OMPI_COMM_WORLD_LOCAL_SIZE", "2", 1);
  before_mpi();
  TEST_EQUALITY(variables.value(messages), "none");
  ::setenv("OMPI_COMM_WORLD_LOCAL_SIZE", "4", 1);
  before_mpi();
  TEST_EQUALITY(variables.value(messages), "ob1");
  ::unsetenv(messages);
  ::unsetenv("OMPI_COMM_WORLD_SIZE");
  ::setenv("PMIX_RANK", "0", 1);  // of a batch system, which tells not how many there are
  before_mpi();
  TEST_EQUALITY(variables.value(messages), "none");
  ::unsetenv("PMIX_RANK");
  before_mpi();
  TEST_EQUALITY(variables.value(messages), "ob1");
}

TEUCHOS_UNIT_TEST(BeforeMpi, WhatAUserHasSetIsKept) {
  Variables variables;
  ::setenv("OMPI_MCA_pml", "ucx", 1);
  ::setenv("OMPI_MCA_sharedfp", "sm", 1);
  before_mpi();
  TEST_EQUALITY(variables.value("OMPI_MCA_sharedfp"), "sm");
  TEST_EQUALITY(variables.value("OMPI_MCA_pml"), "ucx");
  TEST_EQUALITY(variables.value("OMPI_MCA_ess_singleton_isolated"), "1");
}

}  // namespace
