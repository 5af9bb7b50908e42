// The unknowns of a selection: nodes tied by bonded points share their displacement.
//
// Block-level displacements u and unknowns x are related by u = R x, where R copies an unknown to every
// node of its cluster. With nothing selected x is the bonded continuum; with everything selected R is the identity.
// A node that a support holds along a normal is tied to none, and its unknowns go along axes of its own, of which some
// are held whole: there R turns them.
#pragma once

#include <vector>

#include "blocks/held.hpp"
#include "joints/contact_points.hpp"

namespace voussoir {

class MergedSpace {
 public:
  /// @param selected  per local contact point, ghosts up to date; the others are bonded
  /// @param held      of local node copies, what supports prescribe of the displacement. Points at nodes with axes of
  ///                  their own must be selected
  MergedSpace(const BlockSystem&, const ContactPoints&, const std::vector<char>& selected, const Held& held);

  /// Of displacements: 2 in the plane, 3 in space.
  int components() const { return dim_; }
  /// Unknowns, numbered without gaps rank by rank: components * node + component.
  const Teuchos::RCP<const TpetraMap>& map() const { return map_; }
  /// Unknowns this rank reads: the owned ones first, then ghosts.
  const Teuchos::RCP<const TpetraMap>& column_map() const { return column_map_; }
  const TpetraImport& import() const { return *import_; }
  int owned_clusters() const { return owned_clusters_; }
  int clusters() const { return static_cast<int>(multiplicity_.size()); }

  /// Cluster (local number of the column map's nodes) of each local node copy.
  const std::vector<int>& cluster() const { return cluster_; }
  /// Whether a point holds its two nodes together, or others at its vertex do.
  bool tied(const ContactPoint& p) const { return is_tied(p, cluster_); }
  /// Number of node copies in each cluster.
  const std::vector<double>& multiplicity() const { return multiplicity_; }
  /// 1 where the unknown of the column map is prescribed [components x clusters], and own axes of clusters.
  const Held& held() const { return held_; }
  /// What of vectors on node copies is prescribed of their clusters, zero in all else.
  std::vector<double> held_part(const std::vector<double>& nodal) const;
  /// A node copy of each owned cluster.
  const std::vector<int>& representative() const { return representative_; }

  /// u = R x on all local node copies.
  void scatter(const TpetraVector& x, std::vector<double>& u) const;
  /// x = R^T r on owned unknowns, from all local node copies; held rows become 0.
  void sum(const std::vector<double>& r, TpetraVector& x) const;
  /// Takes vectors on node copies to the axes that unknowns go along.
  void turn_to_unknowns(std::vector<double>& nodal) const;
  /// x = mean of the node copies of each cluster; prescribed components take that of a held copy.
  void average(const std::vector<double>& u, TpetraVector& x) const;

 private:
  void turn_own(double* value) const;

  std::vector<int> cluster_, representative_;
  std::vector<double> multiplicity_;
  Held held_, held_copy_;
  int dim_, owned_clusters_ = 0, nodes_ = 0;
  Teuchos::RCP<const TpetraMap> map_, column_map_;
  Teuchos::RCP<const TpetraImport> import_;
  Teuchos::RCP<TpetraVector> column_vector_;
};

}  // namespace voussoir
