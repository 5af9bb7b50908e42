// Pieces of stones. Every piece is a model of its own in units of its size: gmsh has absolute tolerances, and what one
// piece is must not depend on those before it.
#include <gmsh.h>

#include <numeric>
#include <utility>

#include "gmsh/gmsh_session.hpp"
#include "gmsh/gmsh_works.hpp"
#include "stones/gmsh_pieces.hpp"

namespace voussoir {
namespace {

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

FlatMesh mesh_one(Gmsh& gmsh_itself, const FlatDomain& domain) {
  FlatMesh mesh;
  const auto& origin = domain.loops[0][0];
  mesh.failure = gmsh_itself.run_piece([&] {
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

FilledMesh fill_one(Gmsh& gmsh_itself, const ClosedMesh& surface) {
  FilledMesh mesh;
  const auto& origin = surface.nodes[0];
  mesh.failure = gmsh_itself.run_piece([&] {
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

/// Every piece of the request, one after the other.
template <class Piece, class Mesh>
std::string all_of(const std::string& request, void (*read)(ByteReader&, Piece&), Mesh (*one)(Gmsh&, const Piece&),
                   void (*write)(ByteWriter&, const Mesh&)) {
  Gmsh gmsh_itself;
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeMax", 1);
  ByteReader reader(request);
  ByteWriter writer;
  while (reader.left() > 0) {
    Piece piece;
    read(reader, piece);
    write(writer, one(gmsh_itself, piece));
  }
  return writer.bytes;
}

}  // namespace

std::string gmsh_work::polygons_meshed(const std::string& request) {
  return all_of<FlatDomain, FlatMesh>(request, exchange_domain<ByteReader, FlatDomain>, mesh_one,
                                      exchange_flat<ByteWriter, const FlatMesh>);
}

std::string gmsh_work::surfaces_filled(const std::string& request) {
  return all_of<ClosedMesh, FilledMesh>(request, exchange_closed<ByteReader, ClosedMesh>, fill_one,
                                        exchange_filled<ByteWriter, const FilledMesh>);
}

}  // namespace voussoir
