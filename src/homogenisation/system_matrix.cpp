#include "homogenisation/system_matrix.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "base/components.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

template <class View>
View without_values(std::size_t size) {
  return View(Kokkos::view_alloc(Kokkos::WithoutInitializing, "H"), size);
}

/// Neighbours of owned nodes, in compressed rows: all is counted first, then filled in.
class Neighbours {
 public:
  explicit Neighbours(int nodes) : start_(nodes + 1, 0) {}
  void count(int node, std::size_t more) { start_[node + 1] += more; }
  void begin_filling() {
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    neighbour_.resize(start_.back());
    end_.assign(start_.begin(), start_.end() - 1);
  }
  void add(int node, int neighbour) { neighbour_[end_[node]++] = neighbour; }
  /// Each row ascending and without doubles.
  void sort() {
    for (std::size_t i = 0; i < end_.size(); ++i) {
      std::sort(begin(i), end(i));
      end_[i] = std::unique(begin(i), end(i)) - neighbour_.begin();
    }
  }
  std::vector<int>::iterator begin(std::size_t node) { return neighbour_.begin() + static_cast<long>(start_[node]); }
  std::vector<int>::iterator end(std::size_t node) { return neighbour_.begin() + static_cast<long>(end_[node]); }

 private:
  std::vector<std::size_t> start_, end_;
  std::vector<int> neighbour_;
};

}  // namespace

SystemMatrix::SystemMatrix(const BlockSystem& structure, const ContactPoints& points, const std::vector<char>& selected,
                           const MergedSpace& space, Matrix NodesOfBlock::*of_block)
    : dim_(structure.components()),
      structure_(structure),
      points_(points),
      selected_(selected),
      space_(space),
      of_block_(of_block) {
  set_pattern();
  add_stiffness();
  remember_stiffness_of_points();
  matrix_ = Teuchos::rcp(new TpetraMatrix(space.map(), space.column_map(), start_, column_, value_));
  matrix_->expertStaticFillComplete(space.map(), space.map());
}

/// By nodes: neighbours within a block, and across selected points.
void SystemMatrix::set_pattern() {
  const int dim = dim_;
  const auto& cluster = space_.cluster();
  const int owned = space_.owned_clusters();
  Neighbours neighbours(owned);
  const auto for_all = [&](const auto& of_block, const auto& of_point) {
    for (int block = 0; block < structure_.local_blocks(); ++block) {
      const auto& b = structure_.nodes_of(block);
      for (int i = 0; i < b.nodes; ++i)
        if (cluster[b.first_local + i] < owned) of_block(b, i);
    }
    for (int k = 0; k < points_.size(); ++k) {
      if (!selected_[k]) continue;
      points_.at(k).each_pair([&](int a, int b, double) {
        if (a != b && cluster[a] < owned) of_point(cluster[a], cluster[b]);
      });
    }
  };
  for_all(
      [&](const NodesOfBlock& b, int i) {
        neighbours.count(cluster[b.first_local + i],
                         ((b.*of_block_)->start[dim * i + 1] - (b.*of_block_)->start[dim * i]) / dim);
      },
      [&](int a, int) { neighbours.count(a, 1); });
  neighbours.begin_filling();
  for_all(
      [&](const NodesOfBlock& b, int i) {
        for (int e = (b.*of_block_)->start[dim * i]; e < (b.*of_block_)->start[dim * i + 1]; e += dim)
          neighbours.add(cluster[b.first_local + i], cluster[b.first_local + (b.*of_block_)->column[e] / dim]);
      },
      [&](int a, int b) { neighbours.add(a, b); });
  neighbours.sort();

  std::size_t entries = 0;
  for (int k = 0; k < owned; ++k) entries += dim * dim * (neighbours.end(k) - neighbours.begin(k));
  start_ = without_values<decltype(start_)>(static_cast<std::size_t>(dim) * owned + 1);
  column_ = without_values<decltype(column_)>(entries);
  std::size_t next = 0;
  for (int k = 0; k < owned; ++k)
    for (int c = 0; c < dim; ++c) {
      start_(dim * k + c) = next;
      for (auto j = neighbours.begin(k); j != neighbours.end(k); ++j)
        for (int d = 0; d < dim; ++d) column_(next++) = dim * *j + d;
    }
  start_(dim * owned) = next;
}

