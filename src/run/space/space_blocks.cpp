#include "run/space/space_blocks.hpp"

#include "base/error.hpp"
#include "model/space/space_model.hpp"
#include "range/checked_blocks.hpp"
#include "range/input_warnings.hpp"
#include "range/space/measures.hpp"
#include "results/prediction.hpp"

namespace voussoir {
namespace {

class SpaceAppraisal final : public Appraisal {
 public:
  using Appraisal::Appraisal;
  std::vector<RangeMeasure> measures() const override { return measures_in_space(model_); }
  Warnings of_weakening_joints(const ContactState&, const std::string& when) const override {
    if (!model_.weakens()) return {};
    return {{"cells_not_measured", "joints", when, 0,
             "joints lose their strength at once, where the stress of a point reaches it, and whether cells are short "
             "enough for the stress at the ends of joints is not measured in space; take half the cells' size and "
             "compare"}};
  }
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
  RunSummary limit_analysis(const Scene& scene, const std::string&, const Comm&, std::ostream&) const override {
    throw InputError(
        scene.file +
        ": scene > mesh > type = \"wall in space\"\n  is of space, and --limit-analysis takes plane scenes "
        "alone so far.\n  Leave --limit-analysis out: the steps of the scene tell whether it stands.");
  }

 private:
  std::unique_ptr<BlockSource<3>> source_;
};

}  // namespace

std::unique_ptr<SceneBlocks> space_blocks_of(const Scene& scene, const SceneBlocks::Comm& comm, Trust trust) {
  return std::make_unique<SpaceBlocks>(checked_blocks<3>(scene, comm, trust));
}

}  // namespace voussoir
