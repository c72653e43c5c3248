// Operations on outlines, entries, and durations of programs, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "../cam_tools.h"
#include "../family.h"
#include "fieldfab/cam/plan/material.h"
#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/cam/plan/planes.h"
#include "fieldfab/cam/plan/planned_stock.h"
#include "fieldfab/cam/plan/program.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"

namespace fieldfab::cam {
namespace {

constexpr double pi = std::numbers::pi;

Loop rectangle(double w, double h) { return {{{0, 0}, {w, 0}, {w, h}, {0, h}}}; }
Loop ring(const Vec2& centre, double radius, bool hole, int n = 256) {
  Loop loop;
  for (int i = 0; i < n; ++i)
    loop.points.push_back(
        centre + radius * Vec2(std::cos((hole ? -2 : 2) * pi * i / n), std::sin((hole ? -2 : 2) * pi * i / n)));
  return loop;
}
Outline outline(const Loops& loops, const Rectangle& bounds) { return {outline_field(loops), bounds, 0.1}; }

CutSettings cut_of(double radius, double depth) {
  CutSettings cut;
  cut.radius = radius;
  cut.depths = {0, -depth, 1e300};
  return cut;
}

TEST(Depths, AreEvenAndEndAtTheBottom) {
  EXPECT_EQ((Depths{0, -4, 1.5}.passes()), (std::vector<double>{-4.0 / 3, -8.0 / 3, -4}));
  EXPECT_EQ((Depths{0, -4, 2}.passes()), (std::vector<double>{-2, -4}));
  EXPECT_EQ((Depths{1, 0, 1e300}.passes()), (std::vector<double>{0}));
  EXPECT_THROW((void)(Depths{0, 0, 1}.passes()), Error);
  EXPECT_THROW((void)(Depths{0, -1, 0}.passes()), Error);
}

TEST(Profile2d, RunsAroundAtTheToolsRadius) {
  const Outline part = outline({rectangle(20, 10)}, {{0, 0}, {20, 10}});
  const auto outside = profile(part, Side::outside, cut_of(2, 3)), inside = profile(part, Side::inside, cut_of(2, 3)),
             on = profile(part, Side::on, cut_of(2, 3));
  ASSERT_EQ(outside.size(), 1U);
  EXPECT_NEAR(outside[0].length(), 60 + 4 * pi, 0.02);
  EXPECT_NEAR(inside[0].length(), 60 - 16, 0.02);
  EXPECT_NEAR(on[0].length(), 60, 0.02);
  // Climb milling: the wall is on the right, so that outside profiles are clockwise and inside
  // profiles anticlockwise.
  const auto area = [](const Path& path) {
    Loop loop;
    for (const PathPoint& p : points_along(path, 0.1)) loop.points.push_back(p.at.head<2>());
    return loop.area();
  };
  EXPECT_LT(area(outside[0]), 0);
  EXPECT_GT(area(inside[0]), 0);
  CutSettings conventional = cut_of(2, 3);
  conventional.climb = false;
  EXPECT_GT(area(profile(part, Side::outside, conventional)[0]), 0);
}

TEST(Profile2d, TabsStandAsWideAsAsked) {
  const Outline part = outline({rectangle(40, 30)}, {{0, 0}, {40, 30}});
  const auto paths = profile(part, Side::outside, cut_of(1.5, 3), {4, 5, 1});
  ASSERT_EQ(paths.size(), 1U);
  double low = 0, high = 0;
  for (std::size_t i = 1; i < paths[0].points.size(); ++i) {
    Path piece;
    piece.points = {paths[0].points[i - 1], paths[0].points[i]};
    if (piece.points[0].at.z() != piece.points[1].at.z()) continue;
    (piece.points[0].at.z() == -3 ? low : high) += piece.length();
  }
  EXPECT_NEAR(high, 4 * (5 + 3), 0.01);  // each as wide as the tab plus the tool
  EXPECT_NEAR(low + high, 140 + 3 * pi, 0.05);
}

TEST(Pocket, ReachesEveryPlaceTheToolFits) {
  const Loops with_island{rectangle(30, 20), ring({15, 10}, 4, true)}, wedge{{{{0, 0}, {30, 6}, {28, 20}, {3, 16}}}};
  for (const auto& [area, stepover] : {std::pair{with_island, 1.2}, {with_island, 2.7}, {wedge, 2.9}, {wedge, 2.2}}) {
    SCOPED_TRACE(stepover);
    const Outline whole = outline(area, {{0, 0}, {30, 20}});
    const FieldPtr distance = outline_field(area);
    // The squares of the distances from places of a lattice to the nearest tip.
    const double dx = 0.17, dy = 0.19;
    const int columns = static_cast<int>(30 / dx) + 1, rows = static_cast<int>(20 / dy) + 1;
    std::vector<double> nearest(static_cast<std::size_t>(columns * rows), 1e9);
    const auto cover = [&](const Vec2& tip) {
      for (int row = std::max(0, static_cast<int>((tip.y() - 1.6) / dy)); row < rows && row * dy < tip.y() + 1.6; ++row)
        for (int c = std::max(0, static_cast<int>((tip.x() - 1.6) / dx)); c < columns && c * dx < tip.x() + 1.6; ++c) {
          double& least = nearest[static_cast<std::size_t>(row * columns + c)];
          least = std::min(least, (tip - Vec2(c * dx, row * dy)).squaredNorm());
        }
    };
    for (const Path& path : pocket(whole, {stepover}, cut_of(1.5, 1))) {
      const auto points = points_along(path, 0.05);
      for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 way = points[i].at - points[i - 1].at;
        const int steps = 1 + static_cast<int>(way.norm() / 0.01);
        for (int k = 0; k <= steps; ++k) {
          const Vec2 tip = (points[i - 1].at + way * k / steps).head<2>();
          EXPECT_LE(distance->value({tip.x(), tip.y(), 0}), -1.5 + 0.01);
          cover(tip);
        }
      }
    }
    // Every point that some permitted position of the tool covers is covered.
    const FieldPtr middles = outline_field(offset(area, -1.5, 0.05));
    for (int row = 0; row < rows; ++row)
      for (int c = 0; c < columns; ++c) {
        const double x = c * dx, y = row * dy;
        if (middles->value({x, y, 0}) > 1.5 - 0.03) continue;
        EXPECT_LE(std::sqrt(nearest[static_cast<std::size_t>(row * columns + c)]), 1.5 + 0.05) << x << " " << y;
      }
  }
}

TEST(Pocket, TellsWhatTheToolIsTooLargeFor) {
  // A round pocket, and a neck between two wide ones.
  const Loop dumbbell{{{0, 20},
                       {10, 20},
                       {10, 24},
                       {20, 24},
                       {20, 20},
                       {30, 20},
                       {30, 30},
                       {20, 30},
                       {20, 26},
                       {10, 26},
                       {10, 30},
                       {0, 30}}};
  const Outline area = outline({rectangle(20, 10), ring({30, 5}, 1, false), dumbbell}, {{0, 0}, {32, 30}});
  EXPECT_FALSE(pocket(area, {1}, cut_of(1.5, 1)).empty());
  std::vector<Vec2> left = too_narrow(area, 1.5);
  std::sort(left.begin(), left.end(), [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
  ASSERT_EQ(left.size(), 2U);
  EXPECT_NEAR((left[0] - Vec2(30, 5)).norm(), 0, 0.1);
  EXPECT_NEAR((left[1] - Vec2(15, 25)).norm(), 0, 0.1);
}

/// Cells of a pocket that are still to be cut: the slow, obvious twin of adaptive()'s model.
struct Chips {
  Chips(const Field& area, const Rectangle& region, double edge)
      : cells(static_cast<int>(region.size().x() / edge), static_cast<int>(region.size().y() / edge), edge,
              region.lower + Vec2::Constant(edge / 2), 0) {
    for (int row = 0; row < cells.height; ++row)
      for (int c = 0; c < cells.width; ++c)
        cells.at(c, row) = area.value({cells.place(c, row).x(), cells.place(c, row).y(), 0}) < 0 ? 1 : 0;
  }
  /// Area that a disc removes.
  double cut(const Vec2& at, double radius) {
    int count = 0;
    const auto first = [&](double from) { return std::max(0, static_cast<int>(std::ceil(from / cells.cell))); };
    const Vec2 middle = at - cells.origin;
    for (int row = first(middle.y() - radius); row < cells.height && row * cells.cell < middle.y() + radius; ++row) {
      const double dy = row * cells.cell - middle.y(), half = std::sqrt(std::max(0.0, radius * radius - dy * dy));
      for (int c = first(middle.x() - half); c < cells.width && c * cells.cell < middle.x() + half; ++c)
        if (cells.at(c, row) != 0) cells.at(c, row) = 0, ++count;
    }
    return count * cells.cell * cells.cell;
  }
  Bitmap cells;
};

TEST(Adaptive, KeepsItsEngagementAndLeavesNothing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(12, 48), y(12, 33), size(2, 5), turn(0, 6);
  for (int trial = sample_or_all(1, 0); trial < 4; trial += sample_or_all(2, 1)) {
    Loops area{rectangle(60, 45)};
    for (int island = 0; island < trial; ++island) {
      // Far enough apart that a tool of 4 mm can turn between them.
      const Vec2 at(x(random), y(random));
      const double radius = size(random), angle = turn(random);
      const bool free = std::all_of(area.begin() + 1, area.end(), [&](const Loop& other) {
        return (0.5 * (other.bounds().lower + other.bounds().upper) - at).norm() > radius + 14;
      });
      if (!free) continue;
      Loop loop;
      const int corners = 3 + island;
      for (int k = 0; k < corners; ++k)
        loop.points.push_back(
            at + radius * Vec2(std::cos(angle - 2 * pi * k / corners), std::sin(angle - 2 * pi * k / corners)));
      area.push_back(loop);
    }
    for (const double stepover : {0.6, 1.6}) {
      SCOPED_TRACE(testing::Message() << trial << " " << stepover);
      CutSettings cut = cut_of(2, 1);
      cut.climb = trial % 2 == 0;
      const Outline pocket_area = outline(area, {{0, 0}, {60, 45}});
      const auto paths = pocket(pocket_area, {stepover, true, 1.6}, cut);
      const double edge = 0.05;
      Chips chips(*pocket_area.distance, {{0, 0}, {60, 45}}, edge);
      std::vector<double> widths;
      double taken = 0, length = 0, in_links = 0;
      for (const Path& path : paths)
        for (std::size_t i = 0; i + 1 < path.points.size() + (path.closed ? 1 : 0); ++i) {
          const PathPoint &a = path.points[i], &b = path.points[(i + 1) % path.points.size()];
          const double way = length_between(a.at, b.at, a.bulge);
          const int steps = std::max(1, static_cast<int>(std::ceil(way / 0.1)));
          for (int k = 1; k <= steps; ++k) {
            const Vec2 p = place_between(a.at, b.at, a.bulge, static_cast<double>(k) / steps).head<2>();
            EXPECT_LE(pocket_area.distance->value({p.x(), p.y(), 0}), -2 + cut.tolerance + 1e-4);
            const double area_cut = chips.cut(p, 2 + cut.tolerance);
            if (a.pace == Pace::link) in_links += area_cut;
            if (a.pace != Pace::cut) continue;
            taken += area_cut, length += way / steps;
            if (length >= 1) widths.push_back(taken / length), taken = length = 0;
          }
        }
      std::sort(widths.begin(), widths.end());
      const auto at = [&](double share) {
        return widths[static_cast<std::size_t>(share * static_cast<double>(widths.size() - 1))];
      };
      EXPECT_LE(at(0.999), 1.15 * stepover);
      EXPECT_LE(at(1), 1.6 * stepover);
      EXPECT_GE(std::accumulate(widths.begin(), widths.end(), 0.0) / static_cast<double>(widths.size()),
                0.7 * stepover);
      EXPECT_LE(in_links, 0.3);
      // The remaining material is out of the tool's reach, except slivers thinner than twice the
      // tolerance.
      const FieldPtr middles = outline_field(offset(area, -2, 0.05));
      for (int row = 0; row < chips.cells.height; ++row)
        for (int c = 0; c < chips.cells.width; ++c) {
          const Vec2 p = chips.cells.place(c, row);
          if (chips.cells.at(c, row) != 0) {
            EXPECT_GT(middles->value({p.x(), p.y(), 0}), 2 - 2 * edge) << p.transpose();
          }
        }
    }
  }
}

TEST(Adaptive, CutsSlotsLast) {
  // A wide pocket with a slot as wide as the tool: only the slot requires full engagement.
  const Loop area{{{0, 0}, {30, 0}, {30, 8}, {45, 8}, {45, 12.2}, {30, 12.2}, {30, 20}, {0, 20}}};
  const auto paths = pocket(outline({area}, {{0, 0}, {45, 20}}), {1, true, 1.6}, cut_of(2, 1));
  double farthest = 0;
  for (const Path& path : paths)
    for (const PathPoint& p : path.points) farthest = std::max(farthest, p.at.x());
  EXPECT_NEAR(farthest, 43, 0.01);
}

TEST(Adaptive, RefusesMoreThanTheTool) {
  EXPECT_THROW((void)pocket(outline({rectangle(30, 20)}, {{0, 0}, {30, 20}}), {0, true}, cut_of(2, 1)), Error);
  EXPECT_THROW((void)pocket(outline({rectangle(30, 20)}, {{0, 0}, {30, 20}}), {4.1, true}, cut_of(2, 1)), Error);
}

TEST(Drill, FindsRoundHolesOnly) {
  const std::vector<Hole> found =
      holes({rectangle(40, 40), ring({10, 10}, 2, true), {{{20, 20}, {20, 24}, {24, 24}, {24, 20}}}}, 0.02);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].radius, 2, 1e-3);
  EXPECT_NEAR((found[0].centre - Vec2(10, 10)).norm(), 0, 1e-3);
  const auto paths = drill(found, 2, {0, -5, 1e300});
  EXPECT_NEAR(paths[0].length(), 5.0 / 3 * 2 + 10.0 / 3 * 2 + 5, 1e-9);
}

/// Depth of a V of half angle 45 degrees at a point.
double carved(const std::vector<Path>& paths, const Vec2& q, double slope) {
  double lowest = 0;
  for (const Path& path : paths) {
    const auto points = points_along(path, 0.05);
    for (std::size_t i = 1; i < points.size(); ++i)
      for (int s = 0; s <= 400; ++s) {
        const Vec3 tip = points[i - 1].at + (points[i].at - points[i - 1].at) * s / 400;
        lowest = std::min(lowest, tip.z() + slope * (tip.head<2>() - q).norm());
      }
  }
  return lowest;
}

void expect_flanks_end_at(const Loops& outline, double half_angle, double tolerance) {
  const FieldPtr distance = outline_field(outline);
  const auto paths = v_carve(outline, half_angle, 0.2, cut_of(0, 50));
  ASSERT_FALSE(paths.empty());
  const double slope = 1 / std::tan(half_angle);
  Rectangle bounds = Rectangle::nothing();
  for (const Vec2& p : outline[0].points) bounds.add(p);
  for (double x = bounds.lower.x() - 0.5; x < bounds.upper.x() + 0.5; x += 0.43)
    for (double y = bounds.lower.y() - 0.5; y < bounds.upper.y() + 0.5; y += 0.47) {
      const double inside = -static_cast<double>(distance->value({x, y, 0}));
      EXPECT_NEAR(carved(paths, {x, y}, slope), -slope * std::max(0.0, inside), tolerance) << x << " " << y;
    }
}

TEST(VCarve, FlanksEndAtTheOutline) {
  for (const double half : {pi / 4, pi / 6})
    expect_flanks_end_at({{{{0, 0}, {12, 0}, {12, 3}, {3, 3}, {3, 12}, {0, 12}}}}, half, 0.05);  // an L
}

TEST(VCarve, BetweenTwoCornersTheVRises) {
  // Between the corners of a waist the radius is a hyperbola, although the axis is straight.
  expect_flanks_end_at({{{{-6, -5}, {0, -1}, {6, -5}, {6, 5}, {0, 1}, {-6, 5}}}}, pi / 4, 0.05);
}

TEST(VCarve, WidePlacesGetAFlatFloor) {
  const auto paths = v_carve({rectangle(20, 20)}, pi / 4, 0.3, cut_of(0, 2));
  double deepest = 0;
  for (const Path& path : paths)
    for (const PathPoint& p : path.points) deepest = std::min(deepest, p.at.z());
  EXPECT_NEAR(deepest, -2, 1e-9);
  EXPECT_NEAR(carved(paths, {10, 10}, 1), -2, 0.3);  // ridges of one stepover at most
  EXPECT_NEAR(carved(paths, {1, 10}, 1), -1, 0.01);
}

TEST(VCarve, RoundThingsHaveNoSpurs) {
  const auto paths = v_carve({ring({0, 0}, 5, false, 200)}, pi / 4, 0.2, cut_of(0, 50));
  double length = 0;
  for (const Path& path : paths) length += path.length();
  EXPECT_LT(length, 1);  // only the centre, not 200 spokes
}

TEST(Link, EntersByRampsAndStaysAboveTheMaterial) {
  Path path;
  path.closed = true;
  path.points = {{{0, 0, -2}}, {{10, 0, -2}}, {{10, 10, -2}}, {{0, 10, -2}}};
  LinkSettings settings;
  settings.entry = Entry::ramp;
  settings.material = [](const Path&) { return 0.0; };
  const auto moves = link({path}, settings);
  EXPECT_TRUE(moves.front().rapid());
  EXPECT_EQ(moves.front().to.z(), 5);
  EXPECT_EQ(moves.back().to.z(), 5);
  double steepest = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const Vec3 way = moves[i].to - moves[i - 1].to;
    if (moves[i].rapid()) {
      EXPECT_GE(moves[i].to.z(), 0.99);
    }
    if (!moves[i].rapid() && way.z() < 0) steepest = std::max(steepest, std::atan2(-way.z(), way.head<2>().norm()));
  }
  EXPECT_LE(steepest, settings.ramp_angle + 1e-9);
  EXPECT_GT(lengths(moves).cut, 80);  // the ramp, and one round at the bottom
}

