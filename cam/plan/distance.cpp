// Distance transform by Meijster, Roerdink and Hesselink, and a lattice as a Field.
#include "fieldfab/cam/plan/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fieldfab/core/parallel.h"

namespace fieldfab::cam {
namespace {

constexpr int block = 64;  // columns or rows per task: whole cache lines

std::size_t blocks(int count) { return static_cast<std::size_t>((count + block - 1) / block); }

/// First pass: number of samples to the nearest solid sample of the column; `far` if there is none.
Lattice<std::int32_t> column_distances(const Bitmap& bitmap, std::int32_t far, Progress& progress) {
  Lattice<std::int32_t> steps(bitmap.width, bitmap.height, bitmap.cell, bitmap.origin, far);
  parallel_for(blocks(bitmap.width), [&](std::size_t b) {
    progress.check();
    const int left = static_cast<int>(b) * block, right = std::min(bitmap.width, left + block);
    const auto relax = [&](int row, int from) {
      const std::uint8_t* const solid = bitmap.row(row);
      std::int32_t* const here = steps.row(row);
      const std::int32_t* const before = from < 0 || from >= bitmap.height ? nullptr : steps.row(from);
      for (int column = left; column < right; ++column) {
        const std::int32_t next = before == nullptr ? far : std::min(before[column] + 1, far);
        here[column] = solid[column] != 0 ? 0 : std::min(here[column], next);
      }
    };
    for (int row = 0; row < bitmap.height; ++row) relax(row, row - 1);
    for (int row = bitmap.height - 1; row >= 0; --row) relax(row, row + 1);
  });
  return steps;
}

/// Second pass for one row: lower envelope of the parabolas (x - i)^2 + g(i)^2.
void row_distances(const std::int32_t* g, int width, std::int32_t far, double cell, float* out,
                   std::vector<std::int64_t>& start, std::vector<int>& site) {
  const auto squared = [&](std::int64_t x, int i) {
    return (x - i) * (x - i) + static_cast<std::int64_t>(g[i]) * g[i];
  };
  int count = 0;
  for (int u = 0; u < width; ++u) {
    if (g[u] == far) continue;
    while (count > 0 && squared(start[static_cast<std::size_t>(count) - 1], site[static_cast<std::size_t>(count) - 1]) >
                            squared(start[static_cast<std::size_t>(count) - 1], u))
      --count;
    std::int64_t from = 0;
    if (count > 0) {
      // first position at which u is nearer than i
      const int i = site[static_cast<std::size_t>(count) - 1];
      const std::int64_t numerator = static_cast<std::int64_t>(u) * u - static_cast<std::int64_t>(i) * i +
                                     static_cast<std::int64_t>(g[u]) * g[u] - static_cast<std::int64_t>(g[i]) * g[i];
      const std::int64_t divisor = 2LL * (u - i);
      from = 1 + (numerator >= 0 ? numerator / divisor : -((-numerator + divisor - 1) / divisor));
      if (from >= width) continue;
    }
    site[static_cast<std::size_t>(count)] = u;
    start[static_cast<std::size_t>(count++)] = from;
  }
  if (count == 0) return std::fill_n(out, width, std::numeric_limits<float>::infinity()), void();
  for (int x = width - 1; x >= 0; --x) {
    out[x] = static_cast<float>(cell *
                                std::sqrt(static_cast<double>(squared(x, site[static_cast<std::size_t>(count) - 1]))));
    if (count > 1 && x == start[static_cast<std::size_t>(count) - 1]) --count;
  }
}

}  // namespace

Lattice<float> distance_transform(const Bitmap& bitmap, Progress& progress) {
  const std::int32_t far = bitmap.width + bitmap.height;
  const Lattice<std::int32_t> steps = column_distances(bitmap, far, progress);
  Lattice<float> distance(bitmap.width, bitmap.height, bitmap.cell, bitmap.origin, 0.0F);
  parallel_for(blocks(bitmap.height), [&](std::size_t b) {
    progress.check();
    std::vector<std::int64_t> start(static_cast<std::size_t>(bitmap.width));
    std::vector<int> site(static_cast<std::size_t>(bitmap.width));
    const int top = static_cast<int>(b) * block, end = std::min(bitmap.height, top + block);
    for (int row = top; row < end; ++row)
      row_distances(steps.row(row), bitmap.width, far, bitmap.cell, distance.row(row), start, site);
  });
  return distance;
}

Lattice<float> signed_distance(const Bitmap& bitmap, Progress& progress) {
  Bitmap others = bitmap;
  for (std::uint8_t& sample : others.values) sample = sample == 0 ? 1 : 0;
  Lattice<float> outside = distance_transform(bitmap, progress);
  const Lattice<float> inside = distance_transform(others, progress);
  const auto half = static_cast<float>(bitmap.cell / 2);
  for (std::size_t i = 0; i < outside.values.size(); ++i)
    outside.values[i] = bitmap.values[i] != 0 ? half - inside.values[i] : outside.values[i] - half;
  return outside;
}

namespace {

/// Bilinear interpolation of a lattice; intervals by the minimum and maximum of tiles of samples.
class LatticeField final : public Field {
 public:
  explicit LatticeField(Lattice<float> lattice) : lattice_(std::move(lattice)) {
    tiles_wide_ = (lattice_.width + tile - 1) / tile;
    const int tiles_high = (lattice_.height + tile - 1) / tile;
    for (int v = 0; v < tiles_high; ++v)
      for (int u = 0; u < tiles_wide_; ++u)
        // One sample more, so that the tile covers the squares that start in it.
        tiles_.push_back(range_of(u * tile, v * tile, std::min(lattice_.width - 1, (u + 1) * tile),
                                  std::min(lattice_.height - 1, (v + 1) * tile)));
  }

