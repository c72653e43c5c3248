// Lowest tip positions of a cutter over a surface, by branch and bound.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "fieldfab/cam/plan/surface.h"
#include "fieldfab/core/clones.h"

namespace fieldfab::cam {

namespace {
constexpr int table_size = 4096;
constexpr int longest_side = 32;  // of blocks and of fine squares
constexpr double below_all = -std::numeric_limits<double>::infinity();
}  // namespace

TipSurface::TipSurface(std::shared_ptr<const Surface> surface, const Profile& profile, double allowance)
    : surface_(std::move(surface)),
      profile_(profile.grown(allowance)),
      allowance_(allowance),
      closed_form_(profile_.closed_form()) {
  const double reach = profile_.radius() * profile_.radius() * (1 + 1e-6);
  per_square_ = table_size / reach;
  for (int i = 0; i <= table_size + 1; ++i) {
    // Minimum over a step of the table: a profile need not rise outwards.
    const double from = std::sqrt(std::min(reach, i / per_square_)),
                 to = std::sqrt(std::min(reach, (i + 1) / per_square_));
    least_heights_.push_back(
        std::min(profile_.height(std::min(from, profile_.radius())), profile_.height(std::min(to, profile_.radius()))));
  }
  for (std::size_t i = least_heights_.size() - 1; i-- > 0;)
    least_heights_[i] = std::min(least_heights_[i], least_heights_[i + 1]);
  const HeightMap& h = surface_->samples();
  // Finest level: maximum of each sample and of the fine samples of the square that starts there.
  HeightMap tops = h;
  const auto samples =
      static_cast<std::size_t>(surface_->fine_side()) * static_cast<std::size_t>(surface_->fine_side());
  for (int row = 0; row < h.height; ++row)
    for (int column = 0; column < h.width; ++column)
      if (const float* const block = surface_->fine(column, row))
        tops.at(column, row) = std::max(tops.at(column, row), *std::max_element(block, block + samples));
  tops_.push_back(std::move(tops));
  while (tops_.back().width > 1 || tops_.back().height > 1 || tops_.size() <= block_level) {
    const HeightMap& below = tops_.back();
    HeightMap above((below.width + 1) / 2, (below.height + 1) / 2, 2 * below.cell, below.origin,
                    -std::numeric_limits<float>::infinity());
    for (int row = 0; row < below.height; ++row)
      for (int column = 0; column < below.width; ++column)
        above.at(column / 2, row / 2) = std::max(above.at(column / 2, row / 2), below.at(column, row));
    tops_.push_back(std::move(above));
  }
  lay_out_blocks();
}

void TipSurface::lay_out_blocks() {
  const HeightMap& h = surface_->samples();
  blocks_wide_ = (h.width + block_side - 1) / block_side;
  const int high = (h.height + block_side - 1) / block_side;
  blocks_.assign(static_cast<std::size_t>(blocks_wide_ * high) * block_side * block_side,
                 -std::numeric_limits<float>::infinity());
  has_fine_.assign(static_cast<std::size_t>(blocks_wide_ * high), 0);
  for (int row = 0; row < h.height; ++row)
    for (int column = 0; column < h.width; ++column) {
      const std::size_t b = block_index(column / block_side, row / block_side);
      blocks_[b * block_side * block_side +
              static_cast<std::size_t>(row % block_side * block_side + column % block_side)] = h.at(column, row);
      if (surface_->fine(column, row) != nullptr) has_fine_[b] = 1;
    }
}

/// A tip height and the column of the block with the sample that determines it.
struct BlockTip {
  float tip;
  int column;
};

/// Highest tip for a block of side x side samples, the first at (x0, y0) from the axis. A plain
/// loop for the compiler's vectorizer.
FIELDFAB_CLONES BlockTip highest_tip(const float* heights, int side, float x0, float y0, float cell, float reach,
                                     const FlatCornerCone& c) {
  const float flat = c.flat, corner = c.corner, widest = c.widest, cone = c.cone, slope = c.slope;
  std::array<float, longest_side> highest;
  std::fill_n(highest.begin(), side, -1e30F);
  for (int row = 0; row < side; ++row) {
    const float y = y0 + cell * static_cast<float>(row), y_squared = y * y;
    for (int k = 0; k < side; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const float x = x0 + cell * static_cast<float>(k), squared = x * x + y_squared, away = std::sqrt(squared),
                  beyond = away - flat;
      const float positive = beyond > 0 ? beyond : 0, out = positive < widest ? positive : widest;
      const float inside = corner * corner - out * out, round = corner - std::sqrt(inside > 0 ? inside : 0),
                  straight = cone + slope * away;
      const float there = heights[row * side + k] - (round > straight ? round : straight),
                  tip = squared <= reach ? there : -1e30F;
      highest[i] = tip > highest[i] ? tip : highest[i];
    }
  }
  const auto best = std::max_element(highest.begin(), highest.begin() + side);
  return {*best, static_cast<int>(best - highest.begin())};
}

/// State of one search: the best contact so far, and the squares that may contain a better one.
struct TipSurface::Search {
  const TipSurface& tips;
  Vec2 p;
  Contact best;
  double radius = tips.profile_.radius(), reach = radius * radius * (1 + 1e-9);

