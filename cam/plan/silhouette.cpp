#include "plan/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

namespace fieldfab::cam {
namespace {

constexpr double share = 0.05;    ///< of the least value: its accuracy
constexpr int most_pieces = 400;  ///< of a line, until it is given up
constexpr float smallest = std::numeric_limits<float>::min();
constexpr int box_pieces = 8;  ///< of a box, for the interval over it

/// A piece of a vertical line, with a lower bound of the values on it.
struct Piece {
  double low, high;
  float least;
  bool operator<(const Piece& other) const { return least > other.least; }  // the lowest comes first
};

/// The least value on a vertical line, where it is, and how many pieces of the line were looked at.
struct Least {
  float value;
  double z;
  int pieces = 0;
};

class Silhouette final : public Field {
 public:
  Silhouette(FieldPtr solid, double low, double high) : solid_(std::move(solid)), low_(low), high_(high) {}

  void values(const Points& points, float* out) const noexcept override {
    for (std::size_t i = 0; i < points.count; ++i) out[i] = least(points.x[i], points.y[i]).value;
  }

  /// The gradient of a least value is that of the values where it is.
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    std::vector<float> z(points.count), none(points.count);
    for (std::size_t i = 0; i < points.count; ++i) {
      const Least found = least(points.x[i], points.y[i]);
      out[i] = found.value;
      z[i] = static_cast<float>(found.z);
    }
    solid_->gradients({points.x, points.y, z.data(), points.count}, none.data(), slopes);
    std::fill_n(slopes.dz, points.count, 0.0F);
  }

  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    Interval all{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
    for (int i = 0; i < box_pieces; ++i) {
      Box piece = box;
      piece.lower.z() = low_ + (high_ - low_) * i / box_pieces;
      piece.upper.z() = low_ + (high_ - low_) * (i + 1) / box_pieces;
      const Interval values = solid_->interval(piece);
      all.lower = std::min(all.lower, values.lower);
      all.upper = std::min(all.upper, values.upper);
      all.maybe_nan = all.maybe_nan || values.maybe_nan;
    }
    return all;
  }

  /// A least value changes no faster than any of the values does.
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    std::vector<Vec3> level(directions.begin(), directions.end());
    for (Vec3& direction : level) direction.z() = 0;
    solid_->slopes(column(box), level, out);
  }

  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    std::vector<Box> columns;
    for (const Box& box : boxes) columns.push_back(column(box));
    solid_->restrict_all(columns, purpose, out);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      out[i].range = interval(boxes[i]);
      if (out[i].field == solid_)
        out[i].field = *this;
      else
        out[i].field = silhouette(std::move(out[i].field), low_, high_);
    }
  }

  [[nodiscard]] bool sampled() const noexcept override { return solid_->sampled(); }
  [[nodiscard]] std::size_t cost() const noexcept override { return 20 * solid_->cost(); }

  [[nodiscard]] Least least(float x, float y) const noexcept {
    Least best{std::numeric_limits<float>::infinity(), low_, 0};
    std::priority_queue<Piece> open;
    const auto add = [&](double low, double high) {
      ++best.pieces;
      const Interval values = solid_->interval({{x, y, low}, {x, y, high}});
      if (!(values.lower < best.value)) return;
      const double z = (low + high) / 2;
      if (const auto value = static_cast<float>(solid_->value({x, y, z})); value < best.value)
        best.value = value, best.z = z;
      open.push({low, high, values.lower});
    };
    add(low_, high_);
    for (int tried = 0; !open.empty(); ++tried) {
      const Piece next = open.top();
      if (next.least >= best.value - share * std::abs(best.value) - smallest) break;
      if (tried >= most_pieces)
        return best.value < 0 || next.least > 0 ? best : Least{std::min(next.least, -smallest), best.z, best.pieces};
      open.pop();
      const double middle = (next.low + next.high) / 2;
      add(next.low, middle), add(middle, next.high);
    }
    return best;
  }

 private:
  [[nodiscard]] Box column(Box box) const {
    box.lower.z() = low_, box.upper.z() = high_;
    return box;
  }

  FieldPtr solid_;
  double low_, high_;
};

}  // namespace

FieldPtr silhouette(FieldPtr solid, double low, double high) {
  return std::make_shared<Silhouette>(std::move(solid), low, high);
}

bool has_quick_silhouette(const FieldPtr& solid, const Box& bounds) {
  if (solid->sampled() || solid->faceted()) return false;
  constexpr int lines = 12;  // along each side
  constexpr double most_pieces_of_one = 30;
  constexpr double most_work = 50'000;  // operations for a line
  const Silhouette seen(solid, bounds.lower.z(), bounds.upper.z());
  double pieces = 0;
  for (int i = 0; i < lines; ++i)
    for (int j = 0; j < lines; ++j) {
      const Vec3 at = bounds.lower + bounds.size().cwiseProduct(Vec3((i + 0.3) / lines, (j + 0.6) / lines, 0));
      pieces += seen.least(static_cast<float>(at.x()), static_cast<float>(at.y())).pieces;
    }
  const double one = pieces / (lines * lines);
  return one <= most_pieces_of_one && one * static_cast<double>(solid->cost()) <= most_work;
}

}  // namespace fieldfab::cam
