// What the process that runs gmsh is asked for.
#pragma once

#include <string>

#include "mesh/mesh_parameters.hpp"

namespace voussoir {

/// The parameters as bytes, for another process of this program, and back.
std::string bytes_of(const GmshParameters&);
GmshParameters gmsh_parameters_of(const std::string& bytes);

}  // namespace voussoir
