#include "run/space/space_blocks.hpp"

#include "model/space/space_model.hpp"
#include "range/checked_blocks.hpp"
#include "range/input_warnings.hpp"
#include "range/space/measures.hpp"
#include "results/mechanism_words.hpp"
#include "results/prediction.hpp"
#include "run/limit_run.hpp"
#include "run/rigid_limits.hpp"

namespace voussoir {
namespace {

class SpaceAppraisal final : public Appraisal {
 public:
  explicit SpaceAppraisal(const SpaceModel& model) : Appraisal(model), space_(model), theorem_(model) {}
  std::vector<RangeMeasure> measures() const override { return measures_in_space(space_); }
  Warnings of_weakening_joints(const ContactState&, const std::string& when) const override {
    if (!model_.weakens()) return {};
    return {{"cells_not_measured", "joints", when, 0,
             "joints lose their strength at once, where the stress of a point reaches it, and whether cells are short "
             "enough for the stress at the ends of joints is not measured in space; take half the cells' size and "
             "compare"}};
  }
  const LimitTheorem* theorem() const override { return &theorem_; }
  std::string words_of(const std::vector<double>& mechanism, bool dilates) const override {
    return mechanism_in_words(model_, mechanism) + of_slip_that_dilates(dilates);
  }

 private:
  const SpaceModel& space_;
  RigidTheorem<3> theorem_;
};

class SpaceBlocks final : public SceneBlocks {
 public:
  explicit SpaceBlocks(std::unique_ptr<BlockSource<3>> source) : source_(std::move(source)) {}
  BlockId count() const override { return source_->block_count(); }
  std::vector<std::string> report() const override { return source_->report(); }
  Warnings warnings(const Scene& scene) const override { return mesh_warnings(scene, *source_); }
  void predict(const Scene& scene, const Comm& comm, std::ostream& say) const override {
    voussoir::predict(scene, *source_, comm, say);
  }
  Modelled modelled(const Scene& scene, const Comm& comm) const override {
    auto model = std::make_unique<SpaceModel>(scene, *source_, comm);
    auto appraisal = std::make_unique<SpaceAppraisal>(*model);
    return {std::move(model), std::move(appraisal)};
  }
  RunSummary limit_analysis(const Scene& scene, const std::string& folder, const Comm& comm,
                            std::ostream& say) const override {
    return limit_run(scene, *source_, folder, comm, say);
  }

 private:
  std::unique_ptr<BlockSource<3>> source_;
};

}  // namespace

std::unique_ptr<SceneBlocks> space_blocks_of(const Scene& scene, const SceneBlocks::Comm& comm, Trust trust) {
  return std::make_unique<SpaceBlocks>(checked_blocks<3>(scene, comm, trust));
}

}  // namespace voussoir
