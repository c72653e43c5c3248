#include "raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

constexpr int split = 4;        // parts an axis at each level of recursion
constexpr int leaf_side = 16;   // pixels a side that are evaluated one by one
constexpr int task_side = 128;  // regions up to this size are one thread's work

/// Pixels [left, right) x [top, bottom).
struct Rectangle {
  int left, top, right, bottom;
  [[nodiscard]] int longer() const { return std::max(right - left, bottom - top); }
};

/// The box spanned by the pixels' centres.
Box box_of(const PixelGrid& grid, const Rectangle& r, double low, double high) {
  return {{grid.x(r.left), grid.y(r.bottom - 1), low}, {grid.x(r.right - 1), grid.y(r.top), high}};
}

/// The parts of a rectangle, at most split x split, row by row, and the Field restricted to each.
struct Parts {
  std::size_t count = 0;
  std::array<Rectangle, split * split> area;
  std::array<Restriction, split * split> here;

  Parts(const Field& field, const PixelGrid& grid, const Rectangle& r, double low, double high) {
    std::array<Box, split * split> box;
    const int step = (r.longer() + split - 1) / split;
    for (int y = r.top; y < r.bottom; y += step)
      for (int x = r.left; x < r.right; x += step, ++count) {
        area[count] = {x, y, std::min(x + step, r.right), std::min(y + step, r.bottom)};
        box[count] = box_of(grid, area[count], low, high);
      }
    field.restricted_all({box.data(), count}, Purpose::occupancy, {here.data(), count});
  }
};

/// Goes down the rectangles in parallel, restricting the Field on the way; `leaf` gets those that one thread should do.
class Descent {
 public:
  Descent(const PixelGrid& grid, double low, double high, Progress& progress)
      : grid_(grid), low_(low), high_(high), progress_(progress) {}

