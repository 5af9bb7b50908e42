// Pieces of stones. Every piece is a model of its own in units of its size: gmsh has absolute tolerances, and what one
// piece is must not depend on those before it.
#include <gmsh.h>

#include <map>
#include <numeric>
#include <utility>

#include "gmsh/gmsh_session.hpp"
#include "gmsh/gmsh_works.hpp"
#include "stones/gmsh_pieces.hpp"
#include "stones/polygon.hpp"

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

/// A part of a flat domain, and its border as curves of gmsh.
struct FlatPart {
  Polygon outline;
  std::vector<int> curves;  ///< loops, the outer one first
};

/// Borders of a domain, in units of its size. Where one touches itself or another the curves share a point.
class FlatBorders {
 public:
  explicit FlatBorders(const FlatDomain& domain) : domain_(domain), origin_(domain.loops[0][0]) {
    std::vector<std::pair<Polygon, int>> holes;
    for (std::size_t k = 0; k < domain.loops.size(); ++k) {
      const auto& loop = domain.loops[k];
      for (const auto& apart : loops_apart(loop)) {
        Polygon outline;
        for (const int n : apart) outline.push_back(loop[n]);
        // What the border touches from within is a hole, and what touches a hole from within is a part.
        const bool as_whole = (area(outline) > 0) == (area(loop) > 0);
        if (as_whole == (k == 0))
          parts_.push_back({outline, {curve(outline)}});
        else
          holes.emplace_back(outline, curve(outline));
      }
      for (const auto& x : loop) corners_.push_back(point(x));
    }
    for (const auto& [outline, curve] : holes) part_around(outline).curves.push_back(curve);
  }
  const std::vector<FlatPart>& parts() const { return parts_; }
  const std::vector<int>& corners() const { return corners_; }  ///< of all loops in their order, as points of gmsh

 private:
  int point(const Vector<2>& x) {
    const auto [known, is_new] = point_.emplace(x, 0);
    const auto p = (1 / domain_.size) * (x - origin_);
    if (is_new) known->second = gmsh::model::geo::addPoint(p[0], p[1], 0);
    return known->second;
  }
  int curve(const Polygon& outline) {
    std::vector<int> lines;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      lines.push_back(gmsh::model::geo::addLine(point(outline[k]), point(outline[(k + 1) % outline.size()])));
      gmsh::model::geo::mesh::setTransfiniteCurve(lines.back(), 2);
    }
    return gmsh::model::geo::addCurveLoop(lines);
  }
  /// A hole may touch its part in corners, not in the middle of its edges.
  FlatPart& part_around(const Polygon& hole) {
    const Vector<2> middle = 0.5 * (hole[0] + hole[1]);
    for (auto& part : parts_)
      if (holds(part.outline, middle)) return part;
    return parts_.front();
  }

  const FlatDomain& domain_;
  Vector<2> origin_;
  std::map<Vector<2>, int> point_;
  std::vector<FlatPart> parts_;
  std::vector<int> corners_;
};

FlatMesh mesh_one(Gmsh& gmsh_itself, const FlatDomain& domain) {
  FlatMesh mesh;
  const auto& origin = domain.loops[0][0];
  mesh.failure = gmsh_itself.run_piece([&] {
    const FlatBorders borders(domain);
    const auto& points = borders.corners();
    std::vector<int> surfaces;
    for (const auto& part : borders.parts()) surfaces.push_back(gmsh::model::geo::addPlaneSurface(part.curves));
    gmsh::model::geo::synchronize();
    gmsh::model::mesh::generate(2);
    Tags tags;
    std::vector<std::size_t> nodes;
    std::vector<double> x, parametric;
    for (std::size_t k = 0; k < points.size(); ++k) {
      gmsh::model::mesh::getNodes(nodes, x, parametric, 0, points[k]);
      tags.set(nodes.at(0), static_cast<int>(k));
    }
    for (const int surface : surfaces) {
      gmsh::model::mesh::getNodes(nodes, x, parametric, 2, surface);
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        tags.set(nodes[k], static_cast<int>(points.size() + mesh.inside.size()));
        mesh.inside.push_back(origin + domain.size * Vector<2>{x[3 * k], x[3 * k + 1]});
      }
      std::vector<std::size_t> elements, corners;  // empty: gmsh takes lists with members for memory of the right size
      gmsh::model::mesh::getElementsByType(2, elements, corners, surface);
      for (std::size_t k = 0; k < corners.size(); k += 3)
        mesh.triangles.push_back({tags[corners[k]], tags[corners[k + 1]], tags[corners[k + 2]]});
    }
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
