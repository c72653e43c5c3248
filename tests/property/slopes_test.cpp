// Field::slopes() of expressions, volumes and OpenSCAD's building blocks contains all difference
// quotients.
#include "slopes_check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "fieldfab/contour/contour.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/opcode.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/openscad/design.h"
#include "fieldfab/volume/volume_field.h"
#include "random_expression.h"

namespace fieldfab {
namespace {

double number(double from, double to) { return from + (to - from) * draw(0, 10001) / 10000.0; }
Vec3 place(double from, double to) { return {number(from, to), number(from, to), number(from, to)}; }

/// Boxes of all sizes and shapes with their centre in a box.
Box box_near(const Box& whole) {
  const Vec3 middle = whole.lower + place(0, 1).cwiseProduct(whole.size());
  const double side = whole.size().maxCoeff() * std::pow(10, number(-2.5, 0));
  const Vec3 half = draw(0, 2) == 0 ? Vec3::Constant(side / 2) : Vec3(side / 2 * place(0.2, 1));
  return {middle - half, middle + half};
}

// ---------- expressions

/// An expression in double precision. Constants have single precision, as in the tape.
class Twin {
 public:
  explicit Twin(const frep::Expression& expression) : flat_(frep::flatten(expression)) {}

  /// NaN if single precision takes another branch than double precision, so that the values belong
  /// to different formulas.
  RoundedValue operator()(const Vec3& p) {
    entries_.resize(flat_.order.size());
    double largest = 0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const auto& [op, constant, first, second, third, source] = flat_.order[i];
      entries_[i] = made(op, constant, entries_[first], entries_[second], p);
      if (!same_branch(op, entries_[first], entries_[second], entries_[i])) return {NAN, 0};
      largest = std::max(largest, std::abs(entries_[i].value));
    }
    return {entries_.back().value, 1e-14 * largest, 8 * last_place * entries_.back().summed + 2 * entries_.back().blur};
  }

 private:
  struct Entry {
    double value;
    float single;
    bool fixed;
    double summed = 0;  // sum of the absolute values of the slope's terms
    double blur = 0;    // part of it that is due to rounding of values to single precision
  };

  static Entry made(frep::Opcode op, double constant, const Entry& a, const Entry& b, const Vec3& p) {
    switch (op) {
      case frep::Opcode::constant: return {static_cast<float>(constant), static_cast<float>(constant), true};
      case frep::Opcode::x: return {p.x(), static_cast<float>(p.x()), false, 1};
      case frep::Opcode::y: return {p.y(), static_cast<float>(p.y()), false, 1};
      case frep::Opcode::z: return {p.z(), static_cast<float>(p.z()), false, 1};
      default: break;
    }
    const float single = frep::apply(op, a.single, b.single);
    const bool fixed = a.fixed && (frep::info(op).arity == 1 || b.fixed);
    const double value = fixed ? single : frep::apply(op, a.value, b.value);
    Entry made{value, single, fixed};
    if (fixed) return made;
    const auto [by_a, by_b] = partials(op, a.value, b.value, value);
    const auto [single_by_a, single_by_b] = partials(op, a.single, b.single, single);
    const auto add = [&](const Entry& from, double slope, double single_slope) {
      if (from.fixed) return;
      made.summed += std::abs(slope) * from.summed;
      made.blur += std::abs(slope) * from.blur + std::abs(slope - single_slope) * from.summed;
    };
    add(a, by_a, single_by_a);
    if (frep::info(op).arity == 2) add(b, by_b, single_by_b);
    return made;
  }
  /// Partial derivatives by the first and the second argument; bounds for operations that depend on
  /// order or sign.
  static std::pair<double, double> partials(frep::Opcode op, double x, double y, double value) {
    using frep::Opcode;
    switch (op) {
      case Opcode::sine: return {std::cos(x), 0};
      case Opcode::cosine: return {std::sin(x), 0};
      case Opcode::tangent: return {1 + value * value, 0};
      case Opcode::arcsine:
      case Opcode::arccosine: return {1 / std::sqrt(1 - x * x), 0};
      case Opcode::arctangent: return {1 / (1 + x * x), 0};
      case Opcode::square: return {2 * x, 0};
      case Opcode::square_root: return {1 / (2 * value), 0};
      case Opcode::exponential: return {value, 0};
      case Opcode::logarithm: return {1 / x, 0};
      case Opcode::floor:
      case Opcode::ceiling:
      case Opcode::compare: return {0, 0};
      case Opcode::multiply: return {y, x};
      case Opcode::divide: return {1 / y, value / y};
      case Opcode::power: return {y * std::pow(x, y - 1), x > 0 ? value * std::log(x) : 0};
      case Opcode::arctangent2: return {y / (x * x + y * y), x / (x * x + y * y)};
      case Opcode::modulo: return {1, std::floor(x / y)};
      default: return {1, 1};
    }
  }
  static bool same_branch(frep::Opcode op, const Entry& a, const Entry& b, const Entry& made) {
    switch (op) {
      case frep::Opcode::floor:
      case frep::Opcode::ceiling:
      case frep::Opcode::compare: return made.value == static_cast<double>(made.single);
      case frep::Opcode::modulo:
        return std::floor(a.value / b.value) == static_cast<double>(std::floor(a.single / b.single));
      case frep::Opcode::minimum: return (a.value <= b.value) == (a.single <= b.single);
      case frep::Opcode::maximum: return (a.value >= b.value) == (a.single >= b.single);
      default: return true;
    }
  }

