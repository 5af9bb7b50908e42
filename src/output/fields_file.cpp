#include "output/fields_file.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <utility>

#include <Teuchos_CommHelpers.hpp>

#include "base/check.hpp"
#include "base/error.hpp"
#include "linalg/agree.hpp"
#include "linalg/fail_together.hpp"
#include "linalg/reduce.hpp"
#include "output/safe_file.hpp"

namespace voussoir {
namespace {

/// "/steps/0007": four digits keep the groups in order up to 9999 steps; readers sort by number.
std::string step_group(int number) {
  char name[32];
  std::snprintf(name, sizeof name, "/steps/%04d", number);
  return name;
}

/// Cells of `width` corners: a cell with fewer repeats its last node.
std::vector<long long> padded_corners(const MeshRows& mesh, int width) {
  std::vector<long long> table;
  table.reserve(mesh.cell.size() * width);
  auto corner = mesh.corners.begin();
  for (const int count : mesh.corner_count) {
    table.insert(table.end(), corner, corner + count);
    table.insert(table.end(), width - count, corner[count - 1]);
    corner += count;
  }
  VOUSSOIR_ENSURE(corner == mesh.corners.end());
  return table;
}

/// 0, 1, 2, ...
std::vector<long long> first_numbers(std::size_t count) {
  std::vector<long long> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0LL);
  return numbers;
}

}  // namespace

bool cut_fields(const std::string& path, int steps, const Teuchos::Comm<int>& comm) {
  int kept = 0;
  on_first_rank(comm, [&] {
    const std::string beside = path + ".part";
    std::vector<std::string> paths{"/mesh", "/joints"};
    for (int k = 1; k <= steps; ++k) paths.push_back(step_group(k));
    std::error_code ignored;
    const auto space = std::filesystem::file_size(path, ignored);
    try {
      if (steps == 0 || ignored) return;
      copy_hdf5(path, beside, paths);
      kept = 1;
    } catch (const ResourceError& error) {
      // A full disk is no damage: nothing is put aside for want of space.
      std::filesystem::remove(beside, ignored);
      if (std::filesystem::space(std::filesystem::absolute(path).parent_path(), ignored).available < 2 * space) throw;
      const auto aside = std::filesystem::path(path).replace_extension(".damaged.h5");
      std::filesystem::rename(path, aside, ignored);
      return;
    }
    publish_file(beside, path);
  });
  Teuchos::broadcast(comm, 0, &kept);
  return kept == 1;
}

FieldsFile::FieldsFile(const std::string& path, Teuchos::RCP<const Teuchos::Comm<int>> comm, int dim, int steps)
    : comm_(std::move(comm)),
      dim_(dim),
      file_(path, comm_, steps > 0 ? Hdf5File::Mode::append : Hdf5File::Mode::create) {
  VOUSSOIR_EXPECT(dim == 2 || dim == 3);
  fail_together(*comm_, [&] {  // before the file is closed, which takes all ranks
    const std::filesystem::path fields(path);
    folder_ = fields.parent_path().string();
    xdmf_.fields = fields.filename().string();
    xdmf_.dim = dim;
    for (int k = 1; k <= steps; ++k) {
      const auto group = step_group(k);
      const bool timed = file_.has_attribute(group, "time_s");
      list(group, timed ? file_.read_attribute<double>(group, "time_s") : k, timed);
    }
  });
}

FieldsFile::Rows FieldsFile::counted(const std::vector<long long>& ids) const {
  return {ids, total_over_ranks(*comm_, static_cast<long long>(ids.size()))};
}

template <class T>
void FieldsFile::write(const std::string& path, const Rows& rows, const std::vector<T>& values, int columns,
                       const std::string& unit, const std::string& text) {
  if (!file_.has(path)) file_.write_rows(path, rows.ids, values, Table{rows.total, columns, unit, text});
}

