// Construction stages: which blocks are there, and how joints are born and die.
//
// Blocks that are not there are held where they are, bear no load, and their joints stand so far open that they never
// close: no unknown moves for them and no force passes. A block is born without stress where the mesh draws it; its
// joints with blocks that have moved already are born closed and without slip.
#pragma once

#include <vector>

#include "step/contact_problem.hpp"
#include "step/model.hpp"

namespace voussoir {

template <int dim>
class Construction {
 public:
  explicit Construction(const Model<dim>&);

  /// Lets blocks appear and disappear as a stage wants them; nothing happens when they are as they should be. To be
  /// called before every step.
  void begin(const std::string& stage, Model<dim>&, ContactState&);
  /// Whether each local block is not there; empty when a scene builds nothing.
  const std::vector<char>& absent() const { return absent_; }
  /// Takes loads off blocks that are not there, and holds them where they are.
  void restrict(const ContactState&, std::vector<double>& force, std::vector<double>& prescribed) const;

 private:
  bool present(const Block<dim>&, std::size_t stage) const;
  /// Of points with a side that is not there [m]: nothing moves as far as the structure is large.
  double apart() const { return structure_.size(); }
  double drawn(int k) const { return drawn_gap_.empty() ? 0.0 : drawn_gap_[k]; }
  void part(int k, ContactState&) const;
  /// @param between  relative motion of the two sides so far [m]
  void give_birth(int k, const Vector<dim>& between, ContactState&) const;
  void close(int k, const Vector<dim>& between, ContactState&) const;

  const Scene& scene_;
  const BlockSource<dim>& source_;
  const Structure<dim>& structure_;
  std::vector<double> drawn_gap_;  ///< [m] per point, of joints as the scene draws them; empty when all are closed
  std::vector<char> absent_;       ///< per local block; empty when a scene builds nothing
};

extern template class Construction<2>;

}  // namespace voussoir
