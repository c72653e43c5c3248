/// Free space around a part, for collision tests of shanks, holders and inclined cutters.
#pragma once

#include <cstdint>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

/// A piece of a tool: a cylinder or a frustum between two heights above the tip, mm.
struct Frustum {
  double from, to;                ///< heights along the axis, mm
  double radius_from, radius_to;  ///< radii at these heights, mm
  bool cuts = false;              ///< whether this is the cutting part, which may touch the part
};

/// The complement of a solid. Answers are conservative: they rest on the Field's intervals, not on samples. All points
/// are in the Field's coordinates, mm. Member functions may be called by several threads.
class FreeSpace {
 public:
  /// Examines the part inside `bounds`; the space beyond is free. Shares ownership of `part`. Throws Error(cancelled).
  FreeSpace(FieldPtr part, const Box& bounds, Progress& progress = Progress::none());

  /// Whether a piece of a tool is clear of the part. `axis` is a unit vector from the tip to the shank. False if this
  /// is not certain: within `tolerance` mm of the part, or if a proof would take too long.
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
  // per cell: distance to the nearest cell that may contain the part, in cells, at most 255
  std::vector<std::uint8_t> steps_;
};

}  // namespace fieldfab::cam
