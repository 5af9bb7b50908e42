#include "nonlinear/patch_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void PatchParameters::declare(ParameterSection& section) {
  section.add("used", used,
              "stones that keep a load step from closing are brought to rest alone. Reason: nonlinear elimination: "
              "Lanzkron, Rose, Wilkes (1996)");
  section.add("trigger", trigger, "-", above(0.0),
              "share of the best residual above which a solve has left stuck stones. Reason: with the right statuses "
              "a solve leaves a hundredth");
  section.add("block threshold", block_threshold, "-", above(0.0),
              "share of the residual beyond which a stone is stuck, and share of its tolerance that a patch aims at. "
              "Reason: with the right statuses a solve leaves a hundredth");
  section.add("aim", aim, "-", above(0.0),
              "share of the residual that a patch is solved to. Reason: the stones around it are farther from rest");
  section.add("largest share", largest_share, "-", above(0.0),
              "of all unknowns that patches may have together; half of it, that all that has parted may have to be one "
              "patch. Reason: their direct solutions then cost as much as two or three linear solves of the whole");
  section.add("more rings", more_rings, "-", between(0, 1000),
              "rings of neighbours that a patch which passes on too much may gain. Reason: each doubles a small patch");
  section.add("most solves", most_solves, "-", between(1, 1e6),
              "linear solves of active sets in a patch, and steps of the path. Reason: those of walls of 512 courses "
              "that arrive take up to 157, paths up to 142");
  section.add("patience", patience, "-", between(1, 1e6),
              "solves without a gain in a patch without border. Reason: it is all that has parted, and large");
}

}  // namespace voussoir
