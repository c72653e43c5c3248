#include "fieldfab/volume/volume_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "../field/interval_sums.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/operations.h"
#include "trilinear_slopes.h"

namespace fieldfab {
namespace {

/// Appends the steepness, in density per mm, of the cells between two slices that the surface
/// crosses.
void collect_steepness(const SampleLattice& lattice, const float* lower, const float* upper, double threshold,
                       std::vector<float>& steepness) {
  const auto width = static_cast<std::size_t>(lattice.size[0]);
  for (std::size_t j = 0; j + 1 < static_cast<std::size_t>(lattice.size[1]); ++j)
    for (std::size_t i = 0; i + 1 < width; ++i) {
      const std::size_t at = j * width + i;
      std::array<double, 8> corner;
      unsigned solid = 0;
      for (std::size_t c = 0; c < 8; ++c) {
        corner[c] = (c < 4 ? lower : upper)[at + (c & 1) + (c >> 1 & 1) * width];
        solid |= static_cast<unsigned>(corner[c] > threshold) << c;
      }
      if (solid == 0 || solid == 255) continue;
      double squares = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double difference = 0;
        for (std::size_t c = 0; c < 8; ++c) difference += (c >> axis & 1) != 0 ? corner[c] : -corner[c];
        const double slope = difference / 4 / lattice.spacing[static_cast<Eigen::Index>(axis)];
        squares += slope * slope;
      }
      if (squares > 0) steepness.push_back(static_cast<float>(std::sqrt(squares)));
    }
}

constexpr int block = 8;  // cells per side of a block whose least and greatest values are kept

/// Trilinear interpolation between samples, which are kept as values of the Field.
class VolumeField final : public Field {
 public:
  VolumeField(std::unique_ptr<const float[]> samples, const SampleLattice& lattice)
      : samples_(std::move(samples)),
        size_(lattice.size),
        stride_{1, static_cast<std::size_t>(size_[0]), lattice.slice()},
        box_(lattice.box()) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      per_mm_[axis] = static_cast<float>(1 / lattice.spacing[a]);
      // Slightly beyond the outermost samples, so that their densities decide whether they are in
      // the solid.
      const double farthest = std::max(std::abs(box_.lower[a]), std::abs(box_.upper[a]));
      const double behind = std::max(std::ldexp(lattice.spacing[a], -10), std::ldexp(farthest, -20));
      faces_[0][axis] = static_cast<float>(box_.lower[a] - behind),
      faces_[1][axis] = static_cast<float>(box_.upper[a] + behind);
      blocks_[axis] = (size_[axis] - 1 + block - 1) / block;
    }
    find_extremes();
  }

  void values(const Points& points, float* out) const noexcept override {
    // Many points are in rows, and have y and z in common with the one before.
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    std::array<float, 3> before{none, none, none};
    std::array<Coordinate, 3> at{};
    for (std::size_t i = 0; i < points.count; ++i) {
      const std::array<float, 3> point{points.x[i], points.y[i], points.z[i]};
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (point[axis] != before[axis]) at[axis] = find(axis, point[axis]);
      before = point;
      out[i] = std::max(interpolate(at).value, at[axis_beyond(at)].beyond);
    }
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    for (std::size_t i = 0; i < points.count; ++i) {
      const std::array<Coordinate, 3> at{find(0, points.x[i]), find(1, points.y[i]), find(2, points.z[i])};
      const Interpolated here = interpolate(at);
      const std::size_t out_along = axis_beyond(at);
      const bool capped = at[out_along].beyond > here.value;
      out[i] = capped ? at[out_along].beyond : here.value;
      const std::array<float*, 3> to{slopes.dx + i, slopes.dy + i, slopes.dz + i};
      for (std::size_t axis = 0; axis < 3; ++axis)
        *to[axis] = !capped ? here.slope[axis] * per_mm_[axis] : axis == out_along ? at[axis].outwards : 0.0F;
    }
  }
  [[nodiscard]] Box known_bounds() const noexcept override {
    Box bounds;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      bounds.lower[a] = faces_[0][axis], bounds.upper[a] = faces_[1][axis];
    }
    return bounds;
  }
  [[nodiscard]] bool sampled() const noexcept override { return true; }

  [[nodiscard]] std::optional<Sampling> sampling() const noexcept override {
    return Sampling{box_.lower,
                    (box_.upper - box_.lower).array() / Eigen::Array3d(size_[0] - 1, size_[1] - 1, size_[2] - 1)};
  }
  /// True in one cell between samples; also in a cell beyond the outermost ones, since the solid
  /// ends slightly beyond them and has the border's values up to there.
  [[nodiscard]] bool corners_tell(const Box& box) const noexcept override {
    constexpr double slack = 1e-3;  // of a cell: rounding may select the neighbouring cell, which agrees on the border
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      const double lower = (box.lower[a] - box_.lower[a]) * per_mm_[axis],
                   upper = (box.upper[a] - box_.lower[a]) * per_mm_[axis];
      if (!(upper < std::floor(lower + slack) + 1 + slack)) return false;
    }
    return true;
  }

  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    const Interval inside = interpolated_over(box), cap = beyond_over(box);
    return {std::max(inside.lower, cap.lower), std::max(inside.upper, cap.upper), false};
  }
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    const Interval inside = interpolated_over(box), cap = beyond_over(box);
    if (inside.upper >= cap.lower)
      trilinear_slopes({samples_.get(), size_, box_.lower, per_mm_}, box, directions, out);
    else
      std::fill_n(out.begin(), directions.size(), no_slope);
    if (cap.upper < inside.lower) return;
    // Sides of the lattice from which a point of the box can be as far as its value.
    const float least = std::max(inside.lower, cap.lower);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const bool below = faces_[0][a] - static_cast<float>(box.lower[axis]) >= least;
      const bool above = static_cast<float>(box.upper[axis]) - faces_[1][a] >= least;
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const auto along = static_cast<float>(directions[i][axis]);
        if (below) out[i] = hull(out[i], Interval::of(-along));
        if (above) out[i] = hull(out[i], Interval::of(along));
      }
    }
  }
  [[nodiscard]] std::size_t cost() const noexcept override { return 40; }

 private:
  static constexpr Interval no_slope{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                                     false};

  /// Interval of the interpolation, without the ends of the samples.
  [[nodiscard]] Interval interpolated_over(const Box& box) const {
    std::array<int, 3> first, last;  // cells that the box meets
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      const auto cell = [&](double at) {
        const double place = (at - box_.lower[a]) * per_mm_[axis];
        return static_cast<int>(std::clamp(std::isnan(place) ? 0.0 : place, 0.0, size_[axis] - 2.0));
      };
      // Coordinates are rounded to floats before the lookup.
      const double slack = 1e-3 / per_mm_[axis] + 1e-6 * (std::abs(box_.lower[a]) + std::abs(box_.upper[a]));
      first[axis] = cell(box.lower[a] - slack), last[axis] = cell(box.upper[a] + slack);
    }
    Extremes found = extremes_of_cells(first, last);
    const float rounding = 4e-6F * std::max(std::abs(found.least), std::abs(found.most));
    return {found.least - rounding, found.most + rounding, false};
  }

  struct Extremes {
    float least = std::numeric_limits<float>::infinity(), most = -std::numeric_limits<float>::infinity();
    void add(float value) { least = std::min(least, value), most = std::max(most, value); }
    void add(const Extremes& other) { least = std::min(least, other.least), most = std::max(most, other.most); }
  };
  struct Interpolated {
    float value;
    std::array<float, 3> slope;  // per cell
  };

  [[nodiscard]] std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i) + stride_[1] * static_cast<std::size_t>(j) +
           stride_[2] * static_cast<std::size_t>(k);
  }

  /// A coordinate of a point.
  struct Coordinate {
    std::size_t sample;  ///< offset of the first sample of its cell
    float within;        ///< 0 to 1
    float beyond;        ///< distance from the nearer of the two sides of the samples, negative between them
    float outwards;      ///< 1 if that is the upper side, -1 if it is the lower one
  };

  /// A point outside the lattice is moved to the nearest point in it; NaN counts as the lower corner.
  [[nodiscard]] Coordinate find(std::size_t axis, float at) const {
    const double sample = (at - box_.lower[static_cast<Eigen::Index>(axis)]) * per_mm_[axis];
    const double inside = sample > 0 ? std::min(sample, size_[axis] - 1.0) : 0.0;
    const int cell = std::min(static_cast<int>(inside), size_[axis] - 2);
    const float below = faces_[0][axis] - at, above = at - faces_[1][axis];
    const bool upper = above > below;
    return {stride_[axis] * static_cast<std::size_t>(cell), static_cast<float>(inside - cell), upper ? above : below,
            upper ? 1.0F : -1.0F};
  }
  /// The axis along which a point is farthest beyond the samples. The solid ends there.
  [[nodiscard]] static std::size_t axis_beyond(const std::array<Coordinate, 3>& at) {
    std::size_t farthest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
      if (!(at[axis].beyond <= at[farthest].beyond)) farthest = axis;
    return farthest;
  }

  [[nodiscard]] Interpolated interpolate(const std::array<Coordinate, 3>& at) const {
    const float* const s = samples_.get() + at[0].sample + at[1].sample + at[2].sample;
    const std::size_t row = stride_[1], slice = stride_[2];
    const float u = at[0].within, v = at[1].within, w = at[2].within;
    const auto mix = [](float a, float b, float t) { return a + (b - a) * t; };
    const std::array<float, 4> along_x{mix(s[0], s[1], u), mix(s[row], s[row + 1], u), mix(s[slice], s[slice + 1], u),
                                       mix(s[slice + row], s[slice + row + 1], u)};
    const float lower = mix(along_x[0], along_x[1], v), upper = mix(along_x[2], along_x[3], v);
    const float dx = mix(mix(s[1] - s[0], s[row + 1] - s[row], v),
                         mix(s[slice + 1] - s[slice], s[slice + row + 1] - s[slice + row], v), w);
    return {mix(lower, upper, w), {dx, mix(along_x[1] - along_x[0], along_x[3] - along_x[2], w), upper - lower}};
  }

  /// Interval, over a box, of the distance by which points are beyond the samples.
  [[nodiscard]] Interval beyond_over(const Box& box) const {
    Interval range{-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(), false};
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const auto lower = static_cast<float>(box.lower[axis]), upper = static_cast<float>(box.upper[axis]);
      range.lower = std::max({range.lower, faces_[0][a] - upper, lower - faces_[1][a]});
      range.upper = std::max({range.upper, faces_[0][a] - lower, upper - faces_[1][a]});
    }
    return range;
  }

  void find_extremes() {
    extremes_.resize(static_cast<std::size_t>(blocks_[0]) * static_cast<std::size_t>(blocks_[1]) *
                     static_cast<std::size_t>(blocks_[2]));
    parallel_for(static_cast<std::size_t>(blocks_[2]), [&](std::size_t layer) {
      const int bz = static_cast<int>(layer);
      for (int by = 0; by < blocks_[1]; ++by)
        for (int bx = 0; bx < blocks_[0]; ++bx) {
          Extremes& here = extremes_[block_index(bx, by, bz)];
          here = samples_between({bx * block, by * block, bz * block},
                                 {std::min((bx + 1) * block, size_[0] - 1), std::min((by + 1) * block, size_[1] - 1),
                                  std::min((bz + 1) * block, size_[2] - 1)});
        }
    });
  }
  [[nodiscard]] std::size_t block_index(int x, int y, int z) const {
    return static_cast<std::size_t>(x) +
           static_cast<std::size_t>(blocks_[0]) *
               (static_cast<std::size_t>(y) + static_cast<std::size_t>(blocks_[1]) * static_cast<std::size_t>(z));
  }

  /// Both ends included.
  [[nodiscard]] Extremes samples_between(const std::array<int, 3>& first, const std::array<int, 3>& last) const {
    constexpr int lanes = 4;  // partial results, for vectorisation
    std::array<float, lanes> least, most;
    least.fill(std::numeric_limits<float>::infinity());
    most.fill(-std::numeric_limits<float>::infinity());
    const int count = last[0] - first[0] + 1;
    const auto add = [&](const float* value, std::size_t many) {
      for (std::size_t lane = 0; lane < many; ++lane) {
        least[lane] = value[lane] < least[lane] ? value[lane] : least[lane];
        most[lane] = value[lane] > most[lane] ? value[lane] : most[lane];
      }
    };
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j) {
        const float* const row = samples_.get() + index(first[0], j, k);
        if (count < lanes) {
          add(row, static_cast<std::size_t>(count));
          continue;
        }
        for (int i = 0; i < count - lanes; i += lanes) add(row + i, lanes);
        add(row + count - lanes, lanes);
      }
    return {*std::min_element(least.begin(), least.end()), *std::max_element(most.begin(), most.end())};
  }

  /// Few samples are examined one by one, many by their blocks.
  [[nodiscard]] Extremes extremes_of_cells(const std::array<int, 3>& first, const std::array<int, 3>& last) const {
    double cells = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) cells *= last[axis] - first[axis] + 1;
    if (cells <= 4096) return samples_between(first, {last[0] + 1, last[1] + 1, last[2] + 1});
    Extremes found;
    for (int z = first[2] / block; z <= last[2] / block; ++z)
      for (int y = first[1] / block; y <= last[1] / block; ++y)
        for (int x = first[0] / block; x <= last[0] / block; ++x) found.add(extremes_[block_index(x, y, z)]);
    return found;
  }

  std::unique_ptr<const float[]> samples_;
  std::array<int, 3> size_;
  std::array<std::size_t, 3> stride_;
  Box box_;
  std::array<float, 3> per_mm_{};
  std::array<std::array<float, 3>, 2> faces_{};  // end of the solid: lower, upper
  std::array<int, 3> blocks_{};
  std::vector<Extremes> extremes_;
};

}  // namespace

