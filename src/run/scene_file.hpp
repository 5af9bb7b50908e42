// scene.xml in the folder of a run: what is being computed there, every default included.
#pragma once

#include <Teuchos_Comm.hpp>
#include <string>

#include "scene/scene.hpp"

namespace voussoir {

/// Writes it, and takes away the result of a run that is gone on with: until there is another one the run is not at its
/// end. Collective; throws ResourceError on all ranks.
void write_scene_file(const Scene&, const std::string& folder, const Teuchos::Comm<int>&);

/// drawing.svg: how a drawing of stones was fitted together. Nothing where there is no picture. Collective.
void write_drawing(const std::string& picture, const std::string& folder, const Teuchos::Comm<int>&);

}  // namespace voussoir
