// Five-axis machining: FreeSpace is conservative, and tilted tools touch the part only with their
// ball.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "../cam_tools.h"
#include "../family.h"
#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/cam/plan/tilt.h"
#include "fieldfab/field/operations.h"

namespace fieldfab::cam {
namespace {

constexpr double pi = std::numbers::pi;

FieldPtr dome_in_a_corner() {
  return formula(
      "min(max(sqrt(x*x+y*y+(z+8)*(z+8))-14, -z-2), min(max(max(x+11, -x-14), max(abs(y)-12, max(z-14, -z-2))), "
      "max(max(abs(x)-14, abs(y)-12), abs(z+1)-1)))");
}
FieldPtr waves() { return formula("(z - 2 - 1.2*sin(0.7*x+sin(0.4*y)) - 0.9*cos(0.8*y+0.3*x))/1.8"); }

Tool held_ball(double diameter, double flute, double length) {
  Tool t = tool("ball", diameter);
  t.flute = flute, t.length = length, t.shank = diameter + 1, t.holder_diameter = 16, t.holder_length = 30;
  return t;
}

/// Visits points of a piece of a tool: its walls, its ends, its inside.
template <class Visit>
void each_point(const Vec3& tip, const Vec3& axis, const Frustum& piece, double longest, const Visit& visit) {
  const Vec3 side = axis.unitOrthogonal(), other = axis.cross(side);
  const double to = std::min(piece.to, piece.from + longest);
  for (int i = 0; i <= 16; ++i)
    for (const double share : {1.0, 0.7, 0.35, 0.0})
      for (int k = 0; k < 12; ++k) {
        const double along = piece.from + (to - piece.from) * i / 16,
                     radius = piece.radius_from + (piece.radius_to - piece.radius_from) * (along - piece.from) /
                                                      std::max(piece.to - piece.from, 1e-9);
        const double angle = 2 * pi * k / 12;
        visit(tip + along * axis + share * radius * (std::cos(angle) * side + std::sin(angle) * other));
      }
}

TEST(FreeSpace, NeverCallsClearWhatIsNot) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-20, 20), height(-4, 20), one(-1, 1), radius(0.2, 4), length(1, 40);
  for (const auto& [part, bounds] : {std::pair{dome_in_a_corner(), Box{{-14, -12, -2}, {14, 12, 14}}},
                                     std::pair{waves(), Box{{-12, -12, -2}, {12, 12, 5}}}}) {
    const FieldPtr solid = intersect(part, box_field(bounds));
    const FreeSpace space(solid, bounds);
    int clear = 0, blocked = 0;
    for (int trial = 0; trial < 1500; ++trial) {
      const Vec3 tip(at(random), at(random), height(random)), axis = Vec3(one(random), one(random), 1).normalized();
      Frustum piece;
      piece.from = 0, piece.to = length(random), piece.radius_from = radius(random), piece.radius_to = radius(random);
      bool touches = false, near = false;
      each_point(tip, axis, piece, 1e9,
                 [&](const Vec3& p) { touches |= solid->value(p) < 0, near |= solid->value(p) < 0.4; });
      const bool called_clear = space.clear(tip, axis, piece, 0.05);
      EXPECT_FALSE(called_clear && touches) << tip.transpose() << " along " << axis.transpose();
      // Poses with a wide clearance are reported as clear: samples are at most 2 mm apart.
      if (!near && !called_clear) {
        Frustum wider = piece;
        wider.radius_from += 2, wider.radius_to += 2, wider.from -= 1;
        bool really = false;
        each_point(tip, axis, wider, 1e9, [&](const Vec3& p) { really |= solid->value(p) < 0.5; });
        EXPECT_TRUE(really) << tip.transpose() << " along " << axis.transpose();
      }
      (called_clear ? clear : blocked)++;
    }
    EXPECT_GT(clear, 150);
    EXPECT_GT(blocked, 150);
  }
}

struct Case {
  FieldPtr part;
  Box bounds;
  Tool tool;
  double lead, most;
};

std::vector<Case> cases() {
  Tool tapered = tool("tapered", 6, 1, 12 * pi / 180);
  tapered.flute = 14, tapered.length = 30, tapered.holder_diameter = 14, tapered.holder_length = 25;
  return {{dome_in_a_corner(), {{-14, -12, -2}, {14, 12, 14}}, held_ball(4, 8, 22), 10 * pi / 180, 1},
          {waves(), {{-12, -12, -2}, {12, 12, 5}}, held_ball(3, 6, 15), 0, 1.2},
          {waves(), {{-12, -12, -2}, {12, 12, 5}}, tapered, -0.2, 0.8}};
}

