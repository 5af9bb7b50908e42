// The pieces of work of voussoir-gmsh (mesh/gmsh_program.hpp), each from the bytes of a request to those of an answer.
#pragma once

#include <string>

namespace voussoir::gmsh_work {

std::string looked_at(const std::string& request);
std::string drawing_meshed(const std::string& request);
std::string volumes_meshed(const std::string& request);
std::string volumes_outlined(const std::string& request);
std::string step_triangulated(const std::string& file);
std::string polygons_meshed(const std::string& request);
std::string surfaces_filled(const std::string& request);

}  // namespace voussoir::gmsh_work
