// Pieces that gmsh meshes and what comes of them, as bytes between its program and this one: written where they are
// const, else read.
#pragma once

#include <cstddef>

#include "mesh/bytes.hpp"
#include "stones/gmsh_stones.hpp"

namespace voussoir {

template <class Bytes, class Domain>
void exchange_domain(Bytes& bytes, Domain& domain) {
  const std::size_t loops = bytes.size(domain.loops, sizeof(std::size_t));
  for (std::size_t k = 0; k < loops; ++k) plain_list(bytes, domain.loops[k]);
  bytes.plain(domain.size);
}

template <class Bytes, class Mesh>
void exchange_flat(Bytes& bytes, Mesh& mesh) {
  plain_list(bytes, mesh.inside);
  plain_list(bytes, mesh.triangles);
  plain_list(bytes, mesh.failure);
}

template <class Bytes, class Mesh>
void exchange_closed(Bytes& bytes, Mesh& mesh) {
  plain_list(bytes, mesh.nodes);
  plain_list(bytes, mesh.triangles);
  bytes.plain(mesh.size);
}

template <class Bytes, class Mesh>
void exchange_filled(Bytes& bytes, Mesh& mesh) {
  plain_list(bytes, mesh.inside);
  plain_list(bytes, mesh.cells);
  plain_list(bytes, mesh.failure);
}

}  // namespace voussoir
