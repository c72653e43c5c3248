// Operations on Fields, and the Asdf: intervals contain all values; restriction and threads do not
// change values.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <random>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/render/render.h"
#include "fieldfab/volume/distances.h"
#include "random_expression.h"
#include "slopes_check.h"

namespace fieldfab {
namespace {

namespace s = frep::shapes;

double number(double from, double to) { return from + (to - from) * draw(0, 10001) / 10000.0; }

FieldPtr random_shape() {
  switch (draw(0, 5)) {
    case 0: return frep::make_field(s::sphere(number(0.3, 1.2)));
    case 1: return frep::make_field(s::box(number(0.3, 2), number(0.3, 2), number(0.3, 2)));
    case 2: return frep::make_field(s::torus(number(0.5, 1), number(0.1, 0.4)));
    case 3: return frep::make_field(s::cylinder(number(0.2, 1), number(0.2, 2)));
    default: return box_field({{-0.5, -0.7, -0.4}, {number(0.1, 1), 0.6, 0.9}});
  }
}

FieldPtr random_solid(int depth) {
  if (depth == 0) return random_shape();
  const FieldPtr a = random_solid(depth - 1);
  const auto b = [&] { return random_solid(depth - 1); };
  switch (draw(0, 15)) {
    case 0: return unite(a, b());
    case 1: return intersect(a, b());
    case 2: return subtract(a, b());
    case 3: return complement(a);
    case 4: return offset(a, number(-0.2, 0.2));
    case 5: return shell(a, number(0.05, 0.4));
    case 6: return blend(a, b(), number(0.1, 1));
    case 7: return morph(a, b(), number(0, 1));
    case 8: return translate(a, {number(-1, 1), number(-1, 1), number(-1, 1)});
    case 9: return scale(a, {number(0.5, 2), number(0.5, 2), -number(0.5, 2)});
    case 10: return rotate(a, {number(-1, 1), number(-1, 1), 1}, number(-3, 3));
    case 11: return mirror(a, {1, number(-1, 1), number(-1, 1)});
    case 12: return seen_from_near(a, {number(-1, 1), number(-1, 1), number(-1, 1)}, number(5, 20));
    case 13: return distances(a, {{-1, -1, -1}, {1, 1, 1}}, {number(0.2, 0.8), 0.15});
    default: {
      const auto axis = [](const frep::Expression& e) { return frep::make_field(e); };
      return map(a, axis(frep::Expression::x() * 1.5), axis(frep::Expression::y() + frep::sin(frep::Expression::z())),
                 axis(frep::Expression::z()));
    }
  }
}

struct Cloud {
  std::vector<float> x, y, z;
  explicit Cloud(const Box& box, std::size_t count = 120) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 p = box.lower + Vec3(unit(random), unit(random), unit(random)).cwiseProduct(box.size());
      x.push_back(static_cast<float>(p.x())), y.push_back(static_cast<float>(p.y())),
          z.push_back(static_cast<float>(p.z()));
    }
  }
  [[nodiscard]] Points points() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

Box random_box() {
  const Vec3 lower(number(-2, 2), number(-2, 2), number(-2, 2));
  return {lower, lower + Vec3::Constant(number(0.01, 1))};
}

RC_GTEST_PROP(FieldOperations, IntervalsHoldValuesAndRestrictionChangesNothing, ()) {
  const FieldPtr solid = random_solid(draw(0, 4));
  const Box box = random_box();
  const Cloud cloud(box);
  std::vector<float> a(cloud.x.size()), ax(a), ay(a), az(a), b(a), bx(a), by(a), bz(a), v(a);
  solid->values(cloud.points(), v.data());
  solid->gradients(cloud.points(), a.data(), {ax.data(), ay.data(), az.data()});
  const Restriction part = solid->restricted(box);
  part.field->gradients(cloud.points(), b.data(), {bx.data(), by.data(), bz.data()});
  const FieldPtr sign = solid->restricted(box, Purpose::occupancy).field;
  std::vector<float> c(a);
  sign->values(cloud.points(), c.data());
  const Interval range = solid->interval(box);
  for (std::size_t i = 0; i < a.size(); ++i) {
    RC_ASSERT(v[i] == a[i]);
    RC_ASSERT(range.contains(a[i]));
    RC_ASSERT(part.range.contains(a[i]));
    RC_ASSERT(a[i] == b[i]);
    RC_ASSERT(ax[i] == bx[i] && ay[i] == by[i] && az[i] == bz[i]);
    RC_ASSERT((a[i] < 0) == (c[i] < 0));
  }
}

/// Asserts that no point of a cloud that lies in the solid lies outside its bounds.
void assert_holds(const SolidBounds& bounds, const Field& solid, const Cloud& cloud) {
  std::vector<float> value(cloud.x.size());
  solid.values(cloud.points(), value.data());
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!(value[i] < 0)) continue;
    RC_ASSERT(!bounds.empty);
    const std::array at{cloud.x[i], cloud.y[i], cloud.z[i]};
    for (int axis = 0; axis < 3; ++axis) {
      const double place = at[static_cast<std::size_t>(axis)];
      RC_ASSERT(!bounds.bounded[axis] || (bounds.box.lower[axis] <= place && place <= bounds.box.upper[axis]));
    }
  }
}

