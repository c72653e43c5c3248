/// Cutters as solids of revolution.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/base/units.h"

namespace fieldfab::cam {

/// A profile's numbers for loops without branches: at a distance d from the axis, with w = min(max(d - flat, 0), widest), its
/// height is the greater of corner - sqrt(corner^2 - w^2) and cone + slope * d. Not valid for a free profile.
struct FlatCornerCone {
  float flat = 0, corner = 0, widest = 0, cone = 0, slope = 0;
  bool valid = false;
};

/// The lower side of a cutter: how far its surface lies above the tip, by the distance from its axis. A flat disc of radius
/// `flat`, a corner of radius `corner`, then a cone that leans `taper` from the axis (0: a cylinder), out to `radius`; flat,
/// ball, bull-nose, V and tapered ball cutters are all of this family, and so is each of them grown by a distance. A free profile
/// is a polyline instead.
class Profile {
 public:
  /// Throws bad_input for what is no cutter.
  Profile(double flat, double corner, double taper, double radius);
  /// Points (distance from the axis, height above the tip), from the axis outwards.
  explicit Profile(std::vector<Vec2> points);

  [[nodiscard]] double radius() const { return radius_; }
  /// Height of the surface above the tip at a distance from the axis of at most radius(), mm.
  [[nodiscard]] double height(double distance) const;
  /// How far from the axis the surface is at a height above the tip: the greatest distance.
  [[nodiscard]] double distance(double height) const;
  [[nodiscard]] FlatCornerCone closed_form() const;
  /// Distances from the axis at which the surface has a sharp outer edge, or ends.
  [[nodiscard]] const std::vector<double>& edges() const { return edges_; }
  /// The cutter and all within `by` mm of it, its tip as much lower.
  [[nodiscard]] Profile grown(double by) const;

 private:
  double flat_ = 0, corner_ = 0, taper_ = 0, radius_ = 0;
  double bend_ = 0, bend_height_ = 0;  // where the corner ends and the cone begins
  std::vector<Vec2> points_;
  std::vector<double> edges_;
};

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
/// "flat" and so on.
std::string_view name_of(ToolShape shape);
/// Throws bad_input at `place`, with the nearest name.
ToolShape tool_shape_named(std::string_view name, const std::string& place);

/// A cutter as it sits in the machine.
struct Tool {
  int number = 1;
  std::string name;
  ToolShape shape = ToolShape::flat;
  double diameter = 0;       ///< of the cutting part at its widest, mm
  double corner_radius = 0;  ///< bull-nose; the tip's of a tapered ball
  double angle = 0;          ///< included angle of a v, a drill or a tapered ball, radians
  double tip_diameter = 0;   ///< of a v with a blunt tip
  std::vector<Vec2> points;  ///< of a free profile
  double flute = 0;          ///< length that cuts, mm; 0: not known
  double length = 0;         ///< from the tip to the holder, mm; 0: not known
  double shank = 0;          ///< diameter above the flutes, mm; 0: as the cutting part
  double holder_diameter = 0, holder_length = 0;
  int flutes = 2;
  double feed = 0, plunge = 0;  ///< mm/min; 0: the material's or the machine's
  double spindle = 0;           ///< revolutions per minute; 0: alike

  [[nodiscard]] double radius() const { return diameter / 2; }
  /// Of its middle on a helix into solid material: so that no core stays, mm.
  [[nodiscard]] double helix_radius() const { return 0.4 * diameter; }
  /// Throws bad_input for a tool that is none.
  [[nodiscard]] Profile profile() const;
};

}  // namespace fieldfab::cam