Isosurface isosurface(const Volume& volume, double threshold, bool below) {
  constexpr int most_pairs = 32;
  const SampleLattice& lattice = volume.lattice();
  const int pairs = std::min(lattice.size[2] - 1, most_pairs);
  std::vector<std::vector<float>> between(static_cast<std::size_t>(pairs));  // steepness, by pair
  parallel_for(between.size(), [&](std::size_t pair) {
    std::vector<float> slices(2 * lattice.slice());
    volume.read(static_cast<int>((static_cast<double>(pair) + 0.5) * (lattice.size[2] - 1) / pairs), 2, slices.data());
    collect_steepness(lattice, slices.data(), slices.data() + lattice.slice(), threshold, between[pair]);
  });
  std::vector<float> steepness;
  for (const std::vector<float>& some : between) steepness.insert(steepness.end(), some.begin(), some.end());
  if (steepness.empty()) return {threshold, below, 1};
  const auto middle = steepness.begin() + static_cast<std::ptrdiff_t>(steepness.size() / 2);
  std::nth_element(steepness.begin(), middle, steepness.end());
  return {threshold, below, 1 / static_cast<double>(*middle)};
}

FieldPtr volume_field(const Volume& volume, const Isosurface& surface, Progress& progress) {
  const SampleLattice& lattice = volume.lattice();
  require_memory(lattice.count() * sizeof(float), "volume");
  auto samples = std::make_unique_for_overwrite<float[]>(lattice.count());
  parallel_for(static_cast<std::size_t>(lattice.size[2]), [&](std::size_t k) {
    progress.check();
    const std::span slice(samples.get() + k * lattice.slice(), lattice.slice());
    volume.read(static_cast<int>(k), 1, slice.data());
    for (float& sample : slice) sample = surface.value(sample);
  });
  progress.check();
  const FieldPtr solid = std::make_shared<VolumeField>(std::move(samples), lattice);
  progress.check();
  return lattice.straight() ? solid : transform(solid, lattice.placement());
}

}  // namespace fieldfab
