// Which Voussoir this is.
#pragma once

namespace voussoir {

/// Version of the program as the build system knows it, such as "0.1.0".
const char* version();

}  // namespace voussoir
