// fields.h5 and fields.xdmf of a small structure; read_fields.py then opens them as a viewer does.
#include "output/fields_file.hpp"

#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

#include <Teuchos_UnitTestHarness.hpp>

#include "base/error.hpp"
#include "unit/output/folders.hpp"

namespace voussoir {
namespace {

using namespace test;
int rank() { return world()->getRank(); }
int last_rank() { return world()->getSize() - 1; }

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<long long> first(long long count) {
  std::vector<long long> ids(static_cast<std::size_t>(count));
  std::iota(ids.begin(), ids.end(), 0LL);
  return ids;
}

// Two unit squares side by side: block 0 is one quadrilateral and belongs to rank 0, block 1 is two triangles and
// belongs to the last rank. Contact points 0 and 1 lie on the line x = 1.
MeshRows two_squares() {
  MeshRows mesh;
  mesh.block_set_names = {"left", "right side"};
  mesh.sets_of_a_block = 2;
  for (int block = 0; block < 2; ++block) {
    if (rank() != (block == 0 ? 0 : last_rank())) continue;
    for (int corner = 0; corner < 4; ++corner) mesh.node.push_back(4 * block + corner);
    const double x = block;
    for (const double coordinate : {x, 0.0, x + 1.0, 0.0, x + 1.0, 1.0, x, 1.0}) mesh.coordinates.push_back(coordinate);
    mesh.block_of_node.insert(mesh.block_of_node.end(), 4, block);
    mesh.block.push_back(block);
    mesh.block_set.push_back(block);
    for (const int set : {block, block == 1 ? 0 : -1}) mesh.block_sets.push_back(set);  // block 1 is in both
    mesh.held.insert(mesh.held.end(), 4, block == 0);
    const std::vector<long long> cells = block == 0 ? std::vector<long long>{0} : std::vector<long long>{1, 2};
    const std::vector<NodeId> corners =
        block == 0 ? std::vector<NodeId>{0, 1, 2, 3} : std::vector<NodeId>{4, 5, 6, 4, 6, 7};
    mesh.cell.insert(mesh.cell.end(), cells.begin(), cells.end());
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    mesh.corner_count.insert(mesh.corner_count.end(), cells.size(), block == 0 ? 4 : 3);
    mesh.block_of_cell.insert(mesh.block_of_cell.end(), cells.size(), block);
  }
  return mesh;
}

JointRows joint_between_them() {
  JointRows joints;
  for (int point = 0; point < 2; ++point) {
    if (rank() != (point == 0 ? 0 : last_rank())) continue;
    joints.point.push_back(point);
    joints.position.insert(joints.position.end(), {1.0, static_cast<double>(point)});
    joints.normal.insert(joints.normal.end(), {1.0, 0.0});
    joints.area.push_back(0.5);
    joints.block_i.push_back(0);
    joints.block_j.push_back(1);
    joints.main_of_i.push_back(point == 0 ? 1 : 2);
    joints.main_of_j.push_back(point == 0 ? 4 : 7);
  }
  return joints;
}

/// Values that tell step and row; read_fields.py knows the same formulas.
StepRows state(int step, const MeshRows& mesh, const JointRows& joints) {
  StepRows rows;
  rows.number = step;
  rows.stage = step == 1 ? "own weight" : "push";
  rows.load_factor = 0.5 * step;
  for (const auto node : mesh.node)
    rows.displacement.insert(rows.displacement.end(), {0.001 * step * double(node), -0.002 * step * double(node)});
  for (const auto cell : mesh.cell)
    rows.stress.insert(rows.stress.end(), {100.0 * step + double(cell), 10.0 * step + double(cell), double(cell)});
  for (const auto point : joints.point) {
    rows.gap.push_back(1e-4 * step * double(point));
    rows.slip.push_back(1e-5 * step);
    rows.normal_force.push_back(1000.0 * step);
    rows.tangential_force.push_back(-100.0 * double(point));
    rows.status.push_back(point == 0 ? 2 : 0);
    rows.selected.push_back(point == 0 ? 1 : 0);
  }
  return rows;
}

TEUCHOS_UNIT_TEST(FieldsFile, HoldsWhatEveryRankGaveInGlobalOrder) {
  const std::string folder = fresh_folder("fields");
  const MeshRows mesh = two_squares();
  const JointRows joints = joint_between_them();
  {
    FieldsFile fields(folder + "/fields.h5", world(), 2);
    fields.write_mesh(mesh);
    fields.write_joints(joints);
    for (int step = 1; step <= 2; ++step) fields.write_step(state(step, mesh, joints));
  }
  const Hdf5File file(folder + "/fields.h5", world(), Hdf5File::Mode::read);
  TEST_ASSERT(file.read_rows<int>("/mesh/block_of_node", first(8)) == (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
  // The triangles repeat their last node.
  TEST_ASSERT(file.read_rows<long long>("/mesh/cells", first(3)) ==
              (std::vector<long long>{0, 1, 2, 3, 4, 5, 6, 6, 4, 6, 7, 7}));
  TEST_ASSERT(file.read_rows<int>("/mesh/rank_of_block", first(2)) == (std::vector<int>{0, last_rank()}));
  TEST_ASSERT(file.read_texts("/mesh/block_set_names") == mesh.block_set_names);
  TEST_ASSERT(file.read_rows<int>("/mesh/block_set", first(2)) == (std::vector<int>{0, 1}));
  TEST_ASSERT(file.read_rows<int>("/mesh/block_sets", first(2)) == (std::vector<int>{0, -1, 1, 0}));
  TEST_ASSERT(file.read_rows<int>("/mesh/held", {3, 4}) == (std::vector<int>{1, 0}));
  TEST_ASSERT(file.read_rows<long long>("/joints/node_j", first(2)) == (std::vector<long long>{4, 7}));
  TEST_EQUALITY(file.table("/joints/area").unit, "m2");

  TEST_EQUALITY(file.read_attribute<std::string>("/steps/0002", "stage"), "push");
  TEST_EQUALITY(file.read_attribute<long long>("/steps/0002", "step"), 2);
  TEST_EQUALITY(file.read_attribute<double>("/steps/0001", "load_factor"), 0.5);
  TEST_EQUALITY(file.table("/steps/0001/stress").unit, "Pa");
  // Not computed with here, so equal to the last bit.
  TEST_ASSERT(file.read_rows<double>("/steps/0002/displacement", {7}) ==
              (std::vector<double>{0.001 * 2 * 7.0, -0.002 * 2 * 7.0}));
  TEST_ASSERT(file.read_rows<int>("/steps/0002/joint_status", first(2)) == (std::vector<int>{2, 0}));
}

TEUCHOS_UNIT_TEST(FieldsFile, EveryFinishedStepCanBeReadWhileTheRunGoesOn) {
  const std::string folder = fresh_folder("running");
  const MeshRows mesh = two_squares();
  const JointRows joints = joint_between_them();
  FieldsFile fields(folder + "/fields.h5", world(), 2);
  fields.write_mesh(mesh);
  fields.write_joints(joints);
  for (int step = 1; step <= 2; ++step) {
    fields.write_step(state(step, mesh, joints));
    world()->barrier();
    const std::string copy = folder + "/killed-" + std::to_string(step) + ".h5";
    if (rank() == 0) std::filesystem::copy_file(folder + "/fields.h5", copy);
    world()->barrier();
    const Hdf5File killed(copy, world(), Hdf5File::Mode::read);
    const std::string group = "/steps/000" + std::to_string(step);
    TEST_ASSERT(killed.read_rows<double>(group + "/joint_normal_force_N", {1}) == (std::vector<double>{1000.0 * step}));
    TEST_ASSERT(contains(content(folder + "/fields.xdmf"), "fields.h5:" + group + "/stress"));
    TEST_ASSERT(contains(content(folder + "/stones.xdmf"), "fields.h5:" + group + "/stress"));
    TEST_ASSERT(contains(content(folder + "/joints.xdmf"), "fields.h5:" + group + "/joint_gap_m"));
    TEST_ASSERT(!std::filesystem::exists(folder + "/fields.xdmf.part"));
  }
}

TEUCHOS_UNIT_TEST(FieldsFile, AStructureWithoutJointsInThreeDimensionsIsWrittenToo) {
  const std::string folder = fresh_folder("tetrahedron");
  MeshRows mesh;
  StepRows step;
  step.number = 1;
  step.time = 0.25;
  if (rank() == last_rank()) {
    mesh.node = {0, 1, 2, 3};
    mesh.coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    mesh.block_of_node = {0, 0, 0, 0};
    mesh.cell = {0};
    mesh.corner_count = {4};
    mesh.corners = {0, 1, 2, 3};
    mesh.block_of_cell = {0};
    mesh.block = {0};
    mesh.block_set = {-1};
    mesh.held = {0, 0, 0, 1};
    step.displacement.assign(12, 0.5);
    step.velocity.assign(12, 2.0);
    step.stress.assign(6, 1.0);
  }
  {
    FieldsFile fields(folder + "/fields.h5", world(), 3);
    fields.write_mesh(mesh);
    fields.write_joints({});
    fields.write_step(step);
  }
  const Hdf5File file(folder + "/fields.h5", world(), Hdf5File::Mode::read);
  TEST_EQUALITY(file.read_attribute<double>("/steps/0001", "time_s"), 0.25);
  TEST_EQUALITY(file.table("/steps/0001/stress").columns, 6);
  TEST_EQUALITY(file.table("/joints/normal").rows, 0);
  const std::string xdmf = content(folder + "/fields.xdmf");
  TEST_ASSERT(contains(xdmf, "\"Tetrahedron\""));
  TEST_ASSERT(contains(xdmf, "velocity [m/s]"));
  TEST_ASSERT(contains(xdmf, "<Time Value=\"0.25\"/>"));
  TEST_ASSERT(!std::filesystem::exists(folder + "/joints.xdmf"));
  TEST_ASSERT(!contains(xdmf, "_xyz"));
}

// A hexahedron of rank 0 and a tetrahedron of the last.
TEUCHOS_UNIT_TEST(FieldsFile, ViewersAreGivenCellsOfTwoKindsInATableOfTheirOwn) {
  const std::string folder = fresh_folder("solids");
  MeshRows mesh;
  const auto add = [&](int block, long long place, int corners, long long first_node) {
    for (int n = 0; n < corners; ++n) {
      mesh.node.push_back(first_node + n);
      mesh.corners.push_back(first_node + n);
      mesh.coordinates.insert(mesh.coordinates.end(), {double(n), 0.0, 0.0});
      mesh.block_of_node.push_back(block);
      mesh.held.push_back(0);
    }
    mesh.cell.push_back(block);
    mesh.place_of_cell.push_back(place);
    mesh.corner_count.push_back(corners);
    mesh.block_of_cell.push_back(block);
    mesh.block.push_back(block);
    mesh.block_set.push_back(-1);
  };
  if (rank() == 0) add(0, 0, 8, 0);
  if (rank() == last_rank()) add(1, 9, 4, 8);
  StepRows step;
  step.number = 1;
  step.displacement.assign(3 * mesh.node.size(), 0.5);
  step.stress.assign(6 * mesh.cell.size(), 1.0);
  {
    FieldsFile fields(folder + "/fields.h5", world(), 3);
    fields.write_mesh(mesh);
    fields.write_joints({});
    fields.write_step(step);
  }
  const Hdf5File file(folder + "/fields.h5", world(), Hdf5File::Mode::read);
  TEST_ASSERT(file.read_rows<long long>("/mesh/mixed_cells", first(14)) ==
              (std::vector<long long>{9, 0, 1, 2, 3, 4, 5, 6, 7, 6, 8, 9, 10, 11}));
  TEST_ASSERT(file.read_rows<long long>("/mesh/cells", {1}) == (std::vector<long long>{8, 9, 10, 11, 11, 11, 11, 11}));
  const std::string xdmf = content(folder + "/fields.xdmf");
  TEST_ASSERT(contains(xdmf, "TopologyType=\"Mixed\" NumberOfElements=\"2\""));
  TEST_ASSERT(contains(xdmf, "Dimensions=\"14\""));
}

// Two loads: one on nodes of the first rank and of the last, one on all of stones.
TEUCHOS_UNIT_TEST(FieldsFile, LoadsStandWithTheirNamesWhereTheyAct) {
  const std::string folder = fresh_folder("loads");
  const MeshRows mesh = two_squares();
  const JointRows joints = joint_between_them();
  auto step = state(1, mesh, joints);
  step.loads.name = {"push", "weight"};
  step.loads.type = {"traction", "self weight"};
  step.loads.factor = {2.0, 1.0};
  step.loads.of_stones = {0, 1};
  step.loads.total = {3.0, 0.0, 0.0, -7.0};
  const auto add = [&](long long row, NodeId node, double force) {
    step.loads.row.push_back(row);
    step.loads.load_of.push_back(0);
    step.loads.node.push_back(node);
    step.loads.force.insert(step.loads.force.end(), {force, 0.0});
  };
  if (rank() == 0) add(0, 1, 1.0);
  if (rank() == last_rank()) add(1, 6, 2.0);
  {
    FieldsFile fields(folder + "/fields.h5", world(), 2);
    fields.write_mesh(mesh);
    fields.write_joints(joints);
    fields.write_step(step);
    fields.write_step(state(2, mesh, joints));
  }
  const Hdf5File file(folder + "/fields.h5", world(), Hdf5File::Mode::read);
  TEST_ASSERT(file.read_texts("/steps/0001/loads/name") == step.loads.name);
  TEST_ASSERT(file.read_rows<double>("/steps/0001/loads/factor", first(2)) == step.loads.factor);
  TEST_ASSERT(file.read_rows<double>("/steps/0001/loads/total_N", first(2)) == step.loads.total);
  TEST_ASSERT(file.read_rows<long long>("/steps/0001/loads/node", first(2)) == (std::vector<long long>{1, 6}));
  TEST_ASSERT(file.read_rows<double>("/steps/0001/loads/force_N", first(2)) == (std::vector<double>{1, 0, 2, 0}));
  TEST_ASSERT(!file.has("/steps/0002/loads"));
}

TEUCHOS_UNIT_TEST(Xdmf, TrianglesAloneAreCalledTriangles) {
  XdmfContent only_triangles;
  only_triangles.fields = "fields.h5";
  only_triangles.steps = {{"/steps/0001", 1.0}};
  TEST_ASSERT(contains(xdmf_text(only_triangles, XdmfOf::stones), "\"Triangle\""));
  XdmfContent mixed = only_triangles;
  mixed.corners = 4;
  TEST_ASSERT(contains(xdmf_text(mixed, XdmfOf::last_stones), "\"Quadrilateral\""));
}

}  // namespace
}  // namespace voussoir
