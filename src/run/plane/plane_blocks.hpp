// The blocks of a scene of the plane.
#pragma once

#include "run/scene_blocks.hpp"

namespace voussoir {

/// Collective; throws InputError on every rank alike.
std::unique_ptr<SceneBlocks> plane_blocks_of(const Scene&, const SceneBlocks::Comm&, Trust);

}  // namespace voussoir
