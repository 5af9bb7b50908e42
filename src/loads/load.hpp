// A load at work: made once from what a scene says and the structure it acts on, then added at every load step.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/warning.hpp"
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
  /// @param force       [N, dim x local node copies]
  /// @param prescribed  [m, the same shape]
  virtual void add(const std::vector<LoadMoment>&, std::vector<double>& force,
                   std::vector<double>& prescribed) const = 0;
  /// The load moves by itself, so that it is not the same at all times.
  virtual bool moves() const { return false; }
  /// Adds the times between two times at which it does not move smoothly [s]; between them it moves linearly.
  virtual void add_corners(double, double, std::vector<double>&) const {}
  /// Adds factor times the strain that a block would take freely, in every direction of the plane [-, per local block].
  virtual void add_free_strain(double, std::vector<double>&) const {}
  virtual bool strains() const { return false; }
  /// The load acts on all of stones, and not on edges, faces or points of them.
  virtual bool of_stones() const { return strains(); }
  /// Adds factor times the force on all of a block [N/m3, dim x local block]; of blocks whose edges bend.
  virtual void add_body_force(double, std::vector<double>&) const {}
  virtual bool has_body_force() const { return false; }
  /// Adds the part of the forces that turns with its stone, in balance on each by itself, as what heat does or what
  /// edges that bend hand over: it has no moment however the stone turns. All else keeps its direction.
  virtual void add_turning(const std::vector<LoadMoment>&, std::vector<double>&) const {}
  virtual bool has_turning() const { return false; }
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

/// Numbers of components of nodes of which those that are zero are not held.
class NodalPattern {
 public:
  NodalPattern() = default;
  explicit NodalPattern(const std::vector<double>& unit);
  void add(double factor, std::vector<double>& to) const {
    for (std::size_t k = 0; k < index_.size(); ++k) to[index_[k]] += factor * value_[k];
  }
  bool empty() const { return index_.empty(); }
  std::size_t bytes() const { return index_.capacity() * sizeof(int) + value_.capacity() * sizeof(double); }

 private:
  std::vector<int> index_;
  std::vector<double> value_;
};

/// Forces that keep their pattern: the factor times what they are for factor 1.
template <int dim>
class PatternLoad : public Load<dim> {
 public:
  enum class Of { forces, displacements };
  /// @param unit  [N or m, dim x local node copies] for factor 1
  explicit PatternLoad(const std::vector<double>& unit, Of of = Of::forces) : of_(of), pattern_(unit) {}
  void add(const std::vector<LoadMoment>&, std::vector<double>& force, std::vector<double>& prescribed) const override;
  std::size_t bytes() const override { return sizeof(*this) + pattern_.bytes(); }

 protected:
  const NodalPattern& pattern() const { return pattern_; }

 private:
  Of of_;
  NodalPattern pattern_;
};

/// The same of forces on all of a block, which bend edges within: stresses are told of them.
template <int dim>
class BodyForce final : public PatternLoad<dim> {
 public:
  /// @param per_volume  [N/m3, dim x local block] for factor 1
  BodyForce(const Structure<dim>&, const std::vector<double>& unit, std::vector<double> per_volume);
  void add_body_force(double factor, std::vector<double>& force) const override;
  bool has_body_force() const override { return !per_volume_.empty(); }
  void add_turning(const std::vector<LoadMoment>& moments, std::vector<double>& force) const override {
    of_edges_.add(sum_of_factors(moments), force);
  }
  bool has_turning() const override { return !of_edges_.empty(); }
  bool of_stones() const override { return true; }
  std::size_t bytes() const override {
    return PatternLoad<dim>::bytes() + sizeof(per_volume_) + per_volume_.capacity() * sizeof(double) +
           sizeof(of_edges_) + of_edges_.bytes();
  }

 private:
  std::vector<double> per_volume_;  ///< empty where no edge bends
  NodalPattern of_edges_;           ///< [N] of the pattern what such edges hand over
};

/// A pattern load from a function that adds forces for factor 1: add(unit).
template <int dim, class Add>
std::unique_ptr<Load<dim>> pattern_of(const Structure<dim>& s, const Add& add) {
  std::vector<double> unit(static_cast<std::size_t>(dim) * s.nodes(), 0.0);
  add(unit);
  return std::make_unique<PatternLoad<dim>>(unit);
}

/// Adds to nodes what edges of a block that bend hand over of a force on all of it [N/m3]; else nothing.
template <int dim>
void hand_over_edges(const LocalBlock<dim>&, const Vector<dim>& per_volume, std::vector<double>& force);

extern template class PatternLoad<2>;

}  // namespace voussoir
