// Operations on Fields against closed forms, and bounds of solids.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/expression.h"
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

/// Expects tight bounds that contain the expected ones and are at most `share` of their size larger.
void expect_tight_bounds(const FieldPtr& field, const Box& expected, double share) {
  const Box found = tight_bounds(*field, solid_bounds(*field).box);
  const double size = expected.size().maxCoeff(), rounding = 1e-6 * (size + expected.lower.cwiseAbs().maxCoeff());
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(found.lower[axis], expected.lower[axis] + rounding) << axis;
    EXPECT_GE(found.upper[axis], expected.upper[axis] - rounding) << axis;
    EXPECT_GE(found.lower[axis], expected.lower[axis] - share * size - rounding) << axis;
    EXPECT_LE(found.upper[axis], expected.upper[axis] + share * size + rounding) << axis;
  }
}

TEST(Operations, ABlendIsAUnionAwayFromItsFillet) {
  const FieldPtr a = box_field({{-1, -1, -1}, {1, 1, 1}}), b = box_field({{9, -1, -1}, {11, 1, 1}}),
                 both = blend(a, b, 2);
  EXPECT_EQ(both->restricted({{-1.2, -0.5, -0.5}, {-0.9, 0.5, 0.5}}).field,
            a->restricted({{-1.2, -0.5, -0.5}, {-0.9, 0.5, 0.5}}).field);
  // Between two balls that nearly touch the blend is solid.
  const FieldPtr near = blend(a, translate(a, {2.2, 0, 0}), 2);
  const Box middle{{1.05, -0.5, -0.5}, {1.15, 0.5, 0.5}};
  EXPECT_LT(near->value({1.1, 0, 0}), 0);
  EXPECT_EQ(near->restricted(middle).field->value({1.1, 0.1, 0.1}), near->value({1.1, 0.1, 0.1}));
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

// Flat faces of many holes and parts are found as closely as those of one box.
TEST(Bounds, AreCloseAroundPartsOfManyFaces) {
  std::string holes, pins;
  for (int i = 0; i < 200; ++i)
    holes += fmt::format(", move(cylinder(1.2, 9), {}, {})", 6 * (i % 16) - 45, 6 * (i / 16) - 36);
  for (int i = 0; i < 30; ++i) pins += fmt::format("{}move(cylinder(1, {}), {}, 0)", i == 0 ? "" : ", ", i + 1, 3 * i);
  const struct {
    std::string solid;
    Box expected;
  } parts[] = {{"difference(box(100, 80, 3)" + holes + ")", {{-50, -40, -1.5}, {50, 40, 1.5}}},
               {"union(" + pins + ")", {{-1, -1, -15}, {88, 1, 15}}},
               {"box(100, 0.1, 0.01)", {{-50, -0.05, -0.005}, {50, 0.05, 0.005}}}};
  for (const auto& [text, expected] : parts) {
    const SolidBounds found = solid_bounds(*frep::make_field(frep::parse_infix(text)));
    ASSERT_TRUE(found.is_bounded() && !found.empty) << text;
    for (int axis = 0; axis < 3; ++axis) {
      const double near = expected.size()[axis] / 100;
      EXPECT_LE(found.box.lower[axis], expected.lower[axis]) << text << axis;
      EXPECT_GE(found.box.upper[axis], expected.upper[axis]) << text << axis;
      EXPECT_NEAR(found.box.lower[axis], expected.lower[axis], near) << text << axis;
      EXPECT_NEAR(found.box.upper[axis], expected.upper[axis], near) << text << axis;
    }
  }
}

// A second look needs no search; what was cancelled is not kept, and another Field has its own.
TEST(Bounds, AreKeptWithTheField) {
  const FieldPtr field = ball();
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW((void)solid_bounds(*field, cancelled), Error);
  const SolidBounds found = solid_bounds(*field), again = solid_bounds(*field, cancelled);
  EXPECT_EQ(found.box.lower, again.box.lower);
  EXPECT_EQ(found.box.upper, again.box.upper);
  EXPECT_TRUE(again.is_bounded());
  EXPECT_THROW((void)solid_bounds(*ball(), cancelled), Error);
  EXPECT_GT(solid_bounds(*translate(field, {5, 0, 0})).box.lower.x(), 3);
}

TEST(Bounds, CanBeTight) {
  const auto solid = [](const char* text) { return frep::make_field(frep::parse_infix(text)); };
  expect_tight_bounds(solid("box(40, 30, 10)"), {{-20, -15, -5}, {20, 15, 5}}, 1e-6);
  expect_tight_bounds(solid("move(box(40, 30, 10), 1000, 0.3, -7)"), {{980, -14.7, -12}, {1020, 15.3, -2}}, 1e-6);
  expect_tight_bounds(solid("difference(box(40, 30, 8), move(cylinder(3, 30), 9, 5, 0))"),
                      {{-20, -15, -4}, {20, 15, 4}}, 1e-6);
  expect_tight_bounds(solid("move(sphere(7.3), 1, 2, 3.3)"), {{-6.3, -5.3, -4}, {8.3, 9.3, 10.6}}, 1e-5);
  const double sine = std::sin(std::numbers::pi / 9), cosine = std::cos(std::numbers::pi / 9);
  const double y = 15 * cosine + 5 * sine, z = 15 * sine + 5 * cosine;
  expect_tight_bounds(solid("rotate_x(box(40, 30, 10), 20)"), {{-20, -y, -z}, {20, y, z}}, 1e-4);
  expect_tight_bounds(solid("box(40, 30, 10) | move(cylinder(0.01, 3), 11, 2, 6)"), {{-20, -15, -5}, {20, 15, 7.5}},
                      1e-5);  // a needle
  const FieldPtr tangle = frep::make_field(frep::parse_vm(read_file(TEST_DATA "/frep/tanglecube.vm")));
  expect_tight_bounds(tangle, {Vec3::Constant(-2.3363), Vec3::Constant(2.3363)}, 8e-3);  // wide intervals
  const Box flat = tight_bounds(*solid("circle(3)"), {{-4, -4, 0}, {4, 4, 0}});
  EXPECT_NEAR(flat.upper.x(), 3, 1e-5);
  EXPECT_EQ(flat.size().z(), 0);
}

frep::Expression turned(const frep::Expression& shape, int turn) {
  return s::move(s::rotate_x(s::rotate_z(shape, 0.37 * turn), 0.53 * turn), 20, -7, 3);
}

// Intervals of a twisted bar are unbounded until its length is known, and the length of a rotated
// bar is along none of x, y and z.
TEST(Bounds, AreFoundOfWhatIsTwistedTaperedAndTurned) {
  const double half = std::sqrt(2 * 0.49 + 1);  // half diagonal of the twisted bar
  for (int turn = 0; turn < 10; ++turn) {
    for (const frep::Expression& shape : {s::twist(s::box(1.4, 1.4, 2), 0.6), s::taper(s::box(1.6, 1.6, 2), 4, 0.5)}) {
      const FieldPtr solid = frep::make_field(turned(shape, turn));
      const SolidBounds found = solid_bounds(*solid);
      ASSERT_TRUE(found.is_bounded()) << turn;
      EXPECT_TRUE(found.box.contains({20, -7, 3}));
      EXPECT_LT(found.box.diagonal(), 2 * std::sqrt(3.0) * 1.1 * half);
      // No part of it is beyond any side.
      for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
          Box beyond{found.box.lower - Vec3::Constant(3), found.box.upper + Vec3::Constant(3)};
          (sign > 0 ? beyond.lower : beyond.upper)[axis] = (sign > 0 ? found.box.upper : found.box.lower)[axis];
          for (int i = 0; i < 4000; ++i) {
            const Vec3 share(std::fmod(i * 0.7548776662, 1), std::fmod(i * 0.5698402910, 1), i / 4000.0);
            EXPECT_GE(solid->value(beyond.lower + share.cwiseProduct(beyond.size())), 0);
          }
        }
    }
  }
}

TEST(Framed, IsTheSameFieldInOtherCoordinates) {
  const frep::Expression shape = s::unite(s::twist(s::box(1.4, 1.4, 2), 0.6), s::taper(s::torus(1, 0.3), 4, 0.5));
  for (int turn = 1; turn < 10; ++turn)
    for (const FieldPtr& solid : {frep::make_field(turned(shape, turn)),
                                  offset(rotate(frep::make_field(turned(shape, turn)), {1, 2, 3}, 0.8), 0.1)}) {
      const Framed framed = solid->framed();
      ASSERT_NE(framed.field, solid);
      for (int i = 0; i < 100; ++i) {
        const Vec3 p = Vec3(20, -7, 3) + 2 * Vec3(std::sin(i * 1.7), std::sin(i * 2.9), std::sin(i * 4.3));
        EXPECT_NEAR(framed.field->value(framed.axes.inverse() * (p - framed.origin)), solid->value(p), 1e-3);
      }
    }
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
