// Silhouettes against values along many vertical lines.
#include "plan/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"

namespace fieldfab::cam {
namespace {

FieldPtr solid(const std::string& text) { return frep::make_field(frep::parse_infix(text)); }

const std::vector<std::string> solids{
    "difference(box(40, 30, 8), move(cylinder(3, 30), 9, 5, 0))",
    "move(sphere(7), 2, 3, -1) | move(box(4, 30, 3), -6, 0, 4)",
    "rotate_y(difference(box(30, 20, 6), cylinder(4, 30)), 25)",
    "move(torus(9, 2), 0, 0, 3) | move(cylinder(2, 3), 0, 0, -4)",
    "shell(gyroid(14), 2) & box(26, 26, 16)",
    "exp(0.3 * x) + square(y / 4) + square(z / 3) - 9",
};

/// The least of many values along a vertical line.
float least_of_many(const Field& field, double x, double y, double low, double high) {
  float least = std::numeric_limits<float>::infinity();
  for (int i = 0; i <= 2000; ++i)
    least = std::min(least, static_cast<float>(field.value({x, y, low + (high - low) * i / 2000})));
  return least;
}

TEST(Silhouette, IsTheLeastValueOfVerticalLines) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-22, 22);
  for (const std::string& text : solids) {
    const FieldPtr field = solid(text), seen = silhouette(field, -9, 9);
    for (int i = 0; i < 200; ++i) {
      const double x = place(random), y = place(random);
      const auto fast = static_cast<float>(seen->value({x, y, 0.7}));
      const float slow = least_of_many(*field, x, y, -9, 9);
      // The samples may miss the least value by the way between them.
      EXPECT_LE(fast, slow + 0.053 * std::abs(slow) + 1e-6) << text << " " << x << " " << y;
      EXPECT_GE(fast, slow - 0.053 * std::abs(slow) - 0.02) << text << " " << x << " " << y;
      if (std::abs(slow) > 0.02) {
        EXPECT_EQ(fast < 0, slow < 0) << text << " " << x << " " << y;
      }
      EXPECT_EQ(fast, static_cast<float>(seen->value({x, y, -3})));
    }
  }
}

TEST(Silhouette, LeavesNothingOfWhatIsThin) {
  const FieldPtr seen = silhouette(solid("move(box(10, 10, 0.001), 0, 0, 3.217) | sphere(1)"), -9, 9);
  EXPECT_LT(seen->value({4.9, -4.9, 0}), 0);
  EXPECT_GE(seen->value({5.1, -4.9, 0}), 0);
  const FieldPtr above = silhouette(solid("move(box(10, 10, 0.001), 0, 0, 3.217) | sphere(1)"), -9, 3);
  EXPECT_GE(above->value({4.9, -4.9, 0}), 0);
}

TEST(Silhouette, ItsIntervalsAndSlopesHold) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-18, 18), extent(0.05, 6);
  for (const std::string& text : solids) {
    const FieldPtr seen = silhouette(solid(text), -9, 9);
    for (int i = 0; i < 60; ++i) {
      Box box;
      box.lower = Vec3(place(random), place(random), 0);
      box.upper = box.lower + Vec3(extent(random), extent(random), 0);
      const Restriction inside = seen->restricted(box);
      const Interval range = seen->interval(box);
      const Vec3 along(0.6, 0.8, 0);
      Interval slope;
      seen->slopes(box, {&along, 1}, {&slope, 1});
      for (int s = 0; s < 25; ++s) {
        const Vec3 p = box.lower + Vec3(s % 5 / 4.0, s / 5 / 4.0, 0).cwiseProduct(box.size());
        const auto value = static_cast<float>(seen->value(p));
        const float loose = 0.053F * std::abs(value) + 1e-5F;  // a value is exact to a twentieth
        EXPECT_GE(value, range.lower - loose) << text;
        EXPECT_LE(value, range.upper + loose) << text;
        EXPECT_EQ(inside.field->value(p) < 0, value < 0) << text;
        const double way = 0.3 * std::min((box.upper.x() - p.x()) / 0.6, (box.upper.y() - p.y()) / 0.8);
        if (!(way > 0.01) || !std::isfinite(slope.lower)) continue;
        const double there = seen->value(p + way * along), least = std::min(std::abs(there), std::abs(double{value}));
        EXPECT_GE((there - value) / way, slope.lower - (0.11 * (least + std::abs(there)) + 1e-3) / way) << text;
        EXPECT_LE((there - value) / way, slope.upper + (0.11 * (least + std::abs(there)) + 1e-3) / way) << text;
      }
    }
  }
}

}  // namespace
}  // namespace fieldfab::cam
