// Paths: arcs, fitting, ordering.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fieldfab/cam/plan/contour.h"
#include "fieldfab/cam/plan/order.h"

namespace fieldfab::cam {
namespace {

constexpr double pi = std::numbers::pi;

Path circle(const Vec2& centre, double radius, int level = 0) {
  Path path;
  path.closed = true;
  path.level = level;
  for (int i = 0; i < 4; ++i)
    path.points.push_back({{centre.x() + radius * std::cos(i * pi / 2), centre.y() + radius * std::sin(i * pi / 2), 0},
                           std::tan(pi / 8)});
  return path;
}

TEST(Path, ArcsHaveLengthBoundsAndPoints) {
  const Path path = circle({1, 2}, 5);
  EXPECT_NEAR(path.length(), 10 * pi, 1e-9);
  EXPECT_NEAR(path.bounds().lower.x(), -4, 1e-9);
  EXPECT_NEAR(path.bounds().upper.y(), 7, 1e-9);
  for (const PathPoint& p : points_along(path, 0.1)) EXPECT_NEAR((p.at.head<2>() - Vec2(1, 2)).norm(), 5, 1e-9);
  Path turned = path;
  reverse(turned);
  EXPECT_NEAR(turned.length(), 10 * pi, 1e-9);
  EXPECT_LT(turned.points[0].bulge, 0);
  for (const PathPoint& p : points_along(turned, 0.1)) EXPECT_NEAR((p.at.head<2>() - Vec2(1, 2)).norm(), 5, 1e-9);
}

/// Greatest distance of a path's points from a polyline's corners and edges.
double deviation(const Path& path, const std::vector<Vec2>& points) {
  double worst = 0;
  for (const PathPoint& p : points_along(path, 0.02)) {
    double nearest = 1e9;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i], along = points[(i + 1) % points.size()] - a, q = p.at.head<2>();
      nearest =
          std::min(nearest, (q - a - std::clamp((q - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along).norm());
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

TEST(FitArcs, ARoundedSquareBecomesFourLinesAndFourArcs) {
  const Loops grown = offset({{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}}, 2, 0.1);
  ASSERT_EQ(grown.size(), 1U);
  const Path path = fit_arcs(grown[0].points, true, -1, 0.005);
  int arcs = 0;
  for (const PathPoint& p : path.points) arcs += p.bulge != 0 ? 1 : 0;
  EXPECT_LE(path.points.size(), 10U);
  EXPECT_GE(arcs, 4);
  EXPECT_NEAR(path.length(), 40 + 4 * pi, 0.02);
  EXPECT_LE(deviation(path, grown[0].points), 0.0055);
}

TEST(FitArcs, StaysWithinTheToleranceOfAnything) {
  std::mt19937 random(5);
  for (int round = 0; round < 30; ++round) {
    std::vector<Vec2> points;
    const double a = 1 + static_cast<double>(random() % 5), b = static_cast<double>(random() % 7);
    for (int i = 0; i < 400; ++i) {
      const double angle = 2 * pi * i / 400, radius = 10 + std::sin(a * angle) + 0.3 * std::cos(b * angle);
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    for (const double tolerance : {0.001, 0.01, 0.1}) {
      const Path path = fit_arcs(points, true, 0, tolerance);
      EXPECT_LE(deviation(path, points), 1.05 * tolerance);
      EXPECT_LT(path.points.size(), points.size());
    }
  }
  std::vector<Vec2> jagged;
  for (int i = 0; i < 50; ++i) jagged.emplace_back(i, i % 2);
  const Path path = fit_arcs(jagged, false, 0, 0.01);
  EXPECT_EQ(path.points.size(), 50U);
  EXPECT_EQ(path.points.back().at, Vec3(49, 1, 0));
}

TEST(Order, CutsWhatIsInsideFirstAndLevelsInTurn) {
  std::vector<Path> paths{circle({0, 0}, 10), circle({0, 0}, 3),     circle({30, 0}, 2),
                          circle({0, 0}, 6),  circle({0, 0}, 10, 1), circle({3, 3}, 0.5)};
  const AirTravel air = order(paths, {{40, 0}});
  EXPECT_LE(air.after, air.before);
  std::vector<double> radius;
  for (const Path& p : paths) radius.push_back(p.bounds().size().x() / 2);
  const auto place = [&](double r) {
    return std::find_if(radius.begin(), radius.end(), [&](double x) { return std::abs(x - r) < 1e-6; }) -
           radius.begin();
  };
  EXPECT_LT(place(3), place(6));
  EXPECT_LT(place(0.5), place(6));
  EXPECT_LT(place(6), place(10));
  EXPECT_EQ(paths.back().level, 1);
  EXPECT_EQ(place(2), 0);
}

TEST(Order, IsNeverWorseThanGreedyAndKeepsTheRule) {
  std::mt19937 random(6);
  std::uniform_real_distribution<> any(0, 100);
  for (int round = 0; round < 10; ++round) {
    std::vector<Path> paths;
    for (int i = 0; i < 120; ++i)
      paths.push_back(circle({any(random), any(random)}, 0.2 + 0.01 * any(random) * (i % 10 == 0 ? 20 : 1)));
    std::vector<Path> ordered = paths;
    const AirTravel air = order(ordered, {});
    ASSERT_EQ(ordered.size(), paths.size());
    EXPECT_LT(air.after, 0.35 * air.before);
    // Circles that enclose others come later.
    for (std::size_t i = 0; i < ordered.size(); ++i)
      for (std::size_t k = i + 1; k < ordered.size(); ++k) {
        const Rectangle a = ordered[i].bounds(), b = ordered[k].bounds();
        const Vec2 ca = 0.5 * (a.lower + a.upper), cb = 0.5 * (b.lower + b.upper);
        const double ra = a.size().x() / 2, rb = b.size().x() / 2;
        if ((ca - cb).norm() + rb >= ra) continue;
        bool crossing = false;  // loops that cross have no order
        for (const Path& other : ordered) {
          const Rectangle c = other.bounds();
          const Vec2 cc = 0.5 * (c.lower + c.upper);
          const double rc = c.size().x() / 2, d = (cc - cb).norm(), e = (cc - ca).norm();
          crossing |= (d < rb + rc && d > std::abs(rb - rc)) || (e < ra + rc && e > std::abs(ra - rc));
        }
        EXPECT_TRUE(crossing) << i << " is cut before " << k << ", which lies inside";
      }
  }
}

TEST(Order, OpenPathsMayBeTurned) {
  std::vector<Path> paths;
  for (int i = 0; i < 20; ++i) {
    Path p;
    p.points = {{{0, static_cast<double>(i), 0}}, {{50, static_cast<double>(i), 0}}};
    paths.push_back(p);
  }
  OrderSettings settings;
  settings.may_reverse = true;
  EXPECT_NEAR(order(paths, settings).after, 19, 1e-6);
}

}  // namespace
}  // namespace fieldfab::cam
