// Pictures of triangles against the slow, obvious twin: each pixel's ray against every triangle.
#include "fieldfab/render/triangles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

struct Mesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Colour> colours;
  [[nodiscard]] Triangles view() const { return {vertices, triangles, colours}; }
};

/// Random triangles, large and small, which intersect; some share edges.
Mesh random_mesh(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<float> place(-5, 5), step(-1, 1);
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<float, 3> a{place(random), place(random), place(random)};
    const float reach = i % 3 ? 0.8F : 6.0F;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(a);
    for (int k = 0; k < 3; ++k)
      mesh.vertices.push_back({a[0] + reach * step(random), a[1] + reach * step(random), a[2] + reach * step(random)});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first + 2, first + 1, first + 3});
  }
  return mesh;
}

/// A closed ball of triangles.
Mesh ball(int rings, float radius) {
  Mesh mesh;
  const auto at = [&](int ring, int step) { return static_cast<std::uint32_t>(ring * 2 * rings + step % (2 * rings)); };
  for (int ring = 0; ring <= rings; ++ring)
    for (int step = 0; step < 2 * rings; ++step) {
      const float up = 3.14159265F * static_cast<float>(ring) / static_cast<float>(rings),
                  round = 3.14159265F * static_cast<float>(step) / static_cast<float>(rings);
      mesh.vertices.push_back(
          {radius * std::sin(up) * std::cos(round), radius * std::sin(up) * std::sin(round), radius * std::cos(up)});
    }
  for (int ring = 0; ring < rings; ++ring)
    for (int step = 0; step < 2 * rings; ++step) {
      mesh.triangles.push_back({at(ring, step), at(ring + 1, step), at(ring + 1, step + 1)});
      mesh.triangles.push_back({at(ring, step), at(ring + 1, step + 1), at(ring, step + 1)});
    }
  return mesh;
}

/// z of a vertical ray's first intersection with a triangle, after the rotation.
double first_height(const Mesh& mesh, const Eigen::Matrix3d& turn, double x, double y) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& v = mesh.vertices[t[k]];
      p[k] = turn * Vec3(v[0], v[1], v[2]);
    }
    Eigen::Matrix2d sides;
    sides << p[1].x() - p[0].x(), p[2].x() - p[0].x(), p[1].y() - p[0].y(), p[2].y() - p[0].y();
    if (std::abs(sides.determinant()) < 1e-12) continue;
    const Eigen::Vector2d share = sides.inverse() * Eigen::Vector2d(x - p[0].x(), y - p[0].y());
    if (share.minCoeff() < 0 || share.sum() > 1) continue;
    highest = std::max(highest, p[0].z() + share.x() * (p[1].z() - p[0].z()) + share.y() * (p[2].z() - p[0].z()));
  }
  return highest;
}

TEST(TrianglePictures, ShowWhatRaysMeet) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int round = 0; round < 20; ++round) {
    const Mesh mesh = random_mesh(random, 1 + static_cast<std::size_t>(round) * 4);
    RenderSettings settings;
    settings.mode = RenderMode::height;
    settings.size = 97;
    settings.alpha = round ? angle(random) : 0, settings.beta = round ? angle(random) : 0;
    const TrianglePicture picture = render(mesh.view(), settings);
    const Box& region = picture.image.bounds;
    int seen = 0, different = 0;
    for (int row = 0; row < picture.image.height; ++row)
      for (int column = 0; column < picture.image.width; ++column) {
        const double x = region.lower.x() + (column + 0.5) * region.size().x() / picture.image.width,
                     y = region.upper.y() - (row + 0.5) * region.size().y() / picture.image.height;
        const double wanted = first_height(mesh, picture.turn, x, y);
        const float found =
            picture.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.image.width) +
                            static_cast<std::size_t>(column)];
        seen += std::isfinite(wanted);
        different += std::isfinite(wanted) ? !(std::abs(found - wanted) < 1e-4) : std::isfinite(found);
      }
    EXPECT_GT(seen, 20) << round;
    EXPECT_EQ(different, 0) << round;
  }
}

