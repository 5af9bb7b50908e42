// Files that tell ParaView and other viewers how to read fields.h5.
//
// Format: https://www.xdmf.org/index.php/XDMF_Model_and_Format, version 3. Each holds one thing, since readers take one
// grid from a file: stones over all steps (cells with displacement, stress, block, rank), stones at the last step, and
// contact points over all steps (with gap, slip, forces, status, selected).
#pragma once

#include <string>
#include <vector>

namespace voussoir {

struct XdmfContent {
  struct Step {
    std::string group;  ///< "/steps/0007"
    double time = 0.0;
    bool moving = false;  ///< it has a velocity
  };
  std::string fields;  ///< name of the HDF5 file, seen from the folder of the XDMF file
  int dim = 2;
  long long nodes = 0;
  long long cells = 0;
  int corners = 3;       ///< columns of /mesh/cells
  long long mixed = 0;   ///< numbers in /mesh/mixed_cells; 0 where all cells have as many corners
  bool damage = false;   ///< points have a damage
  long long points = 0;  ///< contact points; without any there is no file of them
  std::vector<Step> steps;
};

/// Table of cells of different kinds: for each the number of its kind in XDMF, then its nodes.
constexpr const char* mixed_cells = "/mesh/mixed_cells";
long long xdmf_kind_of_solid(int corners);

/// Their names.
constexpr const char *xdmf_of_steps = "fields.xdmf", *xdmf_of_last_step = "stones.xdmf",
                     *xdmf_of_joints = "joints.xdmf";

enum class XdmfOf { stones, last_stones, joints };

/// A whole file.
std::string xdmf_text(const XdmfContent&, XdmfOf);

/// Name of the view of a table of vectors that viewers need: "displacement" -> "displacement_xyz" in 2D.
std::string vectors_for_viewers(const std::string& table, int dim);

}  // namespace voussoir
