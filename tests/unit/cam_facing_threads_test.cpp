// Facing and thread milling: paths against what they promise, by counting.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/core/error.h"

using namespace fieldfab;
using namespace fieldfab::cam;

namespace {

constexpr double pi = std::numbers::pi;

CutSettings cut_of(double radius, double top, double bottom, double step = 1e300, bool climb = true) {
  CutSettings cut;
  cut.radius = radius;
  cut.depths = {top, bottom, step};
  cut.climb = climb;
  return cut;
}

double distance_to(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - p).norm();
}

/// Whether a point is within a tool that goes along a path.
bool covered(const Vec2& p, const std::vector<Path>& paths, double radius) {
  for (const Path& path : paths)
    for (std::size_t i = 1; i < path.points.size(); ++i)
      if (distance_to(p, path.points[i - 1].at.head<2>(), path.points[i].at.head<2>()) <= radius + 1e-9) return true;
  return false;
}

TEST(Facing, CoversTheStockAndCutsNoWiderThanTheStepover) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> size(4, 60), share(0.1, 1), turn(-pi, pi);
  for (int tried = 0; tried < 60; ++tried) {
    const Vec2 extent(size(random), size(random)), lower(size(random) - 30, size(random) - 30);
    const Rectangle stock{lower, lower + extent};
    const double radius = size(random) / 4, angle = turn(random);
    const FaceSettings settings{share(random) * 2 * radius, angle, tried % 2 == 0};
    const auto paths = face(stock, settings, cut_of(radius, 1, 0));
    for (double x = 0; x <= 1; x += 0.04)
      for (double y = 0; y <= 1; y += 0.04)
        ASSERT_TRUE(covered(stock.lower + Vec2(x * extent.x(), y * extent.y()), paths, radius)) << tried;
    // The leading edge advances by at most the stepover from pass to pass, the first from the stock's edge.
    const Vec2 v(-std::sin(angle), std::cos(angle));
    std::vector<double> passes;
    for (const Path& path : paths)
      for (std::size_t i = 1; i < path.points.size(); i += 2) {
        ASSERT_NEAR(path.points[i - 1].at.head<2>().dot(v), path.points[i].at.head<2>().dot(v), 1e-9);
        passes.push_back(path.points[i].at.head<2>().dot(v));
      }
    double edge = 1e300;
    for (const double x : {stock.lower.x(), stock.upper.x()})
      for (const double y : {stock.lower.y(), stock.upper.y()}) edge = std::min(edge, Vec2(x, y).dot(v));
    double reached = edge;
    for (const double at : passes) {
      if (passes.size() > 1) {
        ASSERT_LE(at + radius - reached, settings.stepover + 1e-9);
      }
      reached = at + radius;
    }
  }
}

TEST(Facing, ClimbsWhereItIsAsked) {
  for (const bool climb : {true, false}) {
    const auto paths = face({{0, 0}, {50, 30}}, {4, 0, false}, cut_of(5, 1, 0, 1e300, climb));
    ASSERT_GT(paths.size(), 5U);
    for (const Path& path : paths) {
      // What is left lies towards y: on the right of a tool that goes towards -x.
      EXPECT_EQ(path.points.back().at.x() < path.points.front().at.x(), climb);
      EXPECT_GT(std::max(path.points.front().at.x(), path.points.back().at.x()), 55);
      EXPECT_LT(std::min(path.points.front().at.x(), path.points.back().at.x()), -5);
    }
  }
}

TEST(Facing, GoesDownInSteps) {
  const auto paths = face({{0, 0}, {50, 30}}, {4, 0, true}, cut_of(5, 3, 0, 1.2));
  ASSERT_EQ(paths.size(), 3U);
  for (int level = 0; level < 3; ++level) {
    EXPECT_EQ(paths[static_cast<std::size_t>(level)].level, level);
    EXPECT_NEAR(paths[static_cast<std::size_t>(level)].points[0].at.z(), 2 - level, 1e-9);
  }
  EXPECT_THROW((void)face({{0, 0}, {50, 30}}, {0, 0, true}, cut_of(5, 3, 0)), Error);
  EXPECT_THROW((void)face({{0, 0}, {50, 30}}, {1, 0, true}, cut_of(0, 3, 0)), Error);
}

