// What a run of the plane tells of its structure: whether steps are in range, rigid limit analysis, joints.csv and
// hinges, mechanisms in the words of masonry.
#pragma once

#include "model/plane/plane_model.hpp"
#include "run/appraisal.hpp"
#include "run/rigid_limits.hpp"

namespace voussoir {

class PlaneAppraisal : public Appraisal {
 public:
  explicit PlaneAppraisal(const PlaneModel& model) : Appraisal(model), plane_(model), theorem_(model) {}

  std::vector<RangeMeasure> measures() const override;
  Warnings of_weakening_joints(const ContactState&, const std::string& when) const override;
  const LimitTheorem* theorem() const override { return &theorem_; }
  std::string words_of(const std::vector<double>& mechanism, bool dilates) const override;
  StaticsSummary statics(const AdaptiveStep&, const ContactState&, const std::vector<double>& load,
                         const std::string& folder) const override;

 private:
  const PlaneModel& plane_;
  RigidTheorem<2> theorem_;
};

}  // namespace voussoir
