// Bounds of volumes and areas hold, by closed forms and by random points.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/measure.h"
#include "fieldfab/field/plane_bounds.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"

namespace fieldfab {
namespace {

constexpr double pi = std::numbers::pi, infinite = std::numeric_limits<double>::infinity();

FieldPtr solid_of(const std::string& text) { return frep::make_field(frep::parse_infix(text)); }

/// Random combinations of rotated primitives and polynomials.
std::string random_solid(std::mt19937& random, int depth) {
  const auto number = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  const auto one_of = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); };
  if (depth == 0) {
    const std::string primitives[] = {
        fmt::format("box({}, {}, {})", number(0.1, 3), number(0.1, 3), number(0.1, 3)),
        fmt::format("sphere({})", number(0.2, 1.5)),
        fmt::format("cylinder({}, {})", number(0.2, 1), number(0.2, 3)),
        fmt::format("torus({}, {})", number(0.6, 1.2), number(0.05, 0.5)),
        fmt::format("x * x * {} + y * y * z * {} + z - {}", number(0.2, 2), number(-2, 2), number(-1, 1)),
        fmt::format("sin({0} * x) * cos({0} * y) + sin({0} * z) - {1}", number(1, 4), number(-0.5, 0.5))};
    return fmt::format("move(rotate_x(rotate_z({}, {}), {}), dx = {}, dy = {}, dz = {})", primitives[one_of(6)],
                       number(0, 360), number(0, 360), number(-1, 1), number(-1, 1), number(-1, 1));
  }
  const char* const joins[] = {"union", "intersection", "difference"};
  return fmt::format("{}({}, {})", joins[one_of(3)], random_solid(random, depth - 1), random_solid(random, depth - 1));
}

struct Known {
  const char* text;
  double half;                      ///< of the measured cube about the origin
  double volume, area;              ///< mm3, mm2
  double volume_error, area_error;  ///< upper bounds, percent
};

TEST(Measure, HoldsClosedForms) {
  const Known all[] = {
      {"sphere(10)", 11, 4000 * pi / 3, 400 * pi, 0.2, 10},
      {"box(10, 8, 6)", 5.5, 480, 376, 0.02, 3},
      {"box(10, 8, 0.01)", 5.5, 0.8, 160.36, 0.02, 0.1},
      {"rotate_x(rotate_y(box(10, 8, 6), 20), 33)", 9, 480, 376, 0.1, 8},
      {"move(cylinder(3, 8), dx = 0.2, dy = -0.7)", 9, 72 * pi, 66 * pi, 0.05, 5},
      {"torus(8, 2)", 11, 64 * pi * pi, 64 * pi * pi, 1.5, 25},
      {"cone(4, 6)", 7, 32 * pi, 16 * pi + 4 * pi * std::sqrt(52.0), 0.1, 15},
      {"shell(sphere(8), 0.2)", 9, 4 * pi / 3 * (std::pow(8.1, 3) - std::pow(7.9, 3)), 4 * pi * (8.1 * 8.1 + 7.9 * 7.9),
       60, infinite},
      {"difference(box(10, 10, 10), sphere(4))", 5.6, 1000 - 256 * pi / 3, 600 + 64 * pi, 0.1, 4},
      {"x*x + y*y + z*z - 25", 6, 500 * pi / 3, 100 * pi, 0.2, 10},
  };
  for (const Known& known : all) {
    const Measures found = measure(*solid_of(known.text), {Vec3::Constant(-known.half), Vec3::Constant(known.half)},
                                   {.most_boxes = 100'000});
    EXPECT_LE(found.volume.lower, known.volume) << known.text;
    EXPECT_GE(found.volume.upper, known.volume) << known.text;
    EXPECT_LE(found.area.lower, known.area) << known.text;
    EXPECT_GE(found.area.upper, known.area) << known.text;
    EXPECT_LT(found.volume.error(), 0.01 * known.volume_error * known.volume) << known.text << " " << found.boxes;
    EXPECT_LE(found.area.error(), 0.01 * known.area_error * known.area) << known.text << " " << found.boxes;
    fmt::print("{}: volume {:.6g} +- {:.2g} %, area {:.6g} +- {:.2g} %, {} boxes\n", known.text, found.volume.middle(),
               100 * found.volume.error() / known.volume, found.area.middle(), 100 * found.area.error() / known.area,
               found.boxes);
  }
}

TEST(Measure, HoldsWhatRandomPointsTell) {
  std::mt19937 random(5);
  const Box box{Vec3::Constant(-2), Vec3::Constant(2)};
  std::uniform_real_distribution<double> any(-2, 2);
  int closed_in = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const FieldPtr solid = solid_of(random_solid(random, 2));
    MeasureSettings settings;
    settings.most_boxes = 5000;
    const Measures found = measure(*solid, box, settings);
    constexpr int count = 20000;
    int inside = 0;
    for (int i = 0; i < count; ++i) inside += solid->value({any(random), any(random), any(random)}) < 0 ? 1 : 0;
    const double share = static_cast<double>(inside) / count, all = box.size().prod();
    const double deviation = 5 * std::sqrt(share * (1 - share) / count) + 5.0 / count;
    EXPECT_LE(found.volume.lower, all * (share + deviation)) << trial;
    EXPECT_GE(found.volume.upper, all * (share - deviation)) << trial;
    EXPECT_LE(found.area.lower, found.area.upper) << trial;
    closed_in += found.volume.error() < 0.01 * all ? 1 : 0;
  }
  EXPECT_GT(closed_in, 30);
}

TEST(Measure, PlanesHoldAllValues) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> any(-2, 2), part(-1, 1);
  int known = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const FieldPtr solid = solid_of(random_solid(random, 2));
    const Vec3 corner(any(random), any(random), any(random));
    const Box box{corner, corner + 0.2 * Vec3(part(random), part(random), part(random)).cwiseAbs()};
    const PlaneBounds plane = plane_bounds(*solid, box);
    if (!plane.known) continue;
    ++known;
    for (int i = 0; i < 200; ++i) {
      const Vec3 offset = plane.half.cwiseProduct(Vec3(part(random), part(random), part(random)));
      const double value = solid->value(plane.centre + offset);
      EXPECT_LE(std::abs(value - plane.value - plane.slope.dot(offset)), plane.error * (1 + 1e-6) + 1e-30) << trial;
      EXPECT_GE(value, plane.lower()) << trial;
      EXPECT_LE(value, plane.upper()) << trial;
    }
  }
  EXPECT_GT(known, 100);
}

TEST(Measure, IsTheSameForAnyNumberOfThreads) {
  const FieldPtr solid = solid_of("rotate_x(difference(sphere(5), box(4, 4, 20)), 30)");
  const Box box{Vec3::Constant(-6), Vec3::Constant(6)};
  const Measures many = measure(*solid, box);
  const ThreadLimit one(1);
  const Measures single = measure(*solid, box);
  EXPECT_EQ(many.volume.lower, single.volume.lower);
  EXPECT_EQ(many.volume.upper, single.volume.upper);
  EXPECT_EQ(many.area.lower, single.area.lower);
  EXPECT_EQ(many.area.upper, single.area.upper);
}

TEST(Measure, RefusesBoundsWithoutEnd) { EXPECT_THROW((void)measure(*solid_of("x"), Box::everything()), Error); }

}  // namespace
}  // namespace fieldfab
