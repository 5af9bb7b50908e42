// Meshes behind gmsh: what its process hands back becomes blocks that were looked at, or is refused.
//
// After an even byte the others are changes of the bytes of a good mesh, three for each: where (two) and what is turned
// over. After an odd one they draw surfaces: nodes on a small lattice (so that nodes, edges and blocks coincide often)
// or at places no file should have, cells and lines between them.
#include <Teuchos_DefaultSerialComm.hpp>
#include <limits>

#include "fuzz.hpp"
#include "mesh/mesh_check.hpp"
#include "mesh/surface_mesh.hpp"

namespace {

using namespace voussoir;

class Drawing {
 public:
  Drawing(const std::uint8_t* bytes, std::size_t count) : bytes_(bytes), count_(count) {}

  SurfaceMesh mesh() {
    SurfaceMesh mesh;
    mesh.position.resize(static_cast<std::size_t>(1 + next() % 24));
    for (auto& x : mesh.position) x = place();
    const int nodes = static_cast<int>(mesh.position.size());
    for (int k = next() % 3; k > 0; --k) mesh.block_sets.push_back("set " + std::to_string(k));
    for (int k = next() % 3; k > 0; --k) mesh.facet_sets.push_back("curves " + std::to_string(k));
    mesh.surfaces.resize(static_cast<std::size_t>(next() % 6));
    for (auto& surface : mesh.surfaces) {
      surface.tag = next();
      if (!mesh.block_sets.empty()) surface.sets.push_back(next() % static_cast<int>(mesh.block_sets.size()));
      surface.cells.resize(static_cast<std::size_t>(next() % 6));
      for (Cell& cell : surface.cells) {
        const int what = next();
        cell.count = what == 255 ? 5 : 3 + what % 2;
        for (int k = 0; k < cell.count; ++k) cell.node[k] = what == 254 ? next() - 1 : next() % nodes;
      }
    }
    mesh.lines.resize(static_cast<std::size_t>(next() % 4));
    for (auto& line : mesh.lines) line = {{next() % nodes, next() % nodes}, next() % 3};
    return mesh;
  }

 private:
  int next() { return at_ < count_ ? bytes_[at_++] : 0; }
  Vector<2> place() {
    const int where = next();
    Vector<2> x{0.5 * (where % 8), 0.5 * (where / 8 % 8)};
    if (where < 192) return x;  // of 256: the others lie elsewhere
    const double places[] = {1e-7,
                             1e-3,
                             -4.0,
                             1e7,
                             1e-300,
                             1e300,
                             std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()};
    const int axis = where % 2;
    x[axis] += places[next() % 8];
    return x;
  }

  const std::uint8_t* bytes_;
  std::size_t count_, at_ = 0;
};

std::string good() {
  SurfaceMesh mesh;
  mesh.position = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 2}, {0, 2}};
  mesh.block_sets = {"stone"};
  mesh.facet_sets = {"base"};
  Cell lower, upper;
  lower.count = upper.count = 4;
  lower.node = {0, 1, 2, 3};
  upper.node = {3, 2, 4, 5};
  mesh.surfaces = {{1, {0}, {lower}}, {2, {}, {upper}}};
  mesh.lines = {{{0, 1}, 0}};
  return bytes_of(mesh);
}

double doubled_area(const Block<2>& block, const Cell& cell) {
  double area = 0;
  for (int k = 1; k + 1 < cell.count; ++k)
    area += cross(block.position[cell.node[k]] - block.position[cell.node[0]],
                  block.position[cell.node[k + 1]] - block.position[cell.node[0]]);
  return area;
}

/// What was not refused can be computed: cells have an area, sets exist.
void look_at(const BlockSource<2>& source) {
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const Block<2> block = source.block(b);
    if (block.cells.empty() || block.vertex.size() != block.position.size()) std::abort();
    for (const Cell& cell : block.cells)
      if (!(doubled_area(block, cell) > 0)) std::abort();
    for (const TaggedFacet& facet : block.facets)
      if (facet.set >= static_cast<int>(source.facet_sets().size())) std::abort();
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  static const std::string whole = good();
  const bool drawn = count > 0 && bytes[0] % 2 == 1;
  std::string handed_back = drawn ? bytes_of(Drawing(bytes + 1, count - 1).mesh()) : whole;
  if (!drawn)
    for (std::size_t k = 1; k + 3 <= count; k += 3)
      handed_back[(bytes[k] + 256u * bytes[k + 1]) % whole.size()] ^= static_cast<char>(bytes[k + 2]);
  const Teuchos::SerialComm<int> comm;
  fuzz::refuse_or_read([&] {
    auto list = blocks_of_surfaces(surface_mesh_of(handed_back));
    check_mesh(list.blocks);
    const auto source = make_source(std::move(list));
    std::vector<FacetNames> supported;
    if (!source->facet_sets().empty()) supported.emplace_back(source->facet_sets()[0]);
    check_supports(*source, supported, comm);
    look_at(*source);
  });
  return 0;
}
