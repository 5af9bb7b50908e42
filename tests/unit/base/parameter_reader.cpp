// Declarations of a made-up module, read from lists: what is bound, what is refused, what is left alone.
#include "base/parameter_reader.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "base/error.hpp"

namespace {

using namespace voussoir;
using Teuchos::ParameterList;

struct Round {
  double radius = 1;
  void declare(ParameterSection& section) { section.add("radius", radius, "m", above(0), "half the width"); }
};

struct Square {
  double side = 1;
  int corners = 4;
  void declare(ParameterSection& section) {
    section.add("side", side, "m", above(0), "width");
    section.add("corners", corners, "-", between(4, 4), "of a square");
    section.check(corners < side, "corners", "", "must be fewer than metres of side", "Give a larger side");
  }
};

enum class Shape { round, square };

/// A stone: its shape decides which keys it has.
struct Stone {
  Shape shape = Shape::round;
  Round round;
  Square square;
  std::map<std::string, double> prices;
  void declare(ParameterSection& section) {
    section.add_choice<Shape>("shape", shape, {{"round", Shape::round}, {"square", Shape::square}}, "of the stone",
                              Presence::required);
    section.add_alternative("", round, shape == Shape::round, "shape = round", "");
    section.add_alternative("square", square, shape == Shape::square, "shape = square", "");
    section.add_numbers("prices", prices, "", at_least(0), "per quarry");
  }
};

std::string said(const ParameterList& list, Stone& stone, const Overrides& overrides = {}) {
  InputProblems problems("stone.xml");
  ParameterReader reader(list, overrides, problems);
  stone.declare(reader);
  reader.finish();
  try {
    problems.throw_if_any();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEUCHOS_UNIT_TEST(ParameterReader, AnIntIsADoubleAndAnAbsentKeyKeepsItsDefault) {
  ParameterList list;
  list.set("shape", "square");
  list.sublist("square").set("side", 7);
  Stone stone;
  TEST_EQUALITY_CONST(said(list, stone), "");
  TEST_ASSERT(stone.shape == Shape::square);
  TEST_EQUALITY_CONST(stone.square.side, 7.0);
  TEST_EQUALITY_CONST(stone.square.corners, 4);
}

TEUCHOS_UNIT_TEST(ParameterReader, KeysOfAnotherChoiceAreNamedAsSuch) {
  ParameterList list;
  list.set("shape", "square").set("radius", 2.0);
  list.sublist("square").set("side", 7.0);
  Stone stone;
  TEST_EQUALITY_CONST(said(list, stone),
                      "stone.xml: scene > radius is present\n  but belongs to shape = round, which this section has "
                      "not chosen.\n  Remove it, or choose shape = round.");
  TEST_EQUALITY_CONST(stone.round.radius, 1.0);
}

TEUCHOS_UNIT_TEST(ParameterReader, ARefusedChoiceSpeaksAlone) {
  ParameterList list;
  list.set("shape", "squar").set("radius", -2.0);
  list.sublist("square").set("side", -7.0);
  Stone stone;
  TEST_EQUALITY_CONST(
      said(list, stone),
      "stone.xml: scene > shape = \"squar\"\n  must be one of round, square (did you mean \"square\"?).\n"
      "  Of the stone.");
}

TEUCHOS_UNIT_TEST(ParameterReader, RelationsAreCheckedOnlyWhereValuesAreRight) {
  ParameterList list;
  list.set("shape", "square");
  list.sublist("square").set("side", 3.0);
  Stone stone;
  TEST_EQUALITY_CONST(
      said(list, stone),
      "stone.xml: scene > square > corners\n  must be fewer than metres of side.\n  Give a larger side.");
  list.sublist("square").set("side", -3.0);
  TEST_EQUALITY_CONST(said(list, stone), "stone.xml: scene > square > side = -3 [m]\n  must be > 0.\n  Width.");
}

TEUCHOS_UNIT_TEST(ParameterReader, OverridesHaveTheDeclaredTypeAndReplaceAWrongValue) {
  ParameterList list;
  list.set("shape", "square").sublist("prices").set("Ketton", -1.0);
  Stone stone;
  const Overrides overrides{
      {"scene > square > side", "8"}, {"scene > prices > Ketton", "3"}, {"scene > prices > Bath", "4"}};
  TEST_EQUALITY_CONST(said(list, stone, overrides), "");
  TEST_EQUALITY_CONST(stone.square.side, 8.0);
  TEST_EQUALITY_CONST(stone.prices.at("Ketton"), 3.0);
  TEST_EQUALITY_CONST(stone.prices.at("Bath"), 4.0);
}

TEUCHOS_UNIT_TEST(ParameterReader, AValueInTheWrongPlaceIsRefused) {
  ParameterList list;
  list.sublist("shape");
  list.set("prices", 3.0).set("radius", true);
  Stone stone;
  const std::string message = said(list, stone);
  TEST_INEQUALITY_CONST(message.find("scene > shape = a ParameterList\n  must be of type string"), std::string::npos);
  TEST_INEQUALITY_CONST(message.find("scene > prices = 3 (double)\n  must be a ParameterList"), std::string::npos);
}

}  // namespace
