// Parts of the preconditioner of the block-level system.
#pragma once

namespace voussoir {

class ParameterSection;

struct PreconditionerParameters {
  bool homogenised = true;       ///< the bonded continuum, by MueLu
  bool rigid_blocks = true;      ///< rigid motions of the blocks, solved directly
  bool block_local = true;       ///< exact solves on single blocks
  bool released_region = true;   ///< where little has parted, direct solution there instead of the two before
  int factored_up_to = 2000000;  ///< unknowns of systems that are factored whole where Krylov's method labours
  void declare(ParameterSection&);
};

}  // namespace voussoir
