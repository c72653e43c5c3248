#include "assembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

#include "few_directions.h"

namespace fieldfab::openscad {
namespace {

constexpr std::size_t chunk = 256;
using Chunk = std::array<float, chunk>;

/// Distance of two boxes along the axis on which they are farthest apart; 0 if they overlap.
double apart(const Box& a, const Box& b) {
  return std::max(0.0, std::max((a.lower - b.upper).maxCoeff(), (b.lower - a.upper).maxCoeff()));
}

/// Lower bound of the part's values in the box.
double least_of(const Placed& part, const Box& box) {
  const double distance = apart(part.box, box);
  return distance > 0 ? part.steepness * distance * (1 - 1e-6) : -std::numeric_limits<double>::infinity();
}

class Assembly final : public Field {
 public:
  explicit Assembly(std::vector<Placed> parts) : parts_(std::move(parts)) {
    for (const Placed& part : parts_) cost_ += part.field->cost();
  }

  void values(const Points& points, float* out) const noexcept override {
    for (std::size_t first = 0; first < points.count; first += chunk) {
      const Points here = points.part(first, std::min(chunk, points.count - first));
      Chunk other;
      visit(here, out + first, [&](const Field& field, bool is_first) {
        if (is_first) return field.values(here, out + first);
        field.values(here, other.data());
        for (std::size_t i = 0; i < here.count; ++i) {
          const float a = out[first + i], b = other[i];
          out[first + i] = std::isnan(a) || std::isnan(b) ? std::numeric_limits<float>::quiet_NaN() : std::min(a, b);
        }
      });
    }
  }

  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    for (std::size_t first = 0; first < points.count; first += chunk) {
      const Points here = points.part(first, std::min(chunk, points.count - first));
      const Gradients mine{slopes.dx + first, slopes.dy + first, slopes.dz + first};
      Chunk other, dx, dy, dz;
      visit(here, out + first, [&](const Field& field, bool is_first) {
        if (is_first) return field.gradients(here, out + first, mine);
        field.gradients(here, other.data(), {dx.data(), dy.data(), dz.data()});
        for (std::size_t i = 0; i < here.count; ++i) {
          if (std::isnan(other[i])) out[first + i] = other[i];
          if (!(other[i] < out[first + i])) continue;
          out[first + i] = other[i];
          mine.dx[i] = dx[i], mine.dy[i] = dy[i], mine.dz[i] = dz[i];
        }
      });
    }
  }

  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    Interval all{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(), false};
    for (const Placed& part : parts_) {
      if (least_of(part, box) > all.upper) continue;
      const Interval here = part.field->interval(box);
      all = {std::min(all.lower, here.lower), std::min(all.upper, here.upper), all.maybe_nan || here.maybe_nan};
    }
    return all;
  }

  /// If several functions change by at least and at most so much per step, their minimum does so
  /// too.
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    const float upper = interval(box).upper;
    std::fill_n(out.begin(), directions.size(), Interval::unknown());
    bool any = false;
    std::array<Interval, lanes> one;
    for (const Placed& part : parts_) {
      if (least_of(part, box) > upper) continue;
      if (const Interval range = part.field->interval(box); range.lower > upper && !range.maybe_nan) continue;
      for_few(directions, [&](std::span<const Vec3> some, std::size_t first) {
        part.field->slopes(box, some, one);
        for (std::size_t i = 0; i < some.size(); ++i) {
          Interval& all = out[first + i];
          all = any ? Interval{std::min(all.lower, one[i].lower), std::max(all.upper, one[i].upper),
                               all.maybe_nan || one[i].maybe_nan}
                    : one[i];
        }
      });
      any = true;
    }
  }

  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    if (boxes.size() != 1) {  // then the restriction keeps the parts near any of the boxes
      for (std::size_t i = 0; i < boxes.size(); ++i) restrict_all(boxes.subspan(i, 1), purpose, out.subspan(i, 1));
      return;
    }
    const Box& box = boxes.front();
    out[0] = {Interval::unknown(), *this};
    if (!box.lower.allFinite() || !box.upper.allFinite()) return;
    struct Kept {
      std::size_t part;
      Restriction restriction;
    };
    std::vector<Kept> kept;
    float upper = std::numeric_limits<float>::infinity();
    for (const std::size_t i : by_distance(box)) {
      const Placed& part = parts_[i];
      const double least = least_of(part, box);
      if (least > upper || (purpose == Purpose::occupancy && least > 0 && !kept.empty())) continue;
      kept.push_back({i, part.field->restricted(box, purpose)});
      if (!kept.back().restriction.range.maybe_nan) upper = std::min(upper, kept.back().restriction.range.upper);
    }
    if (upper == std::numeric_limits<float>::infinity()) return;
    std::erase_if(
        kept, [&](const Kept& one) { return one.restriction.range.lower > upper && !one.restriction.range.maybe_nan; });
    std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.part < b.part; });
    Interval range{std::numeric_limits<float>::infinity(), upper, false};
    for (const Kept& one : kept) {
      range.lower = std::min(range.lower, one.restriction.range.lower);
      range.maybe_nan = range.maybe_nan || one.restriction.range.maybe_nan;
    }
    out[0].range = range;
    if (kept.size() == 1) {
      out[0].field = std::move(kept.front().restriction.field);
      return;
    }
    std::vector<Placed> fewer;
    for (Kept& one : kept)
      fewer.push_back({std::move(one.restriction.field), parts_[one.part].box, parts_[one.part].steepness});
    out[0].field = std::make_shared<Assembly>(std::move(fewer));
  }

  [[nodiscard]] std::size_t cost() const noexcept override { return cost_; }

 private:
  [[nodiscard]] std::vector<std::size_t> by_distance(const Box& box) const {
    std::vector<std::size_t> order(parts_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> distance(parts_.size());
    for (std::size_t i = 0; i < parts_.size(); ++i) distance[i] = apart(parts_[i].box, box);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distance[a] < distance[b]; });
    return order;
  }

  /// Calls `ask` for the parts that may matter for these points: the nearest first, then the others
  /// in order. `values` are the minima so far.
  template <class Ask>
  void visit(const Points& points, const float* values, const Ask& ask) const {
    Box box{Vec3::Constant(std::numeric_limits<double>::infinity()),
            Vec3::Constant(-std::numeric_limits<double>::infinity())};
    for (std::size_t i = 0; i < points.count; ++i) {
      const Vec3 p(points.x[i], points.y[i], points.z[i]);
      if (!p.allFinite()) {
        for (std::size_t k = 0; k < parts_.size(); ++k) ask(*parts_[k].field, k == 0);
        return;
      }
      box = {box.lower.cwiseMin(p), box.upper.cwiseMax(p)};
    }
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < parts_.size(); ++k)
      if (const double distance = apart(parts_[k].box, box); distance < least) least = distance, nearest = k;
    ask(*parts_[nearest].field, true);
    double most = greatest(values, points.count);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (k == nearest || least_of(parts_[k], box) > most) continue;
      ask(*parts_[k].field, false);
      most = greatest(values, points.count);
    }
  }
  static double greatest(const float* values, std::size_t count) {
    float most = -std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
      if (std::isnan(values[i])) return std::numeric_limits<double>::infinity();
      most = std::max(most, values[i]);
    }
    return most;
  }

  std::vector<Placed> parts_;
  std::size_t cost_ = 1;
};

}  // namespace

FieldPtr assembly(std::vector<Placed> parts) { return std::make_shared<Assembly>(std::move(parts)); }

}  // namespace fieldfab::openscad
