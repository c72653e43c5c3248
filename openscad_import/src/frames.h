/// Axes along which the parts of a design are joined, such that faces drawn in one plane stay in
/// one plane.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <vector>

#include "leaf.h"

namespace fieldfab::openscad {

/// In its own axes a rotated part has round coordinates, and faces drawn in one plane are in one
/// plane; in other axes they differ by a few last places. So each part and each of its children
/// gets the frame to whose axes most of its faces are perpendicular. Only faces in a plane with
/// faces of another solid count.
class Frames {
 public:
  static constexpr int any = -1;  ///< frame of a part that shares no planes

  Frames();  ///< Makes one frame, that of the design
  /// Finds the frames of a part. No coordinate exceeds `farthest` mm in magnitude.
  Frames(const Part& part, double farthest);

  [[nodiscard]] int of(const Part& part) const;
  [[nodiscard]] int whole() const { return whole_; }  ///< frame of the whole design
  /// Axes of a frame, as rows.
  [[nodiscard]] const Eigen::Matrix3d& axes(int frame) const { return axes_[static_cast<std::size_t>(frame)]; }
  /// Rotation from the coordinates of one frame to those of another.
  [[nodiscard]] Eigen::Matrix3d turn(int from, int to) const;

 private:
  std::vector<Eigen::Matrix3d> axes_;
  std::map<const Part*, int> of_;
  int whole_ = 0;
};

}  // namespace fieldfab::openscad
