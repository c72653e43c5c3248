#include "raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <span>

#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/render/heights.h"

namespace fieldfab {
namespace {

constexpr int split = 4;        // parts per axis at each level of recursion
constexpr int leaf_side = 16;   // pixels per side that are evaluated one by one
constexpr int task_side = 128;  // regions up to this size are one thread's work

/// Pixels [left, right) x [top, bottom).
struct Rectangle {
  int left, top, right, bottom;
  [[nodiscard]] int longer() const { return std::max(right - left, bottom - top); }
};

/// The box spanned by the centres of the pixels.
Box box_of(const PixelGrid& grid, const Rectangle& r, double low, double high) {
  return {{grid.x(r.left), grid.y(r.bottom - 1), low}, {grid.x(r.right - 1), grid.y(r.top), high}};
}

/// Returns the length of the parts of a length: a quarter, or less if the parts are then leafs of
/// at most `leaf`.
int step_of(int length, int leaf) {
  const int parts = length <= split * leaf ? (length + leaf - 1) / leaf : split;
  return (length + parts - 1) / parts;
}

/// Positions of the pixels' centres by column and by row.
struct Centres {
  std::vector<float> x, y;
  explicit Centres(const PixelGrid& grid) {
    for (int column = 0; column < grid.width; ++column) x.push_back(grid.x(column));
    for (int row = 0; row < grid.height; ++row) y.push_back(grid.y(row));
  }
  /// Writes the centres of a rectangle, row by row, and returns their number.
  std::size_t write(const Rectangle& r, float* to_x, float* to_y) const {
    const auto columns = static_cast<std::size_t>(r.right - r.left), rows = static_cast<std::size_t>(r.bottom - r.top);
    for (std::size_t row = 0; row < rows; ++row) {
      std::copy_n(x.data() + r.left, columns, to_x + row * columns);
      std::fill_n(to_y + row * columns, columns, y[static_cast<std::size_t>(r.top) + row]);
    }
    return rows * columns;
  }
};

/// Parts of a rectangle, at most split x split, row by row, and the Field restricted to each.
struct Parts {
  std::size_t count = 0;
  std::array<Rectangle, split * split> area;
  std::array<Restriction, split * split> here;

  Parts(const Field& field, const PixelGrid& grid, const Rectangle& r, double low, double high) {
    std::array<Box, split * split> box;
    const int step = step_of(r.longer(), leaf_side);
    for (int y = r.top; y < r.bottom; y += step)
      for (int x = r.left; x < r.right; x += step, ++count) {
        area[count] = {x, y, std::min(x + step, r.right), std::min(y + step, r.bottom)};
        box[count] = box_of(grid, area[count], low, high);
      }
    field.restrict_all({box.data(), count}, Purpose::occupancy, {here.data(), count});
  }
};

/// Divides rectangles recursively and in parallel, and restricts the Field; calls `leaf` for those
/// that are one thread's work.
class Descent {
 public:
  Descent(const PixelGrid& grid, double low, double high, Progress& progress)
      : grid_(grid), low_(low), high_(high), progress_(progress) {}

  template <class Decided, class Leaf>
  void run(const Field& field, const Rectangle& r, const Decided& decided, const Leaf& leaf) {
    progress_.check();
    if (r.longer() <= task_side) {
      leaf(field, r);
      return finish(r);
    }
    const Parts parts(field, grid_, r, low_, high_);
    parallel_for(parts.count, [&](std::size_t i) {
      const Restriction& here = parts.here[i];
      if (here.range.outside() || (here.range.inside() && decided(parts.area[i])))
        finish(parts.area[i]);
      else
        run(*here.field, parts.area[i], decided, leaf);
    });
  }

 private:
  void finish(const Rectangle& r) {
    const auto pixels = static_cast<std::size_t>(r.right - r.left) * static_cast<std::size_t>(r.bottom - r.top);
    progress_.report(static_cast<double>(done_ += pixels) / static_cast<double>(grid_.count()), "rendering");
  }
  const PixelGrid& grid_;
  double low_, high_;
  Progress& progress_;
  std::atomic<std::size_t> done_{0};
};

/// Draws pixels of a plane, tile by tile (Alg. 3.2 in two dimensions).
class PlaneTile {
 public:
  PlaneTile(const PixelGrid& grid, std::uint8_t* pixels) : grid_(grid), centres_(grid), pixels_(pixels) {}

