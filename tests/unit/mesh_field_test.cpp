// A mesh as a Field, against brute force over its triangles.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "../family.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/mesh/mesh_field.h"

namespace fieldfab {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

TriangleMesh ball_mesh(double radius = 1, const Vec3& centre = Vec3::Zero()) {
  const FieldPtr ball = translate(frep::make_field(frep::shapes::sphere(radius)), centre);
  return contour(*ball, Box{Vec3::Constant(-1.2 * radius) + centre, Vec3::Constant(1.2 * radius) + centre},
                 {0.12 * radius});
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

TriangleMesh inside_out(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  return mesh;
}

std::array<Vec3, 3> corners(const TriangleMesh& mesh, std::size_t triangle) {
  std::array<Vec3, 3> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& v = mesh.vertices[mesh.triangles[triangle][i]];
    points[i] = Vec3(v[0], v[1], v[2]);
  }
  return points;
}

/// The nearest point of a triangle is inside of it, on an edge, or a corner.
double distance_to(const std::array<Vec3, 3>& t, const Vec3& p) {
  double best = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = t[i], ab = t[(i + 1) % 3] - a;
    best = std::min(best, (a + std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0) * ab - p).norm());
  }
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized(), foot = p - normal.dot(p - t[0]) * normal;
  bool within = true;
  for (std::size_t i = 0; i < 3; ++i) within = within && normal.dot((t[(i + 1) % 3] - t[i]).cross(foot - t[i])) >= 0;
  return within ? std::min(best, (foot - p).norm()) : best;
}

double brute_distance(const TriangleMesh& mesh, const Vec3& p) {
  double best = HUGE_VAL;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) best = std::min(best, distance_to(corners(mesh, i), p));
  return best;
}

double brute_winding(const TriangleMesh& mesh, const Vec3& p) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto t = corners(mesh, i);
    const Vec3 a = (t[0] - p).normalized(), b = (t[1] - p).normalized(), c = (t[2] - p).normalized();
    sum += std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a)) / (2 * std::numbers::pi);
  }
  return sum;
}

TEST(MeshField, AgreesWithBruteForce) {
  TriangleMesh soup = ball_mesh();
  append(soup, ball_mesh(0.7, {0.8, 0.3, 0}));             // they overlap
  append(soup, inside_out(ball_mesh(0.4, {-0.3, 0, 0})));  // a cavity
  TriangleMesh open = ball_mesh();
  std::erase_if(open.triangles, [&](const auto& t) { return open.vertices[t[0]][2] > 0.6F; });
  for (const TriangleMesh& mesh : {ball_mesh(), soup, inside_out(soup), open}) {
    const FieldPtr solid = mesh_field(mesh);
    std::mt19937 random(1);
    std::vector<float> x, y, z;
    for (int i = 0; i < 400; ++i) {
      // Runs of neighbours, because a query reuses the result of the previous one.
      const bool jump = i % 20 == 0;
      x.push_back(static_cast<float>(jump ? uniform(random, -1.5, 1.7) : x.back() + uniform(random, -0.05, 0.05)));
      y.push_back(static_cast<float>(jump ? uniform(random, -1.5, 1.5) : y.back() + uniform(random, -0.05, 0.05)));
      z.push_back(static_cast<float>(jump ? uniform(random, -1.5, 1.5) : z.back() + uniform(random, -0.05, 0.05)));
    }
    std::vector<float> value(x.size()), again(x.size()), dx(x.size()), dy(x.size()), dz(x.size());
    solid->values({x.data(), y.data(), z.data(), x.size()}, value.data());
    solid->gradients({x.data(), y.data(), z.data(), x.size()}, again.data(), {dx.data(), dy.data(), dz.data()});
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vec3 p(x[i], y[i], z[i]);
      EXPECT_NEAR(std::abs(value[i]), brute_distance(mesh, p), 1e-5);
      EXPECT_EQ(value[i], again[i]);
      if (const double winding = std::abs(brute_winding(mesh, p)); std::abs(winding - 0.5) > 0.03) {
        EXPECT_EQ(value[i]<0, winding> 0.5) << p.transpose() << " winding " << winding;
      }
      EXPECT_TRUE(std::abs(value[i]) < 1e-3 || std::abs(Vec3(dx[i], dy[i], dz[i]).norm() - 1) < 1e-4);
    }
  }
}

/// A box with faces of four triangles round their centre, and a triangle without area on each edge
/// of the lower face.
TriangleMesh divided_box(float side) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.push_back({corner & 1 ? side : 0, corner & 2 ? side : 0, corner & 4 ? side : 0});
  const std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::array<float, 3> middle{};
    for (const std::uint32_t v : faces[f])
      for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += mesh.vertices[v][axis] / 4;
    const auto centre = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(middle);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t a = faces[f][i], b = faces[f][(i + 1) % 4];
      if (f != 0) {
        mesh.triangles.push_back({a, b, centre});
        continue;
      }
      const auto between = static_cast<std::uint32_t>(mesh.vertices.size());
      std::array<float, 3> half{};
      for (std::size_t axis = 0; axis < 3; ++axis) half[axis] = (mesh.vertices[a][axis] + mesh.vertices[b][axis]) / 2;
      mesh.vertices.push_back(half);
      mesh.triangles.insert(mesh.triangles.end(), {{a, between, centre}, {between, b, centre}, {a, b, between}});
    }
  }
  return mesh;
}

