// Contacts of cutters with surfaces, against closed forms, brute force, and the Field itself.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "../cam_tools.h"
#include "../family.h"
#include "fieldfab/cam/plan/contour.h"
#include "fieldfab/cam/plan/surface.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/mesh/mesh_field.h"

namespace fieldfab::cam {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Profile, HeightsAreThoseOfTheShapes) {
  EXPECT_EQ(tool("flat", 6).profile().height(2.9), 0);
  EXPECT_NEAR(tool("ball", 6).profile().height(3), 3, 1e-12);
  EXPECT_NEAR(tool("ball", 6).profile().height(1), 3 - std::sqrt(8.0), 1e-12);
  EXPECT_NEAR(tool("bull", 6, 1).profile().height(2.5), 1 - std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(tool("v", 6, 0, pi / 2).profile().height(2), 2, 1e-12);
  const Profile tapered = tool("tapered", 6, 0.5, pi / 9).profile();  // 10 degrees per side
  const double bend = 0.5 * std::cos(pi / 18);
  EXPECT_NEAR(tapered.height(bend), 0.5 * (1 - std::sin(pi / 18)), 1e-12);
  EXPECT_NEAR(tapered.height(bend + 1) - tapered.height(bend), 1 / std::tan(pi / 18), 1e-12);
  EXPECT_THROW((void)tool("bull", 6, 4).profile(), Error);
  EXPECT_THROW((void)tool("spoon", 6).profile(), Error);
  EXPECT_THROW((void)tool("v", 6).profile(), Error);
}

TEST(Profile, GrownIsTheMinkowskiSumWithABall) {
  for (const Tool& t : {tool("flat", 6), tool("ball", 6), tool("bull", 6, 1), tool("v", 6, 0, pi / 2),
                        tool("tapered", 6, 0.5, pi / 9)}) {
    const Profile p = t.profile(), grown = p.grown(0.4);
    std::vector<Vec2> points;
    for (int i = 0; i <= 200; ++i) points.emplace_back(3.0 * i / 200, p.height(3.0 * i / 200));
    Tool free = tool("profile", 0);
    free.points = points;
    const Profile sampled = free.profile().grown(0.4);
    for (double d = 0; d < 2.95; d += 0.05)
      EXPECT_NEAR(grown.height(d), sampled.height(d), 0.02) << name_of(t.shape) << " " << d;
  }
}

TEST(Profile, DistanceIsTheInverseOfHeight) {
  for (const Tool& t :
       {tool("ball", 6), tool("bull", 6, 1), tool("v", 6, 0, pi / 2), tool("tapered", 6, 0.5, pi / 9)}) {
    const Profile p = t.profile();
    for (double d = 2.1; d < 2.99; d += 0.1) EXPECT_NEAR(p.distance(p.height(d)), d, 1e-9) << name_of(t.shape);
  }
}

TEST(Surface, KeepsWallsToTheTolerance) {
  const FieldPtr box = rotate(box_field({{-5, -4, 0}, {5, 4, 6}}), {0, 0, 1}, 0.3);
  const auto surface = Surface::of(*box, {{-8, -8, -1}, {8, 8, 7}}, {0.25, 0.02});
  EXPECT_GT(surface->fine_squares(), 50U);
  EXPECT_EQ(surface->top(), 6);
  std::mt19937 random(1);
  std::uniform_real_distribution<> any(-7.5, 7.5);
  for (int i = 0; i < 20000; ++i) {
    const Vec2 p(any(random), any(random));
    const double wall = box->value({p.x(), p.y(), 3});
    if (std::abs(wall) > 0.03) {
      EXPECT_NEAR(surface->height(p), wall < 0 ? 6 : -1, 1e-3) << p.transpose();
    }
  }
}

TEST(Surface, FindsRibsThatNoSampleMeets) {
  const FieldPtr rib = box_field({{0.10, -3, 0}, {0.15, 3, 5}});
  const auto surface =
      Surface::of(*unite(rib, box_field({{-4, -4, -1}, {4, 4, 0}})), {{-4, -4, -1}, {4, 4, 5}}, {0.3, 0.02});
  EXPECT_NEAR(surface->top(), 5, 1e-3);
  EXPECT_NEAR(surface->height({0.125, 1.234}), 5, 1e-2);
}

/// Ribs and pins thinner than the distance of fine samples: low ones, some beside a higher wall, a
/// rotated one. The tool must stay above all of them.
TEST(Surface, KeepsWhatIsThinnerThanAnySample) {
  const Box bounds{{-6, -6, -1}, {6, 6, 5}};
  const FieldPtr floor = box_field({{-6, -6, -1}, {6, 6, 0}});
  const auto with = [&](const FieldPtr& part) { return unite(part, floor); };
  const auto wall = box_field({{2, -5, 0}, {4, 5, 5}});
  struct Rib {
    const char* name;
    FieldPtr solid;
    Vec2 from, to;  ///< along its centre line
    double top;
  };
  const auto line = [](double angle, double length) {
    return Vec2(length * std::cos(angle), length * std::sin(angle));
  };
  const Rib all[] = {
      {"high", with(box_field({{0.1, -3, 0}, {0.1001, 3, 4}})), {0.10005, -3}, {0.10005, 3}, 4},
      {"low", with(box_field({{0.1, -3, 0}, {0.1004, 3, 0.3}})), {0.1002, -3}, {0.1002, 3}, 0.3},
      {"beside a wall", unite(with(box_field({{0.1, -3, 0}, {0.1004, 3, 2}})), wall), {0.1002, -3}, {0.1002, 3}, 2},
      {"turned", with(rotate(box_field({{-3, 0.1, 0}, {3, 0.1003, 1}}), {0, 0, 1}, 0.7)),
       line(0.7, -3) + line(0.7 + pi / 2, 0.10015), line(0.7, 3) + line(0.7 + pi / 2, 0.10015), 1},
      {"pin",
       with(formula("max(sqrt((x-1.234)*(x-1.234)+(y-0.567)*(y-0.567))-0.002, max(0-z, z-3))")),
       {1.234, 0.567},
       {1.234, 0.567},
       3},
  };
  for (const Rib& rib : all) {
    const auto surface = Surface::of(*rib.solid, bounds, {0.3, 0.02});
    const TipSurface tips(surface, tool("flat", 1).profile()), needle(surface, Profile(0, 0, 0, 1e-6));
    for (int i = 0; i <= 100; ++i) {
      const Vec2 p = rib.from + (rib.to - rib.from) * (0.01 + 0.0098 * i);
      EXPECT_GE(tips.tip(p), rib.top - 0.081) << rib.name << " " << p.transpose();
      EXPECT_LE(tips.tip(p), rib.top + 0.081) << rib.name << " " << p.transpose();
      // so that it is part of an outline
      EXPECT_GT(needle.tip(p), 0.01) << rib.name << " " << p.transpose();
    }
  }
}

/// A slope with loose intervals is not taken for a rib.
TEST(Surface, RaisesNothingWhereNothingStands) {
  const FieldPtr hills = formula("z - sin(x)*cos(y) - 0.3*sin(3*x + 1)*sin(2*y) - 1.5");
  const auto surface = Surface::of(*hills, {{-6, -6, -1}, {6, 6, 5}}, {0.2, 0.01});
  EXPECT_EQ(surface->doubtful().count, 0U);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-5.9, 5.9);
  for (int i = 0; i < 20000; ++i) {
    const double x = at(random), y = at(random);
    EXPECT_NEAR(surface->height({x, y}), std::sin(x) * std::cos(y) + 0.3 * std::sin(3 * x + 1) * std::sin(2 * y) + 1.5,
                0.02);
  }
}

