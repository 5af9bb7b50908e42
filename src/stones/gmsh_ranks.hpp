// Polygons that all ranks mesh, each its share with a gmsh of its own, for the rank that puts them together.
#pragma once

#include <Teuchos_Comm.hpp>
#include <functional>
#include <vector>

#include "stones/gmsh_stones.hpp"

namespace voussoir {

/// Who meshes polygons: this rank alone, or all by the function below. What comes is the same either way.
using PolygonMesher = std::function<std::vector<FlatMesh>(const std::vector<FlatDomain>&)>;

/// Has the first rank do work for which polygons are meshed: these are dealt out to all ranks in equal numbers, and
/// come back in their order. gmsh makes the same of a polygon whoever asks it, so nothing depends on the number of
/// ranks. What the work throws, or gmsh on any rank, is thrown on all as by on_first_rank (linalg/agree.hpp).
/// Collective.
/// @param here  what each rank meshes with
void on_first_rank_meshed_by_all(const Teuchos::Comm<int>&, const std::function<void(const PolygonMesher&)>& work,
                                 const PolygonMesher& here = meshed);

}  // namespace voussoir
