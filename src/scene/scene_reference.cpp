// The documented reference: a bridge with one load of every type.
#include "scene/scene_printer.hpp"
#include "scene/scene_sections.hpp"
#include "scene/xml_printer.hpp"

namespace voussoir {
namespace {

Scene example() {
  Scene scene;
  scene.title = "Every parameter of a scene, shown on Clare College Bridge";
  scene.mesh.gmsh.file = "clare-college-bridge.geo";
  scene.mesh.gmsh.geometry = {{"deformed", 0.0}};
  scene.model.thickness = 0.2;
  scene.materials = {{"stone", {}}};
  scene.joints = {{"dry", {}}};
  for (const char* part : {"abutment west", "pier west", "pier east", "abutment east"}) {
    SupportParameters support;
    support.on = std::string("foundation ") + part;
    scene.supports.push_back({part, support});
  }
  const auto load = [&scene](const char* name, LoadType type) -> LoadParameters& {
    scene.loads.emplace_back();
    scene.loads.back().name = name;
    scene.loads.back().type = type;
    return scene.loads.back();
  };
  load("weight", LoadType::self_weight);
  load("earthquake", LoadType::acceleration).acceleration.ax = 0.981;
  TractionParameters& crowd = load("crowd", LoadType::traction).traction;
  crowd.on = "deck central";
  crowd.pressure = 5e3;
  SettlementParameters& scour = load("scour", LoadType::settlement).settlement;
  scour.support = "pier west";
  scour.uy = -0.01;
  scene.stages = {{"own weight", 1, {{"weight", 1.0}}},
                  {"crowd", 2, {{"crowd", 1.0}}},
                  {"scour and shaking", 4, {{"scour", 1.0}, {"earthquake", 1.0}}}};
  return scene;
}

}  // namespace

void print_reference(std::ostream& os) {
  DefaultsCollector collector;
  Scene empty;
  declare(empty, collector);
  XmlPrinter printer(os, collector.defaults);
  os << "<!-- Every parameter of a scene, as the program declares it; made by: voussoir with the option "
        "print-parameters.\n"
        "     A comment gives [unit] range, default: meaning. All units are SI. Whatever has a default may be left "
        "out.\n"
        "     Numbers of type double may be written as int, and inf where the range says so.\n"
        "     A key can be set on the command line by its path: selection/mode=all -->\n"
        "<ParameterList name=\"reference\">\n";
  Scene scene = example();
  declare(scene, printer);
  os << "</ParameterList>\n";
}

}  // namespace voussoir