TEST(Link, WindsDownWhereThereIsRoom) {
  Path path;
  path.closed = true;
  path.points = {{{0, 0, -2}}, {{10, 0, -2}}, {{10, 10, -2}}, {{0, 10, -2}}};
  LinkSettings settings;
  settings.entry = Entry::helix;
  settings.helix_radius = 1.2;
  settings.material = [](const Path&) { return 0.0; };
  settings.may_stay_down = [](const Vec3& a, const Vec3& b) {  // inside of the square only
    const auto in = [](const Vec3& p) { return p.x() >= -1e-9 && p.y() >= -1e-9 && p.x() <= 10 && p.y() <= 10; };
    return in(a) && in(b) && (b - a).norm() < 3;
  };
  const auto moves = link({path}, settings);
  std::size_t arcs = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    if (moves[i].bulge == 0) continue;
    ++arcs;
    Path piece;
    piece.points = {{moves[i - 1].to, moves[i].bulge}, {moves[i].to}};
    for (const PathPoint& p : points_along(piece, 0.1))
      EXPECT_TRUE(p.at.x() >= -1e-6 && p.at.y() >= -1e-6) << p.at.transpose();
    const double way = length_between(moves[i - 1].to, moves[i].to, moves[i].bulge),
                 down = moves[i - 1].to.z() - moves[i].to.z();
    EXPECT_LE(std::asin(down / way), settings.ramp_angle + 1e-9);
  }
  EXPECT_GE(arcs, 4U);
  // Without clearance it descends along the path.
  settings.may_stay_down = [](const Vec3&, const Vec3&) { return false; };
  for (const Move& m : link({path}, settings)) EXPECT_EQ(m.bulge, 0);
}