  void values(const Points& points, float* out) const noexcept override {
    for (std::size_t i = 0; i < points.count; ++i) {
      const Square s = square_at(points.x[i], points.y[i]);
      const float low = s.a + s.u * (s.b - s.a), high = s.c + s.u * (s.d - s.c);
      out[i] = low + s.v * (high - low);
    }
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    values(points, out);
    const auto cell = static_cast<float>(lattice_.cell);
    for (std::size_t i = 0; i < points.count; ++i) {
      const Square s = square_at(points.x[i], points.y[i]);
      slopes.dx[i] = ((1 - s.v) * (s.b - s.a) + s.v * (s.d - s.c)) / cell;
      slopes.dy[i] = ((1 - s.u) * (s.c - s.a) + s.u * (s.d - s.b)) / cell;
      slopes.dz[i] = 0;
    }
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    const int left = column(box.lower.x()), right = std::min(lattice_.width - 1, column(box.upper.x()) + 1);
    const int low = row(box.lower.y()), high = std::min(lattice_.height - 1, row(box.upper.y()) + 1);
    if (right - left <= tile && high - low <= tile) return range_of(left, low, right, high);
    Interval range = tiles_[tile_index(left / tile, low / tile)];
    for (int v = low / tile; v <= high / tile; ++v)
      for (int u = left / tile; u <= right / tile; ++u) widen(range, tiles_[tile_index(u, v)]);
    return range;
  }
  [[nodiscard]] bool sampled() const noexcept override { return true; }

 private:
  static constexpr int tile = 32;

  struct Square {
    float a, b, c, d;  // lower left, lower right, upper left, upper right
    float u, v;
  };
  static void widen(Interval& range, const Interval& other) {
    range.lower = std::min(range.lower, other.lower), range.upper = std::max(range.upper, other.upper);
    range.maybe_nan |= other.maybe_nan;
  }
  [[nodiscard]] std::size_t tile_index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(tiles_wide_) + static_cast<std::size_t>(u);
  }
  [[nodiscard]] Interval range_of(int left, int low, int right, int high) const noexcept {
    Interval range = Interval::of(lattice_.at(left, low));
    for (int j = low; j <= high; ++j) {
      const float* const samples = lattice_.row(j);
      for (int i = left; i <= right; ++i) {
        range.lower = std::min(range.lower, samples[i]), range.upper = std::max(range.upper, samples[i]);
        // interpolation may compute inf - inf
        range.maybe_nan |= !(std::abs(samples[i]) < std::numeric_limits<float>::infinity());
      }
    }
    return range;
  }
  /// Index of the square that contains a coordinate, by its lower sample; clamped to the lattice.
  [[nodiscard]] int column(double x) const {
    return static_cast<int>(
        std::clamp(std::floor((x - lattice_.origin.x()) / lattice_.cell), 0.0, lattice_.width - 1.0));
  }
  [[nodiscard]] int row(double y) const {
    return static_cast<int>(
        std::clamp(std::floor((y - lattice_.origin.y()) / lattice_.cell), 0.0, lattice_.height - 1.0));
  }
  [[nodiscard]] Square square_at(float x, float y) const noexcept {
    const int i = column(x), j = row(y), right = std::min(i + 1, lattice_.width - 1),
              high = std::min(j + 1, lattice_.height - 1);
    const double u = (x - lattice_.origin.x()) / lattice_.cell - i, v = (y - lattice_.origin.y()) / lattice_.cell - j;
    return {lattice_.at(i, j),
            lattice_.at(right, j),
            lattice_.at(i, high),
            lattice_.at(right, high),
            static_cast<float>(std::clamp(u, 0.0, 1.0)),
            static_cast<float>(std::clamp(v, 0.0, 1.0))};
  }

  Lattice<float> lattice_;
  int tiles_wide_ = 0;
  std::vector<Interval> tiles_;
};

}  // namespace

FieldPtr lattice_field(Lattice<float> lattice) { return std::make_shared<LatticeField>(std::move(lattice)); }

}  // namespace fieldfab::cam
