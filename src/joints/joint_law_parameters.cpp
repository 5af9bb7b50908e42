#include "joints/joint_law_parameters.hpp"

#include "base/parameter_section.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

/// How strength is lost.
void declare_softening(JointLawParameters& law, ParameterSection& section) {
  section.add("fracture energy", law.fracture_energy, "J/m2", at_least(0.0).usually(0.1, 1e4),
              "that parts the joint in opening: tension strength and cohesion fall with the largest opening there has "
              "been; 0: they are lost at once",
              "a crack takes energy", "Lime mortar takes 5 to 20.");
  section.add("shear fracture energy", law.shear_fracture_energy, "J/m2", at_least(0.0).usually(0.1, 1e4),
              "that parts the joint in shear, friction not counted: both strengths fall with the way slipped; 0: they "
              "are lost at once",
              "a crack takes energy", "Lime mortar takes 20 to 150.");
  section.add_choice<SofteningShape>(
      "softening", law.softening, {{"linear", SofteningShape::linear}, {"exponential", SofteningShape::exponential}},
      "how strength falls with opening or slip, from the same strength and with the same energy. Of cracks that could "
      "open side by side one runs on, as in a structure; where no such state is found a warning says unstable");
  const auto check_energy = [&](const char* name, double energy, const char* strength, double value) {
    section.check(energy == 0 || (value > 0 && value < JointLawParameters::infinity), name,
                  number_text(energy) + " J/m2",
                  std::string("needs a ") + strength + " that is positive and finite, which is " + number_text(value) +
                      " Pa (energy is what a strength takes on the way to nothing)",
                  std::string("Give the ") + strength + ", or leave the energy out");
    // A crack of mortar is through after a tenth of a millimetre or some millimetres.
    constexpr double widest = 1;  // [m]
    const double way = value > 0 && value < JointLawParameters::infinity ? energy / value : 0;
    section.expect(way <= widest, name, number_text(energy) + " J/m2",
                   std::string("parts the joint at ") + strength + " = " + number_text(value) + " Pa only after " +
                       six_digits(way) + " m, energy over strength",
                   std::string("is the ") + strength + " given in Pa? Mortar parts after 0.1 to 5 mm");
  };
  check_energy("fracture energy", law.fracture_energy, "tension strength", law.tension_strength);
  check_energy("shear fracture energy", law.shear_fracture_energy, "cohesion", law.cohesion);
}

/// Joints as springs.
void declare_mortar(JointLawParameters& law, ParameterSection& section) {
  section.add("normal stiffness", law.normal_stiffness, "Pa/m", above(0.0).or_infinite().usually(1e7, 1e13),
              "pressure per shortening of the mortar, Young's modulus by thickness; inf: no mortar",
              "mortar without stiffness carries nothing", "10 mm of lime mortar have 1e11 to 4e11.");
  section.add("tangential stiffness", law.tangential_stiffness, "Pa/m", above(0.0).or_infinite().usually(1e7, 1e13),
              "shear per distortion of the mortar, shear modulus by thickness; inf: no mortar",
              "mortar without stiffness carries nothing", "10 mm of lime mortar have 0.4e11 to 1.6e11.");
  const auto too_stiff = [](double k) { return k > JointLawParameters::stiffest && k < JointLawParameters::infinity; };
  const std::string why =
      "must be <= " + number_text(JointLawParameters::stiffest) + " or inf (that is a millimetre of stone)";
  const auto check = [&](const char* name, double value) {
    section.check(!too_stiff(value), name, number_text(value) + " Pa/m", why, "Leave it out");
    constexpr double softest = 1e-130;  // squares of what yields more are beyond the numbers a computer holds
    section.check(value >= softest, name, number_text(value) + " Pa/m",
                  "must be >= " + number_text(softest) + " (mortar without stiffness carries nothing)",
                  "Give it in Pa/m");
  };
  check("normal stiffness", law.normal_stiffness);
  check("tangential stiffness", law.tangential_stiffness);
}

}  // namespace

void JointLawParameters::declare(ParameterSection& section) {
  const std::string set_advice = "Give \"all\" or a set of the mesh.";
  section.add("between", between, "set of blocks on one side; a later family of joints goes before an earlier one",
              Presence::optional, set_advice);
  section.add("and", and_, "set of blocks on the other side", Presence::optional, set_advice);
  section.add("friction coefficient", friction_coefficient, "-", at_least(0.0).or_infinite().usually(0.001, 2),
              "Coulomb's coefficient; inf forbids slip", "a negative coefficient would create energy in sliding",
              "Give mu = tan(friction angle); dry stone is 0.5 to 0.8.");
  section.add("cohesion", cohesion, "Pa", at_least(0.0).or_infinite().usually(100, 1e9),
              "shear strength without compression, lost for good as a point opens or slips", "a strength",
              "Dry joints have 0, lime mortar 0.05e6 to 0.3e6.");
  section.add("tension strength", tension_strength, "Pa", at_least(0.0).or_infinite().usually(100, 1e9),
              "tension a joint bears, lost for good as a point opens or slips", "a strength",
              "Dry joints have 0, lime mortar 0.02e6 to 0.2e6.");
  declare_softening(*this, section);
  declare_mortar(*this, section);
  section.add(
      "initial gap", initial_gap, "m", at_least(0.0).usually(1e-7, 0.2),
      "opening of these joints at the start; the mesh shows them closed. What stands open is not bonded: its cohesion "
      "and tension strength count for nothing",
      "blocks do not lie in each other", "Give 0 for blocks that touch.");
}

}  // namespace voussoir
