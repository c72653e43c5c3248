// In a cell the derivative along x is bilinear in y and z, and so on. So a directional derivative,
// a sum of the three, is linear in each coordinate alone; over the part of a cell inside the box it
// takes its extremes at the corners of that part. These corners are the nodes of a grid, formed by
// the faces of the box and the planes of samples between them. At a node each axis has at most two
// derivatives, below and above, and the parts around the node are all combinations of them. So the
// minimum of the sum is the sum of the minima.
#include "trilinear_slopes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fieldfab {
namespace {

constexpr int most_cells = 16 * 16 * 16;
constexpr std::size_t lanes = 8;  // partial results, for vectorisation

/// Nodes along an axis.
struct Axis {
  int first = 0, cells = 1;            // cells that the box meets
  float lower = 0, upper = 1;          // start of the box in the first cell, and its end in the last
  bool before = false, after = false;  // the box reaches beyond the samples, where nothing changes along the axis
  bool met = true;                     // the box meets the samples

  [[nodiscard]] std::size_t nodes() const { return static_cast<std::size_t>(cells) + 1; }
};

Axis axis_of(double lower, double upper, int size) {
  Axis axis;
  const double last = size - 1;
  axis.before = lower < 0;
  axis.after = upper > last;
  axis.met = upper > 0 && lower < last;
  lower = std::clamp(lower, 0.0, last);
  upper = std::clamp(upper, 0.0, last);
  axis.first = std::min(static_cast<int>(lower), size - 2);
  axis.cells = std::max(1, static_cast<int>(std::ceil(upper)) - axis.first);
  axis.lower = static_cast<float>(lower - axis.first);
  axis.upper = static_cast<float>(upper - (axis.first + axis.cells - 1));
  return axis;
}

/// Memory kept between calls, one number per node.
struct Space {
  std::vector<float> samples, trimmed;
  std::array<std::vector<float>, 3> least, most;  // derivatives along each axis
};

class Slopes {
 public:
  Slopes(const SampleGrid& grid, const std::array<Axis, 3>& axes, Space& space)
      : grid_(grid), axes_(axes), space_(space) {
    for (std::size_t axis = 0; axis < 3; ++axis) count_[axis] = axes[axis].nodes();
    stride_ = {1, count_[0], count_[0] * count_[1]};
    nodes_ = stride_[2] * count_[2];
  }

  /// Returns whether all samples are finite.
  bool prepare() {
    const std::size_t padded = (nodes_ + lanes - 1) / lanes * lanes;
    space_.samples.resize(padded);
    if (!gather()) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      space_.trimmed = space_.samples;
      for (std::size_t other = 0; other < 3; ++other)
        if (other != axis) trim(other);
      space_.least[axis].resize(padded);
      space_.most[axis].resize(padded);
      derive(axis);
      // The padding of the last lanes counts as well, so it repeats a node.
      std::fill(space_.least[axis].begin() + static_cast<std::ptrdiff_t>(nodes_), space_.least[axis].end(),
                space_.least[axis][0]);
      std::fill(space_.most[axis].begin() + static_cast<std::ptrdiff_t>(nodes_), space_.most[axis].end(),
                space_.most[axis][0]);
    }
    return true;
  }

