// What a test asks of errors of input.
#pragma once

#include <string>

#include "base/error.hpp"

namespace voussoir::test {

/// The message of the InputError that `act` throws; empty when it throws none.
template <class Act>
std::string input_error(Act act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace voussoir::test
