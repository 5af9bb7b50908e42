// Lists for Belos and MueLu are tried before they are used: by name, type and value.
#include "linalg/refused_list.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <iostream>
#include <sstream>

namespace {

using namespace voussoir;

/// What is said of a list for MueLu, empty where it is taken.
template <class Change>
std::string said_of_muelu(const Change& change, int dim) {
  SolverParameters given;
  change(given.muelu);
  const auto refused = refused_list(given, dim);
  return refused ? refused->key + ": " + refused->why : "";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEUCHOS_UNIT_TEST(RefusedList, NothingIsTriedWhereNothingIsGiven) {
  TEST_ASSERT(!refused_list({}, 2));
  TEST_ASSERT(!refused_list({}, 3));
}

TEUCHOS_UNIT_TEST(RefusedList, ListsOfTheManualAreTaken) {
  for (const int dim : {2, 3}) {
    TEST_EQUALITY(said_of_muelu([](auto& list) { list.set("smoother: type", "CHEBYSHEV"); }, dim), "");
    TEST_EQUALITY(said_of_muelu([](auto& list) { list.set("coarse: max size", 200); }, dim), "");
    TEST_EQUALITY(said_of_muelu([](auto& list) { list.set("max levels", 1); }, dim), "");
    TEST_EQUALITY(said_of_muelu([](auto& list) { list.set("sa: damping factor", 1.2); }, dim), "");
    TEST_EQUALITY(said_of_muelu([](auto& list) { list.set("verbosity", "high"); }, dim), "");
    TEST_EQUALITY(said_of_muelu([](auto& list) { list.set("repartition: enable", true); }, dim), "");
    TEST_EQUALITY(said_of_muelu([](auto& list) { list.sublist("level 1").set("smoother: type", "CHEBYSHEV"); }, dim),
                  "");
  }
  SolverParameters given;
  given.belos.set("Verbosity", 33);
  given.belos_unsymmetric.set("Orthogonalization", "IMGS");
  given.belos_unsymmetric.set("Num Blocks", 20);
  for (const int most : {1, 2000})  // few iterations are the scene's own choice
    for (const auto* method : {"FLEXIBLE GMRES", "BLOCK GMRES"}) {
      given.largest_iterations = most;
      given.unsymmetric_method = method;
      TEST_ASSERT(!refused_list(given, 2));
    }
}

TEUCHOS_UNIT_TEST(RefusedList, WhatALibraryRefusesIsNamed) {
  for (const int dim : {2, 3}) {
    TEST_ASSERT(holds(said_of_muelu([](auto& list) { list.set("smoother: type", "NONSENSE"); }, dim), "smoother"));
    const auto large = [](auto& list) {
      list.set("coarse: max size", 100000);
      list.set("smoother: type", "NONSENSE");
    };
    TEST_ASSERT(holds(said_of_muelu(large, dim), "NONSENSE"));
    const auto of_a_level = [](auto& list) { list.sublist("level 2").set("smoother: type", "NONSENSE"); };
    TEST_ASSERT(holds(said_of_muelu(of_a_level, dim), "NONSENSE"));
    TEST_ASSERT(holds(said_of_muelu([](auto& list) { list.set("smother: type", "CHEBYSHEV"); }, dim), "smother: type"));
    TEST_ASSERT(holds(said_of_muelu([](auto& list) { list.set("max levels", "three"); }, dim), "max levels"));
    TEST_ASSERT(holds(said_of_muelu([](auto& list) { list.set("verbosity", "loudest"); }, dim), "loudest"));
  }
  SolverParameters given;
  given.belos.set("Nonsense", 3);
  TEST_EQUALITY(refused_list(given, 2)->key, "Belos");
  TEST_ASSERT(holds(refused_list(given, 2)->why, "Nonsense"));
  given = {};
  given.belos_unsymmetric.set("Num Blocks", -3);
  TEST_EQUALITY(refused_list(given, 2)->key, "Belos unsymmetric");
  TEST_ASSERT(holds(refused_list(given, 2)->why, "Num Blocks"));
  given = {};
  given.belos_unsymmetric.set("Orthogonalization", "NOPE");
  TEST_ASSERT(holds(refused_list(given, 2)->why, "orthogonalization"));
}

// Of levels that are shared out anew among ranks, whether or not this program has several.
TEUCHOS_UNIT_TEST(RefusedList, WhatIsWrongOnSeveralRanksAloneIsKnownOnOne) {
  TEST_INEQUALITY(said_of_muelu([](auto& list) { list.set("repartition: partitioner", "nonsense"); }, 2), "");
  TEST_EQUALITY(said_of_muelu([](auto& list) { list.set("repartition: partitioner", "zoltan2"); }, 2), "");
  TEST_EQUALITY(said_of_muelu([](auto& list) { list.set("repartition: enable", false); }, 3), "");
}

TEUCHOS_UNIT_TEST(RefusedList, WhatALibraryPrintsIsNotHeard) {
  std::ostringstream heard;
  auto* const before = std::cout.rdbuf(heard.rdbuf());
  const auto said = said_of_muelu([](auto& list) { list.set("smother: type", "CHEBYSHEV"); }, 2);
  std::cout.rdbuf(before);
  TEST_ASSERT(!said.empty());
  TEST_EQUALITY(heard.str(), "");
}

}  // namespace
