/// Flat shapes as polygons, and what is done with them (by Clipper, which OpenSCAD uses, too).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace fieldfab::openscad {

using Vec2 = Eigen::Vector2d;
using Outline = std::vector<Vec2>;

/// What lies within outlines that cross neither themselves nor each other: anticlockwise around the solid, clockwise around
/// holes. mm.
struct Region {
  std::vector<Outline> outlines;

  [[nodiscard]] bool empty() const { return outlines.empty(); }
  [[nodiscard]] double area() const;    ///< mm^2
  [[nodiscard]] double length() const;  ///< of all outlines, mm
  /// About how wide the strokes are that it is made of, mm: the least of its pieces' areas over half their outlines' lengths.
  [[nodiscard]] double stroke() const;
  /// The smallest rectangle that holds it; only for one that is not empty.
  [[nodiscard]] Eigen::AlignedBox2d bounds() const;
};

/// What an odd number of outlines is around, whatever way round they go.
Region even_odd(const std::vector<Outline>& outlines);
/// What outlines wind around; those that go the other way round cancel each other.
Region wound(const std::vector<Outline>& outlines);

Region unite(const std::vector<Region>& all);
Region intersect(const std::vector<Region>& all);
/// The first less the others.
Region subtract(const std::vector<Region>& all);

/// How an offset goes round corners.
enum class Corner { round, mitre, chamfer };
/// Grown by `distance` mm (shrunk where negative); round corners are polygons of `fragments` sides to the circle.
Region offset(const Region& region, double distance, Corner corner, int fragments);

/// The sums of points of two shapes.
Region minkowski(const Region& a, const Region& b);
/// The convex hull of all points.
Region hull_of(const std::vector<Region>& all);

/// Moved; a map that mirrors keeps outlines the right way round. One that is not invertible gives an empty region.
Region moved(const Region& region, const Eigen::Affine2d& placement);

/// The same with gaps narrower than `width` mm closed, and strips narrower than that gone.
Region without_narrows(const Region& region, double width);
/// The same without slits and spikes that have no width: the union of many shadows has some, and their sides cannot be told.
Region tidied(const Region& region);
/// The same where no point is on the rim twice; else so little smaller that what touched lies apart.
Region separated(const Region& region);

/// Triangles that fill it, by its own corners, anticlockwise; each corner as outline and place in it, flattened into one count.
/// Throws internal where an outline crosses another.
std::vector<std::array<std::uint32_t, 3>> triangulate(const Region& region);

}  // namespace fieldfab::openscad
