#include "flat.h"

#include <algorithm>
#include <clipper.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "fieldfab/core/error.h"

namespace fieldfab::openscad {
namespace {

// Clipper computes with integers. This unit is small enough to keep the six digits that OpenSCAD
// writes to a .csg file, and large enough for shapes of a metre to fit into Clipper's fast range.
constexpr double units_a_mm = 1U << 20U;
constexpr double largest = 4e18 / units_a_mm / 4;  // mm

ClipperLib::Path to_path(const Outline& outline) {
  ClipperLib::Path path;
  path.reserve(outline.size());
  for (const Vec2& p : outline) {
    if (!(p.cwiseAbs().maxCoeff() < largest))
      throw Error(ErrorKind::bad_input, "polygon", "a point is too far away, or nowhere");
    path.emplace_back(std::llround(p.x() * units_a_mm), std::llround(p.y() * units_a_mm));
  }
  return path;
}

ClipperLib::Paths to_paths(const std::vector<Outline>& outlines) {
  ClipperLib::Paths paths;
  for (const Outline& outline : outlines) paths.push_back(to_path(outline));
  return paths;
}

/// Rounding leaves slivers and edges that go back on themselves. Anything narrower than this is
/// removed.
constexpr double sliver = 8;  // units

Region to_region(const ClipperLib::Paths& found) {
  ClipperLib::Paths paths = found;
  ClipperLib::CleanPolygons(paths, sliver);
  Region region;
  for (const ClipperLib::Path& path : paths) {
    if (path.size() < 3) continue;
    double length = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const ClipperLib::IntPoint &a = path[i], &b = path[(i + 1) % path.size()];
      length += std::hypot(static_cast<double>(b.X - a.X), static_cast<double>(b.Y - a.Y));
    }
    if (std::abs(ClipperLib::Area(path)) < 0.5 * sliver * length) continue;
    Outline outline;
    outline.reserve(path.size());
    for (const ClipperLib::IntPoint& p : path)
      outline.emplace_back(static_cast<double>(p.X) / units_a_mm, static_cast<double>(p.Y) / units_a_mm);
    region.outlines.push_back(std::move(outline));
  }
  return region;
}

ClipperLib::Paths clipped(ClipperLib::ClipType operation, const ClipperLib::Paths& subject,
                          const ClipperLib::Paths& clip, ClipperLib::PolyFillType filling = ClipperLib::pftNonZero) {
  ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
  const bool has_subject = clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  const bool has_clip = clipper.AddPaths(clip, ClipperLib::ptClip, true);
  ClipperLib::Paths result;
  if (!has_subject && !has_clip) return result;  // Clipper reports this as a failure
  if (!clipper.Execute(operation, result, filling, filling))
    throw Error(ErrorKind::bad_input, "polygon", "outlines cannot be joined");
  return result;
}

Region cleaned(const std::vector<Outline>& outlines, ClipperLib::PolyFillType filling) {
  return to_region(clipped(ClipperLib::ctUnion, to_paths(outlines), {}, filling));
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

double Region::area() const {
  double twice = 0;
  for (const Outline& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) twice += cross(outline[i], outline[(i + 1) % outline.size()]);
  return twice / 2;
}

double Region::length() const {
  double length = 0;
  for (const Outline& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) length += (outline[(i + 1) % outline.size()] - outline[i]).norm();
  return length;
}

double Region::stroke() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Outline& outline : outlines) {
    const Region one{{outline}};
    least = std::min(least, 2 * std::abs(one.area()) / one.length());
  }
  return least;
}

Eigen::AlignedBox2d Region::bounds() const {
  Eigen::AlignedBox2d box;
  for (const Outline& outline : outlines)
    for (const Vec2& p : outline) box.extend(p);
  return box;
}

Region even_odd(const std::vector<Outline>& outlines) { return cleaned(outlines, ClipperLib::pftEvenOdd); }
Region wound(const std::vector<Outline>& outlines) { return cleaned(outlines, ClipperLib::pftNonZero); }

Region unite(const std::vector<Region>& all) {
  if (all.size() == 1) return all.front();
  std::vector<Outline> outlines;
  for (const Region& region : all) outlines.insert(outlines.end(), region.outlines.begin(), region.outlines.end());
  return wound(outlines);
}

Region intersect(const std::vector<Region>& all) {
  if (all.empty()) return {};
  Region result = all.front();
  for (std::size_t i = 1; i < all.size(); ++i)
    result = to_region(clipped(ClipperLib::ctIntersection, to_paths(result.outlines), to_paths(all[i].outlines)));
  return result;
}

