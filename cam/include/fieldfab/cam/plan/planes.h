/// Machining from several sides (Keeter 6.9): planes, areas finished from earlier planes, and transfers between planes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/cam/plan/program.h"

namespace fieldfab::cam {

/// A machining plane: coordinates in which the tool points straight down.
struct Plane {
  std::string name = "top";
  /// its x, y and z directions in part coordinates, as columns; z is the tool axis
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  /// origin in the plane's own directions, mm; not zero for a set-up with its own zero
  Vec3 origin = Vec3::Zero();
  /// whether the plane covers only the near half of the part; the opposite plane covers the rest
  bool to_the_middle = true;
  bool setup = false;  ///< whether the part is rotated by hand and programs use the plane's coordinates
  [[nodiscard]] bool is_top() const { return axes.isIdentity(1e-12); }
  /// Converts a point from part to plane coordinates, mm.
  [[nodiscard]] Vec3 into(const Vec3& p) const { return axes.transpose() * p - origin; }
  /// Converts a point from plane to part coordinates, mm.
  [[nodiscard]] Vec3 out_of(const Vec3& p) const { return axes * (p + origin); }
  /// Returns the bounding box of another box in plane coordinates.
  [[nodiscard]] Box into(const Box& box) const { return image_of(box, axes.transpose(), -origin); }
};

/// Returns the plane orthogonal to the tool axis (from tip to spindle); its x direction is horizontal.
Plane plane_along(const Vec3& axis, std::string name);
/// Returns the plane "top", "bottom", "front", "back", "left" or "right". Throws Error(bad_input) for another name.
Plane plane_named(const std::string& name);
/// Returns the plane seen after a rotation of the part by `alpha` about z and then by `beta` about x (radians), as in
/// pictures.
Plane plane_from_view(double alpha, double beta);
/// Returns the five visible faces: top, back, front, left, right.
std::vector<Plane> five_planes();
/// Returns planes in equal angular steps: `count` per half turn about z, and from vertical to horizontal. None faces
/// down; each occurs once.
std::vector<Plane> stepped_planes(int count);

/// The area that an earlier operation on some plane could reach with its tool.
class Reached {
 public:
  /// `steepest` is the least cosine between surface normal and tool axis at which its passes were dense enough.
  Reached(Plane plane, std::shared_ptr<const TipSurface> tips, double steepest)
      : plane_(std::move(plane)), tips_(std::move(tips)), steepest_(steepest) {}
  /// Whether the tool could touch a point of the part's surface with that normal, to within `tolerance` mm. Both are in
  /// part coordinates.
  [[nodiscard]] bool touches(const Vec3& point, const Vec3& normal, double tolerance) const;
  [[nodiscard]] const Plane& plane() const { return plane_; }

 private:
  Plane plane_;
  std::shared_ptr<const TipSurface> tips_;
  double steepest_;
};

/// Returns the parts of finishing paths (in plane coordinates) on which the tool touches areas that no earlier
/// operation has reached.
std::vector<Path> not_reached(const std::vector<Path>& paths, const Plane& plane, const TipSurface& tips,
                              const Field& part, const std::vector<Reached>& earlier, double tolerance);

/// Converts moves from plane to part coordinates. Unless the plane is the top, arcs become lines with a deviation of at
/// most `tolerance` mm.
std::vector<Move> placed(const std::vector<Move>& moves, const Plane& plane, double tolerance);

/// Returns the rapids between two operations (Keeter Algorithm 6.1). `arm` is the distance from the tip to the pivot of
/// a head, mm; 0 for machines that rotate the work, where the tip moves around a ball that contains the stock. Throws
/// Error(bad_input) for a head axis below the horizontal.
std::vector<Move> transfer(const Move& from, const Move& to, const Box& stock, double clearance, double arm);

}  // namespace fieldfab::cam
