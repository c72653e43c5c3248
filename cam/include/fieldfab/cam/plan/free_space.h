/// Where there is room around a part: for shanks, holders and tilted cutters.
#pragma once

#include <cstdint>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

/// A piece of a tool about its axis: a cylinder or a cone, from one height above the tip to another, mm.
struct Frustum {
  double from, to;                ///< heights along the axis
  double radius_from, radius_to;  ///< there
  bool cuts = false;              ///< the cutting part: the part may be touched
};

/// The space outside of a solid. What it says is clear, is: by the Field's intervals, not by samples.
class FreeSpace {
 public:
  /// Looks at the part inside of `bounds`; outside of it there is nothing. Throws cancelled.
  FreeSpace(FieldPtr part, const Box& bounds, Progress& progress = Progress::none());

  /// Whether a piece of a tool is clear of the part. False also where that is not certain: within `tolerance` mm of it, or where
  /// telling would take too long.
  [[nodiscard]] bool clear(const Vec3& tip, const Vec3& axis, const Frustum& piece, double tolerance) const;
  [[nodiscard]] const Box& bounds() const { return bounds_; }

 private:
  void fill(const Field& part, const Eigen::Vector3i& from, int size);
  [[nodiscard]] std::size_t index(const Eigen::Vector3i& c) const {
    return (static_cast<std::size_t>(c.z()) * static_cast<std::size_t>(count_.y()) + static_cast<std::size_t>(c.y())) *
               static_cast<std::size_t>(count_.x()) +
           static_cast<std::size_t>(c.x());
  }
  [[nodiscard]] double room(const Vec3& p) const;

  FieldPtr part_;
  Box bounds_;
  double cell_;
  Eigen::Vector3i count_;
  std::vector<std::uint8_t> steps_;  // by cell: how many cells to the nearest one that may hold some of the part, at most 255
};

}  // namespace fieldfab::cam