  [[nodiscard]] Interval along(const Vec3& direction) const {
    std::array<const float*, 3> least, most;
    std::array<float, 3> d;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      d[axis] = static_cast<float>(direction[static_cast<Eigen::Index>(axis)]);
      least[axis] = (d[axis] < 0 ? space_.most : space_.least)[axis].data();
      most[axis] = (d[axis] < 0 ? space_.least : space_.most)[axis].data();
    }
    std::array<float, lanes> lower, upper;
    lower.fill(std::numeric_limits<float>::infinity());
    upper.fill(-std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < nodes_; i += lanes)
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const float low = d[0] * least[0][i + lane] + d[1] * least[1][i + lane] + d[2] * least[2][i + lane];
        const float high = d[0] * most[0][i + lane] + d[1] * most[1][i + lane] + d[2] * most[2][i + lane];
        lower[lane] = low < lower[lane] ? low : lower[lane];
        upper[lane] = high > upper[lane] ? high : upper[lane];
      }
    const Interval range{*std::min_element(lower.begin(), lower.end()), *std::max_element(upper.begin(), upper.end()),
                         false};
    return std::isfinite(range.lower) && std::isfinite(range.upper) ? range : Interval::unknown();
  }

 private:
  bool gather() {
    float total = 0;
    for (std::size_t k = 0; k < count_[2]; ++k)
      for (std::size_t j = 0; j < count_[1]; ++j) {
        const float* const row = grid_.samples + axes_[0].first +
                                 grid_.size[0] * (axes_[1].first + static_cast<std::ptrdiff_t>(j) +
                                                  grid_.size[1] * (axes_[2].first + static_cast<std::ptrdiff_t>(k)));
        float* const to = space_.samples.data() + stride_[1] * j + stride_[2] * k;
        for (std::size_t i = 0; i < count_[0]; ++i) to[i] = row[i], total += std::abs(row[i]);
      }
    return std::isfinite(total);
  }

  /// Calls visit(first) for the first node of each line along an axis.
  template <class Visit>
  void each_line(std::size_t axis, const Visit& visit) const {
    const std::size_t inner = axis == 0 ? 1 : 0, outer = axis == 2 ? 1 : 2;
    for (std::size_t b = 0; b < count_[outer]; ++b)
      for (std::size_t a = 0; a < count_[inner]; ++a) visit(a * stride_[inner] + b * stride_[outer]);
  }

  /// Moves the outermost nodes along an axis from the planes of samples to the faces of the box.
  void trim(std::size_t axis) {
    const Axis& ends = axes_[axis];
    if (ends.lower == 0 && ends.upper == 1) return;
    const std::size_t step = stride_[axis], end = (count_[axis] - 1) * step;
    float* const value = space_.trimmed.data();
    each_line(axis, [&](std::size_t first) {
      float *const low = value + first, *const high = low + end;
      const float lower = low[0] + (low[step] - low[0]) * ends.lower;
      const float upper = *(high - step) + (*high - *(high - step)) * ends.upper;
      *low = lower, *high = upper;
    });
  }

  /// Computes the least and the greatest derivative along an axis in the cells around each node.
  void derive(std::size_t axis) {
    const Axis& ends = axes_[axis];
    const std::size_t step = stride_[axis], count = count_[axis];
    const float per_mm = ends.met ? grid_.per_mm[axis] : 0;
    const float* const value = space_.trimmed.data();
    float *const least = space_.least[axis].data(), *const most = space_.most[axis].data();
    each_line(axis, [&](std::size_t first) {
      float below = (value[first + step] - value[first]) * per_mm;
      for (std::size_t i = 0, at = first; i < count; ++i, at += step) {
        const float above = i + 1 < count ? (value[at + step] - value[at]) * per_mm : below;
        least[at] = std::min(below, above), most[at] = std::max(below, above);
        below = above;
      }
      const auto hold_zero = [&](std::size_t at) {
        least[at] = std::min(least[at], 0.0F), most[at] = std::max(most[at], 0.0F);
      };
      if (ends.before) hold_zero(first);
      if (ends.after) hold_zero(first + (count - 1) * step);
    });
  }

  const SampleGrid& grid_;
  const std::array<Axis, 3>& axes_;
  Space& space_;
  std::array<std::size_t, 3> count_, stride_;
  std::size_t nodes_;
};

}  // namespace

void trilinear_slopes(const SampleGrid& grid, const Box& box, std::span<const Vec3> directions,
                      std::span<Interval> out) noexcept {
  std::fill_n(out.begin(), directions.size(), Interval::unknown());
  if (!box.valid()) return;
  std::array<Axis, 3> axes;
  double cells = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double per_mm = grid.per_mm[axis];
    axes[axis] =
        axis_of((box.lower[a] - grid.lower[a]) * per_mm, (box.upper[a] - grid.lower[a]) * per_mm, grid.size[axis]);
    cells *= axes[axis].cells;
  }
  if (cells > most_cells) return;
  static thread_local Space space;
  Slopes slopes(grid, axes, space);
  if (!slopes.prepare()) return;
  for (std::size_t i = 0; i < directions.size(); ++i) out[i] = slopes.along(directions[i]);
}

}  // namespace fieldfab