  void try_place(const Vec2& place, double height) {
    const double squared = (place - p).squaredNorm();
    if (squared > reach) return;
    const double tip = height - tips.profile_.height(std::min(std::sqrt(squared), radius));
    if (tip > best.tip) best = {tip, place};
  }

  /// Upper bound of the tip height due to a square of a level; minus infinity out of reach.
  [[nodiscard]] double bound(std::size_t level, int column, int row) const {
    const HeightMap& l = tips.tops_[level];
    const double top = l.at(column, row);
    if (top <= best.tip) return below_all;
    const double x = l.origin.x() + l.cell * column - p.x(), y = l.origin.y() + l.cell * row - p.y();
    const double dx = std::max(0.0, std::max(x, -x - l.cell)), dy = std::max(0.0, std::max(y, -y - l.cell));
    const double squared = dx * dx + dy * dy;
    return squared > reach ? below_all : top - tips.least_height(squared);
  }

  void descend(std::size_t level, int column, int row) {
    if (level == block_level) return try_block(column, row);
    struct Child {
      double bound;
      int column, row;
    };
    const HeightMap& below = tips.tops_[level - 1];
    std::array<Child, 4> children;
    std::size_t count = 0;
    for (int v = 2 * row; v <= std::min(2 * row + 1, below.height - 1); ++v)
      for (int u = 2 * column; u <= std::min(2 * column + 1, below.width - 1); ++u)
        if (const double b = bound(level - 1, u, v); b > best.tip) {
          std::size_t at = count++;  // the greatest bound first
          for (; at > 0 && children[at - 1].bound < b; --at) children[at] = children[at - 1];
          children[at] = {b, u, v};
        }
    for (std::size_t i = 0; i < count && children[i].bound > best.tip; ++i)
      descend(level - 1, children[i].column, children[i].row);
  }

  /// Tests side x side samples with distance `step`, the first at `first`.
  void try_samples(const float* heights, int side, const Vec2& first, double step) {
    const auto try_sample = [&](int k) { try_place(first + step * Vec2(k % side, k / side), heights[k]); };
    if (!tips.closed_form_.valid) {
      for (int k = 0; k < side * side; ++k)
        if (heights[k] > best.tip) try_sample(k);
      return;
    }
    const BlockTip found =
        highest_tip(heights, side, static_cast<float>(first.x() - p.x()), static_cast<float>(first.y() - p.y()),
                    static_cast<float>(step), static_cast<float>(reach), tips.closed_form_);
    if (found.tip > best.tip - margin)
      for (int row = 0; row < side; ++row) try_sample(row * side + found.column);
  }

