// Distances, contours, offsets and nesting in the plane, against brute force and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fieldfab/cam/plan/contour.h"
#include "fieldfab/cam/plan/distance.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/solid/open.h"

namespace fieldfab::cam {
namespace {

constexpr double pi = std::numbers::pi;

Loop square(double side) { return {{{0, 0}, {side, 0}, {side, side}, {0, side}}}; }

FieldPtr formula(const std::string& text) { return frep::make_field(frep::parse_infix(text)); }

Bitmap random_bitmap(std::mt19937& random, double share) {
  Bitmap bitmap(1 + static_cast<int>(random() % 70), 1 + static_cast<int>(random() % 70), 0.25, {1, 2}, 0);
  for (std::uint8_t& s : bitmap.values) s = std::uniform_real_distribution<>()(random) < share ? 1 : 0;
  return bitmap;
}

TEST(Distance, IsThatOfBruteForce) {
  std::mt19937 random(1);
  for (int round = 0; round < 60; ++round) {
    const Bitmap bitmap = random_bitmap(random, round % 3 == 0 ? 0.002 : round % 3 == 1 ? 0.05 : 0.7);
    const Lattice<float> distance = distance_transform(bitmap);
    for (int j = 0; j < bitmap.height; ++j)
      for (int i = 0; i < bitmap.width; ++i) {
        std::int64_t best = std::numeric_limits<std::int64_t>::max();
        for (int v = 0; v < bitmap.height; ++v)
          for (int u = 0; u < bitmap.width; ++u)
            if (bitmap.at(u, v) != 0) best = std::min<std::int64_t>(best, (u - i) * (u - i) + (v - j) * (v - j));
        if (best == std::numeric_limits<std::int64_t>::max())
          EXPECT_TRUE(std::isinf(distance.at(i, j)));
        else
          EXPECT_EQ(distance.at(i, j), static_cast<float>(0.25 * std::sqrt(static_cast<double>(best))));
      }
  }
}

TEST(Distance, IsTheSameForAnyNumberOfThreads) {
  std::mt19937 random(2);
  Bitmap bitmap(700, 500, 1, {0, 0}, 0);
  for (std::uint8_t& s : bitmap.values) s = random() % 1000 == 0 ? 1 : 0;
  const auto one = [&] {
    const ThreadLimit limit(1);
    return signed_distance(bitmap).values;
  }();
  EXPECT_EQ(one, signed_distance(bitmap).values);
}

TEST(Contours, ACircleIsRoundAndCounterClockwise) {
  const Loops loops = contours(*formula("sqrt(x*x + y*y) - 10"), {{-12, -12}, {12, 12}}, {0.5});
  ASSERT_EQ(loops.size(), 1U);
  for (const Vec2& p : loops[0].points) EXPECT_NEAR(p.norm(), 10, 1e-4);
  EXPECT_NEAR(loops[0].area(), pi * 100, 0.3);
}

TEST(Contours, AFormulaThatIsNoDistanceHasTheSameOutline) {
  const Loops loops = contours(*formula("(x*x + y*y)^3 - 1000000"), {{-12, -12}, {12, 12}}, {0.5});
  ASSERT_EQ(loops.size(), 1U);
  for (const Vec2& p : loops[0].points) EXPECT_NEAR(p.norm(), 10, 1e-3);
}

TEST(Contours, CornersAreSharpUnderAnyTurn) {
  for (int degrees = 0; degrees < 90; degrees += 7) {
    const FieldPtr turned = rotate(box_field({{-3, -2, -1}, {3, 2, 1}}), {0, 0, 1}, degrees * pi / 180);
    const Loops loops = contours(*turned, {{-5, -5}, {5, 5}}, {0.173});
    ASSERT_EQ(loops.size(), 1U);
    EXPECT_NEAR(loops[0].area(), 24, 2e-3) << degrees;
  }
}

TEST(Contours, WhatLeavesTheRegionIsClosedAlongItsBorder) {
  const Loops loops = contours(*formula("x - 1.03"), {{0, 0}, {2, 3}}, {0.1});
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_NEAR(loops[0].area(), 1.03 * 3, 1e-3);
}

TEST(Contours, AreTheSameForAnyNumberOfThreadsAndHoldEveryIsland) {
  const FieldPtr field = formula("sin(x)*sin(y) + 0.3*sin(3*x+1)");
  const Rectangle region{{0, 0}, {60, 50}};
  const Loops many = contours(*field, region, {0.1});
  const ThreadLimit limit(1);
  const Loops one = contours(*field, region, {0.1});
  ASSERT_EQ(one.size(), many.size());
  double area = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].points, many[i].points);
    area += one[i].area();
  }
  int inside = 0;  // brute force: solid fraction of the region
  for (int j = 0; j < 2000; ++j)
    for (int i = 0; i < 2400; ++i) inside += field->value({0.0125 + 0.025 * i, 0.0125 + 0.025 * j, 0}) < 0 ? 1 : 0;
  EXPECT_NEAR(area, inside * 0.000625, 0.2);
}