TEST(Surface, OfAMeshIsTheTopOfItsSolid) {
  const FieldPtr knot =
      formula("max(min(sqrt(x*x+y*y+z*z)-4, max(abs(x+3)-1, max(abs(y)-5, abs(z-1)-1))), 0-(sqrt((y-2)*(y-2)+z*z)-1))");
  const TriangleMesh mesh = contour(*knot, {{-5, -6, -5}, {5, 6, 5}}, {0.35});
  for (const FieldPtr& solid :
       {mesh_field(mesh), rotate(scale(mesh_field(mesh), Vec3::Constant(1.3)), {0.2, 0.9, 0.3}, 0.7)}) {
    const Box bounds{{-7, -7, -3}, {7, 7, 7}};
    const auto surface = Surface::of(*solid, bounds, {0.1, 0.01});
    std::mt19937 random(1);
    std::uniform_real_distribution<double> at(-6.9, 6.9);
    int solid_places = 0;
    for (int trial = 0; trial < sample_or_all(150, 500); ++trial) {
      const Vec2 p(at(random), at(random));
      const double h = surface->height(p);
      for (double z = h + 0.02; z < 7; z += 0.9)
        EXPECT_GT(solid->value({p.x(), p.y(), z}), -0.01) << p.transpose() << " " << z;
      if (h < bounds.lower.z() + 0.02) continue;
      bool at_a_wall = false;  // heights there are intermediate
      for (const Vec2& q : {Vec2(0.02, 0), Vec2(-0.02, 0), Vec2(0, 0.02), Vec2(0, -0.02)})
        at_a_wall |= std::abs(surface->height(p + q) - h) > 0.1;
      if (at_a_wall) continue;
      ++solid_places;
      EXPECT_LT(solid->value({p.x(), p.y(), h - 0.01}), 0.03) << p.transpose();
    }
    EXPECT_GT(solid_places, sample_or_all(20, 60));
  }
}

