// Brittle joints with too few cells along them, as they come near to their strength.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/warning.hpp"
#include "joints/coarse_joint.hpp"
#include "joints/joint_statics.hpp"
#include "model/contact_state.hpp"
#include "model/model_of_blocks.hpp"

namespace voussoir {

template <int dim>
class CoarseJoints {
 public:
  /// Joints that can break at once and have fewer than six cells along them, as they are drawn. Those that bend are
  /// left out. The model must outlive it. Local.
  explicit CoarseJoints(const ModelOfBlocks<dim>&);

  /// One warning for each family of joints with cohesion or tension strength, of the joint whose strength may be
  /// overrated most; nothing of joints far from breaking. The same on every rank. Collective.
  /// @param when  stage and load factor, or time
  Warnings look(const ContactState&, const std::string& when) const;

 private:
  struct Candidate {
    int joint = 0;
    JointSection section;
    std::vector<int> points;
    std::vector<Vector<2>> place;                   ///< [m] of the points along the axes
    std::vector<std::array<Vector<2>, 2>> tangent;  ///< of the points, along the axes; in the plane the first alone
  };
  struct Found;
  void add(int joint, const std::vector<int>& points, const std::vector<FacetOfJoint<dim>>& facets);
  CoarseJoint look_at(const Candidate&, const ContactState&) const;
  std::vector<Found> found_here(const ContactState&) const;

  const ModelOfBlocks<dim>& model_;
  std::vector<Candidate> candidates_;
};

extern template class CoarseJoints<2>;
extern template class CoarseJoints<3>;

}  // namespace voussoir
