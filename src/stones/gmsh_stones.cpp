// gmsh, as stones need it. Every piece is a model of its own in units of its size: gmsh has absolute tolerances, and
// what one piece is must not depend on those before it.
#include "stones/gmsh_stones.hpp"

#include <gmsh.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/bytes.hpp"
#include "stones/gmsh_session.hpp"

namespace voussoir {
namespace {

/// A session that makes cells of the length 1 and smaller.
struct Session {
  GmshSession gmsh_itself;
  Session() {
    gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
    gmsh::option::setNumber("Mesh.MeshSizeMax", 1);
  }
};

template <class Bytes, class Domain>
void exchange_domain(Bytes& bytes, Domain& domain) {
  const std::size_t loops = bytes.size(domain.loops, sizeof(std::size_t));
  for (std::size_t k = 0; k < loops; ++k) plain_list(bytes, domain.loops[k]);
  bytes.plain(domain.size);
}

template <class Bytes, class Mesh>
void exchange_flat(Bytes& bytes, Mesh& mesh) {
  plain_list(bytes, mesh.inside);
  plain_list(bytes, mesh.triangles);
  plain_list(bytes, mesh.failure);
}

template <class Bytes, class Mesh>
void exchange_closed(Bytes& bytes, Mesh& mesh) {
  plain_list(bytes, mesh.nodes);
  plain_list(bytes, mesh.triangles);
  bytes.plain(mesh.size);
}

template <class Bytes, class Mesh>
void exchange_filled(Bytes& bytes, Mesh& mesh) {
  plain_list(bytes, mesh.inside);
  plain_list(bytes, mesh.cells);
  plain_list(bytes, mesh.failure);
}

/// Numbers of nodes by the tags that gmsh gives them.
class Tags {
 public:
  void set(std::size_t tag, int number) {
    if (tag >= number_.size()) number_.resize(tag + 1, -1);
    number_[tag] = number;
  }
  int operator[](std::size_t tag) const { return tag < number_.size() ? number_[tag] : -1; }

 private:
  std::vector<int> number_;
};

FlatMesh mesh_one(GmshSession& gmsh_itself, const FlatDomain& domain) {
  FlatMesh mesh;
  const auto& origin = domain.loops[0][0];
  mesh.failure = gmsh_itself.run([&] {
    namespace geo = gmsh::model::geo;
    std::vector<int> points, curves;
    for (const auto& loop : domain.loops) {
      const std::size_t first = points.size();
      for (const auto& x : loop) {
        const auto p = (1 / domain.size) * (x - origin);
        points.push_back(geo::addPoint(p[0], p[1], 0));
      }
      std::vector<int> lines;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        lines.push_back(geo::addLine(points[first + k], points[first + (k + 1) % loop.size()]));
        geo::mesh::setTransfiniteCurve(lines.back(), 2);
      }
      curves.push_back(geo::addCurveLoop(lines));
    }
    const int surface = geo::addPlaneSurface(curves);
    geo::synchronize();
    gmsh::model::mesh::generate(2);
    Tags tags;
    std::vector<std::size_t> nodes, elements;
    std::vector<double> x, parametric;
    for (std::size_t k = 0; k < points.size(); ++k) {
      gmsh::model::mesh::getNodes(nodes, x, parametric, 0, points[k]);
      tags.set(nodes.at(0), static_cast<int>(k));
    }
    gmsh::model::mesh::getNodes(nodes, x, parametric, 2, surface);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      tags.set(nodes[k], static_cast<int>(points.size() + k));
      mesh.inside.push_back(origin + domain.size * Vector<2>{x[3 * k], x[3 * k + 1]});
    }
    std::vector<std::size_t> corners;  // empty: gmsh takes lists with members for memory of the right size
    gmsh::model::mesh::getElementsByType(2, elements, corners, surface);
    for (std::size_t k = 0; k < corners.size(); k += 3)
      mesh.triangles.push_back({tags[corners[k]], tags[corners[k + 1]], tags[corners[k + 2]]});
  });
  return mesh;
}

