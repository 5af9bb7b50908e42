#include "run/plane/plane_blocks.hpp"

#include "model/plane/plane_model.hpp"
#include "range/checked_blocks.hpp"
#include "range/input_warnings.hpp"
#include "results/prediction.hpp"
#include "run/limit_run.hpp"
#include "run/plane/plane_appraisal.hpp"

namespace voussoir {
namespace {

class PlaneBlocks final : public SceneBlocks {
 public:
  explicit PlaneBlocks(std::unique_ptr<BlockSource<2>> source) : source_(std::move(source)) {}
  BlockId count() const override { return source_->block_count(); }
  std::vector<std::string> report() const override { return source_->report(); }
  Warnings warnings(const Scene& scene) const override { return mesh_warnings(scene, *source_); }
  void predict(const Scene& scene, const Comm& comm, std::ostream& say) const override {
    voussoir::predict(scene, *source_, comm, say);
  }
  Modelled modelled(const Scene& scene, const Comm& comm) const override {
    auto model = std::make_unique<PlaneModel>(scene, *source_, comm);
    auto appraisal = std::make_unique<PlaneAppraisal>(*model);
    return {std::move(model), std::move(appraisal)};
  }
  RunSummary limit_analysis(const Scene& scene, const std::string& folder, const Comm& comm,
                            std::ostream& say) const override {
    return limit_run(scene, *source_, folder, comm, say);
  }

 private:
  std::unique_ptr<BlockSource<2>> source_;
};

}  // namespace

std::unique_ptr<SceneBlocks> plane_blocks_of(const Scene& scene, const SceneBlocks::Comm& comm, Trust trust) {
  return std::make_unique<PlaneBlocks>(checked_blocks<2>(scene, comm, trust));
}

}  // namespace voussoir
