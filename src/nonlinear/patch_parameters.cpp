#include "nonlinear/patch_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void PatchParameters::declare(ParameterSection& section) {
  section.add("used", used,
              "stones that keep a load step from closing are brought to rest alone. Reason: nonlinear elimination: "
              "Lanzkron, Rose, Wilkes (1996)");
  section.add("loose stones", loose_stones,
              "stones of patches that slide on all they touch are moved to where a point holds them. Reason: no "
              "linear system tells how far they go");
  section.add("trigger", trigger, "-", above(0.0),
              "share of the best residual above which a solve has left stuck stones. Reason: with the right statuses "
              "a solve leaves a hundredth");
  section.add("block threshold", block_threshold, "-", above(0.0),
              std::string("share of the residual beyond which a stone is stuck. ") + no_reason);
  section.add("aim of residual", aim_of_residual, "-", above(0.0),
              std::string("share of the residual that a patch is solved to. ") + no_reason);
  section.add("aim of tolerance", aim_of_tolerance, "-", above(0.0),
              std::string("share of the tolerance that a patch is solved to at most. ") + no_reason);
  section.add("bearable rise", bearable_rise, "-", above(0.0),
              "times the residual that patches may raise it to. Reason: the stones beside them have to follow");
  section.add("largest share", largest_share, "-", above(0.0),
              "of all unknowns that patches may have together. Reason: their direct solutions then cost as much as "
              "two or three linear solves of the whole");
  section.add("largest share of all", largest_share_of_all, "-", at_least(0.0),
              "of all unknowns that may be parted to be one patch; 0: never. Reason: half of the above");
  section.add("more rings", more_rings, "-", between(0, 1000),
              std::string("rings of neighbours that a patch which passes on too much may gain. ") + no_reason);
  section.add("active solves", active_solves, "-", between(1, 1e6),
              "solves of active sets in a patch. Reason: those of W(512) and W(640) that arrive take up to 157");
  section.add("active aim", active_aim, "-", above(0.0),
              "share of the tolerance that they aim at. Reason: a stone out of balance by the rest flies in the next "
              "solve of the whole");
  section.add("patience", patience, "-", between(1, 1e6),
              "solves without a gain in a patch without border. Reason: it is all that has parted, and large");
  section.add("patience with border", patience_with_border, "-", between(1, 1e6),
              "the same in other patches. Reason: those that labour are too narrow: the push of W(64) takes 224 "
              "solves for 314");
  section.add("largest path", largest_path, "-", between(1, 1e6),
              "steps of the path in a patch. Reason: those of W(256) that arrive took up to 142; 80 were too few");
  section.add("held share", held_share, "-", above(0.0),
              "share of its stiffness that moving a stone as a whole takes where it is held. Reason: round-off is "
              "less");
  section.add("parallel", parallel, "-", above(0.0),
              "beds are parallel, and a stone comes nearer to another, up to and beyond this. Reason: round-off");
}

}  // namespace voussoir
