// Integer types of the program. A name says what is counted, so that a node
// is never passed where a block is meant.
#pragma once

namespace voussoir {

/// Number of a block, 0 .. blocks-1, the same on every rank and for any number of ranks.
using BlockId = int;

/// Number of a body node, 0 .. nodes-1: blocks in order, nodes of a block in order.
/// Every block has its own copies, so a point shared by three blocks is three nodes.
using NodeId = long long;

/// Number of a geometric point of the mesh. Coincident nodes of different blocks
/// carry the same vertex: that, not a distance, is what makes them a pair.
using VertexId = long long;

/// Number of a contact point (a pair of nodes of two blocks on one joint).
using PointId = long long;

}  // namespace voussoir
