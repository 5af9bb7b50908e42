#include "run/scene_blocks.hpp"

#include <type_traits>

#include "model/plane/plane_model.hpp"
#include "model/space/space_model.hpp"
#include "range/checked_blocks.hpp"
#include "range/coarse_joints.hpp"
#include "range/input_warnings.hpp"
#include "range/plane/measures.hpp"
#include "range/space/measures.hpp"
#include "results/masonry_statics.hpp"
#include "results/mechanism_words.hpp"
#include "results/prediction.hpp"
#include "run/limit_run.hpp"
#include "run/rigid_limits.hpp"

namespace voussoir {
namespace {

template <int dim>
using ModelIn = std::conditional_t<dim == 2, PlaneModel, SpaceModel>;

template <int dim>
class AppraisalOfBlocks final : public Appraisal {
 public:
  explicit AppraisalOfBlocks(const ModelIn<dim>& model)
      : Appraisal(model), blocks_(model), theorem_(model), coarse_(model) {}
  std::vector<RangeMeasure> measures() const override {
    if constexpr (dim == 2)
      return measures_in_plane(blocks_);
    else
      return measures_in_space(blocks_);
  }
  Warnings of_weakening_joints(const ContactState& state, const std::string& when) const override {
    return coarse_.look(state, when);
  }
  const LimitTheorem* theorem() const override { return &theorem_; }
  std::string words_of(const std::vector<double>& mechanism, bool dilates) const override {
    return mechanism_in_words(blocks_, mechanism) + of_slip_that_dilates(dilates);
  }
  StaticsSummary statics(const AdaptiveStep& step, const ContactState& state, const std::vector<double>& load,
                         const std::string& folder) const override {
    return write_statics(blocks_, step, state, load, folder);
  }

 private:
  const ModelIn<dim>& blocks_;
  RigidTheorem<dim> theorem_;
  CoarseJoints<dim> coarse_;
};

template <int dim>
class BlocksIn final : public SceneBlocks {
 public:
  explicit BlocksIn(std::unique_ptr<BlockSource<dim>> source) : source_(std::move(source)) {}
  BlockId count() const override { return source_->block_count(); }
  std::vector<std::string> report() const override { return source_->report(); }
  std::string picture() const override { return source_->picture(); }
  Warnings warnings(const Scene& scene, const Comm& comm) const override {
    return mesh_warnings(scene, *source_, *comm);
  }
  void place_loads(const Scene& scene, const Comm& comm) const override {
    voussoir::place_loads(scene, *source_, comm);
  }
  void predict(const Scene& scene, const Comm& comm, std::ostream& say) const override {
    voussoir::predict(scene, *source_, comm, say);
  }
  Modelled modelled(const Scene& scene, const Comm& comm) const override {
    auto model = std::make_unique<ModelIn<dim>>(scene, *source_, comm);
    auto appraisal = std::make_unique<AppraisalOfBlocks<dim>>(*model);
    return {std::move(model), std::move(appraisal)};
  }
  RunSummary limit_analysis(const Scene& scene, const std::string& folder, const Comm& comm,
                            std::ostream& say) const override {
    return limit_run(scene, *source_, folder, comm, say);
  }

 private:
  std::unique_ptr<BlockSource<dim>> source_;
};

template <int dim>
std::unique_ptr<SceneBlocks> blocks_in(const Scene& scene, const SceneBlocks::Comm& comm, Trust trust) {
  return std::make_unique<BlocksIn<dim>>(checked_blocks<dim>(scene, comm, trust));
}

}  // namespace

std::unique_ptr<SceneBlocks> blocks_of(const Scene& scene, const SceneBlocks::Comm& comm, Trust trust) {
  return scene.mesh.dimension() == 2 ? blocks_in<2>(scene, comm, trust) : blocks_in<3>(scene, comm, trust);
}

}  // namespace voussoir
