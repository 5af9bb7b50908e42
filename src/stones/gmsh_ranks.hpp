// Pieces of stones that all ranks mesh, each its share with a gmsh of its own; the first rank puts them together.
#pragma once

#include <Teuchos_Comm.hpp>
#include <functional>
#include <vector>

#include "stones/gmsh_stones.hpp"

namespace voussoir {

/// Who meshes pieces: this rank alone, unless it is given by the function below. What comes is the same either way.
struct PieceMesher {
  std::function<std::vector<FlatMesh>(const std::vector<FlatDomain>&)> polygons = meshed;
  std::function<std::vector<FilledMesh>(const std::vector<ClosedMesh>&)> surfaces = filled;
};

/// Has the first rank do work for which pieces are meshed: these are dealt out to all ranks in equal numbers, and come
/// back in their order. gmsh makes the same of a piece whoever asks it, so nothing depends on the number of ranks. What
/// the work throws, or gmsh on any rank, is thrown on all as by on_first_rank (linalg/agree.hpp). Collective.
/// @param here  what each rank meshes with
void on_first_rank_meshed_by_all(const Teuchos::Comm<int>&, const std::function<void(const PieceMesher&)>& work,
                                 const PieceMesher& here = {});

}  // namespace voussoir
