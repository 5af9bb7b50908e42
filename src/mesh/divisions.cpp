#include "mesh/divisions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/lattice.hpp"

namespace voussoir {
namespace {

// Chords along a curved line that is divided evenly, or by a ratio, differ by their curvature: by less than 2 % for
// cells that turn by up to 20 degrees from one to the next.
constexpr double even = 0.02;
// Of a number of cells: far above the rounding of lengths, far below one.
constexpr double round_off = 1e-6;
// Cells up to this much shorter than wanted are what whole numbers bring about.
constexpr double far_shorter = 1.5;

/// Growth from each cell to the next; 0 when it varies.
double ratio_of(const std::vector<double>& lengths) {
  if (lengths.size() < 2) return 1;
  const double ratio = std::pow(lengths.back() / lengths.front(), 1.0 / static_cast<double>(lengths.size() - 1));
  for (std::size_t k = 1; k < lengths.size(); ++k)
    if (std::abs(lengths[k] / lengths[k - 1] / ratio - 1) > even) return 0;
  return std::abs(ratio - 1) < even / static_cast<double>(lengths.size()) ? 1 : ratio;
}

}  // namespace

std::vector<Division> divisions_for(const std::vector<DividedCurve>& curves, double wanted, const std::string& file) {
  int common = 0;
  double longest = 0;  // [m] cell of the file
  std::size_t most = 0;
  for (const DividedCurve& curve : curves) {
    common = std::gcd(common, static_cast<int>(curve.lengths.size()));
    most = std::max(most, curve.lengths.size());
    for (const double length : curve.lengths) longest = std::max(longest, length);
  }
  if (common == 0) return {};
  const auto refuse = [&](const std::string& why, const std::string& advice) {
    refuse_mesh("gmsh > element size", in_words(wanted) + " m", why,
                advice + ", or write DefineConstant[ element_size = ... ]; in the file and use the number there.");
  };
  const double coarsest = longest * common;  // [m] with as few cells as can be
  if (wanted > far_shorter * coarsest && most > static_cast<std::size_t>(common))
    refuse("cannot be had: " + file + " divides curves itself (Transfinite Curve) into cells of " + in_words(longest) +
               " m at most, whose numbers have the common divisor " + std::to_string(common) + ".",
           "Give at most " + in_words(far_shorter * coarsest));
  const int times = std::max(1, static_cast<int>(std::ceil(coarsest / wanted - round_off)));
  if (times == common) return {};
  std::vector<Division> divisions;
  for (const DividedCurve& curve : curves) {
    const int before = static_cast<int>(curve.lengths.size()), cells = before / common * times;
    const double ratio = ratio_of(curve.lengths);
    if (ratio == 0)
      refuse("cannot be had: " + file + " divides curve " + std::to_string(curve.tag) +
                 " into cells that grow neither evenly nor by a constant ratio (Bump?).",
             "Divide it by Progression");
    divisions.push_back({curve.tag, cells, std::pow(ratio, static_cast<double>(before) / cells)});
  }
  return divisions;
}

std::vector<DividedCurve> curves_divided_alike(const std::map<int, std::vector<double>>& one,
                                               const std::map<int, std::vector<double>>& other, double unit) {
  std::vector<DividedCurve> divided;
  for (const auto& [tag, cells] : one)
    if (const auto found = other.find(tag); found != other.end() && found->second.size() == cells.size()) {
      divided.push_back({tag, cells});
      for (double& cell : divided.back().lengths) cell *= unit;
    }
  return divided;
}

std::vector<double> edge_lengths(const std::vector<double>& along, const std::vector<double>& x) {
  std::vector<std::size_t> order(std::min(x.size() / 3, along.size()));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return along[a] < along[b]; });
  std::vector<double> lengths;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const double *a = &x[3 * order[k - 1]], *b = &x[3 * order[k]];
    lengths.push_back(std::hypot(b[0] - a[0], b[1] - a[1]));
  }
  return lengths;
}

}  // namespace voussoir