RC_GTEST_PROP(Bounds, HoldTheSolid, ()) {
  const FieldPtr solid =
      draw(0, 3) == 0 ? frep::make_field(frep::random_expression(draw(1, 12))) : random_solid(draw(0, 4));
  SolidBounds bounds = solid_bounds(*solid);
  const auto assert_all = [&] {
    assert_holds(bounds, *solid, Cloud({Vec3::Constant(-3), Vec3::Constant(3)}, 2000));
    if (bounds.empty || !bounds.is_bounded()) return;
    const Vec3 size = bounds.box.size();
    assert_holds(bounds, *solid, Cloud(bounds.box.grown(0.02 * size.maxCoeff()), 2000));
    for (int axis = 0; axis < 3; ++axis)  // slabs beside the faces
      for (const bool upper : {false, true}) {
        Box slab = bounds.box;
        const double face = (upper ? slab.upper : slab.lower)[axis], thick = 0.005 * size[axis];
        slab.lower[axis] = face - thick, slab.upper[axis] = face + thick;
        assert_holds(bounds, *solid, Cloud(slab, 500));
      }
  };
  assert_all();
  if (bounds.empty || !bounds.is_bounded()) return;
  const Box whole = bounds.box;
  bounds.box = tight_bounds(*solid, whole);
  RC_ASSERT(whole.contains(bounds.box.lower) && whole.contains(bounds.box.upper));
  assert_all();
}

/// Boxes about the planes between copies of a solid, and points at these planes, one float after the other.
RC_GTEST_PROP(FieldOperations, RestrictionAtJumpsChangesNothing, ()) {
  const double period = number(0.5, 1.5), step = number(0.3, 1);
  const auto random_part = [&] { return s::move(s::box(number(0.1, 2), number(0.1, 2), 1), number(-1, 1), 0, 0); };
  const frep::Expression copies = s::repeat_y(s::repeat_x(s::unite(random_part(), random_part()), period), period);
  const frep::Expression stairs = frep::Expression::z() - step * frep::floor(frep::Expression::x() / step);
  const FieldPtr solid = frep::make_field(draw(0, 2) == 0 ? s::subtract(stairs, copies) : s::intersect(copies, stairs));
  const double plane = (draw(0, 2) == 0 ? period / 2 : step) + period * draw(-2, 3);
  const Box box{Vec3(plane, plane, 0) - Vec3(number(0, 0.4), number(-0.1, 0.4), number(0, 0.4)),
                Vec3(plane, plane, 0) + Vec3(number(0, 0.4), number(0.2, 0.4), number(0, 0.4))};
  Cloud cloud(box, 300);
  for (std::size_t i = 0; i < 100; ++i) {
    float at = static_cast<float>(plane);
    for (int n = draw(-9, 10); n != 0; n += n < 0 ? 1 : -1)
      at = std::nextafter(at, n < 0 ? -std::numeric_limits<float>::infinity() : std::numeric_limits<float>::infinity());
    (i % 2 == 0 ? cloud.x : cloud.y)[i] = std::clamp(at, static_cast<float>(box.lower[i % 2 == 0 ? 0 : 1]),
                                                     static_cast<float>(box.upper[i % 2 == 0 ? 0 : 1]));
  }
  std::vector<float> a(cloud.x.size()), b(a), c(a);
  solid->values(cloud.points(), a.data());
  const Restriction part = solid->restricted(box), sign = solid->restricted(box, Purpose::occupancy);
  part.field->values(cloud.points(), b.data());
  sign.field->values(cloud.points(), c.data());
  for (std::size_t i = 0; i < a.size(); ++i) {
    RC_ASSERT(a[i] == b[i]);
    RC_ASSERT((a[i] < 0) == (c[i] < 0));
    RC_ASSERT(part.range.contains(a[i]) && solid->interval(box).contains(a[i]));
    RC_ASSERT(!sign.range.decided() || sign.range.inside() == (a[i] < 0));
  }
}

RC_GTEST_PROP(FieldOperations, SlopesHoldDifferences, ()) {
  const FieldPtr solid = random_solid(draw(0, 4));
  const Box box = random_box();
  expect_slopes_hold(*solid, box);
  expect_slopes_hold(*solid->restricted(box).field, box);
}

RC_GTEST_PROP(AsdfProperties, IntervalsHoldValuesAndRestrictionChangesNothing, ()) {
  const FieldPtr solid = random_solid(draw(0, 2));
  const auto asdf =
      Asdf::build(*solid, {Vec3::Constant(-2), {2, 1.7, 2.3}}, {number(0.07, 0.3), number(0, 0.05), true});
  const Box box = random_box();
  const Cloud cloud(box);
  std::vector<float> a(cloud.x.size()), b(a);
  asdf->values(cloud.points(), a.data());
  const Restriction part = asdf->restricted(box);
  part.field->values(cloud.points(), b.data());
  for (std::size_t i = 0; i < a.size(); ++i) {
    RC_ASSERT(part.range.contains(a[i]));
    RC_ASSERT(a[i] == b[i]);
  }
}

TEST(Threads, MakeNoDifferenceToResults) {
  const FieldPtr solid = frep::make_field(s::subtract(s::box(2, 2, 2), s::sphere(1.2)));
  const Box bounds{Vec3::Constant(-1.3), Vec3::Constant(1.3)};
  TriangleMesh mesh;
  Image image;
  AsdfStatistics counts;
  for (const int threads : {1, 2, 4, 7}) {
    const ThreadLimit limit(threads);
    const TriangleMesh again = contour(*solid, bounds, {0.04});
    const Image picture = render(*solid, bounds, {RenderMode::shaded, 200, 0.6, -0.9, 0.5, 2});
    const auto asdf = Asdf::build(*solid, bounds, {0.04});
    if (threads == 1) {
      mesh = again, image = picture, counts = asdf->statistics();
      continue;
    }
    EXPECT_EQ(mesh.vertices, again.vertices);
    EXPECT_EQ(mesh.triangles, again.triangles);
    EXPECT_EQ(image.pixels8, picture.pixels8);
    EXPECT_EQ(counts.leafs, asdf->statistics().leafs);
    EXPECT_EQ(counts.cells(), asdf->statistics().cells());
  }
}

}  // namespace
}  // namespace fieldfab