  /// Tests all samples of a block, and the fine samples of its squares.
  void try_block(int column, int row) {
    const Surface& surface = *tips.surface_;
    const HeightMap& h = surface.samples();
    try_samples(tips.block(column, row), block_side, h.place(column * block_side, row * block_side), h.cell);
    if (surface.fine_squares() == 0 || !tips.has_fine(column, row)) return;
    const int side = surface.fine_side();
    for (int v = row * block_side; v < std::min(h.height, (row + 1) * block_side); ++v)
      for (int u = column * block_side; u < std::min(h.width, (column + 1) * block_side); ++u)
        if (const float* const fine = surface.fine(u, v); fine != nullptr && bound(0, u, v) > best.tip)
          try_samples(fine, side, h.place(u, v), h.cell / (side - 1));
  }

  // rounding error of single precision: the best is computed again in double
  static constexpr double margin = 1e-4;
};

TipSurface::Contact TipSurface::contact(const Vec2& p, const Vec2& guess) const {
  Search search{*this, p, {surface_->floor(), p}};
  if (guess != p) search.try_place(guess, surface_->height(guess));
  const double h_cell = surface_->samples().cell;
  // Start with squares about as large as the cutter.
  const double radius = profile_.radius();
  std::size_t level = 0;
  while (level + 1 < tops_.size() && (level < block_level || tops_[level].cell < radius)) ++level;
  const HeightMap& l = tops_[level];
  const auto clamp = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, count - 1.0));
  };
  const double reach = radius + h_cell;  // between samples a square is as high as its neighbour
  const Vec2 low = (p - l.origin - Vec2::Constant(reach)) / l.cell,
             high = (p - l.origin + Vec2::Constant(reach)) / l.cell;
  double around = below_all;  // greatest height within reach
  if (high.minCoeff() >= 0 && low.x() <= l.width && low.y() <= l.height)
    for (int row = clamp(low.y(), l.height); row <= clamp(high.y(), l.height); ++row)
      for (int column = clamp(low.x(), l.width); column <= clamp(high.x(), l.width); ++column) {
        if (search.bound(level, column, row) > search.best.tip) search.descend(level, column, row);
        around = std::max<double>(around, l.at(column, row));
      }
  Contact best = search.best;
  edge_contacts(p, around, best);
  best.tip += allowance_;
  return best;
}

/// Refines the contact of sharp edges (the rim of a flat cutter, the tip of a V), which may lie
/// between samples.
void TipSurface::edge_contacts(const Vec2& p, double around, Contact& best) const {
  const HeightMap& h = surface_->samples();
  const Vec2 at = (p - h.origin) / h.cell;
  for (const double edge : profile_.edges()) {
    const double above = profile_.height(edge);
    if (around - above <= best.tip) continue;
    const int count = edge == 0 ? 1 : std::max(8, static_cast<int>(std::ceil(2 * std::numbers::pi * edge / h.cell)));
    const double c = std::cos(2 * std::numbers::pi / count), s = std::sin(2 * std::numbers::pi / count);
    Vec2 out(edge / h.cell, 0);
    for (int k = 0; k < count; ++k, out = Vec2(c * out.x() - s * out.y(), s * out.x() + c * out.y())) {
      const Vec2 q = at + out;
      if (!(q.x() >= 0 && q.y() >= 0 && q.x() < h.width - 1 && q.y() < h.height - 1)) continue;
      const int i = static_cast<int>(q.x()), j = static_cast<int>(q.y());
      const float top =
          std::max(std::max(tops_[0].at(i, j), h.at(i + 1, j)), std::max(h.at(i, j + 1), h.at(i + 1, j + 1)));
      if (top - above <= best.tip) continue;
      const Vec2 place = h.place(q.x(), q.y());
      if (const double tip = surface_->height(place) - above; tip > best.tip) best = {tip, place};
    }
  }
}

