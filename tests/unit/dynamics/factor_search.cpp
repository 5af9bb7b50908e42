// The search for a load factor, with structures that are functions of the factor.
#include "dynamics/factor_search.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <any>
#include <functional>
#include <map>

namespace {

using namespace voussoir;

LoadFactorParameters wanted() {
  LoadFactorParameters p;
  p.pattern = {{"push", 1.0}};
  return p;  // from 0.1, at most 100, to 0.5 %
}

/// What a structure says to a factor when its last equilibrium was at another.
using Structure = std::function<Verdict(double factor, double last)>;

FactorSearch searched(const Structure& structure, FactorSearch search = FactorSearch(wanted()), int most = 100) {
  for (; search.next() && most > 0; --most) search.add(structure(*search.next(), search.lower()), 10);
  return search;
}

Structure collapses_at(double critical) {
  return [=](double factor, double) { return factor < critical ? Verdict::equilibrium : Verdict::collapse; };
}

TEUCHOS_UNIT_TEST(FactorSearch, BracketsTheCriticalFactorWhateverItsSize) {
  for (double critical : {0.0371, 0.1, 0.37, 3.1, 57.0}) {
    const auto search = searched(collapses_at(critical));
    TEST_ASSERT(search.found() && search.sharp());
    TEST_COMPARE(search.lower(), <, critical);
    TEST_COMPARE(search.upper(), >=, critical);
    TEST_COMPARE(search.upper() - search.lower(), <=, 0.005 * search.upper());
    TEST_COMPARE(search.attempts().size(), <=, 20u);  // 10 doublings to 100, 8 halvings of a bracket of one half
  }
}

TEUCHOS_UNIT_TEST(FactorSearch, EveryAttemptIsHigherThanTheLastEquilibrium) {
  for (const auto& structure : {collapses_at(0.37), Structure([](double, double) { return Verdict::undecided; })}) {
    FactorSearch search(wanted());
    while (const auto next = search.next()) {
      TEST_COMPARE(*next, >, search.lower());
      search.add(structure(*next, search.lower()), 10);
    }
  }
}

TEUCHOS_UNIT_TEST(FactorSearch, EndsAtTheLargestFactorWhereNothingCollapses) {
  const auto search = searched(collapses_at(1e6));
  TEST_ASSERT(search.finished() && !search.found());
  TEST_EQUALITY(search.lower(), 100.0);
}

TEUCHOS_UNIT_TEST(FactorSearch, EndsWhereNothingOfThePatternIsBorne) {
  const auto search = searched(collapses_at(0));
  TEST_ASSERT(search.finished() && search.found());
  TEST_EQUALITY(search.lower(), 0.0);
  TEST_COMPARE(search.upper(), <=, 0.005 * 0.1);
}

TEUCHOS_UNIT_TEST(FactorSearch, WhatIsUndecidedIsNoEndOfTheBracket) {
  // Between 0.36 and 0.38 the solver finds neither; both sides are known all the same.
  const auto search = searched([](double factor, double) {
    return factor < 0.36 ? Verdict::equilibrium : factor < 0.38 ? Verdict::undecided : Verdict::collapse;
  });
  TEST_ASSERT(search.finished() && search.found() && !search.sharp());
  TEST_COMPARE(search.lower(), <, 0.36);
  TEST_COMPARE(search.lower(), >=, 0.36 * (1 - 0.01));
  TEST_COMPARE(search.upper(), >=, 0.38);
  TEST_COMPARE(search.upper(), <=, 0.40);  // twice as far from 0.36 as 0.38 is: probes double
}

TEUCHOS_UNIT_TEST(FactorSearch, WithoutAMechanismNothingWasFound) {
  const auto search =
      searched([](double factor, double) { return factor < 0.3 ? Verdict::equilibrium : Verdict::undecided; });
  TEST_ASSERT(search.finished() && !search.found());
  TEST_COMPARE(search.lower(), <, 0.3);
  TEST_COMPARE(search.attempts().size(), <=, 20u);  // undecided attempts are dear
}

TEUCHOS_UNIT_TEST(FactorSearch, WhatWasUndecidedFromAfarIsTriedAgainFromNear) {
  // 0.3625 is undecided from 0.35, a mechanism from 0.3609 on.
  const auto search = searched([](double factor, double last) {
    if (factor < 0.361) return Verdict::equilibrium;
    return factor - last > 0.003 ? Verdict::undecided : Verdict::collapse;
  });
  TEST_ASSERT(search.found() && search.sharp());
  TEST_COMPARE(search.upper(), >, 0.361);
  TEST_COMPARE(search.upper() - search.lower(), <=, 0.005 * search.upper());
}

TEUCHOS_UNIT_TEST(FactorSearch, NearerAttemptsDecideWhatFarOnesCouldNot) {
  const auto search = searched([](double factor, double last) {
    if (factor - last > 0.05) return Verdict::undecided;
    return factor < 0.37 ? Verdict::equilibrium : Verdict::collapse;
  });
  TEST_ASSERT(search.found() && search.sharp());
  TEST_COMPARE(search.lower(), <, 0.37);
  TEST_COMPARE(search.upper() - search.lower(), <=, 0.005 * search.upper());
}

/// Falls from afar from 0.37 on, from near from 0.5 on.
Verdict falls_from_afar(double factor, double last) {
  const bool near = factor - last < 0.05;
  return factor < (near ? 0.5 : 0.37) ? Verdict::equilibrium : Verdict::collapse;
}

TEUCHOS_UNIT_TEST(FactorSearch, AMechanismFoundFromAfarIsNoEndUntilItIsFoundFromNear) {
  const auto search = searched(falls_from_afar);
  TEST_ASSERT(search.found() && search.sharp());
  TEST_COMPARE(search.lower(), >=, 0.5 * (1 - 0.005));
  TEST_COMPARE(search.upper(), <=, 0.5 * (1 + 0.01));
  TEST_COMPARE(search.attempts().size(), <=, 30u);
}

TEUCHOS_UNIT_TEST(FactorSearch, AMechanismFoundFromAfarStaysWhereNearAttemptsDecideNothing) {
  // 0.4 falls from 0.2; what is nearer stands, and 0.4 is undecided from there.
  const auto search = searched([](double factor, double last) {
    if (factor < 0.4) return Verdict::equilibrium;
    return factor - last > 0.1 ? Verdict::collapse : Verdict::undecided;
  });
  TEST_ASSERT(search.finished() && search.found() && search.sharp());
  TEST_EQUALITY(search.upper(), 0.4);
  TEST_COMPARE(search.lower(), >=, 0.4 * (1 - 0.005));
}

FactorSearch with_certificate(double certified, double guess) {
  FactorSearch search(wanted());
  search.certify(certified);
  search.guess(guess);
  return search;
}

TEUCHOS_UNIT_TEST(FactorSearch, NothingIsTriedAboveWhatATheoremExcludes) {
  for (double critical : {0.05, 0.3, 0.37}) {
    const auto search = searched(collapses_at(critical), with_certificate(0.37, 0.31));
    for (const auto& a : search.attempts()) TEST_COMPARE(a.factor, <, 0.37);
    TEST_ASSERT(search.found() && search.sharp());
    TEST_COMPARE(search.upper() - search.lower(), <=, 0.005 * search.upper());
    TEST_EQUALITY(search.has_mechanism(), critical < 0.3699);
  }
}

TEUCHOS_UNIT_TEST(FactorSearch, WhereNothingSlidesOneAttemptNearTheTheoremIsEnough) {
  const auto search = searched(collapses_at(0.37), with_certificate(0.37, 0.37));
  TEST_EQUALITY(search.attempts().size(), 3u);  // 0.1, 0.2, just below 0.37
  TEST_EQUALITY(search.upper(), 0.37);
}

TEUCHOS_UNIT_TEST(FactorSearch, AGoodGuessIsBracketedAtOnce) {
  const auto search = searched(collapses_at(0.3), with_certificate(0.37, 0.3));
  TEST_EQUALITY(search.attempts().size(), 4u);  // 0.1, 0.2, on both sides of 0.3
}

TEUCHOS_UNIT_TEST(FactorSearch, UndecidedBelowATheoremTheBracketIsWideButClosed) {
  const auto search =
      searched([](double factor, double) { return factor < 0.3 ? Verdict::equilibrium : Verdict::undecided; },
               with_certificate(0.37, 0.31));
  TEST_ASSERT(search.finished() && search.found() && !search.sharp() && !search.has_mechanism());
  TEST_EQUALITY(search.upper(), 0.37);
}

TEUCHOS_UNIT_TEST(FactorSearch, WhatIsUndecidedIsApproachedMoreCloselyThanTheBracketAsked) {
  // From nearer than half the accuracy what was undecided is decided.
  const auto search = searched(
      [](double factor, double last) {
        if (factor < 0.36) return Verdict::equilibrium;
        return factor - last > 0.4 * 0.005 * factor ? Verdict::undecided : Verdict::collapse;
      },
      with_certificate(0.365, 0.365));
  TEST_ASSERT(search.found() && search.sharp());
  TEST_COMPARE(search.upper() - search.lower(), <=, 0.005 * search.upper());
  TEST_COMPARE(search.lower(), <, 0.36);
}

TEUCHOS_UNIT_TEST(FactorSearch, WhatBearsNothingOfThePatternIsNotTried) {
  const auto search = searched(collapses_at(0), with_certificate(0, 0));
  TEST_ASSERT(search.attempts().empty() && search.found());
}

/// An archive in memory: saves on its first use, restores when it is turned round.
struct Memory {
  std::map<std::string, std::any> values;
  bool restoring = false;
  template <class T>
  void value(const std::string& name, T& v) {
    if (restoring)
      v = std::any_cast<T>(values.at(name));
    else
      values[name] = v;
  }
  template <class T>
  void within(const std::string& name, T& v, double, double) {
    value(name, v);
  }
};

TEUCHOS_UNIT_TEST(FactorSearch, GoesOnAfterARestartAsIfItHadNotStopped) {
  const auto whole = searched(collapses_at(0.37));
  for (int stop = 0; stop < static_cast<int>(whole.attempts().size()); ++stop) {
    auto first = searched(collapses_at(0.37), FactorSearch(wanted()), stop);
    Memory memory;
    first.keep(memory);
    memory.restoring = true;
    FactorSearch second(wanted());
    second.keep(memory);
    second = searched(collapses_at(0.37), second);
    TEST_EQUALITY(second.lower(), whole.lower());
    TEST_EQUALITY(second.upper(), whole.upper());
    TEST_EQUALITY(second.attempts().size(), whole.attempts().size());
  }
}

}  // namespace
