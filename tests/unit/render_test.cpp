// Pictures against the slow, obvious twin: each pixel computed by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/render/render.h"

namespace fieldfab {
namespace {

namespace s = frep::shapes;

TEST(Bitmaps, AreWhatEachPixelsCentreSays) {
  const FieldPtr prospero = frep::make_field(frep::parse_vm(read_file(TEST_DATA "/frep/prospero.vm")));
  const Box bounds{{-1, -0.6, 0}, {1, 0.7, 0}};
  const Image image = render(*prospero, bounds, {RenderMode::bitmap, 301});
  ASSERT_EQ(image.width, 301);
  ASSERT_EQ(image.height, 196);
  EXPECT_EQ(image.channels, 1);
  int white = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const Vec3 p(-1 + (column + 0.5) * 2 / image.width, 0.7 - (row + 0.5) * 1.3 / image.height, 0);
      const bool inside = prospero->value(p) < 0;
      white += inside;
      ASSERT_EQ(image.pixels8[static_cast<std::size_t>(row * image.width + column)], inside ? 255 : 0)
          << row << ' ' << column;
    }
  EXPECT_GT(white, 1000);
}

TEST(HeightMaps, MeetTheSurface) {
  const FieldPtr ball = translate(frep::make_field(s::sphere(1)), {0, 0, 3});
  const Box bounds{{-1.1, -1.1, 1.5}, {1.1, 1.1, 4.5}};
  const Image image = render(*ball, bounds, {RenderMode::height, 121});
  EXPECT_EQ(image.depth, 16);
  EXPECT_TRUE(image.has_heights);
  EXPECT_EQ(image.bounds.lower.z(), 1.5);
  EXPECT_NEAR(image.pixels_per_mm, 121 / 2.2, 1e-9);
  for (int row = 0; row < 121; ++row)
    for (int column = 0; column < 121; ++column) {
      const double x = -1.1 + (column + 0.5) * 2.2 / 121, y = 1.1 - (row + 0.5) * 2.2 / 121, r = std::hypot(x, y);
      const double pixel = image.pixels16[static_cast<std::size_t>(row * 121 + column)];
      if (r > 1.001) {
        EXPECT_EQ(pixel, 0);
      } else if (r < 0.98) {
        EXPECT_NEAR(1.5 + (pixel - 1) / 65534 * 3, 3 + std::sqrt(1 - r * r), 0.001) << x << ' ' << y;
      }
    }
}

TEST(HeightMaps, TurnWithAlphaAndBeta) {
  // A rod along x, rotated about z by 90 degrees and tilted by 90 about x, is upright.
  const FieldPtr rod = frep::make_field(s::box(4, 1, 1));
  const Box bounds{{-2, -0.5, -0.5}, {2, 0.5, 0.5}};
  const Image image = render(*rod, bounds, {RenderMode::height, 64, std::numbers::pi / 2, std::numbers::pi / 2});
  EXPECT_EQ(image.width, image.height);
  EXPECT_NEAR(image.bounds.size().z(), 4, 1e-9);
  EXPECT_NEAR(image.pixels16[32 * 64 + 32], 65535, 2);
}

TEST(Perspective, ShowsWhatRaysThroughTheEyeMeet) {
  // A ball in the middle of its bounds, seen from near: its outline is that of a tangent cone, and
  // the picture's centre is its top.
  const FieldPtr ball = frep::make_field(s::sphere(1));
  const Box bounds{Vec3::Constant(-1), Vec3::Constant(1)};
  constexpr double angle = 0.8;
  constexpr int size = 301;
  const Image heights = render(*ball, bounds, {RenderMode::height, size, 0, 0, angle});
  const Image normals = render(*ball, bounds, {RenderMode::normals, size, 0, 0, angle});
  const double distance = std::sqrt(3.0) / std::sin(angle / 2), half = 1 / (1 - 1 / distance);
  int seen = 0;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const auto i = static_cast<std::size_t>(row * size + column);
      // The ray from the eye through this pixel's point in the plane z = 0.
      const Vec3 eye(0, 0, distance),
          through((column + 0.5) * 2 * half / size - half, half - (row + 0.5) * 2 * half / size, 0);
      const Vec3 along = (through - eye).normalized();
      const double b = eye.dot(along), c = eye.squaredNorm() - 1, root = b * b - c;
      if (std::abs(root) < 0.02) continue;  // grazing
      ASSERT_EQ(heights.pixels16[i] > 0, root > 0) << row << ' ' << column;
      if (root <= 0) continue;
      ++seen;
      const Vec3 hit = eye + (-b - std::sqrt(root)) * along;
      ASSERT_NEAR(-1 + (heights.pixels16[i] - 1) / 65534.0 * 2, hit.z(), 2e-3) << row << ' ' << column;
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_NEAR(normals.pixels8[3 * i + static_cast<std::size_t>(axis)] / 127.5 - 1, hit[axis], 0.012)
            << row << ' ' << column;
    }
  EXPECT_GT(seen, 20000);
}

TEST(Window, ShowsItsPartOfThePictureEvaluatedForItself) {
  const FieldPtr part = frep::make_field(s::subtract(s::box(2, 2, 2), s::sphere(1.2)));
  const Box bounds{Vec3::Constant(-1.1), Vec3::Constant(1.1)};
  RenderSettings settings{RenderMode::height, 400, 0.4, -0.7};
  settings.window = Box{{-1, -1, 0}, {1, 1, 0}};
  const Image whole = render(*part, bounds, settings);
  settings.window = Box{{-0.5, 0, 0}, {0.5, 1, 0}};
  settings.size = 200;
  const Image quarter = render(*part, bounds, settings);
  int same = 0;
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 200; ++column)
      same += std::abs(quarter.pixels16[static_cast<std::size_t>(row * 200 + column)] -
                       whole.pixels16[static_cast<std::size_t>(row * 400 + column + 100)]) < 40;
  EXPECT_GT(same, 39900);
  settings.window = Box{{1, 1, 0}, {-1, -1, 0}};
  EXPECT_THROW(render(*part, bounds, settings), Error);
}

TEST(Normals, PointOutOfTheSurface) {
  const Image image =
      render(*frep::make_field(s::sphere(1)), {Vec3::Constant(-1), Vec3::Constant(1)}, {RenderMode::normals, 101});
  const auto channel = [&](int row, int column, int c) {
    return image.pixels8[static_cast<std::size_t>(3 * (row * 101 + column) + c)] / 127.5 - 1;
  };
  EXPECT_NEAR(channel(50, 50, 2), 1, 0.01);
  EXPECT_NEAR(channel(50, 75, 0), 50.0 / 101, 0.01);
  EXPECT_NEAR(channel(25, 50, 1), 50.0 / 101, 0.01);
}

TEST(Rendering, RefusesNonsenseAndStopsWhenTold) {
  const FieldPtr ball = frep::make_field(s::sphere(1));
  EXPECT_THROW(render(*ball, {Vec3::Zero(), Vec3::Zero()}, {RenderMode::bitmap, 10}), Error);
  EXPECT_THROW(render(*ball, {Vec3::Constant(-1), Vec3::Constant(1)}, {RenderMode::shaded, 0}), Error);
  EXPECT_THROW(render(*ball, {{-1, -1, 0}, {1, 1, 0}}, {RenderMode::height, 10}), Error);
  EXPECT_THROW(render_mode("pretty"), Error);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(render(*ball, {Vec3::Constant(-1), Vec3::Constant(1)}, {RenderMode::shaded, 100}, progress), Error);
}

}  // namespace
}  // namespace fieldfab
