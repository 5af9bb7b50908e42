#include "run/scene_blocks.hpp"

#include "run/plane/plane_blocks.hpp"

namespace voussoir {

std::unique_ptr<SceneBlocks> blocks_of(const Scene& scene, const SceneBlocks::Comm& comm, Trust trust) {
  return plane_blocks_of(scene, comm, trust);
}

}  // namespace voussoir