TEST(TrianglePictures, OfClosedSurfacesHaveNoHoles) {
  // Seen along an axis, many edges pass exactly through pixels' centres.
  const Mesh mesh = ball(60, 1);
  RenderSettings settings;
  settings.mode = RenderMode::normals;
  settings.size = 200;
  settings.window = Box{{-1, -1, 0}, {1, 1, 0}};
  const TrianglePicture picture = render(mesh.view(), settings);
  ASSERT_EQ(picture.image.width, 200);
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 200; ++column) {
      const double x = -1 + (column + 0.5) / 100, y = 1 - (row + 0.5) / 100, r = std::hypot(x, y);
      const std::size_t i = static_cast<std::size_t>(row) * 200 + static_cast<std::size_t>(column);
      if (r > 0.98) continue;
      ASSERT_NEAR(picture.heights[i], std::sqrt(1 - r * r), 0.03) << x << ' ' << y;
      // Normals are interpolated: those of the ball.
      EXPECT_NEAR(picture.image.pixels8[3 * i] / 127.5 - 1, x, 0.06) << x << ' ' << y;
      EXPECT_NEAR(picture.image.pixels8[3 * i + 1] / 127.5 - 1, y, 0.06) << x << ' ' << y;
    }
}

TEST(TrianglePictures, AreTheSameForAnyNumberOfThreads) {
  std::mt19937 random(3);
  Mesh mesh = random_mesh(random, 300);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    mesh.colours.push_back({static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()), 90});
  RenderSettings settings;
  settings.size = 150, settings.samples = 2, settings.alpha = 0.4, settings.beta = -0.8;
  const TrianglePicture all = render(mesh.view(), settings);
  const ThreadLimit one(1);
  EXPECT_EQ(render(mesh.view(), settings).image.pixels8, all.image.pixels8);
}

TEST(TrianglePictures, HaveTheirVerticesColours) {
  Mesh plate{
      {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, std::vector<Colour>(4, {178, 24, 43})};
  RenderSettings settings;
  settings.size = 33, settings.samples = 3;
  const Image red = render(plate.view(), settings).image;
  const std::size_t middle = 3 * (16 * 33 + 16);
  EXPECT_GT(red.pixels8[middle], 120);
  EXPECT_LT(red.pixels8[middle + 1], 0.3 * red.pixels8[middle]);
  plate.colours.assign(4, {200, 200, 200});
  const Image grey = render(plate.view(), settings).image;
  EXPECT_NEAR(grey.pixels8[middle], grey.pixels8[middle + 2], 16);
}

TEST(TrianglePictures, KnowWhereThingsAre) {
  // Two plates, one above half of the other.
  const Mesh mesh{{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}},
                  {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}},
                  {}};
  RenderSettings settings;
  settings.size = 200;
  settings.window = Box{{0, 0, 0}, {4, 2, 0}};
  const TrianglePicture picture = render(mesh.view(), settings);
  EXPECT_TRUE(picture.on_picture({1, 1.5, 0.3}).isApprox(Vec3(50, 25, 0.3)));
  EXPECT_TRUE(picture.shows({3, 1, 0}, 0.01));
  EXPECT_TRUE(picture.shows({1, 1, 1}, 0.01));
  EXPECT_FALSE(picture.shows({1, 1, 0}, 0.01));
  EXPECT_TRUE(picture.shows({1, 1, 0}, 1.01));
  EXPECT_FALSE(picture.shows({5, 1, 2}, 0.01));
}

TEST(TrianglePictures, RefuseWhatTheyCannotShow) {
  const Mesh good = ball(4, 1), bad{good.vertices, {{0, 1, 9999}}, {}},
             short_of_colours{good.vertices, good.triangles, {{1, 2, 3}}};
  RenderSettings settings;
  EXPECT_THROW(render(bad.view(), settings), Error);
  EXPECT_THROW(render(short_of_colours.view(), settings), Error);
  EXPECT_THROW(render(Mesh{}.view(), settings), Error);
  settings.perspective = 0.5;
  EXPECT_THROW(render(good.view(), settings), Error);
  settings.perspective = 0, settings.mode = RenderMode::bitmap;
  EXPECT_THROW(render(good.view(), settings), Error);
  settings.mode = RenderMode::shaded, settings.window = Box{{0, 0, 0}, {2, 1, 0}};
  EXPECT_EQ(render(Mesh{}.view(), settings).heights,
            std::vector<float>(512 * 256, -std::numeric_limits<float>::infinity()));
}

}  // namespace
}  // namespace fieldfab
