/// Swept volume of a convex piece of a tool: its interval on each line of a lattice.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "fieldfab/cam/base/tool_solid.h"
#include "fieldfab/cam/stock/lattice.h"

namespace fieldfab::cam {

/// Intervals along one axis for a rectangle of a lattice's lines (Hahn 5.2.2 stores them in such a
/// buffer for each direction). Lines are indexed along the other axes, u and v, in cyclic order.
struct Window {
  int axis = 2;
  int u0 = 0, u1 = -1, v0 = 0, v1 = -1;  ///< range of lines, both ends included; empty if u1 < u0
  std::vector<float> entry, exit;        ///< mm from the lattice's corner; entry > exit for a line
                                         ///< without interval

  [[nodiscard]] int width() const { return u1 - u0 + 1; }
  [[nodiscard]] bool empty() const { return u1 < u0 || v1 < v0; }
  [[nodiscard]] bool has(int u, int v) const { return u >= u0 && u <= u1 && v >= v0 && v <= v1; }
  [[nodiscard]] std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v - v0) * static_cast<std::size_t>(width()) + static_cast<std::size_t>(u - u0);
  }
  void clear() {
    const std::size_t count = empty() ? 0 : static_cast<std::size_t>(width()) * static_cast<std::size_t>(v1 - v0 + 1);
    entry.assign(count, std::numeric_limits<float>::infinity());
    exit.assign(count, -std::numeric_limits<float>::infinity());
  }
};

/// The volume that a piece sweeps while its pose is interpolated linearly. Its boundary consists of
/// the piece at both ends (stamps), the surfaces swept by its edges, and the grazing curves (Hahn
/// 2.2): the points of the piece with a normal perpendicular to their velocity. A circle about the
/// axis has at most two of them. Curves become strips of triangles with a distance of at most
/// `tolerance`. If a piece turns while it moves along its axis, its grazing curves move over it;
/// they are also computed at intermediate times. Balls sweep exact capsules. A line's interval
/// reaches from the first intersection to the last: the swept volume is taken as convex along the
/// line. That holds for translations, and within the tolerance for steps from `steps_between`.
class Sweep {
 public:
  /// Poses are in the lattice's coordinates, mm from its corner. bounds() and near() are available
  /// at once; fill() requires build().
  Sweep(const ToolPiece& piece, const ToolPose& from, const ToolPose& to);
  /// Builds the surface. The result is valid within `domain` only.
  void build(double tolerance, const Box& domain);

  [[nodiscard]] const Box& bounds() const { return bounds_; }
  /// Returns false only if the sweep is farther than `distance` from a point, mm.
  [[nodiscard]] bool near(const Vec3& place, double distance) const;
  /// Extends the intervals of a cleared window with set axis and rectangle.
  void fill(Window& window, const StockLattice& lattice) const;

 private:
  /// A zone in one pose; or the volume of a disc about the tool's axis, of radius zone.r0 at height
  /// zone.z0, that moves straight along `way`.
  struct Stamp {
    Zone zone;
    ToolPose pose;
    bool disc;
    Vec3 way;
  };
  using Triangle = std::array<Vec3, 3>;
  /// A range of consecutive triangles and its bounding box.
  struct Strip {
    std::size_t first, last;
    Box box;
  };

  void add_strip(const std::vector<Vec3>& from, const std::vector<Vec3>& to);
  void add_disc(double height, double radius, double tolerance);
  /// A point of the half section with its normal: distance from the axis, height, radial part,
  /// axial part.
  using SectionPoint = std::array<double, 4>;
  /// `sharpest`: minimum radius of curvature of the section.
  void add_grazing(const std::function<SectionPoint(double)>& section, int parts, double sharpest, double tolerance);

  const ToolPiece* piece_;
  ToolPose from_, to_;
  std::vector<Stamp> stamps_;
  std::vector<Triangle> triangles_;
  std::vector<Strip> strips_;
  Box bounds_;
  std::array<Vec3, 4> core_;  ///< the ends of the axis, at the start and at the end: the axis stays
                              ///< in their convex hull, and the piece within `radius_` of it
  double radius_ = 0;
  bool endless_ = false;  ///< the upper end is so far away that it is ignored
};

}  // namespace fieldfab::cam