  frep::Flat flat_;
  std::vector<Entry> entries_;
};

RC_GTEST_PROP(FieldOperations, SlopesOfExpressionsHoldDifferences, ()) {
  const frep::Expression expression = frep::random_expression(draw(1, 6));
  RC_LOG() << frep::print_infix(expression) << std::endl;
  const Vec3 lower = place(-2, 2);
  expect_slopes_hold(*frep::make_field(expression), {lower, lower + Vec3::Constant(number(0.01, 1))}, Twin(expression));
}

// ---------- volumes

struct Scan {
  SampleLattice lattice;
  FieldPtr field;
};

Scan random_scan() {
  Scan scan;
  scan.lattice.size = {draw(2, 24), draw(2, 12), draw(2, 12)};
  scan.lattice.spacing = place(0.2, 1.5);
  scan.lattice.origin = place(-5, 5);
  std::mt19937 random(static_cast<unsigned>(draw(0, 1000)));
  std::normal_distribution<float> density(100, 30);
  std::vector<float> densities(scan.lattice.count());
  for (float& one : densities) one = density(random);
  const double unit = number(0.001, 0.05);
  scan.field = volume_field(*volume_of(std::move(densities), scan.lattice), {number(60, 140), draw(0, 2) == 0, unit});
  return scan;
}

RC_GTEST_PROP(Slopes, OfVolumesHoldDifferences, ()) {
  const Scan scan = random_scan();
  const Box box = box_near(scan.lattice.box().grown(1));
  expect_slopes_hold(*scan.field, box);
  const Eigen::Affine3d placement =
      Eigen::Translation3d(place(-1, 1)) * Eigen::AngleAxisd(number(-3, 3), Vec3(1, 2, 3).normalized());
  const Vec3 middle = placement * box.centre();
  const Vec3 half = 0.3 * box.size();
  expect_slopes_hold(*transform(scan.field, placement), {middle - half, middle + half});
}

/// Except near the ends of the lattice the range is that of the gradients at the corners of all
/// parts of cells in the box.
RC_GTEST_PROP(Slopes, OfVolumesAreTight, ()) {
  const Scan scan = random_scan();
  const Box whole = scan.lattice.box();
  Box box = box_near(whole);
  box = intersection(box, whole.grown(-0.05 * whole.size().minCoeff()));
  if (!box.valid()) return;
  // The surface must lie deeper inside the lattice than the magnitude of the values.
  if (scan.field->interval(box).lower < (box.upper - whole.upper).cwiseMax(whole.lower - box.lower).maxCoeff()) return;
  const std::vector<Vec3> directions = directions_for_slopes(5);
  std::array<Interval, 5> slopes;
  scan.field->slopes(box, directions, slopes);
  // slightly beside the planes between cells, and the box's own faces
  std::array<std::vector<double>, 3> at;
  for (int axis = 0; axis < 3; ++axis) {
    const double nudge = 1e-3 * std::min(scan.lattice.spacing[axis], box.size()[axis]);
    const auto add = [&](double plane) {
      for (const double beside : {plane - nudge, plane + nudge})
        if (beside >= box.lower[axis] && beside <= box.upper[axis])
          at[static_cast<std::size_t>(axis)].push_back(beside);
    };
    add(box.lower[axis]), add(box.upper[axis]);
    for (int i = 0; i < scan.lattice.size[static_cast<std::size_t>(axis)]; ++i) {
      const double plane = scan.lattice.origin[axis] + i * scan.lattice.spacing[axis];
      // A thinner part of a cell is not sampled.
      if (std::min(std::abs(plane - box.lower[axis]), std::abs(plane - box.upper[axis])) < 2 * nudge) return;
      add(plane);
    }
  }
  std::array<Interval, 5> found;
  found.fill({INFINITY, -INFINITY, false});
  double steepest = 0;
  for (const double x : at[0])
    for (const double y : at[1])
      for (const double z : at[2]) {
        const Vec3 gradient = scan.field->gradient({x, y, z});
        steepest = std::max(steepest, gradient.norm());
        for (std::size_t i = 0; i < found.size(); ++i) {
          const auto slope = static_cast<float>(gradient.dot(directions[i]));
          found[i] = {std::min(found[i].lower, slope), std::max(found[i].upper, slope), false};
        }
      }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (slopes[i].maybe_nan) continue;  // too many cells
    RC_ASSERT(found[i].lower - slopes[i].lower < 0.02 * steepest &&
              found[i].lower - slopes[i].lower > -1e-3 * steepest);
    RC_ASSERT(slopes[i].upper - found[i].upper < 0.02 * steepest &&
              slopes[i].upper - found[i].upper > -1e-3 * steepest);
  }
}

