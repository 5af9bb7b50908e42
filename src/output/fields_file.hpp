// fields.h5: the structure and its state at every written load step, and files beside it for viewers.
// The layout (names, shapes, units) is the table "fields.h5" in src/output/README.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include "base/ids.hpp"
#include "output/hdf5_file.hpp"
#include "output/xdmf.hpp"

namespace voussoir {

/// This rank's share of the undeformed structure. Numbers are global and strictly ascending; any share may be empty.
struct MeshRows {
  std::vector<NodeId> node;
  std::vector<double> coordinates;  ///< [m] nodes x dim
  std::vector<int> block_of_node;
  std::vector<int> held;  ///< per node: which components of its motion supports hold, the sum of 1 (x), 2 (y), 4 (z)

  std::vector<long long> cell;
  std::vector<int> corner_count;  ///< per cell: 3 or 4 in 2D, 4 or 8 in 3D
  std::vector<NodeId> corners;    ///< corner_count[0] nodes of the first cell, then the next; counter-clockwise
  std::vector<int> block_of_cell;
  /// Per cell: numbers before its own in a list that holds for every cell a kind and its corners; where cells have
  /// different numbers of corners in 3D.
  std::vector<long long> place_of_cell;

  std::vector<long long> block;              ///< owned blocks
  std::vector<int> block_set;                ///< per owned block: the first set it is in, -1 for none
  int sets_of_a_block = 0;                   ///< how many sets a block is in at most; the same on every rank
  std::vector<int> block_sets;               ///< owned blocks x that number: all sets of a block, -1 for no more
  std::vector<std::string> block_set_names;  ///< on the first rank
};

/// This rank's share of the candidate contact points.
struct JointRows {
  std::vector<PointId> point;
  std::vector<double> position;  ///< [m] points x dim
  std::vector<double> normal;    ///< [-] points x dim, unit, from block i to block j
  std::vector<double> area;      ///< [m2]
  std::vector<int> block_i, block_j;
  std::vector<NodeId> main_of_i, main_of_j;  ///< of the nodes on either side the one that counts most
};

/// Loads as they act at the end of a step. All but `row`, `load_of`, `node` and `force` are the same on every rank.
struct LoadRows {
  std::vector<std::string> name, type;
  std::vector<double> factor;  ///< per load: that of its stage times its function of time
  std::vector<int> of_stones;  ///< per load: 1 when it acts on all of stones; then it has no rows
  std::vector<double> total;   ///< [N] loads x dim
  /// Forces on nodes of this rank; rows ascend.
  std::vector<long long> row;
  std::vector<int> load_of;
  std::vector<NodeId> node;
  std::vector<double> force;  ///< [N] rows x dim
};

/// State at the end of a load step; rows in the order of the MeshRows and JointRows written before.
struct StepRows {
  int number = 0;
  std::string stage;
  double load_factor = 0.0;
  std::optional<double> time;  ///< [s] of a time step; load steps have none, and viewers show their number instead

  std::vector<double> displacement;      ///< [m] nodes x dim
  std::vector<double> velocity;          ///< [m/s] nodes x dim, where there is a time
  std::vector<double> stress;            ///< [Pa] cells x 3: xx, yy, xy (3D: x 6: xx, xy, xz, yy, yz, zz); tension > 0
  std::vector<double> gap;               ///< [m] > 0 open
  std::vector<double> slip;              ///< [m]
  std::vector<double> normal_force;      ///< [N] compression > 0
  std::vector<double> tangential_force;  ///< [N]
  std::vector<double> force;             ///< [N] points x 3 in space: of block i on block j; none in the plane
  std::vector<int> status;               ///< 0 open, 1 stick, 2 slip, 3 bonded
  std::vector<int> selected;             ///< 1 treated as contact, 0 not
  /// [-] share of its strength that a point has lost; of runs in which joints have strength to lose, on all ranks
  std::optional<std::vector<double>> damage;
  LoadRows loads;
};

/// Cuts fields.h5 behind its first `steps` steps. A file that a kill left unreadable is put aside as fields.damaged.h5.
/// Collective; throws ResourceError on all ranks when the file cannot be written.
/// @return whether the steps are there; else the fields begin anew
bool cut_fields(const std::string& path, int steps, const Teuchos::Comm<int>&);

/// Writes in the order mesh, joints, steps. Every function is collective and throws ResourceError on all ranks.
class FieldsFile {
 public:
  /// @param path   "out/wall/fields.h5"; fields.xdmf, joints.xdmf and stones.xdmf go beside it
  /// @param steps  steps to keep of the file that is there; 0 begins it anew. Mesh and joints are kept with them
  FieldsFile(const std::string& path, Teuchos::RCP<const Teuchos::Comm<int>> comm, int dim, int steps = 0);

  void write_mesh(const MeshRows&);
  void write_joints(const JointRows&);
  /// On return the step is on disk: a run that is killed later leaves it readable.
  void write_step(const StepRows&);

 private:
  struct Rows {  ///< what a step needs to know of the tables before it
    std::vector<long long> ids;
    long long total = 0;
  };
  /// A step that is in the file, for viewers.
  void list(const std::string& group, double time, bool moving) { xdmf_.steps.push_back({group, time, moving}); }
  Rows counted(const std::vector<long long>& ids) const;
  template <class T>
  void write(const std::string& path, const Rows&, const std::vector<T>& values, int columns, const std::string& unit,
             const std::string& text = "");
  void write_mixed_cells(const MeshRows&);
  void write_loads(const std::string& group, const LoadRows&);
  /// The files for viewers, as far as steps are written.
  void tell_viewers() const;
  /// A vector field, with a view of three components beside it in 2D.
  void write_vectors(const std::string& path, const Rows&, const std::vector<double>& values, const std::string& unit);

  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  int dim_;
  Hdf5File file_;
  std::string folder_;  ///< of the files for viewers
  XdmfContent xdmf_;
  Rows nodes_, cells_, points_;
};

}  // namespace voussoir