TEST(TipSurface, FollowsClosedForms) {
  // A dome: the centre of a ball cutter keeps its radius as distance.
  const auto dome = Surface::of(*formula("sqrt(x*x+y*y+z*z) - 10"), {{-12, -12, 0}, {12, 12, 10}}, {0.1, 0.01});
  const TipSurface ball(dome, tool("ball", 6).profile());
  for (double x = 0; x < 9; x += 0.37)
    EXPECT_NEAR(ball.tip({x, 0.2}), std::sqrt(13 * 13 - x * x - 0.04) - 3, 0.01) << x;
  // A flat cutter touches a dome with its rim.
  const TipSurface flat(dome, tool("flat", 6).profile());
  for (double x = 3.1; x < 12; x += 0.37) EXPECT_NEAR(flat.tip({x, 0}), std::sqrt(100 - (x - 3) * (x - 3)), 0.01) << x;
  // The allowance is measured along the normal.
  const TipSurface off(dome, tool("ball", 6).profile(), 0.5);
  EXPECT_NEAR(off.tip({5, 0}), std::sqrt(13.5 * 13.5 - 25) - 3, 0.01);
  // A V in a groove of its own angle reaches the bottom.
  const auto groove = Surface::of(*formula("max(z - abs(x), z - 4)"), {{-6, -6, -1}, {6, 6, 4}}, {0.1, 0.01});
  EXPECT_NEAR(TipSurface(groove, tool("v", 6, 0, pi / 2).profile()).tip({0, 0}), 0, 0.02);
  EXPECT_NEAR(TipSurface(groove, tool("v", 6, 0, pi / 2).profile()).tip({1, 0}), 1, 0.02);
}