  void fill(const Rectangle& r) const {
    for (int y = r.top; y < r.bottom; ++y)
      std::memset(pixels_ + grid_.index(r.left, y), 255, static_cast<std::size_t>(r.right - r.left));
  }

  void draw(const Field& field, const Rectangle& r) const {
    if (r.longer() <= leaf_side) return evaluate(field, r);
    const double z = grid_.region.lower.z();
    const Parts parts(field, grid_, r, z, z);
    for (std::size_t i = 0; i < parts.count; ++i)
      if (parts.here[i].range.inside())
        fill(parts.area[i]);
      else if (!parts.here[i].range.outside())
        draw(*parts.here[i].field, parts.area[i]);
  }

 private:
  void evaluate(const Field& field, const Rectangle& r) const {
    std::array<float, leaf_side * leaf_side> x, y, z, value;
    const std::size_t count = centres_.write(r, x.data(), y.data());
    std::fill_n(z.data(), count, static_cast<float>(grid_.region.lower.z()));
    field.values({x.data(), y.data(), z.data(), count}, value.data());
    const auto columns = static_cast<std::size_t>(r.right - r.left), rows = static_cast<std::size_t>(r.bottom - r.top);
    for (std::size_t row = 0; row < rows; ++row) {
      std::uint8_t* const pixel = pixels_ + grid_.index(r.left, r.top + static_cast<int>(row));
      for (std::size_t column = 0; column < columns; ++column)
        pixel[column] = value[row * columns + column] < 0 ? 255 : 0;
    }
  }

  const PixelGrid& grid_;
  Centres centres_;
  std::uint8_t* pixels_;
};

/// Draws heights of a tile from the top down, and skips hidden parts (Keeter 3.10).
class HeightTile {
 public:
  HeightTile(const PixelGrid& grid, std::vector<float>& heights, Normals* normals)
      : grid_(grid), centres_(grid), heights_(heights), normals_(normals) {
    const double pixel = std::max(grid.region.size().x() / grid.width, grid.region.size().y() / grid.height);
    layers_ = std::max(1, static_cast<int>(std::ceil(grid.region.size().z() / pixel)));
    for (int layer = 0; layer <= layers_; ++layer)
      planes_.push_back(static_cast<float>(grid.region.lower.z() + grid.region.size().z() * layer / layers_));
  }
  [[nodiscard]] int layers() const { return layers_; }

  /// Draws pixels r between layer `low` and layer `high`, counted from the bottom; the Field is
  /// restricted to them.
  void draw(const Field& field, const Rectangle& r, int low, int high) const {
    if (r.longer() <= side && high - low <= side) return march(field, r, low, high);
    const int longest = std::max(r.longer(), high - low);
    const int step = step_of(longest, side);
    std::array<Rectangle, split * split> open;  // rectangles not hidden yet
    std::size_t count = 0;
    for (int y = r.top; y < r.bottom; y += step)
      for (int x = r.left; x < r.right; x += step)
        open[count++] = {x, y, std::min(x + step, r.right), std::min(y + step, r.bottom)};
    for (int upper = high; upper > low && count > 0; upper -= step) {
      count = leave_hidden(open, count, plane(upper));
      draw_slab(field, {open.data(), count}, std::max(low, upper - step), upper);
    }
  }

 private:
  static constexpr int side = 8;  // pixels and layers that are evaluated one by one
  static constexpr std::size_t most_columns = side * side;

  /// Moves the rectangles that are not hidden at `top` or above to the front; returns their number.
  std::size_t leave_hidden(std::array<Rectangle, split * split>& open, std::size_t count, float top) const {
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (!hidden(open[i], top)) open[left++] = open[i];
    return left;
  }

  void draw_slab(const Field& field, std::span<const Rectangle> area, int low, int high) const {
    const float top = plane(high);
    std::array<Box, split * split> box;
    std::array<Restriction, split * split> here;
    for (std::size_t i = 0; i < area.size(); ++i) box[i] = box_of(grid_, area[i], plane(low), top);
    field.restrict_all({box.data(), area.size()}, Purpose::occupancy, here);
    for (std::size_t i = 0; i < area.size(); ++i)
      if (here[i].range.inside())
        raise(*here[i].field, area[i], top);
      else if (!here[i].range.outside())
        draw(*here[i].field, area[i], low, high);
  }