void FieldsFile::write_vectors(const std::string& path, const Rows& rows, const std::vector<double>& values,
                               const std::string& unit) {
  write(path, rows, values, dim_, unit);
  const std::string view = vectors_for_viewers(path, dim_);
  if (dim_ < 3 && rows.total > 0 && !file_.has(view)) file_.write_padded_view(view, path, 3);
}

void FieldsFile::write_mesh(const MeshRows& mesh) {
  nodes_ = counted(mesh.node);
  write("/mesh/coordinates", nodes_, mesh.coordinates, dim_, "m");
  write("/mesh/block_of_node", nodes_, mesh.block_of_node, 1, "-");
  write("/mesh/held", nodes_, mesh.held, 1, "-", "what supports hold: the sum of 1 for x, 2 for y, 4 for z");

  int width = dim_ + 1;
  const auto& count = mesh.corner_count;
  if (!count.empty()) width = std::max(width, *std::max_element(count.begin(), count.end()));
  xdmf_.corners = largest_over_ranks(*comm_, width);
  cells_ = counted(mesh.cell);
  write("/mesh/cells", cells_, padded_corners(mesh, xdmf_.corners), xdmf_.corners, "-",
        "nodes of each cell; a cell with fewer corners repeats its last node");
  write_mixed_cells(mesh);
  write("/mesh/block_of_cell", cells_, mesh.block_of_cell, 1, "-");
  write("/mesh/rank_of_cell", cells_, std::vector<int>(mesh.cell.size(), comm_->getRank()), 1, "-");

  const Rows blocks = counted(mesh.block);
  write("/mesh/rank_of_block", blocks, std::vector<int>(mesh.block.size(), comm_->getRank()), 1, "-");
  write("/mesh/block_set", blocks, mesh.block_set, 1, "-", "the first set, an index into block_set_names, -1 for none");
  if (mesh.sets_of_a_block > 0)
    write("/mesh/block_sets", blocks, mesh.block_sets, mesh.sets_of_a_block, "-",
          "all sets of a block, indices into block_set_names, -1 for no more");
  if (!file_.has("/mesh/block_set_names")) file_.write_texts("/mesh/block_set_names", mesh.block_set_names);
  xdmf_.nodes = nodes_.total;
  xdmf_.cells = cells_.total;
}

/// Viewers take no cells that repeat a node for cells of another kind, so mixed kinds have a table of their own. In the
/// plane a quadrilateral whose last two corners are one is drawn as the triangle it is.
void FieldsFile::write_mixed_cells(const MeshRows& mesh) {
  int least = xdmf_.corners;
  for (const int count : mesh.corner_count) least = std::min(least, count);
  if (dim_ == 2 || least_over_ranks(*comm_, static_cast<long long>(least)) == xdmf_.corners) return;
  VOUSSOIR_EXPECT(mesh.place_of_cell.size() == mesh.cell.size());
  std::vector<long long> places, numbers;
  auto corner = mesh.corners.begin();
  for (std::size_t k = 0; k < mesh.cell.size(); ++k) {
    const int count = mesh.corner_count[k];
    numbers.push_back(xdmf_kind_of_solid(count));
    numbers.insert(numbers.end(), corner, corner + count);
    corner += count;
    for (int n = 0; n <= count; ++n) places.push_back(mesh.place_of_cell[k] + n);
  }
  const Rows rows = counted(places);
  write(mixed_cells, rows, numbers, 1, "-",
        "for viewers: of each cell its kind, 6 tetrahedron, 9 hexahedron, and its nodes");
  xdmf_.mixed = rows.total;
}

void FieldsFile::write_joints(const JointRows& joints) {
  points_ = counted(joints.point);
  write("/joints/point", points_, joints.point, 1, "-", "number of the contact point");
  write("/joints/position", points_, joints.position, dim_, "m");
  write_vectors("/joints/normal", points_, joints.normal, "-");
  write("/joints/area", points_, joints.area, 1, "m2");
  write("/joints/block_i", points_, joints.block_i, 1, "-");
  write("/joints/block_j", points_, joints.block_j, 1, "-");
  write("/joints/node_i", points_, joints.main_of_i, 1, "-");
  write("/joints/node_j", points_, joints.main_of_j, 1, "-");
  xdmf_.points = points_.total;
  file_.flush();
}

