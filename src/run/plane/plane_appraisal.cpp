#include "run/plane/plane_appraisal.hpp"

#include "range/plane/coarse_joints.hpp"
#include "range/plane/measures.hpp"
#include "results/mechanism_words.hpp"
#include "results/plane/masonry_statics.hpp"

namespace voussoir {

std::vector<RangeMeasure> PlaneAppraisal::measures() const { return measures_in_plane(plane_); }

Warnings PlaneAppraisal::of_weakening_joints(const ContactState& state, const std::string& when) const {
  return coarse_joints(plane_, state, when);
}

std::string PlaneAppraisal::words_of(const std::vector<double>& mechanism, bool dilates) const {
  return mechanism_in_words(plane_, mechanism) + of_slip_that_dilates(dilates);
}

StaticsSummary PlaneAppraisal::statics(const AdaptiveStep& step, const ContactState& state,
                                       const std::vector<double>& load, const std::string& folder) const {
  return write_statics(plane_, step, state, load, folder);
}

}  // namespace voussoir
