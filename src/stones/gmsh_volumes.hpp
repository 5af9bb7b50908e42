// Volumes from a file of gmsh, by its program.
#pragma once

#include "mesh/geo_commands.hpp"
#include "stones/stones_parameters.hpp"
#include "stones/volume_mesh.hpp"

namespace voussoir {

/// Whether a file is one of gmsh, by its ending.
bool is_of_gmsh(const std::string& file);

/// What of the volumes is wanted: their cells, which gmsh makes for a .geo; or triangles, of plane faces as few as they
/// have corners, of curved ones with chords of a sixteenth of a turn.
enum class VolumesAs { meshed, outlined };

/// Throws InputError where the file cannot be used; what gmsh said is part of the message.
/// @param trust  whether a .geo may do what a drawing need not: run programs, read and write files
VolumeMesh read_volumes(const StonesParameters&, VolumesAs, Trust);

}  // namespace voussoir
