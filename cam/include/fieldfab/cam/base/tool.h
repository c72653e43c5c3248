/// Cutters as solids of revolution.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/base/units.h"

namespace fieldfab::cam {

/// Closed form of a Profile for loops without branches: at a distance d from the axis, with w = min(max(d - flat, 0),
/// widest), the height is max(corner - sqrt(corner^2 - w^2), cone + slope * d). Not valid for a free profile.
struct FlatCornerCone {
  float flat = 0, corner = 0, widest = 0, cone = 0, slope = 0;
  bool valid = false;
};

/// Profile of a cutter: the height of its lower surface above the tip as a function of the distance from its axis, mm.
/// It consists of a flat disc of radius `flat`, a corner of radius `corner`, and a cone whose side is inclined by
/// `taper` radians to the axis (0: a cylinder), out to `radius`. Flat, ball, bull-nose, V and tapered ball cutters
/// belong to this family, and so do their offsets. A free profile is a polyline instead.
class Profile {
 public:
  /// Throws Error(bad_input) for dimensions that are not those of a cutter.
  Profile(double flat, double corner, double taper, double radius);
  /// A free profile: points (distance from the axis, height above the tip), from the axis outwards. Throws
  /// Error(bad_input).
  explicit Profile(std::vector<Vec2> points);

  [[nodiscard]] double radius() const { return radius_; }
  /// Height of the surface above the tip, mm, at a distance from the axis of at most radius().
  [[nodiscard]] double height(double distance) const;
  /// Greatest distance of the surface from the axis, mm, at a height above the tip.
  [[nodiscard]] double distance(double height) const;
  [[nodiscard]] FlatCornerCone closed_form() const;
  /// Distances from the axis at which the surface has a convex edge or ends, mm.
  [[nodiscard]] const std::vector<double>& edges() const { return edges_; }
  /// Returns the offset of the cutter by `by` mm; its tip is lower by the same amount.
  [[nodiscard]] Profile grown(double by) const;

 private:
  double flat_ = 0, corner_ = 0, taper_ = 0, radius_ = 0;
  double bend_ = 0, bend_height_ = 0;  // distance from the axis and height at which the corner meets the cone
  std::vector<Vec2> points_;
  std::vector<double> edges_;
};

/// Shape of a cutter.
enum class ToolShape : std::uint8_t {
  flat,
  ball,
  bull,
  v,
  tapered,
  drill,
  profile,  ///< a free profile
  form,     ///< any half section, for simulation only
};
/// Returns "flat", "ball" and so on.
std::string_view name_of(ToolShape shape);
/// Returns the shape of that name. Throws Error(bad_input) at `place`, with the most similar name.
ToolShape tool_shape_named(std::string_view name, const std::string& place);

/// A tool: cutter, shank and holder.
struct Tool {
  int number = 1;
  std::string name;
  ToolShape shape = ToolShape::flat;
  double diameter = 0;       ///< greatest diameter of the cutting part, mm
  double corner_radius = 0;  ///< corner radius of a bull-nose cutter, tip radius of a tapered ball, mm
  double angle = 0;          ///< included angle of a V cutter, a drill or a tapered ball, radians
  double tip_diameter = 0;   ///< tip diameter of a blunt V cutter, mm
  std::vector<Vec2> points;  ///< points of a free profile: distance from the axis, height above the tip, mm
  double flute = 0;          ///< cutting length, mm; 0: unknown
  double length = 0;         ///< distance from tip to holder, mm; 0: unknown
  double shank = 0;          ///< shank diameter, mm; 0: equal to the cutting diameter
  double holder_diameter = 0, holder_length = 0;
  int flutes = 2;
  double feed = 0, plunge = 0;  ///< feed and plunge rate, mm/min; 0: from the material or the machine
  double spindle = 0;           ///< spindle speed, revolutions per minute; 0: from the material or the machine

  [[nodiscard]] double radius() const { return diameter / 2; }
  /// Radius of the helix of the tool's centre when it enters solid material, mm; small enough that no core remains.
  [[nodiscard]] double helix_radius() const { return 0.4 * diameter; }
  /// Returns the profile. Throws Error(bad_input) for dimensions that are not those of a cutter.
  [[nodiscard]] Profile profile() const;
};

}  // namespace fieldfab::cam
