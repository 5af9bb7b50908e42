#include "run/scene_blocks.hpp"

#include "run/plane/plane_blocks.hpp"
#include "run/space/space_blocks.hpp"

namespace voussoir {

std::unique_ptr<SceneBlocks> blocks_of(const Scene& scene, const SceneBlocks::Comm& comm, Trust trust) {
  return scene.mesh.dimension() == 2 ? plane_blocks_of(scene, comm, trust) : space_blocks_of(scene, comm, trust);
}

}  // namespace voussoir
