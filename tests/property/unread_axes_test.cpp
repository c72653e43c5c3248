// Axes that a Field does not read: values are the same along them, and what contouring does once for all places along
// them gives the mesh that it gives place by place.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <random>

#include "field/forwarding.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "random_expression.h"

namespace fieldfab {
namespace {

namespace s = frep::shapes;
using frep::Expression;

/// A Field that does not tell which axes it leaves unread.
class Reticent final : public Forwarding {
 public:
  explicit Reticent(const FieldPtr& field) : Forwarding(field), field_(field) {}
  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    field_->restrict_all(boxes, purpose, out);
    for (Restriction& here : out.first(boxes.size())) here.field = std::make_shared<Reticent>(std::move(here.field));
  }
  [[nodiscard]] FieldPtr without_seams() const override {
    const FieldPtr merged = field_->without_seams();
    return merged ? std::make_shared<Reticent>(merged) : nullptr;
  }
  [[nodiscard]] unsigned unread_axes() const noexcept override { return 0; }

 private:
  FieldPtr field_;
};

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

RC_GTEST_PROP(UnreadAxes, ChangeNoValue, ()) {
  const FieldPtr field = frep::make_field(frep::random_expression(draw(1, 40)));
  std::mt19937 random(static_cast<unsigned>(draw(0, 1000000)));
  std::uniform_real_distribution<double> unit(0, 1);
  const auto point_in = [&](const Box& box) -> Vec3 {
    return box.lower + Vec3(unit(random), unit(random), unit(random)).cwiseProduct(box.size());
  };
  unsigned unread = 0;
  for (int boxes = 0; boxes < 20; ++boxes) {
    const Vec3 lower = 4 * Vec3(unit(random), unit(random), unit(random)) - Vec3::Constant(2);
    const Box box{lower, lower + Vec3::Constant(unit(random))};
    const FieldPtr part = unite(field, field->restricted(box).field), here = part->restricted(box).field;
    unread |= here->unread_axes();
    for (int axis = 0; axis < 3; ++axis) {
      if ((here->unread_axes() >> axis & 1U) == 0) continue;
      const Vec3 one = point_in(box);
      Vec3 other = one;
      other[axis] = point_in(box)[axis];
      RC_ASSERT(bits(here->value(one)) == bits(here->value(other)));
      RC_ASSERT(bits(field->value(one)) == bits(field->value(other)));
      RC_ASSERT(!(here->gradient(one)[axis] != 0));
    }
  }
  RC_CLASSIFY(unread != 0, "some left an axis unread");
}

/// An outline of bars, discs and rings, some of which touch.
Expression random_outline(int depth) {
  if (depth > 0) {
    const Expression a = random_outline(depth - 1), b = random_outline(depth - 1);
    return draw(0, 4) == 0 ? s::subtract(a, b) : s::unite(a, b);
  }
  const double x = 0.7 * draw(0, 6), y = 0.7 * draw(0, 6), size = 0.7 * draw(1, 3);
  switch (draw(0, 3)) {
    case 0: return s::move(s::circle(size), x, y, 0);
    case 1: return s::move(s::subtract(s::circle(size), s::circle(0.6 * size)), x, y, 0);
    default: return s::move(s::rectangle(size, 0.7 * draw(1, 5)), x, y, 0);
  }
}

/// Two extrusions, turned onto x, y or z.
FieldPtr random_extrusions() {
  const Expression x = Expression::x(), y = Expression::y(), z = Expression::z();
  const Expression solid =
      s::unite(s::extrude(random_outline(draw(0, 3)), 2, -1),
               s::move(s::extrude(random_outline(draw(0, 3)), 2, -1), 0.7, 0.7, 0.7 * draw(-2, 3)));
  const int turned = draw(0, 3);
  return frep::make_field(turned == 0 ? solid : turned == 1 ? remap(solid, y, z, x) : remap(solid, z, x, y));
}

const Box around{Vec3::Constant(-2.6), Vec3::Constant(6.1)};

RC_GTEST_PROP(UnreadAxes, MakeNoDifferenceToSamples, ()) {
  const FieldPtr field = random_extrusions();
  const ContourSettings settings{.voxel = 0.5 + 0.02 * draw(0, 10), .features = false, .depth = 0};
  const ContourMesh told = contour(*field, around, settings),
                    untold = contour(*std::make_shared<Reticent>(field), around, settings);
  RC_ASSERT((told.vertices == untold.vertices));
  RC_ASSERT((told.triangles == untold.triangles));
}

// After many proofs that failed in a block, a closer look gets less effort. Places along an axis count at once, so that
// a few cells more or less are halved; what is certain and the solid are the same.
RC_GTEST_PROP(UnreadAxes, MakeNoDifferenceToWhatIsCertain, ()) {
  const FieldPtr field = random_extrusions();
  const ContourSettings settings{.voxel = 0.5 + 0.02 * draw(0, 10), .features = false};
  const ContourMesh told = contour(*field, around, settings),
                    untold = contour(*std::make_shared<Reticent>(field), around, settings);
  RC_ASSERT(told.certainty.certain() == untold.certainty.certain());
  RC_ASSERT(told.certainty.count == untold.certainty.count);
  RC_ASSERT(std::abs(told.volume() - untold.volume()) <= 1e-3 * untold.volume());
}

}  // namespace
}  // namespace fieldfab
