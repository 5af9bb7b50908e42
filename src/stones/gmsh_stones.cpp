#include "stones/gmsh_stones.hpp"

#include <algorithm>
#include <utility>

#include "mesh/gmsh_program.hpp"
#include "stones/gmsh_crash.hpp"
#include "stones/gmsh_pieces.hpp"

namespace voussoir {
namespace {

/// All pieces in one child; where it crashes, each in one of its own.
template <class Mesh, class Piece>
std::vector<Mesh> answers(const char* work, const std::vector<Piece>& pieces, void (*write)(ByteWriter&, const Piece&),
                          void (*read)(ByteReader&, Mesh&)) {
  std::vector<std::string> requests;
  std::string all;
  for (const auto& piece : pieces) {
    ByteWriter writer;
    write(writer, piece);
    all += writer.bytes;
    requests.push_back(std::move(writer.bytes));
  }
  std::vector<Mesh> meshes(pieces.size());
  if (pieces.empty()) return meshes;
  try {
    const std::string bytes = in_gmsh_child(work, all);
    ByteReader reader(bytes);
    for (auto& mesh : meshes) read(reader, mesh);
    return meshes;
  } catch (const GmshCrash&) {
  }
  for (std::size_t k = 0; k < pieces.size(); ++k) try {
      const std::string bytes = in_gmsh_child(work, requests[k]);
      ByteReader reader(bytes);
      read(reader, meshes[k]);
    } catch (const GmshCrash& crash) {
      meshes[k].failure = crash.how;
    }
  return meshes;
}

bool numbers_hold(const std::vector<int>& numbers, std::size_t nodes) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [&](int n) { return n >= 0 && static_cast<std::size_t>(n) < nodes; });
}

/// What comes from gmsh is looked at: numbers of nodes that are none make a failure.
template <class Cells>
void check_numbers(const Cells& cells, std::size_t nodes, std::string& failure) {
  std::vector<int> numbers;
  for (const auto& cell : cells) numbers.insert(numbers.end(), cell.begin(), cell.end());
  if (failure.empty() && cells.empty()) failure = "gmsh makes no cells";
  if (failure.empty() && !numbers_hold(numbers, nodes)) failure = "gmsh adds nodes on the border";
}

}  // namespace

std::vector<FlatMesh> meshed(const std::vector<FlatDomain>& domains) {
  auto meshes =
      answers<FlatMesh, FlatDomain>(gmsh_work::mesh_polygons, domains, exchange_domain<ByteWriter, const FlatDomain>,
                                    exchange_flat<ByteReader, FlatMesh>);
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    std::size_t nodes = meshes[k].inside.size();
    for (const auto& loop : domains[k].loops) nodes += loop.size();
    check_numbers(meshes[k].triangles, nodes, meshes[k].failure);
  }
  return meshes;
}

std::vector<FilledMesh> filled(const std::vector<ClosedMesh>& surfaces) {
  auto meshes =
      answers<FilledMesh, ClosedMesh>(gmsh_work::fill_surfaces, surfaces, exchange_closed<ByteWriter, const ClosedMesh>,
                                      exchange_filled<ByteReader, FilledMesh>);
  for (std::size_t k = 0; k < meshes.size(); ++k)
    check_numbers(meshes[k].cells, surfaces[k].nodes.size() + meshes[k].inside.size(), meshes[k].failure);
  return meshes;
}

}  // namespace voussoir