Region subtract(const std::vector<Region>& all) {
  if (all.size() < 2) return all.empty() ? Region{} : all.front();
  std::vector<Outline> others;
  for (std::size_t i = 1; i < all.size(); ++i)
    others.insert(others.end(), all[i].outlines.begin(), all[i].outlines.end());
  return to_region(clipped(ClipperLib::ctDifference, to_paths(all.front().outlines), to_paths(others)));
}

Region offset(const Region& region, double distance, Corner corner, int fragments) {
  const ClipperLib::JoinType join = corner == Corner::round   ? ClipperLib::jtRound
                                    : corner == Corner::mitre ? ClipperLib::jtMiter
                                                              : ClipperLib::jtSquare;
  // A polygon of n sides deviates by r (1 - cos(pi / n)) from its circle. OpenSCAD's cosine of 30
  // degrees is exact to the last bit; so the 1.5 sides in a quarter of a hexagon become 1.
  const double cosine = fragments == 6 ? std::sqrt(3.0) / 2 : std::cos(std::numbers::pi / std::max(fragments, 3));
  const double tolerance = std::abs(distance) * units_a_mm * (1 - cosine);
  constexpr double longest_mitre = 1e6;  // OpenSCAD cuts no corner off
  ClipperLib::ClipperOffset clipper(longest_mitre, std::max(tolerance, 1.0));
  clipper.AddPaths(to_paths(region.outlines), join, ClipperLib::etClosedPolygon);
  ClipperLib::Paths result;
  clipper.Execute(result, distance * units_a_mm);
  return to_region(clipped(ClipperLib::ctUnion, result, {}));
}

Region minkowski(const Region& a, const Region& b) {
  // The sum of two shapes is the union of the sums of each edge of one with each edge of the other,
  // and of each shape moved to a point of the other.
  ClipperLib::Paths parts;
  if (a.empty() || b.empty()) return {};
  for (const Outline& p : a.outlines)
    for (const Outline& q : b.outlines) {
      ClipperLib::Paths sum;
      ClipperLib::MinkowskiSum(to_path(p), to_path(q), sum, true);
      parts.insert(parts.end(), sum.begin(), sum.end());
    }
  const auto add_moved = [&](const Region& region, const Region& by) {
    for (const Outline& other : by.outlines) {  // one for each outline, since pieces may be disjoint
      std::vector<Outline> here;
      for (Outline outline : region.outlines) {
        for (Vec2& p : outline) p += other.front();
        here.push_back(std::move(outline));
      }
      const ClipperLib::Paths whole = to_paths(here);
      parts = clipped(ClipperLib::ctUnion, parts, {});
      parts = clipped(ClipperLib::ctUnion, parts, whole);
    }
  };
  parts = clipped(ClipperLib::ctUnion, parts, {});
  add_moved(a, b);
  add_moved(b, a);
  return to_region(parts);
}

Region hull_of(const std::vector<Region>& all) {
  std::vector<Vec2> points;
  for (const Region& region : all)
    for (const Outline& outline : region.outlines) points.insert(points.end(), outline.begin(), outline.end());
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  Outline hull;
  const auto chain = [&](auto first, auto last) {  // Andrew's monotone chain
    const std::size_t base = hull.size();
    for (auto p = first; p != last; ++p) {
      while (hull.size() > base + 1 && cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(*p);
    }
    if (hull.size() > base) hull.pop_back();
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  if (hull.size() < 3) return {};
  return {{hull}};
}

namespace {

bool has_point_twice(const Region& region) {
  std::vector<std::pair<double, double>> points;
  for (const Outline& outline : region.outlines)
    for (const Vec2& p : outline) points.emplace_back(p.x(), p.y());
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) != points.end();
}

constexpr double little = 4 * sliver / units_a_mm;  // mm

}  // namespace

Region without_narrows(const Region& region, double width) {
  const double half = width / 2;
  return offset(offset(offset(region, half, Corner::mitre, 4), -2 * half, Corner::mitre, 4), half, Corner::mitre, 4);
}

Region tidied(const Region& region) { return has_point_twice(region) ? without_narrows(region, 2 * little) : region; }

Region separated(const Region& region) {
  return has_point_twice(region) ? offset(region, -little, Corner::mitre, 4) : region;
}

Region moved(const Region& region, const Eigen::Affine2d& placement) {
  const double determinant = placement.linear().determinant();
  if (!(std::abs(determinant) > 0) || !placement.matrix().allFinite()) return {};
  Region result = region;
  for (Outline& outline : result.outlines) {
    for (Vec2& p : outline) p = placement * p;
    if (determinant < 0) std::reverse(outline.begin(), outline.end());
  }
  return result;
}

}  // namespace fieldfab::openscad
