// What a file is, by how its name ends.
#pragma once

#include <filesystem>
#include <string>

#include "base/words.hpp"

namespace voussoir {

/// ".dxf" of "Wall.DXF": programs write endings in small letters and in capital ones.
inline std::string lower_ending(const std::string& file) {
  return in_small_letters(std::filesystem::path(file).extension().string());
}

}  // namespace voussoir
