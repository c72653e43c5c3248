/// What a convex piece of a tool occupies while it moves: the interval that it takes out of each line of a lattice.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "fieldfab/cam/base/tool_solid.h"
#include "fieldfab/cam/stock/lattice.h"

namespace fieldfab::cam {

/// Intervals along one axis for a rectangle of a lattice's lines (Hahn 5.2.2 stores them in such a buffer for each direction).
/// Lines are counted along the two other axes, u and v, in cyclic order.
struct Window {
  int axis = 2;
  int u0 = 0, u1 = -1, v0 = 0, v1 = -1;  ///< lines, both ends included; empty where u1 < u0
  std::vector<float> entry, exit;        ///< mm from the lattice's corner; entry > exit: the line is not met

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

/// The volume that a piece sweeps while its pose goes evenly from one to another. Its boundary lies on the piece at both ends
/// (stamps), on the ways of its edges, and on the grazing curves (Hahn 2.2): the points of the piece where it moves along itself,
/// of which a circle about the axis has at most two. Curves become strips of triangles, nowhere farther from them than
/// `tolerance`: where grazing curves wander over a piece that turns, as they do when it moves along its axis, they are found at
/// times in between as well. Balls sweep exact capsules. A line's interval reaches from the first of these to the last: the swept
/// volume is taken to be convex along it, which holds for translations, and within the tolerance for steps as `steps_between`
/// makes them.
class Sweep {
 public:
  /// Poses in the lattice's frame, mm from its corner. It knows where it is; fill() wants it built.
  Sweep(const ToolPiece& piece, const ToolPose& from, const ToolPose& to);
  /// Makes its surface. Nobody asks about what lies outside of `domain`.
  void build(double tolerance, const Box& domain);

  [[nodiscard]] const Box& bounds() const { return bounds_; }
  /// False where it surely stays farther than `distance` from a place.
  [[nodiscard]] bool near(const Vec3& place, double distance) const;
  /// Fills the intervals of a window whose rectangle and axis are set and that was cleared.
  void fill(Window& window, const StockLattice& lattice) const;

 private:
  /// A zone in one place; or a disc about the tool's axis, of radius zone.r0 at the height zone.z0, going straight along `way`.
  struct Stamp {
    Zone zone;
    ToolPose pose;
    bool disc;
    Vec3 way;
  };
  using Triangle = std::array<Vec3, 3>;
  /// Triangles that come one after the other, and their box.
  struct Strip {
    std::size_t first, last;
    Box box;
  };

  void add_strip(const std::vector<Vec3>& from, const std::vector<Vec3>& to);
  void add_disc(double height, double radius, double tolerance);
  /// A point of the half section, and its normal's two parts: distance from the axis, height, outwards, upwards.
  using SectionPoint = std::array<double, 4>;
  /// `sharpest`: the least radius that the section itself bends with.
  void add_grazing(const std::function<SectionPoint(double)>& section, int parts, double sharpest, double tolerance);

  const ToolPiece* piece_;
  ToolPose from_, to_;
  std::vector<Stamp> stamps_;
  std::vector<Triangle> triangles_;
  std::vector<Strip> strips_;
  Box bounds_;
  std::array<Vec3, 4> core_;  ///< the ends of the axis, first and last: all of it lies within `radius_` of what they span
  double radius_ = 0;
  bool endless_ = false;  ///< its upper end is so far out that it is taken to have none
};

}  // namespace fieldfab::cam