/// Angle about the hole's axis and height along the helix of a path, at every hundredth of its arcs.
struct Turn {
  double angle, z, radius;
};
std::vector<Turn> turns_of(const Path& path, const Hole& hole) {
  std::vector<Turn> turns;
  double last = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const PathPoint &a = path.points[i - 1], &b = path.points[i];
    if (a.bulge == 0) continue;
    for (int s = 0; s <= 100; ++s) {
      const Vec3 at = place_between(a.at, b.at, a.bulge, s / 100.0);
      const Vec2 out = at.head<2>() - hole.centre;
      double angle = std::atan2(out.y(), out.x());
      while (!turns.empty() && angle < last - pi) angle += 2 * pi;
      while (!turns.empty() && angle > last + pi) angle -= 2 * pi;
      last = angle;
      turns.push_back({angle, at.z(), out.norm()});
    }
  }
  return turns;
}

TEST(Threads, AreHelicesOfTheirPitchAndHand) {
  const Hole hole{{7, -3}, 2.5};
  for (const bool right : {true, false})
    for (const bool climb : {true, false}) {
      const ThreadSettings thread{0.8, 6, right, 1};
      const auto paths = mill_threads({hole}, thread, cut_of(1.6, 0, -7.3, 1e300, climb));
      ASSERT_EQ(paths.size(), 1U);
      std::vector<Turn> wall;
      for (const Turn& turn : turns_of(paths[0], hole))
        if (turn.radius > 1.4 - 1e-6) wall.push_back(turn);  // 3 mm less the tool's radius
      double lowest = 1e300, highest = -1e300;
      for (const Turn& turn : wall) {
        EXPECT_NEAR(turn.radius, 1.4, 1e-6);
        lowest = std::min(lowest, turn.z), highest = std::max(highest, turn.z);
      }
      EXPECT_NEAR(lowest, -7.3, 1e-9);
      EXPECT_GE(highest, 0);
      const Turn &a = wall.front(), &b = wall.back();
      const double rise = (b.z - a.z) / (b.angle - a.angle) * 2 * pi;
      EXPECT_NEAR(rise, right ? 0.8 : -0.8, 1e-6);  // a right-hand screw goes up anticlockwise
      EXPECT_EQ(b.angle > a.angle, climb);          // inside a hole, climbing is anticlockwise
      EXPECT_LT((paths[0].points.front().at.head<2>() - hole.centre).norm(), 1e-9);
      EXPECT_LT((paths[0].points.back().at.head<2>() - hole.centre).norm(), 1e-9);
      EXPECT_GE(paths[0].points.front().at.z(), 0);
    }
}

TEST(Threads, GoDeeperFromPassToPass) {
  const Hole hole{{0, 0}, 5};
  const auto paths = mill_threads({hole}, {1.5, 0, true, 3}, cut_of(3, 0, -10));
  ASSERT_EQ(paths.size(), 3U);
  for (std::size_t pass = 0; pass < 3; ++pass) {
    double widest = 0;
    for (const Turn& turn : turns_of(paths[pass], hole)) widest = std::max(widest, turn.radius + 3);
    EXPECT_NEAR(widest, 5 + thread_depth(1.5) * (static_cast<double>(pass) + 1) / 3, 1e-6);
  }
  EXPECT_NEAR(2 * thread_depth(1), 1.0825, 1e-4);  // M6: 6 less 4.917
}

TEST(Threads, ThatDoNotFitAreRefused) {
  const std::vector<Hole> holes{{{0, 0}, 2.5}};
  EXPECT_THROW((void)mill_threads(holes, {1, 4.9, true, 1}, cut_of(1, 0, -5)), Error);
  EXPECT_THROW((void)mill_threads(holes, {1, 6, true, 1}, cut_of(2.5, 0, -5)), Error);
  EXPECT_THROW((void)mill_threads(holes, {0, 6, true, 1}, cut_of(1, 0, -5)), Error);
  EXPECT_THROW((void)mill_threads(holes, {1, 6, true, 1}, cut_of(1, -5, 0)), Error);
}

}  // namespace
