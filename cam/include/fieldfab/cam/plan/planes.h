/// Machining from several sides (Keeter 6.9): planes, what an earlier plane has cut already, and going from one to the next.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fieldfab/cam/plan/material.h"
#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/cam/plan/program.h"

namespace fieldfab::cam {

/// A plane to cut from: its coordinates, in which the tool points straight down.
struct Plane {
  std::string name = "top";
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< its x, y and z in the part's coordinates; z is the tool's axis
  Vec3 origin = Vec3::Zero();  ///< of its coordinates, in its own directions: not zero where a set-up has a zero of its own
  bool to_the_middle = true;   ///< the far half of the part belongs to the plane across
  bool setup = false;          ///< the part is turned by hand, and programs are in the plane's coordinates
  [[nodiscard]] bool is_top() const { return axes.isIdentity(1e-12); }
  [[nodiscard]] Vec3 into(const Vec3& p) const { return axes.transpose() * p - origin; }
  [[nodiscard]] Vec3 out_of(const Vec3& p) const { return axes * (p + origin); }
  /// The box that holds another one, in the plane's coordinates.
  [[nodiscard]] Box into(const Box& box) const { return image_of(box, axes.transpose(), -origin); }
};

/// The plane that the tool's axis (from tip to spindle) is at right angles to; its x is level.
Plane plane_along(const Vec3& axis, std::string name);
/// "top", "bottom", "front", "back", "left" or "right"; throws bad_input for another name.
Plane plane_named(const std::string& name);
/// The plane seen after turning the part by `alpha` about z and then by `beta` about x (radians), as pictures do.
Plane plane_from_view(double alpha, double beta);
/// The five visible faces: top, back, front, left, right.
std::vector<Plane> five_planes();
/// Planes in even steps: `count` a half turn about z, and from straight above down to level. None overhangs; each occurs once.
std::vector<Plane> stepped_planes(int count);

/// What an earlier operation on some plane could reach with its tool.
class Reached {
 public:
  /// `steepest`: the least cosine between the surface's normal and the tool's axis at which its passes were close enough.
  Reached(Plane plane, std::shared_ptr<const TipSurface> tips, double steepest)
      : plane_(std::move(plane)), tips_(std::move(tips)), steepest_(steepest) {}
  /// Whether its tool could touch a point of the part's surface with that normal (both in the part's coordinates) to within
  /// `tolerance`, mm.
  [[nodiscard]] bool touches(const Vec3& point, const Vec3& normal, double tolerance) const;
  [[nodiscard]] const Plane& plane() const { return plane_; }

 private:
  Plane plane_;
  std::shared_ptr<const TipSurface> tips_;
  double steepest_;
};

/// Lowers a plane's material where operations on another plane have cut: each height to the highest place in its column that the
/// other one's material still holds. Heights stay above the true ones.
void take_away(Material& material, const Plane& plane, double floor, const Material& other, const Plane& other_plane);

/// The parts of finishing paths (in a plane's coordinates) where the tool touches what no earlier operation has reached.
std::vector<Path> not_reached(const std::vector<Path>& paths, const Plane& plane, const TipSurface& tips, const Field& part,
                              const std::vector<Reached>& earlier, double tolerance);

/// Moves from a plane's coordinates into the part's; arcs become lines off by at most `tolerance` unless the plane is the top.
std::vector<Move> placed(const std::vector<Move>& moves, const Plane& plane, double tolerance);

/// Algorithm 6.1: rapids from where one operation ended to where the next one starts. `arm` is the distance from the tip to the
/// point that a head turns about; 0 for machines that turn the work, where the tip goes round outside of a ball about the stock
/// instead. Throws bad_input for an axis that points below the horizon where a head turns.
std::vector<Move> transfer(const Move& from, const Move& to, const Box& stock, double clearance, double arm);

}  // namespace fieldfab::cam
