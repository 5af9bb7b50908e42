// The documented reference: a bridge with one load of every type.
#include "scene/scene_printer.hpp"
#include "scene/scene_sections.hpp"
#include "scene/xml_printer.hpp"

namespace voussoir {
namespace {

/// A load of every type.
void add_loads(Scene& scene) {
  using Time = TimeFunctionType;
  const auto load = [&scene](const char* name, auto kind, Time time = Time::constant) {
    LoadParameters p;
    p.name = name;
    p.kind = kind;
    p.time_function.type = time;
    scene.loads.push_back(p);
  };
  load("weight", SelfWeightParameters{});
  AccelerationParameters tilt;
  tilt.ax = 0.981;
  load("tilt", tilt);
  TractionParameters wind;
  wind.on = "deck central";
  wind.tx = 500;
  load("wind", wind, Time::sine);
  SettlementParameters scour;
  scour.support = "pier west";
  scour.uy = -0.01;
  load("scour", scour, Time::ramp);
  PointLoadParameters statue;
  statue.fy = -20e3;
  load("statue", statue);
  CrowdParameters crowd;
  crowd.on = "deck central";
  crowd.x_from = 0;
  crowd.x_to = 5;
  load("crowd", crowd, Time::table);
  scene.loads.back().time_function.times = "0, 60";
  scene.loads.back().time_function.values = "0, 1";
  GroundMotionParameters earthquake;
  earthquake.record_x = "records/synthetic-quake.csv";
  earthquake.ax = 2;
  load("earthquake", earthquake, Time::sine_sweep);
  MovingTrainParameters cart;
  cart.on = "deck central";
  cart.axle_loads = "10e3, 15e3";
  cart.spacings = "2.5";
  cart.speed = 2;
  load("cart", cart);
  EarthPressureParameters backfill;
  backfill.on = "back west";
  load("backfill", backfill);
  WaterPressureParameters flood;
  flood.on = "foundation pier west";
  load("flood", flood, Time::record);
  scene.loads.back().time_function.file = "records/flood.csv";
  load("lift", BuoyancyParameters{});
  TemperatureParameters summer;
  summer.change = 25;
  load("summer", summer, Time::pulse);
}

Scene example() {
  Scene scene;
  scene.title = "Every parameter of a scene, shown on Clare College Bridge";
  scene.mesh.gmsh.file = "clare-college-bridge.geo";
  scene.mesh.stones.file = "vault.obj";
  scene.mesh.gmsh.geometry = {{"deformed", 0.0}};
  scene.model.thickness = 0.2;
  scene.materials = {{"stone", {}}};
  scene.joints = {{"dry", {}}};
  for (const char* part : {"abutment west", "pier west", "pier east", "abutment east"}) {
    SupportParameters support;
    support.on = std::string("foundation ") + part;
    scene.supports.push_back({part, support});
  }
  add_loads(scene);
  scene.construction = {{"centring", {"ring west", "", "crowd"}}};
  scene.stages = {{"own weight", 1, {{"weight", 1.0}}},
                  {"crowd", 2, {{"crowd", 1.0}}},
                  {"scour and tilt", 4, {{"scour", 1.0}, {"tilt", 1.0}}}};
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
