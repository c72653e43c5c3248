// Seams: where faces of parts coincide, a Field without seams has the same sign everywhere else, and meshes are
// certain; gaps that have a thickness stay.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fieldfab/contour/contour.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"
#include "random_expression.h"

namespace fieldfab {
namespace {

namespace s = frep::shapes;
using frep::Expression;

constexpr double pitch = 0.7;  // between the planes on which all faces lie: no float

/// A box between planes, as someone writes it: from here to there, or by its size and place.
Expression random_box() {
  const auto ends = [] {
    const int from = draw(0, 4);
    return std::pair{pitch * from, pitch * (from + draw(1, 4))};
  };
  const auto [x, u] = ends();
  const auto [y, v] = ends();
  const auto [z, w] = ends();
  if (draw(0, 2) == 0)
    return s::intersect(s::intersect(s::intersect(Expression::x() - u, x - Expression::x()),
                                     s::intersect(Expression::y() - v, y - Expression::y())),
                        s::intersect(Expression::z() - w, z - Expression::z()));
  return s::move(s::box(u - x, v - y, w - z), (x + u) / 2, (y + v) / 2, (z + w) / 2);
}

Expression random_parts(int depth) {
  if (depth == 0) return random_box();
  const Expression a = random_parts(depth - 1), b = random_parts(depth - 1);
  switch (draw(0, 12)) {
    case 0: return s::intersect(a, b);
    case 1: return -a;
    case 2: return a - 0.1;
    case 3: return a * 2.0 + 0.3;
    case 4: return s::shell(a, 0.2);
    case 5: return s::smooth_unite(a, b, 0.3);
    case 6: return s::rotate_z(a, 30);
    case 7:
    case 8: return s::subtract(a, b);
    default: return s::unite(a, b);
  }
}

RC_GTEST_PROP(Seams, LeaveTheSignAsItIsElsewhere, ()) {
  const FieldPtr solid = frep::make_field(random_parts(draw(1, 5)));
  std::mt19937 random(static_cast<unsigned>(draw(0, 1000000)));
  std::uniform_real_distribution<double> unit(0, 1);
  int merged_ones = 0;
  for (int boxes = 0; boxes < 40; ++boxes) {
    const Vec3 lower = 5 * pitch * Vec3(unit(random), unit(random), unit(random));
    const Box box{lower, lower + Vec3::Constant(0.05 + unit(random))};
    const FieldPtr here = solid->restricted(box).field, merged = here->without_seams();
    if (!merged) continue;
    ++merged_ones;
    for (int i = 0; i < 100; ++i) {
      const Vec3 p = box.lower + Vec3(unit(random), unit(random), unit(random)).cwiseProduct(box.size());
      if (std::abs(here->value(p)) < 1e-4) continue;
      RC_ASSERT((here->value(p) < 0) == (merged->value(p) < 0));
    }
  }
  RC_CLASSIFY(merged_ones > 0, "some had seams");
}

struct Design {
  const char* text;
  double volume;
};

TEST(Seams, AreNoReasonForDoubt) {
  for (const Design& design : {
           Design{"difference(box(20, 20, 10), move(box(8, 8, 10), 3.3, 2.7, 0))", 20 * 20 * 10 - 8 * 8 * 10},
           Design{"difference(move(box(20, 20, 7.3), 0.1, 0.2, 0.3), move(box(8, 8, 3.1), 3.3, 2.7, 2.4))",
                  20 * 20 * 7.3 - 8 * 8 * 3.1},
           Design{"box(10, 10, 7.7) | move(box(10, 10, 3.1), 0, 0, 5.4)", 10 * 10 * 10.8},
           Design{"move(box(10, 10, 10), 0.1, 0, 0) | move(box(4.7, 4.7, 4.7), 0.1, 0, 7.35)", 1000 + 4.7 * 4.7 * 4.7},
           Design{"rotate_z(box(10, 10, 10) | move(box(3.3, 3.3, 3.3), 0, 0, 6.65), 30)", 1000 + 3.3 * 3.3 * 3.3},
           Design{"move(cylinder(4, 7), 0.3, 0.1, 0) | move(cylinder(2, 7), 0.3, 0.1, 7)",
                  std::numbers::pi * 7 * (16 + 4)},
       }) {
    const ContourMesh mesh =
        contour(*frep::make_field(frep::parse_infix(design.text)), {Vec3::Constant(-17), Vec3::Constant(17)}, {0.31});
    EXPECT_TRUE(mesh.certainty.certain()) << design.text << mesh.certainty.text();
    EXPECT_NEAR(mesh.volume(), design.volume, 2e-3 * design.volume) << design.text;
  }
}

TEST(Seams, ThatHaveAThicknessStay) {
  const Expression everywhere = s::box(4e6, 4e6, 4e6);  // how exact its faces are does not matter elsewhere
  for (const double gap : {0.1, 0.02, 0.002, 1e-4, 2e-6}) {
    const Expression lower = s::box(2, 2, 2), upper = s::move(s::box(2, 2, 2), 0, 0, 2 + gap);
    const FieldPtr solid = frep::make_field(s::intersect(s::unite(lower, upper), everywhere));
    const ContourMesh mesh = contour(*solid, {Vec3::Constant(-3), Vec3::Constant(5)}, {0.31});
    EXPECT_TRUE(!mesh.certainty.certain() || std::abs(mesh.volume() - 16) < 0.02 * gap) << gap;
  }
}

}  // namespace
}  // namespace fieldfab
