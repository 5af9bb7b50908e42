#include "stones/volume_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "base/text.hpp"
#include "mesh/bytes.hpp"

namespace voussoir {
namespace {

using Face = VolumeMesh::Face;

/// @param mesh  const when it is written
template <class Bytes, class Mesh>
void exchange_volumes(Bytes& bytes, Mesh& mesh) {
  plain_list(bytes, mesh.position);
  plain_list(bytes, mesh.faces);
  plain_list(bytes, mesh.folds);
  for (auto* names : {&mesh.block_sets, &mesh.facet_sets}) {
    const std::size_t count = bytes.size(*names, sizeof(std::size_t));
    for (std::size_t k = 0; k < count; ++k) plain_list(bytes, (*names)[k]);
  }
  const std::size_t volumes = bytes.size(mesh.volumes, sizeof mesh.volumes[0].tag);
  for (std::size_t k = 0; k < volumes; ++k) {
    bytes.plain(mesh.volumes[k].tag);
    plain_list(bytes, mesh.volumes[k].sets);
    plain_list(bytes, mesh.volumes[k].cells);
    plain_list(bytes, mesh.volumes[k].border);
  }
}

/// Every number that is an index points somewhere.
void check_indices(const VolumeMesh& mesh) {
  const auto require_index = [](int index, std::size_t size, const char* of) {
    if (index < 0 || static_cast<std::size_t>(index) >= size)
      refuse_bytes(std::string("a number of ") + of + " is none");
  };
  const auto require_face = [&](const Face& face) {
    if (face.count != 3 && face.count != 4) refuse_bytes("a face is neither triangle nor quadrilateral");
    for (int k = 0; k < face.count; ++k) require_index(face.node[k], mesh.position.size(), "a node");
  };
  for (const int node : mesh.folds) require_index(node, mesh.position.size(), "a node");
  for (const auto& named : mesh.faces) {
    require_face(named.face);
    require_index(named.set, mesh.facet_sets.size(), "a set of surfaces");
  }
  for (const auto& volume : mesh.volumes) {
    for (const int set : volume.sets) require_index(set, mesh.block_sets.size(), "a set of volumes");
    for (const auto& face : volume.border) require_face(face);
    for (const auto& cell : volume.cells) {
      if (cell.count != 4 && cell.count != 8) refuse_bytes("a cell is neither tetrahedron nor hexahedron");
      for (int k = 0; k < cell.count; ++k) require_index(cell.node[k], mesh.position.size(), "a node");
    }
  }
}

[[noreturn]] void refuse(const std::string& volume, const std::string& fault, const std::string& why,
                         const std::string& advice) {
  throw InputError("mesh: " + volume + fault + "\n  " + why + "\n  " + advice);
}

/// Faces of a cell, outward where it has a positive volume.
std::vector<Face> faces_of(const Cell& cell) {
  std::vector<Face> faces;
  const auto add = [&](std::initializer_list<int> corners) {
    Face face;
    for (const int k : corners) face.node[face.count++] = cell.node[k];
    faces.push_back(face);
  };
  if (cell.count == 4) {
    for (const auto& f : {std::array<int, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) add({f[0], f[1], f[2]});
    return faces;
  }
  for (const auto& f :
       {std::array<int, 4>{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
    add({f[0], f[1], f[2], f[3]});
  return faces;
}

/// Nodes of a face in ascending order, of a triangle behind none: the same from both sides.
std::array<int, 4> key_of(const Face& face) {
  std::array<int, 4> key{-1, -1, -1, -1};
  std::copy_n(face.node.begin(), face.count, key.begin());
  std::sort(key.begin(), key.end());
  return key;
}

/// Least Jacobian of a cell at its corners [m3], a tetrahedron has one.
double least_jacobian(const Cell& cell, const Places& x, int& corner) {
  const auto between = [&](int a, int b, int c, int d) {
    const auto& o = x[cell.node[a]];
    return dot(cross(x[cell.node[b]] - o, x[cell.node[c]] - o), x[cell.node[d]] - o);
  };
  corner = 0;
  if (cell.count == 4) return between(0, 1, 2, 3);
  double least = between(0, 1, 3, 4);
  for (int k = 1; k < 8; ++k) {
    const int ring = k / 4 * 4, next = ring + (k + 1) % 4, last = ring + (k + 3) % 4, across = (k + 4) % 8;
    const double jacobian = k < 4 ? between(k, next, last, across) : between(k, last, next, across);
    if (jacobian < least) corner = k, least = jacobian;
  }
  return least;
}

double diameter(const Cell& cell, const Places& x) {
  double largest = 0;
  for (int k = 1; k < cell.count; ++k) largest = std::max(largest, norm(x[cell.node[k]] - x[cell.node[0]]));
  return largest;
}

/// The same cell seen from outside in.
Cell turned(const Cell& cell) {
  Cell other = cell;
  if (cell.count == 4)
    std::swap(other.node[1], other.node[2]);
  else
    for (int k = 0; k < 4; ++k) std::swap(other.node[k], other.node[k + 4]);
  return other;
}

/// Cells of positive volume. Returns whether the volume was turned as a whole.
bool make_positive(const Places& x, const std::string& name, std::vector<Cell>& cells) {
  int corner = 0;
  const bool inside_out = std::all_of(cells.begin(), cells.end(),
                                      [&](const Cell& cell) { return least_jacobian(turned(cell), x, corner) > 0; });
  if (inside_out)
    for (auto& cell : cells) cell = turned(cell);
  // Of the cube of its size, what rounding leaves of a cell without volume.
  constexpr double flat = 1e-12;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double jacobian = least_jacobian(cells[k], x, corner), size = diameter(cells[k], x);
    if (jacobian > flat * size * size * size) continue;
    refuse(name,
           ", cell " + std::to_string(k) + " with a corner at " + place_in_words(x[cells[k].node[corner]]) + " is " +
               (jacobian < -flat * size * size * size ? "inverted" : "flat"),
           "(its Jacobian is " + six_digits(jacobian) + " m3 there, and must be positive).",
           "Mesh the volume again with smaller elements, or leave out very short edges.");
  }
  return inside_out;
}

void find_border(const Places& x, const std::string& name, VolumeMesh::Volume& volume) {
  struct Uses {
    Face face;
    int cell, count;
  };
  const auto middle_of = [&](const Face& face) {
    Vector<3> sum{};
    for (int k = 0; k < face.count; ++k) sum = sum + (1.0 / face.count) * x[face.node[k]];
    return sum;
  };
  std::map<std::array<int, 4>, Uses> uses;
  DisjointSets pieces(volume.cells.size());
  for (std::size_t c = 0; c < volume.cells.size(); ++c)
    for (const auto& face : faces_of(volume.cells[c])) {
      const auto [known, is_new] = uses.emplace(key_of(face), Uses{face, static_cast<int>(c), 1});
      if (is_new) continue;
      if (++known->second.count > 2)
        refuse(name, ", a face at " + place_in_words(middle_of(face)) + " has three cells",
               "(cells lie on each other there).", "Remove doubled volumes or elements and mesh again.");
      pieces.unite(static_cast<int>(c), known->second.cell);
    }
  for (std::size_t c = 0; c < pieces.size(); ++c)
    if (pieces.root(static_cast<int>(c)) != pieces.root(0))
      refuse(name,
             " is in pieces: the cell at " + place_in_words(x[volume.cells[0].node[0]]) + " and that at " +
                 place_in_words(x[volume.cells[c].node[0]]) + " are not connected over faces",
             "(a stone is one elastic body; pieces would move freely against each other).",
             "Make each piece a volume of its own.");
  for (const auto& [key, use] : uses)
    if (use.count == 1) volume.border.push_back(use.face);
}

/// The named sets of faces, by their nodes.
std::map<std::array<int, 4>, std::vector<int>> sets_of_faces(const VolumeMesh& mesh) {
  std::map<std::array<int, 4>, std::vector<int>> sets;
  for (const auto& named : mesh.faces) sets[key_of(named.face)].push_back(named.set);
  for (auto& [face, of_face] : sets) sort_unique(of_face);
  return sets;
}

/// A face of a named set, to be asked whether a place lies in it.
class NamedPlace {
 public:
  NamedPlace(const VolumeMesh& mesh, const Face& face, std::vector<int> sets) : sets_(std::move(sets)) {
    for (int k = 0; k < face.count; ++k) corners_.push_back(mesh.position[face.node[k]]);
    middle_ = mean(corners_);
    for (const auto& x : corners_) radius_ = std::max(radius_, norm(x - middle_));
    normal_ = area_vector(corners_);
    normal_ = (1 / norm(normal_)) * normal_;
  }
  const std::vector<int>& sets() const { return sets_; }
  bool holds(const Vector<3>& x, double within) const {
    if (norm(x - middle_) > radius_ + within || std::abs(dot(x - middle_, normal_)) > within) return false;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const auto along = corners_[(k + 1) % corners_.size()] - corners_[k];
      if (dot(cross(normal_, along), x - corners_[k]) < -within * norm(along)) return false;
    }
    return true;
  }

 private:
  std::vector<int> sets_;
  Places corners_;
  Vector<3> middle_{}, normal_{};
  double radius_ = 0;
};

int number_of(const SetNames& list, const std::string& name) { return list.number_of(name); }
int number_of(const std::vector<std::string>& list, const std::string& name) {
  const auto known = std::find(list.begin(), list.end(), name);
  return known == list.end() ? -1 : static_cast<int>(known - list.begin());
}

/// Numbers in a list of names, which grows by those that are new.
template <class List>
std::vector<int> numbers_in(const std::vector<std::string>& names, List& list) {
  std::vector<int> numbers;
  for (const auto& name : names) {
    numbers.push_back(number_of(list, name));
    if (numbers.back() >= 0) continue;
    numbers.back() = static_cast<int>(list.size());
    list.push_back(name);
  }
  return numbers;
}

/// What a file names itself is what it names, and nothing else.
void leave_to_file(const VolumeMesh& mesh, BlockList<3>& list) {
  const auto is_named = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (is_named(mesh.facet_sets, list.facet_sets.back()))
    throw InputError("mesh: a physical group is named \"" + list.facet_sets.back() +
                     "\"\n  which always means all faces of stones.\n  Choose another name.");
  for (auto& block : list.blocks) {
    const auto of_file = [&](const TaggedFacet& f) { return is_named(mesh.facet_sets, list.facet_sets[f.set]); };
    const auto in_file = [&](int set) { return is_named(mesh.block_sets, list.block_sets[set]); };
    block.facets.erase(std::remove_if(block.facets.begin(), block.facets.end(), of_file), block.facets.end());
    block.sets.erase(std::remove_if(block.sets.begin(), block.sets.end(), in_file), block.sets.end());
  }
}

}  // namespace

std::string VolumeMesh::name_of(std::size_t volume) const {
  std::string in;
  for (const int set : volumes[volume].sets) in += (in.empty() ? " (" : ", ") + block_sets[set];
  return "volume " + std::to_string(volumes[volume].tag) + in + (in.empty() ? "" : ")");
}

std::string bytes_of(const VolumeMesh& mesh) {
  ByteWriter writer;
  exchange_volumes(writer, mesh);
  return writer.bytes;
}

VolumeMesh volume_mesh_of(const std::string& bytes) {
  VolumeMesh mesh;
  ByteReader reader(bytes);
  exchange_volumes(reader, mesh);
  if (reader.left() > 0) refuse_bytes("it goes on behind its end");
  check_indices(mesh);
  return mesh;
}

int find_borders(VolumeMesh& mesh) {
  int turned = 0;
  for (std::size_t k = 0; k < mesh.volumes.size(); ++k) {
    auto& volume = mesh.volumes[k];
    const auto name = mesh.name_of(k);
    if (volume.cells.empty())
      refuse(name, " has no cells", "(a volume that was not meshed, or was not saved with the mesh).",
             "Mesh it; in a .msh file save all elements (Mesh.SaveAll = 1) or put it into a Physical Volume.");
    for (const auto& cell : volume.cells)
      for (int c = 0; c < cell.count; ++c)
        if (const auto& x = mesh.position[cell.node[c]]; !std::isfinite(x[0] + x[1] + x[2]))
          refuse(name, " has a node that is nowhere", "(its coordinates must be finite numbers).",
                 "Look for a division by zero or a missing number in the file.");
    turned += make_positive(mesh.position, name, volume.cells);
    find_border(mesh.position, name, volume);
  }
  return turned;
}

std::vector<StoneSurface> surfaces_of(const VolumeMesh& mesh, const std::string& origin) {
  const auto sets = sets_of_faces(mesh);
  std::map<std::vector<int>, int> part;
  std::vector<StoneSurface> stones;
  for (const auto& volume : mesh.volumes) {
    StoneSurface stone;
    stone.name = "volume " + std::to_string(volume.tag);
    stone.origin = origin;
    std::map<int, int> number;
    for (const auto& face : volume.border) {
      stone.faces.emplace_back();
      for (int k = 0; k < face.count; ++k) {
        const auto [known, is_new] = number.emplace(face.node[k], static_cast<int>(stone.points.size()));
        if (is_new) stone.points.push_back(mesh.position[face.node[k]]);
        stone.faces.back().push_back(known->second);
      }
      const auto named = sets.find(key_of(face));
      stone.part.push_back(named == sets.end() ? 0 : part.emplace(named->second, int(part.size()) + 1).first->second);
    }
    stones.push_back(std::move(stone));
  }
  return stones;
}

void add_sets_of_file(const VolumeMesh& mesh, double within, BlockList<3>& list) {
  const int all = static_cast<int>(list.facet_sets.size()) - 1;
  leave_to_file(mesh, list);
  const auto of_blocks = numbers_in(mesh.block_sets, list.block_sets);
  const auto of_facets = numbers_in(mesh.facet_sets, list.facet_sets);
  const auto sets = sets_of_faces(mesh);
  std::vector<char> found(mesh.facet_sets.size(), 0);
  for (std::size_t k = 0; k < mesh.volumes.size(); ++k) {
    auto& block = list.blocks[k];
    for (const int set : mesh.volumes[k].sets) block.sets.push_back(of_blocks[set]);
    sort_unique(block.sets);
    std::vector<NamedPlace> named;
    for (const auto& face : mesh.volumes[k].border)
      if (const auto known = sets.find(key_of(face)); known != sets.end())
        named.emplace_back(mesh, face, known->second);
    std::vector<TaggedFacet> more;
    for (const auto& facet : block.facets) {
      if (facet.set != all || named.empty()) continue;
      Vector<3> middle{};
      for (int c = 0; c < facet.count; ++c) middle = middle + (1.0 / facet.count) * block.position[facet.node[c]];
      const auto here =
          std::find_if(named.begin(), named.end(), [&](const auto& place) { return place.holds(middle, within); });
      if (here == named.end()) continue;
      for (const int set : here->sets()) {
        more.push_back(facet);
        more.back().set = of_facets[set];
        found[set] = 1;
      }
    }
    block.facets.insert(block.facets.end(), more.begin(), more.end());
  }
  for (std::size_t set = 0; set < found.size(); ++set)
    if (!found[set])
      throw InputError(
          "mesh: the set of surfaces \"" + mesh.facet_sets[set] +
          "\" bounds no volume\n  (supports and loads on it would reach nothing).\n  Put surfaces of volumes "
          "into the Physical Surface, or remove it.");
}

}  // namespace voussoir