TEST(Duration, IsThatOfClosedForms) {
  const Dynamics d{6000, 100, 0.01};
  // 100 mm at 50 mm/s, half a second each to accelerate and to stop: 25/2 mm each.
  EXPECT_NEAR(duration({{{0, 0, 0}}, {{100, 0, 0}, 3000}}, d), 0.5 + 0.5 + 75.0 / 50, 1e-9);
  // Too short to reach its speed.
  EXPECT_NEAR(duration({{{0, 0, 0}}, {{1, 0, 0}, 3000}}, d), 2 * std::sqrt(1.0 / 100), 1e-9);
  // Two collinear pieces take as long as one; a corner takes longer.
  const double straight = duration({{{0, 0, 0}}, {{50, 0, 0}, 3000}, {{100, 0, 0}, 3000}}, d);
  EXPECT_NEAR(straight, 2.5, 1e-9);
  EXPECT_GT(duration({{{0, 0, 0}}, {{50, 0, 0}, 3000}, {{50, 50, 0}, 3000}}, d), straight + 0.2);
}

/// A ball of radius 10 whose centre is 4 mm below a plate's top.
FieldPtr knob() {
  return formula("min(max(sqrt(x*x+y*y+(z+4)*(z+4)) - 10, -z-2), max(abs(x)-16, max(abs(y)-16, abs(z+1)-1)))");
}
const Box knob_bounds{{-16, -16, -2}, {16, 16, 6}};

