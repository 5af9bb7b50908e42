// Edges of triangles or tetrahedra that bend, condensed: what a block of quadratic cells is to its corners.
//
//   u = sum over corners L_i u_i + sum over curved edges 4 L_i L_j b_ij        K_ee b = f_e - K_ec u
//   K = K_cc - K_ce K_ee^-1 K_ec,   f = f_c - K_ce K_ee^-1 f_e
//
// K_cc is the stiffness of linear cells. Edges that stay straight (mesh/curved_edges.hpp) have no b, and every b
// is of one block alone, so none of them is an unknown of the structure: corners, contact points and their areas are
// those of linear cells, and so is mass, as condensation is that of bodies at rest. A rigid motion bends no edge:
// K_ec is zero along it, and a force keeps its sum and its moments.
//
// Theory  R. J. Guyan, AIAA Journal 3 (1965) 380; O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 1,
//         chapters 4 and 8 (hierarchical shape functions, substructures).
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "base/tensor.hpp"
#include "blocks/simplex.hpp"
#include "linalg/local_csr.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

class SparseCholesky;

class CondensedEdges {
 public:
  /// Condenses the edges that a block says are curved, of which there is one at least.
  template <int dim>
  CondensedEdges(const Block<dim>&, const Material&, const ModelParameters&);
  ~CondensedEdges();

  /// Of the corners once their edges are free to bend [N/m]: every entry is there.
  LocalCsr stiffness(const LocalCsr& of_linear_cells) const;
  int size() const { return static_cast<int>(edges_.size()); }
  /// Adds to the forces of edges [N, edge by edge] what comes to them of a uniform force on all of the block [N/m3].
  template <int dim>
  void add_body_force(const Vector<dim>& force, double* of_edges) const;
  /// Adds to the forces of its corners what edges hand to them of theirs [N].
  void hand_over(std::vector<double> of_edges, double* of_corners) const;
  /// What is stored by edges that bend under forces on them [N] while corners stay where they are [J].
  double energy(const std::vector<double>& of_edges) const;
  /// How far the edges of each cell bend [m], in the order of simplex_edges; straight ones by 0.
  /// @param u         of the corners [m], without what they take freely
  /// @param of_edges  forces on edges [N]
  template <int dim>
  std::vector<typename Simplex<dim>::OfEdges> bends(const Block<dim>&, const std::vector<double>& u,
                                                    std::vector<double> of_edges) const;
  long long bytes() const;

 private:
  template <int dim>
  using EdgeNumbers = std::array<int, Simplex<dim>::edges>;  ///< of the edges of a cell, -1 for straight ones
  template <int dim>
  EdgeNumbers<dim> numbers_of(const Cell&) const;
  template <int dim>
  void add_cell(const Cell&, const Simplex<dim>&, const EdgeNumbers<dim>&, const Lame&, double thickness,
                LocalCsr& with_edges);

  std::vector<std::array<int, 2>> edges_;
  LocalCsr with_corners_;                   ///< K_ec
  std::vector<double> volume_;              ///< [m3] integral of the function of each edge
  std::unique_ptr<SparseCholesky> factor_;  ///< of K_ee
};

}  // namespace voussoir