TEST(TipSurface, IsThatOfBruteForce) {
  std::mt19937 random(2);
  HeightMap map(60, 50, 0.5, {1, 2}, 0);
  for (float& z : map.values) z = std::uniform_real_distribution<float>(0, 3)(random);
  const auto surface = Surface::of(map, 0);
  for (const Tool& t : {tool("flat", 4), tool("ball", 6), tool("bull", 6, 1), tool("v", 6, 0, pi / 2),
                        tool("tapered", 5, 0.5, pi / 4)}) {
    const Profile profile = t.profile();
    const TipSurface tips(surface, profile);
    std::uniform_real_distribution<> x(-2, 34), y(-2, 30);
    for (int i = 0; i < 300; ++i) {
      const Vec2 p(x(random), y(random));
      double samples = 0, dense = 0;
      for (int v = 0; v < map.height; ++v)
        for (int u = 0; u < map.width; ++u)
          if (const double away = (map.place(u, v) - p).norm(); away <= profile.radius())
            samples = std::max(samples, map.at(u, v) - profile.height(away));
      for (int v = -80; v <= 80; ++v)
        for (int u = -80; u <= 80; ++u)
          if (const double away = profile.radius() * std::hypot(u, v) / 80; away <= profile.radius())
            dense = std::max(dense, surface->height(p + profile.radius() * Vec2(u, v) / 80) - profile.height(away));
      EXPECT_GE(tips.tip(p), samples - 1e-6) << name_of(t.shape);
      EXPECT_LE(tips.tip(p), std::max(samples, dense) + 0.1) << name_of(t.shape);
    }
    for (int i = 0; i < 100; ++i) {
      const Vec2 low(x(random), y(random)), high = low + Vec2(1.3, 0.7) * static_cast<double>(i % 7);
      const Interval range = tips.range({low, high});
      for (int k = 0; k < 20; ++k) {
        const Vec2 p = low + (high - low)
                                 .cwiseProduct(Vec2(std::uniform_real_distribution<>()(random),
                                                    std::uniform_real_distribution<>()(random)));
        EXPECT_TRUE(range.contains(static_cast<float>(tips.tip(p)))) << name_of(t.shape);
      }
    }
  }
}

TEST(TipSurface, NeverCutsTheSolid) {
  // Random positions of each cutter on difficult solids: no point of its surface is inside by more
  // than the tolerance.
  struct Case {
    FieldPtr solid;
    Box bounds;
  };
  const Case cases[] = {
      {rotate(box_field({{-5, -4, 0}, {5, 4, 4}}), {0, 0, 1}, 0.3), {{-8, -8, 0}, {8, 8, 4.5}}},
      {formula("(z - 3 + 2*abs(x)) / sqrt(5)"), {{-6, -6, 0}, {6, 6, 3.2}}},  // a knife edge
      {formula("z - 2 - sin(1.3*x)*cos(1.1*y)"), {{-8, -8, 0}, {8, 8, 4}}},
  };
  std::mt19937 random(3);
  for (const Case& c : cases) {
    const auto surface = Surface::of(*c.solid, c.bounds, {0.1, 0.01});
    for (const Tool& t : {tool("flat", 3), tool("ball", 4), tool("bull", 4, 0.7), tool("v", 4, 0, pi / 3),
                          tool("tapered", 4, 0.5, pi / 6)}) {
      const Profile profile = t.profile();
      const TipSurface tips(surface, profile);
      std::uniform_real_distribution<> x(c.bounds.lower.x() + 2, c.bounds.upper.x() - 2), share(0, 1);
      double deepest = 0;
      for (int i = 0; i < 400; ++i) {
        const Vec2 p(x(random), x(random));
        const double tip = tips.tip(p);
        for (int k = 0; k < 200; ++k) {
          const double away = profile.radius() * std::sqrt(share(random)), angle = 2 * pi * share(random);
          const Vec3 at(p.x() + away * std::cos(angle), p.y() + away * std::sin(angle), tip + profile.height(away));
          if (at.z() < c.bounds.lower.z()) continue;
          deepest =
              std::min(deepest, static_cast<double>(c.solid->value(at)) / std::max(1.0, c.solid->gradient(at).norm()));
        }
      }
      EXPECT_GT(deepest, -0.015) << name_of(t.shape);
    }
  }
}

}  // namespace
}  // namespace fieldfab::cam
