#include "simulation/input_warnings.hpp"

namespace voussoir {
namespace {

void warn_of_no_joints(const Model<2>& model, Warnings& all) {
  const auto& scene = model.scene();
  if (model.points().total() > 0 || scene.joints.empty()) return;
  const auto blocks = std::to_string(model.source().block_count());
  all.push_back({"no_joints", scene.file + ": scene > joints", "", static_cast<double>(model.source().block_count()),
                 "the scene has laws for joints and the mesh has none: nothing can open or slip between its " + blocks +
                     (blocks == "1" ? " block" : " blocks") +
                     "; draw every stone as a surface of its own, stones that touch sharing the curve between them"});
}

}  // namespace

Warnings input_warnings(const Model<2>& model) {
  Warnings all;
  warn_of_no_joints(model, all);
  return all;
}

}  // namespace voussoir
