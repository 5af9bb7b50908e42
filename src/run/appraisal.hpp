// What a run tells of its structure beside its steps. As it stands here it knows no geometry: it tells what moves most
// and what supports bear. What joints, stones and ranges of the model tell is added where blocks are known
// (run/scene_blocks).
#pragma once

#include <string>
#include <vector>

#include "base/warning.hpp"
#include "output/result_json.hpp"
#include "range/range_check.hpp"
#include "run/limit_theorem.hpp"
#include "step/adaptive_step.hpp"

namespace voussoir {

class Appraisal {
 public:
  /// The model must outlive it.
  explicit Appraisal(const Model& model) : model_(model) {}
  virtual ~Appraisal() = default;

  /// By which RangeCheck looks at steps.
  virtual std::vector<RangeMeasure> measures() const { return {}; }
  /// What a step leaves open of joints that lose their strength. Collective.
  virtual Warnings of_weakening_joints(const ContactState&, const std::string&) const { return {}; }
  /// None where nothing knows the structure as rigid stones.
  virtual const LimitTheorem* theorem() const { return nullptr; }
  /// The motion a collapse begins with, for the end of a sentence: "2 of 5 blocks move, block 3 most, ...". Collective.
  /// @param dilates  it is one of limit analysis in which what slides must lift
  virtual std::string words_of(const std::vector<double>& mechanism, bool dilates) const;
  /// What joints and supports carry in an equilibrium. Collective; throws ResourceError on all ranks.
  /// @param load    [N] nodal loads of the state
  /// @param folder  for tables
  virtual StaticsSummary statics(const AdaptiveStep&, const ContactState&, const std::vector<double>& load,
                                 const std::string& folder) const;

 protected:
  const Model& model_;
};

}  // namespace voussoir
