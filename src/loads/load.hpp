// A load at work: made once from what a scene says and the structure it acts on, then added at every load step.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/warning.hpp"
#include "blocks/block_forces.hpp"
#include "blocks/structure.hpp"
#include "blocks/support_parameters.hpp"
#include "loads/load_parameters.hpp"
#include "mesh/facet_set.hpp"

namespace voussoir {

/// Where a load acts, and how messages call it. Needed while a load is made, not after.
template <int dim>
struct LoadSite {
  const Structure<dim>& structure;
  const BlockSource<dim>& source;  ///< knows the names of sets
  const std::vector<std::pair<std::string, SupportParameters>>& supports;
  std::string where;  ///< "xml/wall.xml: scene > loads > push"

  FacetSet facet_set(const std::string& on, const std::string& blocks) const;
  bool in_block_set(const Block<dim>&, const std::string& name) const;
};

/// What a load is multiplied by at a time.
struct LoadMoment {
  double time = 0;    ///< [s]
  double factor = 0;  ///< [-]
};

/// A load as forces and displacements of nodes: what steps see of it, whatever its dimension.
class LoadOnNodes {
 public:
  virtual ~LoadOnNodes() = default;
  /// Adds what the load is at some times, each times its factor. No communication.
  /// @param force       of nodes and of edges that bend
  /// @param prescribed  [m, dim x local node copies]
  virtual void add(const std::vector<LoadMoment>&, BlockForces& force, std::vector<double>& prescribed) const = 0;
  /// The load moves by itself, so that it is not the same at all times.
  virtual bool moves() const { return false; }
  /// Adds the times between two times at which it does not move smoothly [s]; between them it moves linearly.
  virtual void add_corners(double, double, std::vector<double>&) const {}
  /// Adds factor times the strain that a block would take freely, in every direction of the plane [-, per local block].
  virtual void add_free_strain(double, std::vector<double>&) const {}
  virtual bool strains() const { return false; }
  /// The load acts on all of stones, and not on edges, faces or points of them.
  virtual bool of_stones() const { return strains(); }
  /// [s] A time step that sees how the load varies; infinite when it does not vary by itself. The same on every rank.
  virtual double resolution() const { return std::numeric_limits<double>::infinity(); }
  /// [s] The same for steps between two times.
  virtual double resolution(double, double) const { return std::numeric_limits<double>::infinity(); }
  /// [bytes] held on this rank.
  virtual std::size_t bytes() const = 0;
  /// What a user should know of the load before the run; "" for nothing. The same on every rank.
  virtual std::string remark() const { return ""; }
  /// What the result will not vouch for because of this load. The same on every rank.
  virtual Warnings warnings() const { return {}; }
};

template <int dim>
class Load : public LoadOnNodes {};

/// The sum of the factors: what a load that does not move is multiplied by.
double sum_of_factors(const std::vector<LoadMoment>&);

/// Makes a load of any type. Collective; throws InputError on every rank alike.
template <int dim>
std::unique_ptr<Load<dim>> make_load(const LoadParameters&, const LoadSite<dim>&);

/// Makes a load of one type; defined in the file of the type.
template <int dim, class Parameters>
std::unique_ptr<Load<dim>> make_load_of(const Parameters&, const LoadSite<dim>&);

/// What is not zero of a list.
class Pattern {
 public:
  explicit Pattern(const std::vector<double>&);
  void add(double factor, std::vector<double>& to) const;
  std::size_t bytes() const { return index_.capacity() * sizeof(int) + value_.capacity() * sizeof(double); }

 private:
  std::vector<int> index_;
  std::vector<double> value_;
};

/// A load that keeps its pattern: the factor times what it is for factor 1.
template <int dim>
class PatternLoad : public Load<dim> {
 public:
  explicit PatternLoad(const BlockForces& unit);
  /// @param unit  prescribed displacements [m, dim x local node copies] for factor 1
  explicit PatternLoad(const std::vector<double>& unit);
  void add(const std::vector<LoadMoment>&, BlockForces& force, std::vector<double>& prescribed) const override;
  std::size_t bytes() const override;

 private:
  Pattern nodes_, edges_, prescribed_;
};

/// The same of forces on all of stones.
template <int dim>
class BodyForce final : public PatternLoad<dim> {
 public:
  using PatternLoad<dim>::PatternLoad;
  bool of_stones() const override { return true; }
};

/// A load of such a kind from a function that adds forces for factor 1: add(unit).
template <class Kind, int dim, class Add>
std::unique_ptr<Load<dim>> made_of(const Structure<dim>& s, const Add& add) {
  BlockForces unit(s);
  add(unit);
  return std::make_unique<Kind>(unit);
}
template <int dim, class Add>
std::unique_ptr<Load<dim>> pattern_of(const Structure<dim>& s, const Add& add) {
  return made_of<PatternLoad<dim>>(s, add);
}

extern template class PatternLoad<2>;

}  // namespace voussoir
