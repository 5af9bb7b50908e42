// What supports prescribe of the motion of nodes: along the axes of the drawing, or along those of a frame of its own
// where a support holds a node along a normal. Unknowns of such a node are the components along its own axes.
#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "base/dense.hpp"

namespace voussoir {

class Held {
 public:
  Held() = default;
  /// @param along  1 where the motion of a node along an axis is prescribed [components x nodes]
  Held(std::vector<char> along) : along_(std::move(along)) {}

  std::size_t size() const { return along_.size(); }
  char operator[](std::size_t i) const { return along_[i]; }
  char& operator[](std::size_t i) { return along_[i]; }

  /// Own axes of a node, one a row, the third that of z in the plane.
  void set_frame(int node, const Matrix<3>& axes) { frame_[node] = axes; }
  bool has_frame(int node) const { return !frame_.empty() && frame_.count(node) > 0; }
  const std::map<int, Matrix<3>>& frames() const { return frame_; }

  /// From components along the axes of the drawing to those along the axes of a node, and back.
  template <std::size_t dim>
  std::array<double, dim> to_own(int node, const std::array<double, dim>& v) const {
    const auto* q = find(node);
    return q ? turned(*q, v) : v;
  }
  template <std::size_t dim>
  std::array<double, dim> from_own(int node, const std::array<double, dim>& v) const {
    const auto* q = find(node);
    return q ? turned_back(*q, v) : v;
  }
  /// What of a vector at a node nothing prescribes.
  template <std::size_t dim>
  std::array<double, dim> free_part(int node, const std::array<double, dim>& v) const {
    auto own = to_own(node, v);
    for (std::size_t c = 0; c < dim; ++c)
      if (along_[dim * static_cast<std::size_t>(node) + c]) own[c] = 0;
    return from_own(node, own);
  }
  /// What of vectors at nodes lies in directions that are held, zero in all others.
  std::vector<double> held_part(const std::vector<double>& field, int components) const {
    std::vector<double> part(field.size(), 0.0);
    for (std::size_t i = 0; i < field.size(); ++i)
      if (along_[i]) part[i] = field[i];
    for (const auto& [node, axes] : frame_) {
      const std::size_t first = static_cast<std::size_t>(components) * node;
      Vector<3> v{};
      std::copy_n(field.begin() + static_cast<long>(first), components, v.begin());
      auto own = turned(axes, v);
      for (int c = 0; c < components; ++c)
        if (!along_[first + c]) own[c] = 0;
      own = turned_back(axes, own);
      std::copy_n(own.begin(), components, part.begin() + static_cast<long>(first));
    }
    return part;
  }

  template <std::size_t dim>
  static std::array<double, dim> turned(const Matrix<3>& axes, const std::array<double, dim>& v) {
    std::array<double, dim> own{};
    for (std::size_t i = 0; i < dim; ++i)
      for (std::size_t j = 0; j < dim; ++j) own[i] += axes[i][j] * v[j];
    return own;
  }
  template <std::size_t dim>
  static std::array<double, dim> turned_back(const Matrix<3>& axes, const std::array<double, dim>& own) {
    std::array<double, dim> v{};
    for (std::size_t i = 0; i < dim; ++i)
      for (std::size_t j = 0; j < dim; ++j) v[j] += axes[i][j] * own[i];
    return v;
  }

 private:
  const Matrix<3>* find(int node) const {
    if (frame_.empty()) return nullptr;
    const auto at = frame_.find(node);
    return at == frame_.end() ? nullptr : &at->second;
  }

  std::vector<char> along_;
  std::map<int, Matrix<3>> frame_;
};

}  // namespace voussoir
