// Operations over Fields against closed forms, and the bounds of solids.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"

namespace fieldfab {
namespace {

namespace s = frep::shapes;

FieldPtr ball(double radius = 1) { return frep::make_field(s::sphere(radius)); }

TEST(Operations, HaveTheirClosedForms) {
  const Vec3 p(0.3, -0.4, 1.2);
  const double a = p.norm() - 1, b = (p - Vec3(1, 0, 0)).norm() - 0.5;
  const FieldPtr one = ball(), other = translate(ball(0.5), {1, 0, 0});
  EXPECT_NEAR(other->value(p), b, 1e-6);
  EXPECT_NEAR(unite(one, other)->value(p), std::min(a, b), 1e-6);
  EXPECT_NEAR(intersect(one, other)->value(p), std::max(a, b), 1e-6);
  EXPECT_NEAR(subtract(one, other)->value(p), std::max(a, -b), 1e-6);
  EXPECT_NEAR(complement(one)->value(p), -a, 1e-6);
  EXPECT_NEAR(offset(one, 0.25)->value(p), a - 0.25, 1e-6);
  EXPECT_NEAR(shell(one, 0.5)->value(p), std::max(a - 0.25, -0.25 - a), 1e-6);
  EXPECT_NEAR(morph(one, other, 0.25)->value(p), 0.75 * a + 0.25 * b, 1e-6);
  EXPECT_NEAR(blend(one, other, 0.3)->value(p),
              std::min({a, b, std::sqrt(std::abs(a)) + std::sqrt(std::abs(b)) - std::sqrt(0.3)}), 1e-5);
  EXPECT_NEAR(scale(one, {2, 2, 2})->value(p), p.norm() - 2, 1e-6);
  EXPECT_NEAR(rotate(other, Vec3::UnitZ(), std::numbers::pi / 2)->value({0, 1, 0}), -0.5, 1e-6);
  EXPECT_NEAR(mirror(other, Vec3::UnitX())->value({-1, 0, 0}), -0.5, 1e-6);
  EXPECT_NEAR(box_field({{-1, -1, -1}, {1, 2, 3}})->value({0, 0, 2.5}), -0.5, 1e-6);
}

TEST(Operations, RefuseNonsense) {
  EXPECT_THROW(shell(ball(), 0), Error);
  EXPECT_THROW(scale(ball(), {1, 0, 1}), Error);
  EXPECT_THROW(rotate(ball(), Vec3::Zero(), 1), Error);
  EXPECT_THROW(offset(ball(), INFINITY), Error);
  EXPECT_THROW(box_field({{0, 0, 0}, {-1, 1, 1}}), Error);
}

void expect_bounds(const FieldPtr& field, const Box& expected) {
  const SolidBounds found = solid_bounds(*field);
  ASSERT_FALSE(found.empty);
  const double tolerance = expected.size().maxCoeff() / 100;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(found.bounded[axis]);
    EXPECT_LE(found.box.lower[axis], expected.lower[axis] + 1e-5);
    EXPECT_GE(found.box.upper[axis], expected.upper[axis] - 1e-5);
    EXPECT_NEAR(found.box.lower[axis], expected.lower[axis], tolerance);
    EXPECT_NEAR(found.box.upper[axis], expected.upper[axis], tolerance);
  }
}

TEST(Bounds, AreFoundNotGuessed) {
  expect_bounds(ball(), {Vec3::Constant(-1), Vec3::Constant(1)});
  expect_bounds(translate(ball(), {1000, -2000, 0}), {{999, -2001, -1}, {1001, -1999, 1}});
  expect_bounds(ball(1e-3), {Vec3::Constant(-1e-3), Vec3::Constant(1e-3)});
  expect_bounds(ball(3e5), {Vec3::Constant(-3e5), Vec3::Constant(3e5)});
  expect_bounds(unite(translate(ball(), {-500, 0, 0}), translate(ball(2), {40, 0, 0})), {{-501, -2, -2}, {42, 2, 2}});
  expect_bounds(rotate(frep::make_field(s::box(2, 2, 2)), Vec3::UnitZ(), std::numbers::pi / 4),
                {{-std::sqrt(2.0), -std::sqrt(2.0), -1}, {std::sqrt(2.0), std::sqrt(2.0), 1}});
  expect_bounds(frep::make_field(frep::parse_vm(read_file(TEST_DATA "/frep/tanglecube.vm"))),
                {Vec3::Constant(-2.3363), Vec3::Constant(2.3363)});
}

TEST(Bounds, TellTheUnboundedAndTheEmpty) {
  const SolidBounds flat = solid_bounds(*frep::make_field(s::circle(2)));
  EXPECT_TRUE(flat.bounded[0] && flat.bounded[1] && !flat.bounded[2]);
  EXPECT_NEAR(flat.box.upper.x(), 2, 0.02);
  for (const FieldPtr& endless : {frep::make_field(s::gyroid(2)), complement(ball())}) {
    const SolidBounds found = solid_bounds(*endless);
    EXPECT_FALSE(found.empty || found.bounded[0] || found.bounded[1] || found.bounded[2]);
  }
  EXPECT_FALSE(solid_bounds(*frep::make_field(frep::Expression::x())).bounded[0]);
  EXPECT_TRUE(solid_bounds(*frep::make_field(s::sphere(-1))).empty);
  EXPECT_TRUE(solid_bounds(*intersect(ball(), translate(ball(), {5, 0, 0}))).empty);
}

}  // namespace
}  // namespace fieldfab
