#include "support/repository.hpp"

namespace voussoir {

std::string repository(const std::string& path) { return VOUSSOIR_SOURCE_DIR + path; }

}  // namespace voussoir