TEST(MeshField, CountsLinesThroughEdgesAndCornersRightly) {
  TriangleMesh two = divided_box(4);
  append(two, divided_box(2));  // inside, with common planes: winding number 2
  TriangleMesh open = divided_box(4);
  open.triangles.erase(open.triangles.end() - 4, open.triangles.end());  // without its last face
  for (const TriangleMesh& mesh : {two, inside_out(two), open}) {
    const FieldPtr solid = mesh_field(mesh);
    for (int n = 0; n < 13 * 13 * 13; ++n) {
      // on planes, edges and diagonals of all faces
      const Vec3 p = 0.5 * Vec3(n % 13 - 2, n / 13 % 13 - 2, n / 169 - 2);
      const double winding = std::abs(brute_winding(mesh, p));
      if (brute_distance(mesh, p) < 1e-6 || std::abs(winding - 0.5) < 0.03) continue;
      EXPECT_EQ(solid->value(p) < 0, winding > 0.5) << p.transpose();
    }
  }
}

TEST(MeshField, IntervalsHoldEveryValue) {
  TriangleMesh open = ball_mesh();
  std::erase_if(open.triangles, [&](const auto& t) { return open.vertices[t[0]][0] > 0.3F; });
  for (const TriangleMesh& mesh : {ball_mesh(), open}) {
    const FieldPtr solid = mesh_field(mesh);
    std::mt19937 random(2);
    int decided = 0;
    for (int n = 0; n < 1500; ++n) {
      const double reach = std::pow(10.0, uniform(random, -2.5, 0.3));
      const Vec3 lower(uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5));
      const Box box{lower, lower + reach * Vec3(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1))};
      const Interval range = solid->interval(box);
      decided += range.decided();
      for (int m = 0; m < 20; ++m)
        EXPECT_TRUE(range.contains(solid->value(
            box.lower +
            box.size().cwiseProduct(Vec3(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1))))));
    }
    EXPECT_GT(decided, 500);
  }
}

/// Lines along the normals from facing(), and between them, leave the solid but do not enter it;
/// also for set operations and moves.
TEST(MeshField, WaysAlongItsNormalsDoNotEnterTheSolid) {
  const TriangleMesh ball = ball_mesh();
  TriangleMesh two = ball;
  append(two, ball_mesh(0.7, {0.8, 0.3, 0}));
  // a line may leave a solid with winding number 2 and still be inside
  EXPECT_FALSE(mesh_field(two)->faceted());
  EXPECT_FALSE(mesh_field(inside_out(ball))->faceted());
  const FieldPtr mesh = mesh_field(ball);
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.rotate(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())).scale(Vec3(1, 0.6, 1.3));
  const FieldPtr bar = frep::make_field(frep::parse_infix("box(0.5, 0.5, 3)"));
  std::mt19937 random(3);
  for (const FieldPtr& solid :
       {mesh, transform(mesh, map), subtract(bar, mesh), subtract(mesh, translate(mesh, {0.5, 0, 0}))}) {
    ASSERT_TRUE(solid->faceted());
    int told = 0, crossed = 0;
    for (int n = 0; n < sample_or_all(400, 1500); ++n) {
      const double reach = std::pow(10.0, uniform(random, -2, 0.3));
      const Vec3 lower(uniform(random, -1.5, 1.2), uniform(random, -1.5, 1.2), uniform(random, -1.5, 1.2));
      const Box box{lower,
                    lower + reach * Vec3(uniform(random, 0.1, 1), uniform(random, 0.1, 1), uniform(random, 0.1, 1))};
      std::vector<Eigen::Vector3f> normals;
      if (!solid->facing(box, normals)) continue;
      ++told;
      for (int m = 0; m < 60; ++m) {
        const auto place = [&] {
          return Vec3(box.lower + box.size().cwiseProduct(
                                      Vec3(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1))));
        };
        const Vec3 from = place(), to = place();
        bool along = true;
        for (const Eigen::Vector3f& normal : normals) along = along && normal.dot((to - from).cast<float>()) >= 0;
        const float before = solid->value(from), after = solid->value(to);
        crossed += along && before < 0 && after > 0;
        EXPECT_FALSE(along && before > 1e-5F && after < -1e-5F) << from.transpose() << " to " << to.transpose();
      }
    }
    EXPECT_GT(told, sample_or_all(50, 200));
    EXPECT_GT(crossed, sample_or_all(2, 10));
  }
}

TEST(MeshField, ComesBackAsItWas) {
  const TriangleMesh mesh = ball_mesh();
  const TriangleMesh again = contour(*mesh_field(mesh), mesh.bounds().grown(0.1), {0.05, -1, false});
  EXPECT_NEAR(again.volume(), mesh.volume(), 0.002 * mesh.volume());
}

TEST(MeshField, BadMeshesAreRefused) {
  EXPECT_THROW(mesh_field({}), Error);
  EXPECT_THROW(mesh_field({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}), Error);
  EXPECT_THROW(mesh_field({{{0, 0, 0}, {1, 0, 0}, {NAN, 1, 0}}, {{0, 1, 2}}}), Error);
}

}  // namespace
}  // namespace fieldfab
