#include "scene/scene_printer.hpp"

#include <iomanip>
#include <sstream>

#include "base/text.hpp"
#include "base/words.hpp"
#include "scene/scene_effects.hpp"
#include "scene/scene_sections.hpp"
#include "scene/scene_xml.hpp"
#include "scene/xml_printer.hpp"

namespace voussoir {
namespace {

/// Values of all internals by path.
Defaults internals_of(Internals internals) {
  DefaultsCollector collector;
  declare_internals(internals, collector);
  return collector.defaults;
}

/// Those that are not as usual.
Defaults changed_internals(const Scene& scene) {
  const auto usual = internals_of(Internals());
  auto changed = internals_of(scene.internals);
  for (auto it = changed.begin(); it != changed.end();)
    it = usual.at(it->first) == it->second ? changed.erase(it) : std::next(it);
  return changed;
}

/// Behind a comma; nothing of what goes without saying.
std::string words_of(StoneCells cells) {
  switch (cells) {
    case StoneCells::by_shape:
      return "";
    case StoneCells::tetrahedra:
      return ", tetrahedra";
    case StoneCells::triangles:
      return ", triangles";
    case StoneCells::quadratic_triangles:
      return ", quadratic triangles";
  }
  return "";
}

const char* words_of(UpAxis up) {
  switch (up) {
    case UpAxis::usual:
      return "";
    case UpAxis::x:
      return ", x up";
    case UpAxis::y:
      return ", y up";
    case UpAxis::z:
      return ", z up";
    case UpAxis::minus_y:
      return ", -y up";
  }
  return "";
}

std::string mesh_text(const MeshParameters& mesh) {
  if (const auto* masonry = mesh.masonry()) return masonry->words();
  if (mesh.type == MeshType::stones) {
    const StonesParameters& s = mesh.stones;
    std::string text = "stones of " + s.file + ", unit " + number_text(s.unit) + " m" + words_of(s.up) +
                       (s.element_size > 0 ? ", element size " + number_text(s.element_size) + " m" : "") +
                       words_of(s.cells) + (s.snap > 0 ? ", snap " + number_text(s.snap) + " m" : "");
    for (const auto& [name, value] : s.geometry) text += ", " + name + " = " + number_text(value);
    return text;
  }
  const GmshParameters& g = mesh.gmsh;
  std::string text = g.file + ", " + words_of(g.cells);
  if (g.element_size > 0) text += ", element size " + number_text(g.element_size) + " m";
  for (const auto& [name, value] : g.geometry) text += ", " + name + " = " + number_text(value);
  return text;
}

std::string model_text(const Scene& scene) {
  const auto& model = scene.model;
  if (scene.mesh.dimension() == 3)
    return std::string("space, ") +
           (model.hexahedra == Hexahedra::plain ? "plain hexahedra" : "hexahedra with incompatible modes") +
           (scene.mesh.type != MeshType::stones                 ? ""
            : scene.mesh.stones.element == StoneElement::linear ? ", linear tetrahedra"
                                                                : ", quadratic tetrahedra that are linear on joints");
  return std::string("plane ") + (model.plane == Plane::stress ? "stress" : "strain") + ", thickness " +
         number_text(model.thickness) + " m";
}

std::string stage_text(const StageParameters& stage) {
  std::string text = counted(stage.increments, "increment");
  if (stage.dynamic())
    text = number_text(stage.duration) + " s in " +
           (stage.time_step > 0 ? "time steps of " + number_text(stage.time_step) + " s" : "automatic time steps") +
           (stage.at_once ? ", loads at once" : "");
  const char* separator = " to ";
  for (const auto& [load, factor] : stage.factors) {
    text += separator + number_text(factor) + " x " + load;
    separator = ", ";
  }
  return text;
}

std::string load_factor_text(const LoadFactorParameters& p) {
  std::string text;
  for (const auto& [load, share] : p.pattern) text += (text.empty() ? "" : " + ") + number_text(share) + " x " + load;
  return text + " raised from " + number_text(p.first) + " until no equilibrium exists, at most to " +
         number_text(p.largest) + ", accuracy " + number_text(p.accuracy);
}

std::string selection_text(const SelectionParameters& s) {
  if (s.mode == SelectionMode::all) return "all contact points";
  if (s.mode == SelectionMode::bonded) return "none: all joints bonded";
  return "adaptive, error tolerance " + number_text(s.error_tolerance) + ", bulk " + number_text(s.bulk) +
         (s.whole_joints ? ", whole joints" : ", single points") + ", at most " + counted(s.largest_rounds, "round");
}

/// One paragraph for each method.
void print_internals(std::ostream& os, const Scene& scene) {
  const auto usual = internals_of(Internals());
  os << "  how steps are solved (* not as usual):";
  std::string method;
  std::size_t column = 0;
  for (const auto& [path, value] : internals_of(scene.internals)) {
    const auto words = split(path, " > ");  // internals, method, name
    std::string text = words[2] + ' ' + value + (usual.at(path) == value ? "" : "*");
    if (words[1] != method) {
      method = words[1];
      os << "\n    " << std::left << std::setw(22) << method;
      column = 26;
    } else if (column + text.size() > 116) {
      os << ",\n    " << std::string(22, ' ');
      column = 26;
    } else {
      os << ", ";
      column += 2;
    }
    os << text;
    column += text.size();
  }
  os << '\n';
}

std::string material_text(const MaterialParameters& m) {
  return in_quotes(m.blocks) + ": E " + number_text(m.young_modulus) + " Pa, nu " + number_text(m.poisson_ratio) +
         ", density " + number_text(m.density) + " kg/m3" +
         (m.thickness > 0 ? ", thickness " + number_text(m.thickness) + " m" : "");
}

std::string joint_text(const JointLawParameters& j) {
  std::string text = in_quotes(j.between) + " and " + in_quotes(j.and_) + ": mu " +
                     number_text(j.friction_coefficient) + ", cohesion " + number_text(j.cohesion) +
                     " Pa, tension strength " + number_text(j.tension_strength) + " Pa";
  if (j.fracture_energy > 0 || j.shear_fracture_energy > 0)
    text += ", fracture energies " + number_text(j.fracture_energy) + " and " + number_text(j.shear_fracture_energy) +
            " J/m2";
  if (j.has_mortar())
    text += ", stiffness " + number_text(j.normal_stiffness) + " and " + number_text(j.tangential_stiffness) + " Pa/m";
  return text;
}

std::string velocity_text(const InitialVelocityParameters& v) {
  return in_quotes(v.blocks) + ": (" + number_text(v.vx) + ", " + number_text(v.vy) +
         (v.vz == 0 ? "" : ", " + number_text(v.vz)) + ") m/s" +
         (v.turn.rotation == 0 ? "" : ", turning by " + number_text(v.turn.rotation) + " rad/s");
}

std::string construction_text(const ConstructionParameters& c) {
  return in_quotes(c.blocks) + (c.appears.empty() ? "" : " appears with " + in_quotes(c.appears)) +
         (c.disappears.empty() ? "" : ", disappears with " + in_quotes(c.disappears));
}

void print_remarks(std::ostream& os, const Scene& scene) {
  for (const auto& remark : scene.remarks) os << "  warning: " << remark.where << ": " << remark.text << ".\n";
}

}  // namespace

void print_internals_reference(std::ostream& os) {
  Internals internals;
  XmlPrinter printer(os, internals_of(internals));
  os << "<!-- Numbers and switches that decide how steps are solved, for studies of the program; made by: voussoir "
        "with\n"
        "     the option print-internals. A comment gives [unit] range, default: meaning and reason. -->\n"
        "<ParameterList name=\"internals\">\n";
  declare_internals(internals, printer);
  os << "</ParameterList>\n";
}

void print_scene(std::ostream& os, const Scene& scene, bool internals) {
  const auto row = [&os](const std::string& kind, const std::string& name, const std::string& text) {
    os << "  " << std::left << std::setw(11) << kind << std::setw(14) << name << ' ' << text << '\n';
  };
  os << scene.name << (scene.title.empty() ? "" : ": " + scene.title) << "  (" << scene.file << ")\n";
  row("mesh", "", mesh_text(scene.mesh));
  row("model", "", model_text(scene));
  for (const auto& [name, material] : scene.materials) row("material", name, material_text(material));
  for (const auto& [name, joint] : scene.joints) row("joints", name, joint_text(joint));
  for (const auto& [name, s] : scene.supports) row("support", name, in_quotes(s.on) + ": " + s.components + " held");
  for (const LoadParameters& load : scene.loads) row("load", load.name, load.summary());
  for (const auto& [name, velocity] : scene.velocities) row("velocity", name, velocity_text(velocity));
  for (const auto& [name, stones] : scene.construction) row("built", name, construction_text(stones));
  for (const StageParameters& stage : scene.stages) row("stage", stage.name, stage_text(stage));
  if (scene.load_factor.asked()) row("load factor", "", load_factor_text(scene.load_factor));
  row("selection", "", selection_text(scene.selection));
  row("newton", "",
      "tolerance " + number_text(scene.newton.tolerance) + ", at most " +
          counted(scene.newton.largest_iterations, "linear solve") + " per step, " +
          counted(scene.load_steps.largest_halvings, "halving") +
          (scene.load_steps.expect_collapse ? ", collapse expected" : ""));
  if (scene.load_steps.at_most > 0) row("at most", "", number_text(scene.load_steps.at_most) + " s of the clock");
  row("solver", "",
      scene.solver.method + ", for unsymmetric systems " + scene.solver.unsymmetric_method + ", at most " +
          counted(scene.solver.largest_iterations, "iteration"));
  for (const auto& [path, value] : changed_internals(scene))
    row("internals", "", path.substr(path.find(" > ") + 3) + " = " + value);
  print_effects(os, scene);
  if (internals) print_internals(os, scene);
  print_remarks(os, scene);
}

void write_scene(std::ostream& os, const Scene& scene) {
  Scene copy = scene;
  XmlPrinter printer(os);
  os << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ParameterList name=\"" << xml_escaped(scene.name) << "\">\n";
  declare(copy, printer);
  if (!changed_internals(scene).empty()) declare_internals(copy.internals, printer);
  os << "</ParameterList>\n";
}

}  // namespace voussoir