TEST(Rough, ClearsWhatTheTipReachesAndNothingElse) {
  const auto tips =
      std::make_shared<TipSurface>(Surface::of(*knob(), knob_bounds, {0.1, 0.01}), tool("ball", 5).profile(), 0.3);
  for (const bool adaptive : {false, true}) {
    SCOPED_TRACE(adaptive);
    RoughSettings settings;
    settings.stock = {{-17, -17}, {17, 17}};
    settings.depths = {7, -1, 2};
    settings.cut.radius = 2.5;
    settings.cell = 0.15;
    const Material full(settings.stock, 7, 0.2);
    settings.clear = {1.5, adaptive, 2, 0.05, &full};
    const std::vector<Path> paths = rough(tips, settings);
    for (const Path& path : paths)
      for (std::size_t i = 0; i + 1 < path.points.size() + (path.closed ? 1 : 0); ++i) {
        const PathPoint &a = path.points[i], &b = path.points[(i + 1) % path.points.size()];
        for (int k = 0; k <= 10; k += sample_or_all(5, 1)) {
          const Vec3 p = place_between(a.at, b.at, a.bulge, k / 10.0);
          EXPECT_GE(p.z(), tips->tip(p.head<2>()) - 0.02) << p.transpose();
        }
      }
    PlannedStock stock({{-17, -17, -2}, {17, 17, 7}}, 0.2);
    stock.cut(link(paths, {}), tool("ball", 5), Plane{});
    const Material left = stock.seen_from(Plane{});
    for (double x = -16.5; x < 17; x += 0.7)
      for (double y = -16.5; y < 17; y += 0.7) {
        // Levels are 2 mm apart. Passes of a ball leave a ridge of 0.12 mm, and of a ball that is
        // thinner by half the diagonal of a cell of 0.2 mm one of 0.3 mm.
        const double lowest = tips->tip({x, y}), level = 7 - 2 * std::floor((7 - std::max(lowest, -1.0)) / 2);
        EXPECT_LE(left.highest({x, y}, 0), level + 0.45) << x << " " << y;
      }
  }
}

TEST(Pencil, RunsAlongValleys) {
  // Position of a ball that touches both the plate and the knob.
  const double r = 1.5, away = std::sqrt((10 + r) * (10 + r) - (r + 4) * (r + 4));
  const TipSurface tips(Surface::of(*knob(), knob_bounds, {0.1, 0.005}), tool("ball", 2 * r).profile());
  FinishSettings settings;
  settings.area = {{-14, -14}, {14, 14}};
  settings.tolerance = 0.01;
  const std::vector<Path> paths = pencil(tips, settings, 0.2, 0.35);
  double length = 0;
  for (const Path& path : paths) {
    length += path.length();
    for (const PathPoint& p : path.points) {
      EXPECT_NEAR(p.at.head<2>().norm(), away, 0.02);
      EXPECT_NEAR(p.at.z(), 0, 0.02);
    }
  }
  EXPECT_NEAR(length, 2 * pi * away, 0.3);
  EXPECT_EQ(paths.size(), 1U);
  EXPECT_THROW((void)pencil(TipSurface(Surface::of(*knob(), knob_bounds, {0.2, 0.02}), tool("flat", 3).profile()),
                            settings, 0.2, 0.35),
               Error);
}

}  // namespace
}  // namespace fieldfab::cam
