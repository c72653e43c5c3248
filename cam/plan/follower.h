/// Polyline of tip positions over a surface.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "fieldfab/cam/plan/surface.h"

namespace fieldfab::cam {

/// The tip's path over the surface along a line of the plane, as a polyline that is at most the
/// tolerance below the surface.
class Follower {
 public:
  Follower(const TipSurface& tips, double bottom, double tolerance)
      : tips_(tips), bottom_(bottom), tolerance_(tolerance) {}

  /// Moves straight from the last point to `to`.
  void go(const Vec2& to) {
    const Vec3 next = at(to);
    if (points_.empty())
      points_.push_back(next);
    else
      refine(points_.back(), next, 0);
  }
  /// Returns the polyline and starts a new one.
  std::vector<Vec3> take() { return simplified(std::exchange(points_, {}), 0.25 * tolerance_); }

 private:
  Vec3 at(const Vec2& p) {
    const TipSurface::Contact touched = tips_.contact(p, guess_);
    guess_ = touched.place;
    return {p.x(), p.y(), std::max(bottom_, touched.tip)};
  }

  /// Bisects until the midpoint lies on the segment, or at a wall until the segment is as short as
  /// the tolerance.
  void refine(const Vec3& from, const Vec3& to, int depth) {
    const double across = (to - from).head<2>().norm();
    if (depth < 24 && across > 0.5 * tolerance_) {
      const Vec3 middle = at(0.5 * (from + to).head<2>());
      const bool bent = std::abs(middle.z() - 0.5 * (from.z() + to.z())) > 0.5 * tolerance_;
      // possibly a wall on one side of the midpoint
      const bool steep = std::abs(to.z() - from.z()) > 2 * across;
      if (bent || (steep && across > tolerance_)) {
        refine(from, middle, depth + 1);
        refine(middle, to, depth + 1);
        return;
      }
    }
    // At a wall the tool goes up before it goes on, and on before it goes down.
    if (std::abs(to.z() - from.z()) > 2 * across && across > 0) {
      const double high = std::max(from.z(), to.z());
      points_.emplace_back(to.z() > from.z() ? from.x() : to.x(), to.z() > from.z() ? from.y() : to.y(), high);
    }
    points_.push_back(to);
  }

  const TipSurface& tips_;
  double bottom_, tolerance_;
  Vec2 guess_ = Vec2::Zero();
  std::vector<Vec3> points_;
};

}  // namespace fieldfab::cam
