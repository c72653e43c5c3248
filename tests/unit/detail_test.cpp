// Meshes that are finer near the eye.
#include "fieldfab/contour/detail.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"

namespace fieldfab {
namespace {

namespace s = frep::shapes;
const Box bounds{Vec3::Constant(-1.2), Vec3::Constant(1.2)};

std::size_t triangles(const std::vector<DetailMesh::Part>& parts) {
  std::size_t sum = 0;
  for (const auto& part : parts) sum += part.mesh->triangles.size();
  return sum;
}

TEST(DetailMesh, IsFineWhereTheEyeIsNear) {
  DetailMesh mesh(frep::make_field(s::sphere(1)), bounds, {12, 3, 0.04});
  const Vec3 eye(0, 0, 1.3);
  EXPECT_TRUE(mesh.parts(eye).empty());
  ASSERT_TRUE(mesh.refine(eye));
  EXPECT_EQ(mesh.parts(eye).size(), 1U);  // a coarse mesh is available at once
  int calls = 1;
  while (mesh.refine(eye) && ++calls < 1000) EXPECT_FALSE(mesh.parts(eye).empty());
  int nearest = 0, farthest = 99;
  for (const auto& part : mesh.parts(eye)) {
    const double distance = (part.box.centre() - eye).norm(), cell = part.box.size().x() / 12;
    const Vec3 close = eye.cwiseMax(part.box.lower).cwiseMin(part.box.upper);
    EXPECT_TRUE(cell / (close - eye).norm() <= 0.04 || part.level == 3);
    (distance < 0.5 ? nearest : farthest) =
        distance < 0.5 ? std::max(nearest, part.level) : std::min(farthest, part.level);
    for (const auto& v : part.mesh->vertices) {
      const Vec3 p(v[0], v[1], v[2]);
      EXPECT_NEAR(p.norm(), 1, 0.15 * cell);
      EXPECT_TRUE(part.box.grown(1.5 * cell).contains(p));
    }
  }
  EXPECT_EQ(nearest, 3);
  EXPECT_LT(farthest, 3);
}

TEST(DetailMesh, CoversTheSurfaceWithoutGapsOrInnerWalls) {
  // Parts cover the whole surface, and all their points lie on it.
  const FieldPtr cube = frep::make_field(s::box(1.5, 1.5, 1.5));
  DetailMesh mesh(cube, bounds, {8, 3, 0.05});
  const Vec3 eye(0.2, 0.9, 0.9);
  while (mesh.refine(eye)) {
  }
  double area = 0;
  for (const auto& part : mesh.parts(eye)) {
    area += part.mesh->area();
    for (const auto& v : part.mesh->vertices) EXPECT_NEAR(cube->value({v[0], v[1], v[2]}), 0, 1e-3);
  }
  EXPECT_GT(area, 6 * 1.5 * 1.5 - 1e-3);
  EXPECT_LT(area, 6 * 1.5 * 1.5 * 1.7);  // the margins of neighbours overlap
}

TEST(DetailMesh, ForgetsWhatIsNotLookedAt) {
  DetailMesh mesh(frep::make_field(s::sphere(1)), bounds, {12, 3, 0.04, 2000});
  const Vec3 near(0, 0, 1.1), far(0, 0, 1000), other(0, 1.1, 0);
  while (mesh.refine(near)) {
  }
  const std::size_t before = triangles(mesh.parts(near));
  while (mesh.refine(far)) {
  }
  EXPECT_EQ(mesh.parts(far).size(), 1U);
  EXPECT_LT(triangles(mesh.parts(near)), before);  // it has to be computed again
  while (mesh.refine(other)) {
  }
  EXPECT_GT(triangles(mesh.parts(other)), before / 2);
}

TEST(DetailMesh, RefusesNonsenseAndStopsWhenTold) {
  const FieldPtr ball = frep::make_field(s::sphere(1));
  EXPECT_THROW(DetailMesh(ball, Box::everything()), Error);
  EXPECT_THROW(DetailMesh(ball, bounds, {2}), Error);
  DetailMesh mesh(ball, bounds);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(mesh.refine(Vec3::Zero(), progress), Error);
  EXPECT_TRUE(mesh.parts(Vec3::Zero()).empty());
}

}  // namespace
}  // namespace fieldfab
