// What a run leaves behind.
#pragma once

#include <string>

namespace voussoir {

class ParameterSection;

struct OutputParameters {
  bool fields = true;              ///< fields.h5, and fields.xdmf, stones.xdmf, joints.xdmf for viewers
  int every = 1;                   ///< write fields every so many load steps (the last one always)
  int checkpoint_every = 0;        ///< steps between two checkpoints, 0 = by time alone
  double checkpoint_seconds = 60;  ///< [s] of computing between two checkpoints, 0 = by steps alone
  bool checkpoint_at_end = true;   ///< the state in which a run ends stays, for further stages
  bool report = true;              ///< report.html, drawn by drivers/run
  void declare(ParameterSection&);
};

}  // namespace voussoir
