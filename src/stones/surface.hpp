// A stone as its surface: what a file of stones holds, before anything is known of neighbours.
#pragma once

#include <string>
#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

using Places = std::vector<Vector<3>>;

/// Polygons over points. In a repaired surface each is counter-clockwise seen from outside.
struct StoneSurface {
  std::string name;                     ///< of the group, file or node that it comes from
  std::string origin;                   ///< where it is written, for messages: "vault.obj, line 17"
  bool support = false;                 ///< the file calls it one
  int curved = 0;                       ///< faces that the file has curved, here in chords
  Places points;                        ///< [m]
  std::vector<std::vector<int>> faces;  ///< of point numbers
  std::vector<int> part;                ///< per face: no facet has faces of two; empty where all are of one
};

/// `stone "Mesh 17" (vault.obj, line 345)`
std::string in_words(const StoneSurface&);

/// [m3] inside the surface; a face that is not plane is a fan of triangles about the mean of its points.
double volume(const StoneSurface&);

/// [m] diagonal of the box around some points.
double extent(const Places&);

/// The places of some points, and their mean.
Places places_of(const Places& points, const std::vector<int>& numbers);
Vector<3> mean(const Places&);

/// [m2] area of a polygon along its normal; of one that is not plane the largest that a plane can see of it.
Vector<3> area_vector(const Places& polygon);

}  // namespace voussoir
