// The version comes from project(Voussoir VERSION ...) alone.
#include "base/version.hpp"

namespace voussoir {

const char* version() { return VOUSSOIR_VERSION; }

}  // namespace voussoir
