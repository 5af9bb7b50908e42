#include "loads/deck.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

// Corners as near to the line as places are rounded lie on it: to 1e-16 of coordinates, and 1e-9 as text.
constexpr double on_the_line = 1e-9;  // of the size of the structure

/// A place below the line of wheels, by the shares of the corners of an edge or triangle.
struct Place {
  double x;
  std::array<double, 4> share;
};

template <int dim>
void add_piece(const Structure<dim>& s, const std::array<int, 3>& node, Place a, Place b,
               std::vector<DeckPiece>& pieces) {
  if (a.x == b.x) return;
  if (a.x > b.x) std::swap(a, b);
  DeckPiece piece{{a.x, b.x}, {a.share, b.share}, {-1, -1, -1}, {}, s.blocks()[s.block_of_node()[node[0]]].mesh.id};
  for (std::size_t i = 0; i < node.size(); ++i)
    if (node[i] >= 0) piece.id[i] = s.node_id()[node[i]];
  pieces.push_back(piece);
}

std::vector<DeckPiece> owned_pieces(const Structure<2>& s, const FacetSet& set, double, bool) {
  std::vector<DeckPiece> pieces;
  for (const auto& e : edges_of_set(s, set)) {
    const int left = e.x[0][0] < e.x[1][0] ? 0 : 1, right = 1 - left;
    if (e.node[0] < s.owned_nodes() && e.outward[1] > 0)
      add_piece(s, {e.node[left], e.node[right], -1}, {e.x[left][0], {1, 0, 0}}, {e.x[right][0], {0, 1, 0}}, pieces);
  }
  return pieces;
}

/// Where a line of constant y crosses the sides of a triangle: at two of them, or at none. A corner on it counts to
/// one side, so that of two triangles that share a side along the line one bears the wheel.
void add_crossing(const Structure<3>& s, const LoadedFace& face, const std::array<int, 3>& corner, double y, bool upper,
                  std::vector<DeckPiece>& pieces) {
  const double near = on_the_line * s.size();
  const auto away = [&](int k) {
    const double at = face.x[corner[k]][1] - y;
    return std::abs(at) <= near ? 0.0 : at;
  };
  const auto beyond = [&](int k) { return upper ? away(k) >= 0 : away(k) > 0; };
  std::vector<Place> ends;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    if (beyond(k) == beyond(l)) continue;
    const auto &a = face.x[corner[k]], &b = face.x[corner[l]];
    const double t = away(k) / (away(k) - away(l));
    Place end{t == 1 ? b[0] : a[0] + t * (b[0] - a[0]), {}};
    end.share[k] = 1 - t;
    end.share[l] = t;
    ends.push_back(end);
  }
  if (ends.size() != 2) return;
  add_piece(s, {face.node[corner[0]], face.node[corner[1]], face.node[corner[2]]}, ends[0], ends[1], pieces);
}

std::vector<DeckPiece> owned_pieces(const Structure<3>& s, const FacetSet& set, double y, bool upper) {
  std::vector<DeckPiece> pieces;
  for (const auto& face : faces_of_set(s, set)) {
    const auto outward = face.outward[0] + face.outward[1] + face.outward[2] + face.outward[3];
    const bool bears = outward[2] > 0 && has_width({0, 0}, {outward[2], norm(outward)});
    if (face.node[0] >= s.owned_nodes() || !bears) continue;
    add_crossing(s, face, {0, 1, 2}, y, upper, pieces);
    if (face.count == 4) add_crossing(s, face, {0, 2, 3}, y, upper, pieces);
  }
  return pieces;
}

}  // namespace

template <int dim>
Deck pieces_of_deck(const Structure<dim>& s, const FacetSet& set, double across) {
  const WhyWhole line{"pieces of a line of facets"};
  Deck deck{all_gather(owned_pieces(s, set, across, false), *s.comm(), line), {}};
  auto& pieces = deck.pieces;
  // Where the line is the far side of the deck, all along or for a part, it lies on the other hand.
  std::vector<DeckPiece> beside;
  for (const auto& piece : all_gather(owned_pieces(s, set, across, true), *s.comm(), line)) {
    const double middle = (piece.x[0] + piece.x[1]) / 2;
    const auto covers = [&](const DeckPiece& p) { return p.x[0] <= middle && middle <= p.x[1]; };
    (std::none_of(pieces.begin(), pieces.end(), covers) ? beside : deck.other_hand).push_back(piece);
  }
  pieces.insert(pieces.end(), beside.begin(), beside.end());
  std::sort(pieces.begin(), pieces.end(), [](const DeckPiece& a, const DeckPiece& b) {
    return std::make_pair(a.x[0], a.id[0]) < std::make_pair(b.x[0], b.id[0]);
  });
  std::map<long long, int> local;
  for (int i = 0; i < s.nodes(); ++i) local[s.node_id()[i]] = i;
  for (auto& piece : pieces) {
    std::array<int, 4> node{-1, -1, -1, -1};
    for (std::size_t i = 0; i < piece.id.size(); ++i)
      if (const auto it = local.find(piece.id[i]); it != local.end()) node[i] = it->second;
    piece.local = bearers_of(s, node);
  }
  return deck;
}

template Deck pieces_of_deck<2>(const Structure<2>&, const FacetSet&, double);
template Deck pieces_of_deck<3>(const Structure<3>&, const FacetSet&, double);

}  // namespace voussoir