TEST(Tilted, TouchesThePartWithTheBallOnly) {
  for (const Case& c : cases()) {
    const FieldPtr solid = intersect(c.part, box_field(c.bounds));
    const Box bounds = c.bounds;
    const auto surface = Surface::of(*solid, bounds, {0.1, 0.01});
    const TipSurface tips(surface, c.tool.profile());
    FinishSettings finish;
    finish.area = Rectangle::of(bounds);
    finish.stepover = sample_or_all(9.0, 6.1);
    const std::vector<Path> upright = raster(tips, finish);
    const FreeSpace space(solid, bounds);
    TiltSettings settings;
    settings.lead = c.lead, settings.most = c.most, settings.clearance = 0.8;
    TiltReport report;
    const Plane plane;
    const std::vector<Path> paths = tilted(upright, tips, c.tool, plane, space, settings, report);
    EXPECT_GT(report.leaning, 0.5 * (report.leaning + report.otherwise + report.left_out));

    const double ball = c.tool.shape == ToolShape::ball ? c.tool.radius() : c.tool.corner_radius;
    const std::vector<Frustum> pieces = pieces_of(c.tool, settings.clearance, 60);
    double steepest = 0, length = 0;
    for (const Path& path : paths)
      for (std::size_t i = 1; i < path.points.size(); ++i) {
        const PathPoint &a = path.points[i - 1], &b = path.points[i];
        length += (b.at + ball * b.axis - a.at - ball * a.axis).norm();
        EXPECT_LE(std::acos(std::min(1.0, b.axis.z())), settings.most + 1e-6);
        steepest = std::max(steepest, std::acos(std::min(1.0, b.axis.z())));
        for (const double share : {0.5, 1.0}) {
          const Vec3 axis = (a.axis + share * (b.axis - a.axis)).normalized(), tip = a.at + share * (b.at - a.at),
                     middle = tip + ball * axis;
          // The ball keeps its position, and is no deeper.
          EXPECT_GE(middle.z() - ball, tips.tip(middle.head<2>()) - 0.02) << middle.transpose();
          for (const Frustum& piece : pieces)
            each_point(tip, axis, piece, 45, [&](const Vec3& p) {
              const double value = solid->value(p), depth = -value / std::max(1e-3, solid->gradient(p).norm());
              EXPECT_LE(depth, piece.cuts ? 0.025 : 0.0) << p.transpose();
            });
        }
      }
    double whole = 0;
    for (const Path& path : upright) whole += path.length();
    EXPECT_NEAR(length, whole - report.left_out, 0.03 * whole + 5);
    EXPECT_GT(steepest, 0.4);
  }
}

TEST(Tilted, FollowsTheArcsOfLevelContours) {
  // Round a dome of radius 10: closed paths of a few arcs each. The ball's centre keeps a distance
  // of 12 mm from the dome's centre.
  const FieldPtr solid = formula("max(sqrt(x*x+y*y+z*z)-10, -z)");
  const Box bounds{{-11, -11, 0}, {11, 11, 10}};
  const Tool t = held_ball(4, 20, 30);
  const auto tips = std::make_shared<TipSurface>(Surface::of(*solid, bounds, {0.1, 0.01}), t.profile());
  CutSettings cut;
  cut.radius = 2, cut.depths = {9, 3, 2};
  const std::vector<Path> levels = waterline(tips, {{-14, -14}, {14, 14}}, 0.15, cut);
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_LT(levels[0].points.size(), 20U);
  double length = 0;
  TiltReport report;
  for (const Path& path : tilted(levels, *tips, t, Plane{}, FreeSpace(solid, bounds), {}, report))
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const PathPoint& p = path.points[i];
      EXPECT_NEAR((p.at + 2 * p.axis).norm(), 12, 0.03);
      if (i > 0) length += (p.at + 2 * p.axis - path.points[i - 1].at - 2 * path.points[i - 1].axis).norm();
    }
  double whole = 0;
  for (const Path& path : levels) whole += path.length();
  EXPECT_NEAR(length, whole - report.left_out, 0.01 * whole);
}

TEST(Tilted, LeavesOutWhereNothingFits) {
  // A slot 30 mm deep for a tool that protrudes 12 mm from its holder.
  const FieldPtr solid = formula("max(max(abs(x)-20, max(abs(y)-20, max(z, -31-z))), -max(abs(x)-4, -30-z))");
  const Box bounds{{-20, -20, -31}, {20, 20, 0}};
  const Tool t = held_ball(4, 10, 12);
  const auto surface = Surface::of(*solid, bounds, {0.2, 0.02});
  const TipSurface tips(surface, t.profile());
  FinishSettings finish;
  finish.area = Rectangle::of(bounds);
  finish.stepover = 4;
  const FreeSpace space(solid, bounds);
  TiltReport report;
  const std::vector<Path> paths = tilted(raster(tips, finish), tips, t, Plane{}, space, {}, report);
  EXPECT_GT(report.left_out, 40);
  double lowest = 0;
  for (const Path& path : paths)
    for (const PathPoint& p : path.points)  // at the slot's ends the tool may tilt outwards
      if (std::abs(p.at.y()) < 5) lowest = std::min(lowest, p.at.z());
  EXPECT_GT(lowest, -20);
  EXPECT_LT(lowest, -3);
}

}  // namespace
}  // namespace fieldfab::cam