  template <class Decided, class Leaf>
  void run(const FieldPtr& field, const Rectangle& r, const Decided& decided, const Leaf& leaf) {
    progress_.check();
    if (r.longer() <= task_side) {
      leaf(field, r);
      return finish(r);
    }
    const Parts parts(*field, grid_, r, low_, high_);
    parallel_for(parts.count, [&](std::size_t i) {
      const Restriction& here = parts.here[i];
      if (here.range.outside() || (here.range.inside() && decided(parts.area[i])))
        finish(parts.area[i]);
      else
        run(here.field, parts.area[i], decided, leaf);
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

/// Pixels of a plane, tile by tile (Alg. 3.2 in two dimensions).
class PlaneTile {
 public:
  PlaneTile(const PixelGrid& grid, std::vector<std::uint8_t>& inside) : grid_(grid), inside_(inside) {
    for (int column = 0; column < grid.width; ++column) x_.push_back(grid.x(column));
    for (int row = 0; row < grid.height; ++row) y_.push_back(grid.y(row));
  }

  void fill(const Rectangle& r) const {
    for (int y = r.top; y < r.bottom; ++y)
      std::fill_n(inside_.begin() + static_cast<std::ptrdiff_t>(grid_.index(r.left, y)), r.right - r.left, std::uint8_t{1});
  }

  void draw(const FieldPtr& field, const Rectangle& r) const {
    if (r.longer() <= leaf_side) return evaluate(*field, r);
    const double z = grid_.region.lower.z();
    const Parts parts(*field, grid_, r, z, z);
    for (std::size_t i = 0; i < parts.count; ++i)
      if (parts.here[i].range.inside())
        fill(parts.area[i]);
      else if (!parts.here[i].range.outside())
        draw(parts.here[i].field, parts.area[i]);
  }

 private:
  void evaluate(const Field& field, const Rectangle& r) const {
    std::array<float, leaf_side * leaf_side> x, y, z, value;
    const auto columns = static_cast<std::size_t>(r.right - r.left), rows = static_cast<std::size_t>(r.bottom - r.top);
    const float* const first_x = x_.data() + r.left;
    for (std::size_t row = 0; row < rows; ++row) {
      std::copy_n(first_x, columns, x.data() + row * columns);
      std::fill_n(y.data() + row * columns, columns, y_[static_cast<std::size_t>(r.top) + row]);
    }
    std::fill_n(z.data(), rows * columns, static_cast<float>(grid_.region.lower.z()));
    field.values({x.data(), y.data(), z.data(), rows * columns}, value.data());
    for (std::size_t row = 0; row < rows; ++row) {
      std::uint8_t* const pixel = inside_.data() + grid_.index(r.left, r.top + static_cast<int>(row));
      for (std::size_t column = 0; column < columns; ++column)
        pixel[column] = static_cast<std::uint8_t>(value[row * columns + column] < 0);
    }
  }

  const PixelGrid& grid_;
  std::vector<std::uint8_t>& inside_;
  std::vector<float> x_, y_;  ///< of the columns' and rows' centres
};

/// Heights of a tile, from the top down, leaving out what is hidden (Keeter 3.10).
class HeightTile {
 public:
  HeightTile(const PixelGrid& grid, std::vector<float>& heights) : grid_(grid), heights_(heights) {
    const double pixel = std::max(grid.region.size().x() / grid.width, grid.region.size().y() / grid.height);
    layers_ = std::max(1, static_cast<int>(std::ceil(grid.region.size().z() / pixel)));
  }
  [[nodiscard]] int layers() const { return layers_; }

  /// Pixels r between layer `low` and layer `high`, counted from the bottom.
  void draw(const FieldPtr& field, const Rectangle& r, int low, int high) const {
    const float top = plane(high);
    if (hidden(r, top)) return;
    const Restriction here = field->restricted(box_of(grid_, r, plane(low), top), Purpose::occupancy);
    if (here.range.outside()) return;
    if (here.range.inside()) return raise(r, top);
    constexpr int side = 8;
    if (r.longer() <= side && high - low <= side) return evaluate(*here.field, r, low, high);
    const int step = std::max(r.longer(), high - low) / 2;
    for (int upper = high; upper > low; upper -= step) {
      const int lower = std::max(low, upper - step);
      const int half = std::max(side, std::min((r.longer() + 1) / 2, step));
      for (int y = r.top; y < r.bottom; y += half)
        for (int x = r.left; x < r.right; x += half)
          draw(here.field, {x, y, std::min(x + half, r.right), std::min(y + half, r.bottom)}, lower, upper);
    }
  }

 private:
  [[nodiscard]] float plane(int layer) const {
    return static_cast<float>(grid_.region.lower.z() + grid_.region.size().z() * layer / layers_);
  }
  [[nodiscard]] bool hidden(const Rectangle& r, float top) const {
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x)
        if (heights_[grid_.index(x, y)] < top) return false;
    return true;
  }
  void raise(const Rectangle& r, float top) const {
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x) heights_[grid_.index(x, y)] = std::max(heights_[grid_.index(x, y)], top);
  }

  /// Looks down each column at the layers' planes, then closes in on the crossing by bisection, all columns together.
  void evaluate(const Field& field, const Rectangle& r, int low, int high) const {
    constexpr std::size_t columns = 64, most = columns * 9;
    std::array<float, most> x, y, z, value;
    std::size_t count = 0;
    for (int row = r.top; row < r.bottom; ++row)
      for (int column = r.left; column < r.right; ++column)
        for (int layer = high; layer >= low; --layer, ++count)
          x[count] = grid_.x(column), y[count] = grid_.y(row), z[count] = plane(layer);
    field.values({x.data(), y.data(), z.data(), count}, value.data());

    std::array<float, columns> inside, outside, hx, hy, middle, sign;
    std::array<std::size_t, columns> pixel;
    std::size_t hits = 0, at = 0;
    for (int row = r.top; row < r.bottom; ++row)
      for (int column = r.left; column < r.right; ++column) {
        int layer = high;
        for (std::size_t i = at; layer >= low && !(value[i] < 0); --layer) ++i;
        at += static_cast<std::size_t>(high - low + 1);
        if (layer < low || plane(layer) <= heights_[grid_.index(column, row)]) continue;
        pixel[hits] = grid_.index(column, row);
        inside[hits] = plane(layer);
        outside[hits] = layer == high ? plane(high) : plane(layer + 1);
        hx[hits] = grid_.x(column), hy[hits] = grid_.y(row);
        ++hits;
      }
    constexpr int steps = 12;
    for (int step = 0; step < steps && hits > 0; ++step) {
      for (std::size_t i = 0; i < hits; ++i) middle[i] = 0.5F * (inside[i] + outside[i]);
      field.values({hx.data(), hy.data(), middle.data(), hits}, sign.data());
      for (std::size_t i = 0; i < hits; ++i) (sign[i] < 0 ? inside : outside)[i] = middle[i];
    }
    for (std::size_t i = 0; i < hits; ++i) heights_[pixel[i]] = std::max(heights_[pixel[i]], inside[i]);
  }

  const PixelGrid& grid_;
  std::vector<float>& heights_;
  int layers_;
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

std::vector<std::uint8_t> rasterise_plane(const Field& field, const PixelGrid& grid, Progress& progress) {
  std::vector<std::uint8_t> inside(grid.count(), 0);
  const PlaneTile tile(grid, inside);
  const auto fill = [&](const Rectangle& r) { return tile.fill(r), true; };
  const double z = grid.region.lower.z();
  Descent(grid, z, z, progress)
      .run(field.shared_from_this(), {0, 0, grid.width, grid.height}, fill,
           [&](const FieldPtr& part, const Rectangle& r) { tile.draw(part, r); });
  return inside;
}

std::vector<float> rasterise_heights(const Field& field, const PixelGrid& grid, Progress& progress) {
  std::vector<float> heights(grid.count(), -std::numeric_limits<float>::infinity());
  const HeightTile tile(grid, heights);
  const auto not_filled = [](const Rectangle&) { return false; };
  Descent(grid, grid.region.lower.z(), grid.region.upper.z(), progress)
      .run(field.shared_from_this(), {0, 0, grid.width, grid.height}, not_filled,
           [&](const FieldPtr& part, const Rectangle& r) { tile.draw(part, r, 0, tile.layers()); });
  return heights;
}

}  // namespace fieldfab
