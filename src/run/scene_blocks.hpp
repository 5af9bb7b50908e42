// The blocks of a scene, checked before anything is computed, in the dimension they are of: what is made of them.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "mesh/geo_commands.hpp"
#include "model/model.hpp"
#include "run/appraisal.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Functions are collective, and given the scene and the ranks the blocks were made of.
class SceneBlocks {
 public:
  using Comm = Teuchos::RCP<const Teuchos::Comm<int>>;
  struct Modelled {
    std::unique_ptr<Model> model;
    std::unique_ptr<Appraisal> appraisal;
  };

  virtual ~SceneBlocks() = default;
  virtual BlockId count() const = 0;
  /// What was found and made of what the mesh was given, line by line.
  virtual std::vector<std::string> report() const = 0;
  /// Of it, as SVG on the first rank; "" where there is none.
  virtual std::string picture() const = 0;
  /// What scene and mesh leave open. Collective.
  virtual Warnings warnings(const Scene&, const Comm&) const = 0;
  /// Makes all loads where they act, and forgets them: InputError where one cannot be.
  virtual void place_loads(const Scene&, const Comm&) const = 0;
  /// What a run would cost.
  virtual void predict(const Scene&, const Comm&, std::ostream& say) const = 0;
  /// The blocks must outlive the model.
  virtual Modelled modelled(const Scene&, const Comm&) const = 0;
  /// A run that asks rigid limit analysis alone, of whose results the last is result.json. Throws InputError where
  /// there is none.
  virtual RunSummary limit_analysis(const Scene&, const std::string& folder, const Comm&, std::ostream& say) const = 0;
};

/// Messages name the scene. Collective; throws InputError on every rank alike.
std::unique_ptr<SceneBlocks> blocks_of(const Scene&, const SceneBlocks::Comm&, Trust);

}  // namespace voussoir