void FieldsFile::write_step(const StepRows& step) {
  VOUSSOIR_EXPECT(nodes_.total > 0);
  const std::string group = step_group(step.number);
  file_.write_attribute(group, "step", static_cast<long long>(step.number));
  file_.write_attribute(group, "stage", step.stage);
  file_.write_attribute(group, "load_factor", step.load_factor);
  if (step.time) file_.write_attribute(group, "time_s", *step.time);

  write_vectors(group + "/displacement", nodes_, step.displacement, "m");
  if (step.time) write_vectors(group + "/velocity", nodes_, step.velocity, "m/s");
  write(group + "/stress", cells_, step.stress, dim_ == 2 ? 3 : 6, "Pa",
        dim_ == 2 ? "xx, yy, xy; tension > 0" : "xx, xy, xz, yy, yz, zz; tension > 0");
  write(group + "/joint_gap_m", points_, step.gap, 1, "m", "> 0 open");
  write(group + "/joint_slip_m", points_, step.slip, 1, "m");
  write(group + "/joint_normal_force_N", points_, step.normal_force, 1, "N", "compression > 0");
  write(group + "/joint_tangential_force_N", points_, step.tangential_force, 1, "N");
  if (dim_ == 3) write_vectors(group + "/joint_force_N", points_, step.force, "N");
  write(group + "/joint_status", points_, step.status, 1, "-", "0 open, 1 stick, 2 slip, 3 bonded");
  if (step.damage) write(group + "/joint_damage", points_, *step.damage, 1, "-", "0 sound, 1 all strength is lost");
  xdmf_.damage = step.damage.has_value();
  write(group + "/joint_selected", points_, step.selected, 1, "-", "1 treated as contact, 0 not");
  write_loads(group, step.loads);
  file_.flush();

  list(group, step.time.value_or(static_cast<double>(step.number)), step.time.has_value());
  on_first_rank(*comm_, [this] { tell_viewers(); });
}

void FieldsFile::tell_viewers() const {
  const std::filesystem::path folder(folder_);
  replace_file((folder / xdmf_of_steps).string(), xdmf_text(xdmf_, XdmfOf::stones));
  replace_file((folder / xdmf_of_last_step).string(), xdmf_text(xdmf_, XdmfOf::last_stones));
  if (xdmf_.points > 0) replace_file((folder / xdmf_of_joints).string(), xdmf_text(xdmf_, XdmfOf::joints));
}

void FieldsFile::write_loads(const std::string& group, const LoadRows& loads) {
  if (loads.name.empty()) return;
  const std::string at = group + "/loads/";
  if (!file_.has(at + "name")) file_.write_texts(at + "name", loads.name);
  if (!file_.has(at + "type")) file_.write_texts(at + "type", loads.type);
  const Rows each = counted(comm_->getRank() == 0 ? first_numbers(loads.name.size()) : std::vector<long long>{});
  const auto of_first = [&](auto values) { return each.ids.empty() ? decltype(values){} : values; };
  write(at + "factor", each, of_first(loads.factor), 1, "-", "of its stage times its function of time");
  write(at + "of_stones", each, of_first(loads.of_stones), 1, "-", "1 where it acts on all of stones, and has no rows");
  write(at + "total_N", each, of_first(loads.total), dim_, "N");
  const Rows rows = counted(loads.row);
  write(at + "load_of", rows, loads.load_of, 1, "-", "which load a row is of");
  write(at + "node", rows, loads.node, 1, "-");
  write(at + "force_N", rows, loads.force, dim_, "N");
}

}  // namespace voussoir
