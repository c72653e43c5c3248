/// Flat shapes as polygons, and operations on them (by Clipper, which OpenSCAD uses too).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace fieldfab::openscad {

using Vec2 = Eigen::Vector2d;
using Outline = std::vector<Vec2>;

/// The region within outlines that intersect neither themselves nor each other: anticlockwise
/// around the solid, clockwise around holes. In mm.
struct Region {
  std::vector<Outline> outlines;

  [[nodiscard]] bool empty() const { return outlines.empty(); }
  [[nodiscard]] double area() const;    ///< mm^2
  [[nodiscard]] double length() const;  ///< of all outlines, mm
  /// Approximate width of its narrowest piece, mm: the minimum of area / half the outline length.
  [[nodiscard]] double stroke() const;
  /// Bounding rectangle. Precondition: the region is not empty.
  [[nodiscard]] Eigen::AlignedBox2d bounds() const;
};

/// Returns the points with an odd number of outlines around them, whatever the direction of the
/// outlines.
Region even_odd(const std::vector<Outline>& outlines);
/// Returns the points with a winding number other than 0; outlines of opposite direction cancel.
Region wound(const std::vector<Outline>& outlines);

Region unite(const std::vector<Region>& all);
Region intersect(const std::vector<Region>& all);
/// Returns the first region minus the others.
Region subtract(const std::vector<Region>& all);

/// Shape of an offset at corners.
enum class Corner { round, mitre, chamfer };
/// Offsets outwards by `distance` mm, inwards if negative. Round corners are polygons with
/// `fragments` sides per circle.
Region offset(const Region& region, double distance, Corner corner, int fragments);

/// Minkowski sum of two shapes.
Region minkowski(const Region& a, const Region& b);
/// Convex hull of all points.
Region hull_of(const std::vector<Region>& all);

/// Applies an affine map. Reverses outlines if the map mirrors. A singular map gives an empty
/// region.
Region moved(const Region& region, const Eigen::Affine2d& placement);

/// Closes gaps and removes strips narrower than `width` mm.
Region without_narrows(const Region& region, double width);
/// Removes slits and spikes without width. The union of many shadows has some, and the side that
/// their edges bound is undefined.
Region tidied(const Region& region);
/// Returns the region such that no point is on its outlines twice; shrinks it slightly if needed,
/// so that touching outlines are disjoint.
Region separated(const Region& region);

/// Triangulates the region, anticlockwise, with its own corners only. Indices count the corners of
/// all outlines in order. Throws internal if outlines intersect.
std::vector<std::array<std::uint32_t, 3>> triangulate(const Region& region);

}  // namespace fieldfab::openscad