TEST(Contours, TellOfPartsNarrowerThanASquare) {
  const Rectangle region{{-6, -6}, {6, 6}};
  const FieldPtr wall = rotate(box_field({{-4, 0.101, -1}, {4, 0.111, 1}}), {0, 0, 1}, 0.3);
  const FieldPtr thin = unite(wall, box_field({{-5, 2, -1}, {-1, 5, 1}})),
                 slit = subtract(box_field({{-5, -5, -1}, {5, 5, 1}}), wall);
  MissedParts missed;
  for (const FieldPtr& solid : {thin, slit}) {
    (void)contours(*solid, region, {0.2}, missed);
    EXPECT_GT(missed.lost, 10U);
    EXPECT_NEAR(wall->value({missed.place.x(), missed.place.y(), 0}), 0, 0.02);
    const MissedParts many = missed;
    const ThreadLimit limit(1);
    (void)contours(*solid, region, {0.2}, missed);
    EXPECT_EQ(many.lost, missed.lost);
    EXPECT_EQ(many.place, missed.place);
    const Loops fine = contours(*solid, region, {0.005}, missed);
    EXPECT_EQ(fine.size(), 2U);
    EXPECT_FALSE(missed.any());
  }
  (void)contours(*formula("sqrt(x*x + y*y) - 5"), region, {0.2}, missed);
  EXPECT_FALSE(missed.any());
  (void)contours(*formula("sin(x)*sin(y) + 0.3*sin(3*x+1)"), region, {0.1}, missed);
  EXPECT_EQ(missed.lost, 0U);
}

TEST(Contours, RefuseWhatHasNoSize) {
  EXPECT_THROW(contours(*formula("x"), {{0, 0}, {1, 1}}, {0}), Error);
  EXPECT_THROW(contours(*formula("x"), {{0, 0}, {0, 1}}, {0.1}), Error);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(contours(*formula("x"), {{0, 0}, {1, 1}}, {0.1}, progress), Error);
}

TEST(Offset, ASquareGrownHasRoundCornersAndShrunkSharpOnes) {
  const Loops grown = offset({square(10)}, 2, 0.1), shrunk = offset({square(10)}, -2, 0.2);
  ASSERT_EQ(grown.size(), 1U);
  EXPECT_NEAR(grown[0].area(), 100 + 4 * 20 + pi * 4, 0.02);
  for (const Vec2& p : grown[0].points) {
    const Vec2 nearest = p.cwiseMax(Vec2(0, 0)).cwiseMin(Vec2(10, 10));
    EXPECT_NEAR((p - nearest).norm(), 2, 3e-4);
  }
  ASSERT_EQ(shrunk.size(), 1U);
  EXPECT_NEAR(shrunk[0].area(), 36, 1e-3);
  EXPECT_TRUE(offset({square(10)}, -5.01, 0.2).empty());
}

TEST(Offset, IsTheMinkowskiSumWithADiscByBruteForce) {
  // An L with a hole, offset both ways: each point of the result has exactly that distance from the
  // curves.
  Loops part{{{{0, 0}, {20, 0}, {20, 6}, {8, 6}, {8, 15}, {0, 15}}}, {{{2, 2}, {2, 5}, {5, 5}, {5, 2}}}};
  const FieldPtr distance = outline_field(part);
  for (const double by : {-0.8, -0.3, 0.5, 1.2, 3.0}) {
    const Loops moved = offset(part, by, 0.1);
    ASSERT_FALSE(moved.empty());
    for (const Loop& loop : moved)
      for (const Vec2& p : loop.points) {
        double nearest = 1e9;
        for (const Loop& edge : part)
          for (std::size_t k = 0; k < edge.points.size(); ++k) {
            const Vec2 a = edge.points[k], along = edge.points[(k + 1) % edge.points.size()] - a;
            nearest = std::min(nearest,
                               (p - a - std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along).norm());
          }
        EXPECT_NEAR(nearest, std::abs(by), 5e-4);
      }
  }
  EXPECT_LT(distance->value({1, 1, 0}), 0);
  EXPECT_GT(distance->value({3, 3, 0}), 0);  // in the hole
  EXPECT_GT(distance->value({9, 7, 0}), 0);
}