  [[nodiscard]] float plane(int layer) const { return planes_[static_cast<std::size_t>(layer)]; }
  [[nodiscard]] bool hidden(const Rectangle& r, float top) const {
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x)
        if (heights_[grid_.index(x, y)] < top) return false;
    return true;
  }

  /// Points at which rays meet the solid, at most one per pixel.
  struct Hits {
    std::array<float, most_columns> x, y, z;
    std::array<std::size_t, most_columns> pixel;
    std::size_t count = 0;
  };

  /// Draws a box that is solid up to its top plane.
  void raise(const Field& field, const Rectangle& r, float top) const {
    Hits hits;
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x) {
        const std::size_t pixel = grid_.index(x, y);
        if (heights_[pixel] >= top) continue;
        hits.x[hits.count] = grid_.x(x), hits.y[hits.count] = grid_.y(y), hits.z[hits.count] = top;
        hits.pixel[hits.count++] = pixel;
        if (hits.count == most_columns) record(field, hits), hits.count = 0;
      }
    record(field, hits);
  }

  /// Evaluates the planes of layers down each column. If one plane is inside and the one above is
  /// outside, refines the crossing.
  void march(const Field& field, const Rectangle& r, int low, int high) const {
    constexpr std::size_t most = most_columns * (side + 1);
    std::array<float, most> x, y, z, value;
    const std::size_t area = centres_.write(r, x.data(), y.data()), planes = static_cast<std::size_t>(high - low) + 1;
    for (std::size_t layer = 0; layer < planes; ++layer) {  // the top one first
      if (layer > 0)
        std::copy_n(x.data(), area, x.data() + layer * area), std::copy_n(y.data(), area, y.data() + layer * area);
      std::fill_n(z.data() + layer * area, area, plane(high - static_cast<int>(layer)));
    }
    field.values({x.data(), y.data(), z.data(), area * planes}, value.data());
    int inside = 0;
    for (std::size_t i = 0; i < area * planes; ++i) inside |= static_cast<int>(value[i] < 0);
    if (inside == 0) return;

    std::array<int, most_columns> first;  // index of the first layer inside
    std::fill_n(first.data(), area, -1);
    for (std::size_t layer = planes; layer-- > 0;)
      for (std::size_t i = 0; i < area; ++i)
        first[i] = value[layer * area + i] < 0 ? static_cast<int>(layer) : first[i];
    Hits hits;
    Brackets brackets;
    const auto columns = static_cast<std::size_t>(r.right - r.left);
    for (std::size_t i = 0; i < area; ++i) {
      if (first[i] < 0) continue;
      const std::size_t pixel =
          grid_.index(r.left + static_cast<int>(i % columns), r.top + static_cast<int>(i / columns));
      const std::size_t at = static_cast<std::size_t>(first[i]) * area + i, above = first[i] == 0 ? at : at - area;
      if (z[at] <= heights_[pixel]) continue;
      brackets.inside[hits.count] = z[at], brackets.outside[hits.count] = z[above];
      brackets.value_inside[hits.count] = value[at], brackets.value_outside[hits.count] = value[above];
      hits.x[hits.count] = x[i], hits.y[hits.count] = y[i];
      hits.pixel[hits.count++] = pixel;
    }
    close_in(field, brackets, hits);
    record(field, hits);
  }

  struct Brackets {
    std::array<float, most_columns> inside, outside, value_inside, value_outside;
  };

  /// Regula falsi in the Illinois form, all columns in step, to a thousandth of a layer. Writes the crossings to
  /// hits.z. Separate from the search in contour/edges.cpp: floats in arrays without branches, which are vectorised,
  /// and no bisection.
  void close_in(const Field& field, Brackets& b, Hits& hits) const {
    const float near = 1e-3F * (plane(layers_) - plane(0)) / static_cast<float>(layers_);
    std::array<float, most_columns> value, last{};  // last: side of the previous value, as 1 or -1
    constexpr int most_steps = 14;
    for (std::size_t i = 0; i < hits.count; ++i) hits.z[i] = 2 * b.inside[i] - b.outside[i];
    for (int step = 0; hits.count > 0; ++step) {
      // Plain loops with selections, which the compiler vectorises.
      int moving = 0;
      for (std::size_t i = 0; i < hits.count; ++i) {
        const float share = b.value_inside[i] / (b.value_inside[i] - b.value_outside[i]);
        const float most = share < 0.98F ? share : 0.98F;  // never the ends; the upper limit for NaN
        const float t = most > 0.02F ? most : 0.02F;
        const float middle = b.inside[i] + t * (b.outside[i] - b.inside[i]);
        moving |= static_cast<int>(std::abs(middle - hits.z[i]) > near);
        hits.z[i] = middle;
      }
      if (moving == 0 || step == most_steps) return;
      field.values({hits.x.data(), hits.y.data(), hits.z.data(), hits.count}, value.data());
      for (std::size_t i = 0; i < hits.count; ++i) {
        const bool in = value[i] < 0;
        const float z = hits.z[i], side_now = in ? 1.0F : -1.0F;
        const float weight = last[i] == side_now ? 0.5F : 1.0F;  // of the end that is kept a second time
        b.inside[i] = in ? z : b.inside[i];
        b.outside[i] = in ? b.outside[i] : z;
        b.value_inside[i] = in ? value[i] : weight * b.value_inside[i];
        b.value_outside[i] = in ? weight * b.value_outside[i] : value[i];
        last[i] = side_now;
      }
    }
  }