FilledMesh fill_one(GmshSession& gmsh_itself, const ClosedMesh& surface) {
  FilledMesh mesh;
  const auto& origin = surface.nodes[0];
  mesh.failure = gmsh_itself.run([&] {
    std::vector<std::size_t> tags(surface.nodes.size()), corners, elements;
    std::iota(tags.begin(), tags.end(), 1);
    std::vector<double> x, parametric;
    for (const auto& place : surface.nodes)
      for (const double c : (1 / surface.size) * (place - origin)) x.push_back(c);
    for (const auto& t : surface.triangles)
      for (const int node : t) corners.push_back(static_cast<std::size_t>(node) + 1);
    gmsh::model::addDiscreteEntity(2, 1);
    gmsh::model::mesh::addNodes(2, 1, tags, x);
    gmsh::model::mesh::addElementsByType(1, 2, {}, corners);
    gmsh::model::geo::addSurfaceLoop({1}, 1);
    gmsh::model::geo::addVolume({1}, 1);
    gmsh::model::geo::synchronize();
    gmsh::model::mesh::generate(3);
    Tags number;
    for (std::size_t k = 0; k < tags.size(); ++k) number.set(tags[k], static_cast<int>(k));
    std::vector<std::size_t> inner;
    gmsh::model::mesh::getNodes(inner, x, parametric, 3, 1);
    for (std::size_t k = 0; k < inner.size(); ++k) {
      number.set(inner[k], static_cast<int>(tags.size() + k));
      mesh.inside.push_back(origin + surface.size * Vector<3>{x[3 * k], x[3 * k + 1], x[3 * k + 2]});
    }
    std::vector<std::size_t> cells;
    gmsh::model::mesh::getElementsByType(4, elements, cells, 1);
    for (std::size_t k = 0; k < cells.size(); k += 4)
      mesh.cells.push_back({number[cells[k]], number[cells[k + 1]], number[cells[k + 2]], number[cells[k + 3]]});
  });
  return mesh;
}

/// What a child does: every piece of the request, one after the other.
template <class Piece, class Mesh>
std::string all_of(const std::string& request, void (*read)(ByteReader&, Piece&),
                   Mesh (*one)(GmshSession&, const Piece&), void (*write)(ByteWriter&, const Mesh&)) {
  Session session;
  ByteReader reader(request);
  ByteWriter writer;
  while (reader.left() > 0) {
    Piece piece;
    read(reader, piece);
    write(writer, one(session.gmsh_itself, piece));
  }
  return writer.bytes;
}

std::string mesh_all(const std::string& request) {
  return all_of<FlatDomain, FlatMesh>(request, exchange_domain<ByteReader, FlatDomain>, mesh_one,
                                      exchange_flat<ByteWriter, const FlatMesh>);
}

std::string fill_all(const std::string& request) {
  return all_of<ClosedMesh, FilledMesh>(request, exchange_closed<ByteReader, ClosedMesh>, fill_one,
                                        exchange_filled<ByteWriter, const FilledMesh>);
}

/// All pieces in one child; where it crashes, each in one of its own.
template <class Mesh, class Piece>
std::vector<Mesh> answers(ChildWork work, const std::vector<Piece>& pieces, void (*write)(ByteWriter&, const Piece&),
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
  auto meshes = answers<FlatMesh, FlatDomain>(mesh_all, domains, exchange_domain<ByteWriter, const FlatDomain>,
                                              exchange_flat<ByteReader, FlatMesh>);
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    std::size_t nodes = meshes[k].inside.size();
    for (const auto& loop : domains[k].loops) nodes += loop.size();
    check_numbers(meshes[k].triangles, nodes, meshes[k].failure);
  }
  return meshes;
}

std::vector<FilledMesh> filled(const std::vector<ClosedMesh>& surfaces) {
  auto meshes = answers<FilledMesh, ClosedMesh>(fill_all, surfaces, exchange_closed<ByteWriter, const ClosedMesh>,
                                                exchange_filled<ByteReader, FilledMesh>);
  for (std::size_t k = 0; k < meshes.size(); ++k)
    check_numbers(meshes[k].cells, surfaces[k].nodes.size() + meshes[k].inside.size(), meshes[k].failure);
  return meshes;
}

}  // namespace voussoir