std::optional<Vec3> TipSurface::corner_normal(const Vec2& p, const Contact& touched) const {
  const Vec2 out = touched.place - p;
  const double away = out.norm();
  if (!closed_form_.valid || !(closed_form_.corner > 0) || away > closed_form_.flat + closed_form_.widest + 1e-6)
    return std::nullopt;
  const double level = std::max(0.0, away - closed_form_.flat) / closed_form_.corner;
  if (level < 1e-9) return Vec3(Vec3::UnitZ());
  return Vec3(-level * out.x() / away, -level * out.y() / away, std::sqrt(std::max(0.0, 1 - level * level)));
}

Interval TipSurface::range(const Rectangle& area) const {
  const Vec2 middle = 0.5 * (area.lower + area.upper);
  const Contact touched = contact(middle);
  const double radius = profile_.radius(), half = 0.5 * area.size().norm();
  // Lower bound: from the contact of the middle position, or the floor.
  double lower = surface_->floor();
  if (const double away = (touched.place - middle).norm() + half; away <= radius)
    lower = std::max(lower, surface_->height(touched.place) - profile_.height(away));
  // Upper bound: from the heights of squares within reach.
  double upper = surface_->floor();
  std::size_t level = 0;
  while (level + 1 < tops_.size() && tops_[level].cell < 0.25 * std::min(radius, area.size().minCoeff())) ++level;
  const HeightMap& l = tops_[level];
  const auto clamp = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, count - 1.0));
  };
  const Vec2 low = (area.lower - l.origin - Vec2::Constant(radius)) / l.cell - Vec2::Ones(),
             high = (area.upper - l.origin + Vec2::Constant(radius)) / l.cell + Vec2::Ones();
  for (int row = clamp(low.y(), l.height); row <= clamp(high.y(), l.height); ++row)
    for (int column = clamp(low.x(), l.width); column <= clamp(high.x(), l.width); ++column) {
      const double top = l.at(column, row);
      if (top <= upper) continue;
      const Vec2 from = l.place(column, row), to = from + Vec2::Constant(l.cell);
      const Vec2 gap = (from - area.upper).cwiseMax(area.lower - to).cwiseMax(0.0);
      // Between samples a square may be as high as its neighbour, hence a margin of one cell.
      if (const double away = std::max(0.0, gap.norm() - 1.5 * surface_->samples().cell); away <= radius)
        upper = std::max(upper, top - least_height(away * away));
    }
  return {static_cast<float>(lower + allowance_ - 1e-4), static_cast<float>(upper + allowance_ + 1e-4), false};
}

namespace {

class TipField final : public Field {
 public:
  explicit TipField(std::shared_ptr<const TipSurface> tips) : tips_(std::move(tips)) {}

  void values(const Points& points, float* out) const noexcept override {
    Vec2 guess = points.count > 0 ? Vec2(points.x[0], points.y[0]) : Vec2::Zero();
    for (std::size_t i = 0; i < points.count; ++i) {
      const TipSurface::Contact touched = tips_->contact({points.x[i], points.y[i]}, guess);
      out[i] = static_cast<float>(-touched.tip);
      guess = touched.place;
    }
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    values(points, out);
    const double step = 0.25 * tips_->surface().samples().cell;
    for (std::size_t i = 0; i < points.count; ++i) {
      const Vec2 p(points.x[i], points.y[i]);
      slopes.dx[i] = static_cast<float>((tips_->tip(p - Vec2(step, 0)) - tips_->tip(p + Vec2(step, 0))) / (2 * step));
      slopes.dy[i] = static_cast<float>((tips_->tip(p - Vec2(0, step)) - tips_->tip(p + Vec2(0, step))) / (2 * step));
      slopes.dz[i] = 0;
    }
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    const Interval tips = tips_->range(Rectangle::of(box));
    return {-tips.upper, -tips.lower, false};
  }
  [[nodiscard]] bool sampled() const noexcept override { return true; }
  [[nodiscard]] std::size_t cost() const noexcept override { return 1000; }

 private:
  std::shared_ptr<const TipSurface> tips_;
};

}  // namespace

FieldPtr TipSurface::field(std::shared_ptr<const TipSurface> tips) {
  return std::make_shared<TipField>(std::move(tips));
}

}  // namespace fieldfab::cam
