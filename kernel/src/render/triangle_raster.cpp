#include "triangle_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

constexpr int band_rows = 16;  // rows that one thread draws at a time

using Triangle = std::array<std::uint32_t, 3>;

/// Twice the signed area of (a, b, point), seen from above; exactly the opposite of that of (b, a,
/// point), so that no point on an edge is outside both of its triangles.
double side(std::span<const Vec3> vertices, std::uint32_t a, std::uint32_t b, double x, double y) {
  const double sign = a < b ? 1 : -1;
  const Vec3 &first = vertices[std::min(a, b)], &second = vertices[std::max(a, b)];
  return sign * ((second.x() - first.x()) * (y - first.y()) - (second.y() - first.y()) * (x - first.x()));
}

/// Existing pixels with centres in [low, high]; none if `last` is less than `first`.
struct Run {
  int first, last;
};
Run pixels_between(double low, double high, int count) {
  return {static_cast<int>(std::ceil(std::clamp(low - 0.5, 0.0, static_cast<double>(count)))),
          static_cast<int>(std::floor(std::clamp(high - 0.5, -1.0, count - 1.0)))};
}

class TriangleRaster {
 public:
  TriangleRaster(std::span<const Vec3> vertices, std::span<const Triangle> triangles, const PixelGrid& grid)
      : vertices_(vertices), triangles_(triangles), grid_(grid) {
    const Vec3 size = grid.region.size();
    columns_per_mm_ = grid.width / size.x(), rows_per_mm_ = grid.height / size.y();
    seen_.heights.assign(grid.count(), -std::numeric_limits<float>::infinity());
    seen_.triangles.assign(grid.count(), SeenTriangles::none);
  }

  SeenTriangles draw(Progress& progress) {
    share_out();
    parallel_for(starts_.size() - 1, [&](std::size_t band) {
      progress.check();
      for (std::size_t i = starts_[band]; i < starts_[band + 1]; ++i)
        draw(bands_[i], static_cast<int>(band) * band_rows);
    });
    return std::move(seen_);
  }

 private:
  [[nodiscard]] Run rows_of(const Triangle& t) const {
    const auto [low, high] = std::minmax({vertices_[t[0]].y(), vertices_[t[1]].y(), vertices_[t[2]].y()});
    if (!std::isfinite(low) || !std::isfinite(high)) return {0, -1};
    return pixels_between((grid_.region.upper.y() - high) * rows_per_mm_, (grid_.region.upper.y() - low) * rows_per_mm_,
                          grid_.height);
  }
  [[nodiscard]] Run columns_of(const Triangle& t) const {
    const auto [low, high] = std::minmax({vertices_[t[0]].x(), vertices_[t[1]].x(), vertices_[t[2]].x()});
    if (!std::isfinite(low) || !std::isfinite(high)) return {0, -1};
    return pixels_between((low - grid_.region.lower.x()) * columns_per_mm_,
                          (high - grid_.region.lower.x()) * columns_per_mm_, grid_.width);
  }

  /// Lists for each band of rows the triangles that reach it, in their order (counting sort).
  void share_out() {
    const auto count = static_cast<std::size_t>((grid_.height + band_rows - 1) / band_rows);
    starts_.assign(count + 1, 0);
    const auto each = [&](const auto& what) {
      for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
        const Run rows = rows_of(triangles_[t]), columns = columns_of(triangles_[t]);
        if (rows.first > rows.last || columns.first > columns.last) continue;
        for (int band = rows.first / band_rows; band <= rows.last / band_rows; ++band)
          what(static_cast<std::size_t>(band), t);
      }
    };
    each([&](std::size_t band, std::uint32_t) { ++starts_[band + 1]; });
    for (std::size_t band = 0; band < count; ++band) starts_[band + 1] += starts_[band];
    bands_.resize(starts_.back());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    each([&](std::size_t band, std::uint32_t t) { bands_[next[band]++] = t; });
  }

  /// Draws the part of a triangle that lies in a band.
  void draw(std::uint32_t number, int top) {
    const Triangle& t = triangles_[number];
    const Run rows = rows_of(t), columns = columns_of(t);
    const double za = vertices_[t[0]].z(), zb = vertices_[t[1]].z(), zc = vertices_[t[2]].z();
    for (int row = std::max(rows.first, top); row <= std::min(rows.last, top + band_rows - 1); ++row)
      for (int column = columns.first; column <= columns.last; ++column) {
        const double x = grid_.region.lower.x() + (column + 0.5) / columns_per_mm_,
                     y = grid_.region.upper.y() - (row + 0.5) / rows_per_mm_;
        const double a = side(vertices_, t[1], t[2], x, y), b = side(vertices_, t[2], t[0], x, y),
                     c = side(vertices_, t[0], t[1], x, y), sum = a + b + c;
        const bool within = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
        if (!within || sum == 0) continue;  // outside, or the triangle is seen edge-on
        const auto height = static_cast<float>((a * za + b * zb + c * zc) / sum);
        const std::size_t i = grid_.index(column, row);
        if (height > seen_.heights[i]) seen_.heights[i] = height, seen_.triangles[i] = number;
      }
  }

  std::span<const Vec3> vertices_;
  std::span<const Triangle> triangles_;
  const PixelGrid& grid_;
  double columns_per_mm_, rows_per_mm_;
  SeenTriangles seen_;
  std::vector<std::size_t> starts_;  ///< of each band in bands_, and the end of the last
  std::vector<std::uint32_t> bands_;
};

}  // namespace

SeenTriangles rasterise_triangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                  const PixelGrid& grid, Progress& progress) {
  return TriangleRaster(vertices, triangles, grid).draw(progress);
}

std::array<double, 3> shares_at(std::span<const Vec3> vertices, const Triangle& t, double x, double y) {
  const double a = side(vertices, t[1], t[2], x, y), b = side(vertices, t[2], t[0], x, y),
               c = side(vertices, t[0], t[1], x, y);
  return {a / (a + b + c), b / (a + b + c), c / (a + b + c)};
}

}  // namespace fieldfab
