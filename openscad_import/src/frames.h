/// The axes along which the parts of a design are joined, so that faces drawn in one plane are in one.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <vector>

#include "leaf.h"

namespace fieldfab::openscad {

/// Seen along its own axes, what was turned is of rounded numbers, and faces that were drawn in one plane are in one; seen along
/// others, they are some last places apart. So each part, and each part of it, has the frame along whose axes most of those faces
/// of it look that share a plane with another solid's.
class Frames {
 public:
  static constexpr int any = -1;  ///< of a part that shares no planes

  Frames();  ///< one, the design's own
  /// Of a part no corner of which has a coordinate beyond `farthest` mm.
  Frames(const Part& part, double farthest);

  [[nodiscard]] int of(const Part& part) const;
  [[nodiscard]] int whole() const { return whole_; }  ///< that of the whole design
  [[nodiscard]] const Eigen::Matrix3d& axes(int frame) const { return axes_[static_cast<std::size_t>(frame)]; }  ///< as rows
  /// Coordinates in one frame to those in another.
  [[nodiscard]] Eigen::Matrix3d turn(int from, int to) const;

 private:
  std::vector<Eigen::Matrix3d> axes_;
  std::map<const Part*, int> of_;
  int whole_ = 0;
};

}  // namespace fieldfab::openscad