  void record(const Field& field, const Hits& hits) const {
    for (std::size_t i = 0; i < hits.count; ++i) heights_[hits.pixel[i]] = hits.z[i];
    if (normals_ == nullptr || hits.count == 0) return;
    std::array<float, most_columns> value, dx, dy, dz;
    field.gradients({hits.x.data(), hits.y.data(), hits.z.data(), hits.count}, value.data(),
                    {dx.data(), dy.data(), dz.data()});
    const float top = plane(layers_);
    for (std::size_t i = 0; i < hits.count; ++i) {
      const Eigen::Vector3f slope(dx[i], dy[i], dz[i]);
      const float length = slope.norm();
      if (hits.z[i] < top && std::isfinite(length) && length > 0) (*normals_)[hits.pixel[i]] = slope / length;
    }
  }

  const PixelGrid& grid_;
  Centres centres_;
  std::vector<float>& heights_;
  Normals* normals_;
  int layers_;
  std::vector<float> planes_;  // heights between the layers, from the bottom up
};

}  // namespace

PixelGrid PixelGrid::over(const Box& region, int size) {
  if (size < 1 || size > 16384)
    throw Error(ErrorKind::bad_input, "size", fmt::format("{} pixels; from 1 to 16384 are possible", size));
  const Vec3 extent = region.size();
  if (!region.valid() || extent.x() <= 0 || extent.y() <= 0)
    throw Error(ErrorKind::bad_input, "bounds", "a picture needs finite bounds with a positive size along x and y");
  const double longer = std::max(extent.x(), extent.y());
  const auto side = [&](double length) { return std::max(1, static_cast<int>(std::lround(size * length / longer))); };
  return {side(extent.x()), side(extent.y()), region};
}

void rasterise_plane(const Field& field, const PixelGrid& grid, std::uint8_t* pixels, Progress& progress) {
  const PlaneTile tile(grid, pixels);
  const auto fill = [&](const Rectangle& r) { return tile.fill(r), true; };
  const double z = grid.region.lower.z();
  Descent(grid, z, z, progress)
      .run(field, {0, 0, grid.width, grid.height}, fill,
           [&](const Field& part, const Rectangle& r) { tile.draw(part, r); });
}

std::vector<float> rasterise_heights(const Field& field, const PixelGrid& grid, Normals* normals, Progress& progress) {
  std::vector<float> heights(grid.count(), -std::numeric_limits<float>::infinity());
  if (normals != nullptr) normals->assign(grid.count(), Eigen::Vector3f::UnitZ());
  const HeightTile tile(grid, heights, normals);
  const auto not_filled = [](const Rectangle&) { return false; };
  Descent(grid, grid.region.lower.z(), grid.region.upper.z(), progress)
      .run(field, {0, 0, grid.width, grid.height}, not_filled,
           [&](const Field& part, const Rectangle& r) { tile.draw(part, r, 0, tile.layers()); });
  return heights;
}

std::vector<float> heights(const Field& field, const Box& region, int width, int height, Progress& progress) {
  std::vector<float> found = rasterise_heights(field, {width, height, region}, nullptr, progress);
  for (int low = 0, high = height - 1; low < high; ++low, --high)
    std::swap_ranges(found.begin() + static_cast<std::ptrdiff_t>(low) * width,
                     found.begin() + static_cast<std::ptrdiff_t>(low + 1) * width,
                     found.begin() + static_cast<std::ptrdiff_t>(high) * width);
  return found;
}

}  // namespace fieldfab