void SystemMatrix::add_stiffness() {
  const int dim = dim_;
  const auto& cluster = space_.cluster();
  const int owned = space_.owned_clusters();
  value_ = without_values<decltype(value_)>(column_.extent(0));
  Kokkos::deep_copy(value_, 0.0);
  for (int block = 0; block < structure_.local_blocks(); ++block) {
    const auto& b = structure_.nodes_of(block);
    const auto& k = *(b.*of_block_);
    for (int n = 0; n < b.nodes; ++n) {
      const int node = cluster[b.first_local + n];
      if (node >= owned) continue;
      const int row = k.start[dim * n], length = k.start[dim * n + 1] - row;
      for (int e = 0; e < length; e += dim) {
        const int other = cluster[b.first_local + k.column[row + e] / dim];
        add_along_own(node, other, [&](int i, int j) { return k.value[row + i * length + e + j]; });
      }
    }
  }
  const auto& held = space_.held();
  for (int row = 0; row < dim * owned; ++row)
    for (std::size_t e = start_(row); e < start_(row + 1); ++e)
      if (column_(e) != row && (held[row] || held[column_(e)])) value_(e) = 0;
  diagonal_.resize(owned);
  diagonal_stiffness_.reserve(static_cast<std::size_t>(dim) * dim * owned);
  for (int k = 0; k < owned; ++k) {
    diagonal_[k] = static_cast<int>(offset(k, k));
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) diagonal_stiffness_.push_back(entry(k, diagonal_[k], i, j));
  }
}

/// Adds a matrix between two nodes, given along the axes of the drawing, along their own.
template <class Value>
void SystemMatrix::add_along_own(int node, int other, const Value& value) {
  const auto& held = space_.held();
  const auto at = offset(node, other);
  if (!held.has_frame(node) && !held.has_frame(other)) {
    for (int i = 0; i < dim_; ++i)
      for (int j = 0; j < dim_; ++j) entry(node, at, i, j) += value(i, j);
    return;
  }
  std::array<Vector<3>, 3> half{};  // columns turned
  for (int i = 0; i < dim_; ++i) {
    Vector<3> row{};
    for (int j = 0; j < dim_; ++j) row[j] = value(i, j);
    half[i] = held.to_own(other, row);
  }
  for (int j = 0; j < dim_; ++j) {
    const auto column = held.to_own(node, Vector<3>{half[0][j], half[1][j], half[2][j]});
    for (int i = 0; i < dim_; ++i) entry(node, at, i, j) += column[i];
  }
}

/// Where the columns of a node begin in the rows of another.
std::size_t SystemMatrix::offset(int node, int other) const {
  const int* first = &column_(start_(dim_ * node));
  const int* last = column_.data() + start_(dim_ * node + 1);
  const int* it = std::lower_bound(first, last, dim_ * other);
  VOUSSOIR_ASSERT(it != last && *it == dim_ * other);
  return it - first;
}

/// Whether a point moves two nodes against each other.
bool SystemMatrix::couples(int k) const { return selected_[k] && !space_.tied(points_.points()[k]); }

/// Calls f(node, offset) for every owned block of two different nodes that a point couples.
template <class F>
void SystemMatrix::each_place_of_points(const F& f) {
  const auto& cluster = space_.cluster();
  for (int k = 0; k < points_.size(); ++k) {
    if (!couples(k)) continue;
    points_.at(k).each_pair([&](int a, int b, double) {
      const int row = cluster[a], column = cluster[b];
      if (row != column && row < space_.owned_clusters()) f(row, offset(row, column));
    });
  }
}

void SystemMatrix::remember_stiffness_of_points() {
  if (points_.untieable().empty()) return;  // two coincident nodes are of two blocks
  each_place_of_points([&](int node, std::size_t at) {
    Remembered one{node, at, {}};
    bool any = false;
    for (int i = 0; i < dim_; ++i)
      for (int j = 0; j < dim_; ++j) any |= (one.stiffness[dim_ * i + j] = entry(node, at, i, j)) != 0;
    if (any) remembered_.push_back(one);
  });
}