TEST(Nesting, FindsTheSmallestThatEncloses) {
  const auto ring = [](Vec2 centre, double radius, bool hole) {
    Loop loop;
    for (int i = 0; i < 24; ++i) {
      const double angle = (hole ? -1 : 1) * 2 * pi * (i + 0.3) / 24;
      loop.points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return loop;
  };
  const Loops loops{ring({0, 0}, 1, false),  ring({0, 0}, 10, false), ring({0, 0}, 5, true),
                    ring({20, 0}, 3, false), ring({7, 0}, 1, true),   ring({3, 0}, 1, false)};
  EXPECT_EQ(nesting(loops), (std::vector<int>{2, -1, 1, -1, 1, 2}));
}

TEST(Nesting, AgreesWithBruteForce) {
  const Loops loops = contours(*formula("sin(x)*sin(y) + 0.5*sin(5*x+1)*sin(4*y) + 0.1"), {{0, 0}, {40, 40}}, {0.05});
  ASSERT_GT(loops.size(), 50U);
  const std::vector<int> parent = nesting(loops);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    int best = -1;
    for (std::size_t k = 0; k < loops.size(); ++k)
      if (k != i && loops[k].encloses(loops[i].points[0]) && std::abs(loops[k].area()) > std::abs(loops[i].area()) &&
          (best < 0 || std::abs(loops[k].area()) < std::abs(loops[static_cast<std::size_t>(best)].area())))
        best = static_cast<int>(k);
    EXPECT_EQ(parent[i], best) << i;
  }
}

TEST(LatticeField, IsBilinearAndBounded) {
  std::mt19937 random(3);
  Lattice<float> lattice(90, 70, 0.5, {-1, 2}, 0);
  for (float& v : lattice.values) v = std::uniform_real_distribution<float>(-1, 1)(random);
  const FieldPtr field = lattice_field(lattice);
  EXPECT_EQ(field->value({-1 + 0.5 * 3, 2 + 0.5 * 4, 0}), lattice.at(3, 4));
  EXPECT_NEAR(field->value({-1 + 0.5 * 3.5, 2 + 0.5 * 4, 0}), (lattice.at(3, 4) + lattice.at(4, 4)) / 2, 1e-6);
  for (int round = 0; round < 300; ++round) {
    const double x = std::uniform_real_distribution<>(-3, 46)(random),
                 y = std::uniform_real_distribution<>(0, 40)(random);
    const Box box{{x, y, 0}, {x + static_cast<double>(random() % 40), y + static_cast<double>(random() % 30), 0}};
    const Interval range = field->interval(box);
    for (int k = 0; k < 20; ++k) {
      const Vec3 p = box.lower + (box.upper - box.lower)
                                     .cwiseProduct(Vec3(std::uniform_real_distribution<>()(random),
                                                        std::uniform_real_distribution<>()(random), 0));
      const float value = field->value(p);
      EXPECT_LE(range.lower, value + 1e-6F);
      EXPECT_GE(range.upper, value - 1e-6F);
    }
  }
}

TEST(OutlineField, KeepsItsSignWhereCurvesCross) {
  // A corner with a small bow-shaped self-intersection, as noise causes: its effect must be local.
  const Loop bow{{{0, 0}, {10, 0}, {10, 6}, {9.9, 6.1}, {10.1, 6.12}, {9.95, 5.9}, {9.8, 6.2}, {10, 10}, {0, 10}}};
  const FieldPtr field = outline_field({bow});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> at(-10, 20);
  for (int trial = 0; trial < 20000; ++trial) {
    const Vec2 p(at(random), at(random));
    if (std::abs(p.x() - 10) < 0.3 && std::abs(p.y() - 6) < 0.3) continue;
    const bool inside = p.x() > 0 && p.x() < 9.99 && p.y() > 0 && p.y() < 10;
    const bool near = std::abs(p.x() - 9.9) < 0.25 && p.y() > -0.1 && p.y() < 10.1;
    if (near) continue;
    EXPECT_EQ(field->value({p.x(), p.y(), 0}) < 0, inside) << p.transpose();
  }
  // Offsets are correct, too.
  for (const double distance : {2.0, -2.0}) {
    const Loops moved = offset({bow}, distance, 0.1);
    ASSERT_EQ(moved.size(), 1U);
    EXPECT_NEAR(moved[0].area(), distance > 0 ? 100 + 80 + 4 * 3.1416 : 36, 1.5);
  }
}

}  // namespace
}  // namespace fieldfab::cam
