// Volumes as they are meshed, where stones touch node to node.
#pragma once

#include <string>
#include <vector>

#include "stones/stone_structure.hpp"
#include "stones/volume_mesh.hpp"

namespace voussoir {

struct VolumeBlocks {
  BlockList<3> list;      ///< with what is told of it
  double within = 0;      ///< [m] nodes closer than this are one
  std::string unmatched;  ///< stones that touch where their meshes do not match; empty where all do
};

/// Nodes of different volumes that coincide become one vertex, so volumes drawn one by one with equal divisions fit
/// together. Sets of facets are "base", "top" and "faces", sets of blocks the names of stones and "one neighbour", as
/// of stones that are meshed here. Throws InputError by volume and place for faces of three stones, stones on the same
/// side of a face and stones that lie in each other by more than the tolerance.
/// @param stones     the borders of the volumes
/// @param tolerance  [m] of joints
VolumeBlocks blocks_as_meshed(const VolumeMesh&, const std::vector<StoneSurface>& stones, double tolerance);

}  // namespace voussoir
