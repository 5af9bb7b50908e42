// A structure built in a test and asked one question: does it stand under these loads?
#pragma once

#include <Tpetra_Core.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/plane/plane_model.hpp"
#include "scene/scene.hpp"
#include "step/adaptive_step.hpp"

namespace voussoir::test {

/// One material, one joint law; tests change what they study.
inline Scene plain_scene(double young_modulus, double density, double friction) {
  Scene scene;
  scene.file = scene.name = "test";
  MaterialParameters stone;
  stone.young_modulus = young_modulus;
  stone.density = density;
  scene.materials.push_back({"stone", stone});
  JointLawParameters joint;
  joint.friction_coefficient = friction;
  scene.joints.push_back({"dry", joint});
  return scene;
}

inline void add_support(Scene& scene, const std::string& facets, const std::string& components = "xy") {
  SupportParameters support;
  support.on = facets;
  support.components = components;
  scene.supports.push_back({facets, support});
}

/// Inertia force density x volume x (ax, ay) [m/s2]; gravity is (0, -9.81).
inline void add_acceleration(Scene& scene, const std::string& name, double ax, double ay) {
  LoadParameters load;
  load.name = name;
  auto& acceleration = load.kind.emplace<AccelerationParameters>();
  acceleration.ax = ax;
  acceleration.ay = ay;
  scene.loads.push_back(load);
}

/// Scene, blocks, model and state together; each step starts where the last one ended.
class StaticCase {
 public:
  StaticCase(const Scene& scene, std::unique_ptr<BlockSource<2>> source)
      : scene_(scene), source_(std::move(source)), model_(scene_, *source_, Tpetra::getDefaultComm()), step_(model_) {
    state_ = step_.initial_state();
  }
  StaticCase(const StaticCase&) = delete;
  StaticCase& operator=(const StaticCase&) = delete;

  /// One load step to these load factors.
  const StepReport& step(const std::map<std::string, double>& factors) {
    std::vector<double> load, prescribed;
    model_.loads(factors, 0.0, load, prescribed);
    report_ = advance(step_, state_, {load, prescribed});
    return report_;
  }

  const PlaneModel& model() const { return model_; }
  AdaptiveStep& solver() { return step_; }
  const ContactState& state() const { return state_; }
  const StepReport& report() const { return report_; }

 private:
  Scene scene_;
  std::unique_ptr<BlockSource<2>> source_;
  PlaneModel model_;
  AdaptiveStep step_;
  ContactState state_;
  StepReport report_;
};

inline std::string in_words(NewtonOutcome outcome) {
  if (outcome == NewtonOutcome::converged) return "equilibrium";
  return outcome == NewtonOutcome::collapse ? "collapse" : "not converged";
}

}  // namespace voussoir::test