/// Adds w_ij (d_i, d_j) for the motion d of one side of a point against the other.
/// @param weight  of (axes of the point as the row sees them, as the column does, i, j)
template <int dim, class Weight>
void SystemMatrix::add_between(int k, const Weight& weight) {
  const auto& axis = points_.points()[k].axis;
  const auto& cluster = space_.cluster();
  const auto& held = space_.held();
  const bool turned = !held.frames().empty();
  const auto own = [&](int node) {
    auto axes = axis;
    for (auto& a : axes) a = held.to_own(node, a);
    return axes;
  };
  points_.at(k).each_pair([&](int of_row, int of_column, double share) {
    const int row = cluster[of_row], column = cluster[of_column];
    if (row >= space_.owned_clusters()) return;
    const auto at = row == column ? diagonal_[row] : offset(row, column);
    const auto add = [&](const auto& left, const auto& right) {
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          if (!held[dim * row + i] && !held[dim * column + j])
            entry(row, at, i, j) += share * weight(left, right, i, j);
    };
    if (turned)
      add(own(row), own(column));
    else
      add(axis, axis);
  });
}

template <int dim>
void SystemMatrix::add_points(const std::vector<PointStiffness>& all) {
  for (int k = 0; k < points_.size(); ++k) {
    if (!couples(k) || !(all[k].normal > 0 || all[k].resists_slip())) continue;
    const auto stiffness = all[k].springs();
    add_between<dim>(k, [&](const auto& left, const auto& right, int i, int j) {
      double value = stiffness.normal * left[0][i] * right[0][j];
      for (int t = 1; t < dim; ++t)
        for (int u = 1; u < dim; ++u) value += stiffness.along(t - 1, u - 1) * left[t][i] * right[u][j];
      return value;
    });
  }
}

template <int dim>
void SystemMatrix::add_couplings(int k, const PointStiffness& all) {
  const auto springs = all.springs();  // which update() has added
  add_between<dim>(k, [&](const auto& left, const auto& right, int i, int j) {
    double value = (all.normal - springs.normal) * left[0][i] * right[0][j];
    for (int t = 1; t < dim; ++t) {
      value += all.coupling[t - 1] * left[t][i] * right[0][j] + all.pull[t - 1] * left[0][i] * right[t][j];
      for (int u = 1; u < dim; ++u)
        value += (all.along(t - 1, u - 1) - springs.along(t - 1, u - 1)) * left[t][i] * right[u][j];
    }
    return value;
  });
}

bool SystemMatrix::couple(const std::vector<PointStiffness>& stiffness) {
  bool coupled = false;
  for (int k = 0; k < points_.size(); ++k) {
    if (!selected_[k] || !stiffness[k].couples()) continue;
    coupled = true;
    if (couples(k)) with_components(dim_, [&](auto dim) { add_couplings<dim>(k, stiffness[k]); });
  }
  return any_of_ranks(*matrix_->getComm(), coupled);
}

/// Leaves the stiffness of blocks alone.
void SystemMatrix::forget_points() {
  const auto* stiffness = diagonal_stiffness_.data();
  for (int k = 0; k < space_.owned_clusters(); ++k)
    for (int i = 0; i < dim_; ++i)
      for (int j = 0; j < dim_; ++j) entry(k, diagonal_[k], i, j) = *stiffness++;
  each_place_of_points([&](int node, std::size_t at) {
    for (int i = 0; i < dim_; ++i)
      for (int j = 0; j < dim_; ++j) entry(node, at, i, j) = 0;
  });
  for (const auto& r : remembered_)
    for (int i = 0; i < dim_; ++i)
      for (int j = 0; j < dim_; ++j) entry(r.node, r.offset, i, j) = r.stiffness[dim_ * i + j];
}

void SystemMatrix::update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal) {
  forget_points();
  with_components(dim_, [&](auto dim) { add_points<dim>(stiffness); });
  if (proximal.empty()) return;
  for (int i = 0; i < dim_ * space_.owned_clusters(); ++i)
    if (!space_.held()[i]) entry(i / dim_, diagonal_[i / dim_], i % dim_, i % dim_) += proximal[i];
}

long long SystemMatrix::bytes() const {
  const auto size_of = [](const auto& list, std::size_t each) { return static_cast<long long>(list.size() * each); };
  return size_of(start_, sizeof(std::size_t)) + size_of(column_, sizeof(int)) + size_of(value_, sizeof(double)) +
         size_of(diagonal_, sizeof(int)) + size_of(diagonal_stiffness_, sizeof(double)) +
         size_of(remembered_, sizeof(Remembered));
}

}  // namespace voussoir
