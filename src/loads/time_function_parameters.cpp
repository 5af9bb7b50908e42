#include "loads/time_function_parameters.hpp"

#include <algorithm>
#include <functional>

#include "base/parameter_section.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

using Type = TimeFunctionType;

/// Keys of one type of time function.
struct Keys {
  std::function<void(ParameterSection&)> declaration;
  void declare(ParameterSection& section) { declaration(section); }
};

void declare_table(TimeFunctionParameters& p, ParameterSection& section) {
  section.add("times", p.times, "rising times [s], separated by commas or blanks: \"0, 2, 2.5\"", Presence::required);
  section.add("values", p.values, "factor [-] at each time, linear in between, held before and after",
              Presence::required);
  const auto times = numbers_in(p.times), values = numbers_in(p.values);
  section.check(times.has_value(), "times", in_quotes(p.times), "must be numbers", "Write them like \"0, 2, 2.5\"");
  section.check(values.has_value(), "values", in_quotes(p.values), "must be numbers", "Write them like \"0, 1, 0\"");
  if (!times || !values) return;
  section.check(!times->empty() && times->size() == values->size(), "values", in_quotes(p.values),
                "must be one for each of the " + std::to_string(times->size()) + " times",
                "Give a value for each time");
  section.check(std::adjacent_find(times->begin(), times->end(), std::greater_equal<double>()) == times->end(), "times",
                in_quotes(p.times), "must rise (a load has one value at a time)",
                "Make a jump of two times that are close to each other");
  p.time = *times;
  p.value = *values;
}

}  // namespace

void TimeFunctionParameters::declare(ParameterSection& section) {
  section.add_choice<Type>("type", type,
                           {{"constant", Type::constant},
                            {"table", Type::table},
                            {"ramp", Type::ramp},
                            {"sine", Type::sine},
                            {"pulse", Type::pulse},
                            {"sine sweep", Type::sine_sweep},
                            {"record", Type::record}},
                           "factor of the load over time; static stages pass at time 0, or where dynamic ones ended");
  const auto keys = [&](Type of, const std::string& word, const std::string& text, const auto& declaration) {
    Keys k{declaration};
    section.add_alternative("", k, type == of, "type = " + word, text);
  };
  const auto begin = [this](ParameterSection& s) { s.add("start", start, "s", any_number(), "when it begins"); };
  const auto last = [this](ParameterSection& s) {
    s.add("duration", duration, "s", above(0), "how long it lasts", "a duration");
  };
  const auto size = [this](ParameterSection& s) { s.add("amplitude", amplitude, "-", any_number(), "largest factor"); };
  keys(Type::table, "table", "Linear between given points", [&](ParameterSection& s) { declare_table(*this, s); });
  keys(Type::ramp, "ramp", "Linear from one value to another, held before and after", [&](ParameterSection& s) {
    begin(s);
    last(s);
    s.add("from", from, "-", any_number(), "factor before the ramp");
    s.add("to", to, "-", any_number(), "factor after the ramp");
  });
  keys(Type::sine, "sine", "amplitude sin(2 pi frequency (t - start) + phase) while it lasts, 0 outside",
       [&](ParameterSection& s) {
         begin(s);
         s.add("end", end, "s", any_number().or_infinite(), "when it ends");
         size(s);
         s.add("frequency", frequency, "Hz", above(0).usually(1e-4, 1e6), "oscillations per second", "a frequency");
         s.add("phase", phase, "rad", any_number().usually(1e-6, 13), "angle at the start");
       });
  keys(Type::pulse, "pulse", "Half a sine: amplitude sin(pi (t - start) / duration) while it lasts, 0 outside",
       [&](ParameterSection& s) {
         begin(s);
         last(s);
         size(s);
       });
  keys(Type::sine_sweep, "sine sweep", "A sine whose frequency goes linearly from the first to the last, 0 outside",
       [&](ParameterSection& s) {
         begin(s);
         last(s);
         size(s);
         s.add("first frequency", first_frequency, "Hz", above(0).usually(1e-4, 1e6), "at the start", "a frequency");
         s.add("last frequency", last_frequency, "Hz", above(0).usually(1e-4, 1e6), "at the end", "a frequency");
       });
  keys(Type::record, "record", "Points from a file, linear in between, held before the first and after the last",
       [&](ParameterSection& s) {
         s.add("file", file, "file with factors [-] over time; lines that begin with # are text", Presence::required,
               "Give a path, from the folder of the scene or the one above it.");
         layout.declare(s);
         s.add("value column", value_column, "-", at_least(0), "where rows hold more than two numbers, from 1");
         layout.check(s, {{"value column", value_column}});
         s.add("scale", scale, "-", any_number(), "times every factor of the file");
       });
}

}  // namespace voussoir