TEST(Slopes, OfVolumesAreUnknownForManyCellsAndWhatIsNoNumber) {
  SampleLattice lattice;
  lattice.size = {40, 40, 40};
  std::vector<float> densities(lattice.count(), 1);
  densities[0] = std::numeric_limits<float>::quiet_NaN();
  const FieldPtr field = volume_field(*volume_of(densities, lattice), {0.5, false, 1});
  const std::array<Vec3, 1> directions{Vec3::UnitX()};
  std::array<Interval, 1> slopes;
  field->slopes({Vec3::Constant(1), Vec3::Constant(38)}, directions, slopes);
  EXPECT_TRUE(slopes[0].maybe_nan);
  field->slopes({Vec3::Constant(10), Vec3::Constant(20)}, directions, slopes);
  EXPECT_EQ(slopes[0], Interval::of(0));
  field->slopes({Vec3::Constant(0.5), Vec3::Constant(3)}, directions, slopes);
  EXPECT_TRUE(slopes[0].maybe_nan);
}

// ---------- OpenSCAD

/// A simple outline about the origin.
std::string random_outline(double right_of) {
  const int corners = draw(3, 9);
  std::string points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners, radius = number(0.3, 1);
    points += (i == 0 ? "[" : ", [") + std::to_string(radius * std::cos(angle) + right_of) + ", " +
              std::to_string(radius * std::sin(angle)) + "]";
  }
  return "polygon(points = [" + points + "], paths = undef, convexity = 1);";
}

std::string random_design() {
  const auto n = [](double from, double to) { return std::to_string(number(from, to)); };
  const std::string extruded = "linear_extrude(height = " + n(0.3, 2) +
                               ", center = true, convexity = 1, scale = [1, 1], $fn = 0, $fa = 12, $fs = 2) {\n" +
                               random_outline(0) + "}\n";
  const std::string turned = "rotate_extrude(angle = " + n(40, 360) +
                             ", convexity = 2, $fn = " + std::to_string(draw(3, 40)) + ", $fa = 12, $fs = 2) {\n" +
                             random_outline(1.1) + "}\n";
  const std::string moved = "multmatrix([[1, 0, 0, " + n(-1, 1) + "], [0, 0.8, -0.6, " + n(-1, 1) +
                            "], [0, 0.6, 0.8, " + n(-1, 1) + "], [0, 0, 0, 1]]) {\n";
  // A pyramid with a dent in its base.
  const std::string dented = "polyhedron(points = [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [" + n(-1, 1) +
                             ", " + n(-1, 1) + ", 1], [" + n(-0.1, 0.1) + ", " + n(-0.1, 0.1) + ", " + n(-0.95, -0.3) +
                             "]], faces = [[4, 1, 0], [4, 2, 1], [4, 3, 2], [4, 0, 3], [5, 0, 1], [5, 1, 2], [5, 2, "
                             "3], [5, 3, 0]], convexity = 2);\n";
  switch (draw(0, 6)) {
    case 5: return dented;
    case 0: return extruded;
    case 1: return turned;
    case 2: return moved + extruded + "}\n";
    case 3: return "union() {\n" + extruded + moved + turned + "}\n" + moved + extruded + "}\n}\n";
    default: return "difference() {\n" + extruded + moved + extruded + "}\n}\n";
  }
}

RC_GTEST_PROP(Slopes, OfDesignsHoldDifferences, ()) {
  openscad::DesignOptions options;
  options.smooth = draw(0, 2) == 0;
  const OpenedSolid design = *openscad::make_design(openscad::parse_csg(random_design(), "t"), "/nowhere", options);
  if (!design.field) return;
  for (int i = 0; i < 10; ++i) {
    const Vec3 middle = place(-1.5, 1.5);
    const Vec3 near = middle - (draw(0, 2) * double{design.field->value(middle)}) * design.field->gradient(middle);
    const Vec3 half = Vec3::Constant(std::pow(10, number(-2.5, 0)) / 2);
    if (!near.allFinite()) continue;
    const Box box{near - half, near + half};
    expect_slopes_hold(*design.field, box);
    expect_slopes_hold(*design.field->restricted(box).field, box);
  }
}

}  // namespace
}  // namespace fieldfab
