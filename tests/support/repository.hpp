// Where the files of the repository are that a test reads.
#pragma once

#include <string>

namespace voussoir {

/// @param path  from the top of the repository, with a slash ahead
std::string repository(const std::string& path);

}  // namespace voussoir
