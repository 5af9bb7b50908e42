// Words of messages: things that are counted, letters that are compared.
#pragma once

#include <string>

namespace voussoir {

/// A number of things: counted(1, "stone") is "1 stone", counted(2, "vertex", "vertices") is "2 vertices".
template <class Integer>
std::string counted(Integer number, const std::string& one, const std::string& many = "") {
  return std::to_string(number) + ' ' + (number == 1 ? one : many.empty() ? one + 's' : many);
}

/// With small letters for the capital ones of ASCII; all others stay.
inline std::string in_small_letters(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace voussoir
