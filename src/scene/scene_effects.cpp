#include "scene/scene_effects.hpp"

#include <iomanip>

#include "base/text.hpp"

namespace voussoir {
namespace {

/// Names of the members that have a property.
template <class Members, class Has>
std::string names_with(const Members& members, const Has& has) {
  std::vector<std::string> names;
  for (const auto& m : members)
    if (has(m)) names.push_back(m.name);
  return names.empty() ? "" : list_of(names);
}

}  // namespace

std::vector<Effect> effects_of(const Scene& scene) {
  std::vector<Effect> effects;
  for (const auto& word : load_words())
    effects.push_back({word, names_with(scene.loads, [&](const LoadParameters& p) { return p.word() == word; })});
  const auto joints = [&](const char* name, double JointLawParameters::*value) {
    effects.push_back({name, names_with(scene.joints, [&](const auto& j) { return j.parameters.*value > 0; })});
  };
  joints("friction", &JointLawParameters::friction_coefficient);
  joints("cohesion", &JointLawParameters::cohesion);
  joints("tension strength", &JointLawParameters::tension_strength);
  effects.push_back({"softening", names_with(scene.joints, [](const auto& joint) {
                       return joint.parameters.fracture_energy > 0 || joint.parameters.shear_fracture_energy > 0;
                     })});
  effects.push_back(
      {"joint stiffness", names_with(scene.joints, [](const auto& j) { return j.parameters.has_mortar(); })});
  const auto in_time = names_with(scene.stages, [](const StageParameters& stage) { return stage.dynamic(); });
  const bool damped = scene.time.mass_damping > 0 || scene.time.stiffness_damping > 0;
  effects.push_back({"inertia", in_time});
  effects.push_back({"damping", damped ? in_time : ""});
  effects.push_back(
      {"initial velocities", in_time.empty() ? "" : names_with(scene.velocities, [](const auto&) { return true; })});
  effects.push_back({"construction", names_with(scene.construction, [](const auto&) { return true; })});
  return effects;
}

void print_effects(std::ostream& os, const Scene& scene) {
  std::vector<std::string> absent;
  os << "effects in play\n";
  for (const auto& e : effects_of(scene)) {
    if (e.in_play())
      os << "  " << std::left << std::setw(18) << e.name << ' ' << e.by << '\n';
    else
      absent.push_back(e.name);
  }
  os << "effects absent";
  constexpr std::size_t most = 8;  // in a line, which then fits into 120 columns
  for (std::size_t k = 0; k < absent.size(); ++k) os << (k % most == 0 ? "\n  " : ", ") << absent[k];
  os << (absent.empty() ? ": none\n" : "\n");
}

}  // namespace voussoir
