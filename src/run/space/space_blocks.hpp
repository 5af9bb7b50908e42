// The blocks of a scene in space.
#pragma once

#include "run/scene_blocks.hpp"

namespace voussoir {

/// Collective; throws InputError on every rank alike.
std::unique_ptr<SceneBlocks> space_blocks_of(const Scene&, const SceneBlocks::Comm&, Trust);

}  // namespace voussoir
