// Formulas that contain opened Fields: their Field against the reference evaluator, which is the
// slow twin.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/library.h"
#include "fieldfab/frep/reference.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/solid/solid.h"
#include "random_expression.h"
#include "slopes_check.h"

namespace fieldfab {
namespace {

using frep::Expression;
namespace shapes = frep::shapes;

/// A leaf that is opaque to its users: a box or a ball.
Expression leaf(int which) {
  static const auto made = [] {
    std::vector<frep::SourcePtr> sources;
    for (const FieldPtr& field : {box_field({{-1, -2, -0.5}, {1.5, 1, 2}}), frep::make_field(shapes::sphere(1.7))}) {
      auto source = std::make_shared<OpenedSolid>();
      source->field = field;
      source->path = fmt::format("/somewhere/{}.stl", sources.size());
      sources.push_back(source);
    }
    return sources;
  }();
  return Expression::opened(made[static_cast<std::size_t>(which)], Expression::x(), Expression::y(), Expression::z());
}

double number(double low, double high) { return low + (high - low) * draw(0, 10001) / 10000.0; }

/// A design of leaves, formulas, set operations, blends and moves, whose values are distances or
/// slightly steeper.
Expression random_design(int size) {
  std::vector<Expression> parts{leaf(0), leaf(1), shapes::cylinder(0.8, 3), shapes::torus(1.5, 0.4)};
  const auto any = [&] { return parts[static_cast<std::size_t>(draw(0, static_cast<int>(parts.size())))]; };
  for (int i = 0; i < size; ++i) {
    const Expression a = any(), b = any();
    switch (draw(0, 13)) {
      case 0: parts.push_back(min(a, b)); break;
      case 1: parts.push_back(shapes::subtract(a, b)); break;
      case 2: parts.push_back(max(a, b)); break;
      case 3: parts.push_back(shapes::move(a, number(-1, 1), number(-1, 1), number(-1, 1))); break;
      case 4: parts.push_back(shapes::rotate_z(a, number(-3, 3))); break;
      case 5: parts.push_back(shapes::rotate_x(a, number(-3, 3))); break;
      case 6: parts.push_back(shapes::smooth_unite(a, b, number(0.1, 1))); break;
      case 7: parts.push_back(shapes::shell(a, number(0.1, 1))); break;
      case 8: parts.push_back(a - number(-0.3, 0.3)); break;
      case 9: parts.push_back(shapes::twist(a, number(-0.5, 0.5))); break;
      case 10: parts.push_back(shapes::morph(a, b, number(0, 1))); break;
      case 11: parts.push_back(shapes::mirror_x(a)); break;
      default: parts.push_back(shapes::array_x(a, draw(1, 4), number(0.5, 3)));
    }
  }
  return min(parts.back(), shapes::move(leaf(draw(0, 2)), number(-1, 1), 0, 0));
}

Vec3 place() { return Vec3(number(-4, 4), number(-4, 4), number(-4, 4)).cast<float>().cast<double>(); }

RC_GTEST_PROP(MixedField, IsWhatTheReferenceEvaluatorSays, ()) {
  const Expression design = random_design(draw(1, 9));
  const FieldPtr field = frep::make_field(design);
  for (int i = 0; i < 40; ++i) {
    const Vec3 p = place();
    const float wanted =
        frep::evaluate(design, static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    RC_ASSERT(std::abs(field->value(p) - wanted) < 1e-4F * (1 + std::abs(wanted)));
  }
}

RC_GTEST_PROP(MixedField, HasIntervalsSlopesAndRestrictionsThatHold, ()) {
  const FieldPtr field = frep::make_field(random_design(draw(1, 7)));
  for (int i = 0; i < 5; ++i) {
    const Vec3 middle = place(), half = Vec3::Constant(std::pow(10, number(-2, 0)));
    const Box box{(middle - half).cast<float>().cast<double>(), (middle + half).cast<float>().cast<double>()};
    const Interval range = field->interval(box);
    const Restriction inside = field->restricted(box), sign = field->restricted(box, Purpose::occupancy);
    for (int j = 0; j < 20; ++j) {
      const Vec3 unit(number(0, 1), number(0, 1), number(0, 1));
      const Vec3 p = (box.lower + unit.cwiseProduct(box.size())).cast<float>().cast<double>();
      if (!box.contains(p)) continue;
      const float value = field->value(p);
      RC_ASSERT(value >= range.lower && value <= range.upper);
      RC_ASSERT(inside.field->value(p) == value);
      RC_ASSERT((sign.field->value(p) < 0) == (value < 0));
    }
    expect_slopes_hold(*field, box, [&](const Vec3& p) {
      const RoundedValue own = rounded_value(*field, p);
      return RoundedValue{own.value, 8 * own.rounding};  // coordinates are rounded at each leaf
    });
  }
}

RC_GTEST_PROP(MixedField, IsTheSameAfterBeingWrittenAndReadAgain, ()) {
  const Expression design = random_design(draw(1, 9));
  std::vector<std::string> asked;
  const frep::Opener opener = [&](const std::string& path, std::span<const frep::OpenOption>) {
    asked.push_back(path);
    return leaf(path == "/somewhere/1.stl" ? 1 : 0);
  };
  RC_ASSERT(frep::parse_infix(frep::print_infix(design), "text", opener) == design);
  RC_ASSERT(!asked.empty());
}

TEST(MixedField, OfALeafIsTheLeafsOwnField) {
  const Expression ball = leaf(1);
  EXPECT_EQ(frep::make_field(ball), ball.source()->field);
  EXPECT_LT(frep::make_field(shapes::move(ball, 5, 0, 0))->value({5, 0, 0}), 0);
}

TEST(MixedField, EvaluatesWhatServesTwiceOnce) {
  // Traversal of a chain of smooth unions as a tree would double the work at each link.
  Expression chain = leaf(0);
  for (int i = 0; i < 60; ++i) chain = shapes::smooth_unite(chain, shapes::move(leaf(1), i, 0, 0), 0.5);
  const FieldPtr field = frep::make_field(chain);
  EXPECT_LT(field->value({30, 0, 0}), 0);
  EXPECT_GT(field->value({30, 9, 0}), 0);
}

TEST(Slots, EveryFunctionOfTheLibraryTakesALeaf) {
  for (const frep::LibraryFunction& function : frep::library()) {
    if (function.parameters.empty() || function.group == "numbers") continue;
    const std::string_view first = function.parameters.front().name;
    if (first != "shape" && first != "a") continue;
    std::vector<std::optional<frep::Value>> given;
    for (const frep::Parameter& parameter : function.parameters) {
      const bool shape = parameter.name == "shape" || parameter.name == "a" || parameter.name == "b";
      const bool axis = function.name == "map" && parameter.name.size() == 1;
      if (shape)
        given.emplace_back(frep::Value{leaf(1), true});
      else if (axis)
        given.emplace_back(frep::Value{Expression::x() * 0.5});
      else if (parameter.fallback)
        given.emplace_back();
      else
        given.emplace_back(frep::Value{parameter.quantity == frep::Quantity::whole ? 3.0 : 0.7});
    }
    const frep::Value made = frep::call(function, given);
    const FieldPtr field = frep::make_field(made.expression);
    const Vec3 p(0.3, 0.2, -0.4);
    EXPECT_NEAR(field->value(p), frep::evaluate(made.expression, 0.3F, 0.2F, -0.4F), 1e-4) << function.name;
  }
}

}  // namespace
}  // namespace fieldfab
