// Agreement of evaluators, intervals, pruning and text forms over random expressions.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/language.h"
#include "fieldfab/frep/reference.h"
#include "random_expression.h"

namespace fieldfab::frep {
namespace {

/// Points of a box, including its corners.
struct Samples {
  std::vector<float> x, y, z;
  explicit Samples(const Box& box, std::size_t count = 200) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 t(unit(random), unit(random), unit(random));
      if (i < 8) t = Vec3(static_cast<double>(i & 1U), static_cast<double>(i >> 1 & 1U), static_cast<double>(i >> 2));
      const Vec3 p = box.lower + t.cwiseProduct(box.size());
      x.push_back(static_cast<float>(p.x())), y.push_back(static_cast<float>(p.y())),
          z.push_back(static_cast<float>(p.z()));
    }
  }
  [[nodiscard]] Points points() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

Box random_box() {
  const auto coordinate = [] { return draw(-4000, 4000) / 1000.0; };
  const double size = std::pow(2.0, draw(-8, 3));
  const Vec3 lower(coordinate(), coordinate(), coordinate());
  return {lower, lower + Vec3::Constant(size)};
}

bool same(float a, float b) { return a == b || (a != a && b != b); }

std::vector<float> values(const Field& field, const Samples& samples) {
  std::vector<float> out(samples.x.size());
  field.values(samples.points(), out.data());
  return out;
}

/// Evaluators that this processor supports.
std::vector<Evaluator> all_evaluators() {
  std::vector<Evaluator> all;
  for (int i = 1; i <= static_cast<int>(Evaluator::jit_avx512); ++i)
    if (available(static_cast<Evaluator>(i))) all.push_back(static_cast<Evaluator>(i));
  return all;
}

RC_GTEST_PROP(Frep, EvaluatorsGiveTheSameBits, ()) {
  const Expression expression = random_expression(draw(1, 60));
  const Samples samples(random_box());
  for (const Evaluator evaluator : all_evaluators()) {
    const std::vector<float> out = values(*make_field(expression, evaluator), samples);
    for (std::size_t i = 0; i < out.size(); ++i)
      RC_ASSERT(same(out[i], evaluate(expression, samples.x[i], samples.y[i], samples.z[i])));
  }
}

RC_GTEST_PROP(Frep, GradientsGiveTheSameBits, ()) {
  const Expression expression = random_expression(draw(1, 40));
  const Samples samples(random_box(), 70);
  for (const Evaluator evaluator : all_evaluators()) {
    std::vector<float> out(samples.x.size()), dx(out), dy(out), dz(out);
    make_field(expression, evaluator)->gradients(samples.points(), out.data(), {dx.data(), dy.data(), dz.data()});
    for (std::size_t i = 0; i < out.size(); ++i) {
      const ValueAndGradient expected = evaluate_gradient(expression, samples.x[i], samples.y[i], samples.z[i]);
      RC_ASSERT(same(out[i], expected.value));
      RC_ASSERT(same(dx[i], expected.gradient[0]) && same(dy[i], expected.gradient[1]) &&
                same(dz[i], expected.gradient[2]));
    }
  }
}

RC_GTEST_PROP(Frep, IntervalsHoldEveryValue, ()) {
  const Expression expression = random_expression(draw(1, 30));
  const Box box = random_box();
  const Interval tape = make_field(expression)->interval(box);
  const auto side = [&](int axis) {
    return Interval{static_cast<float>(box.lower[axis]), static_cast<float>(box.upper[axis]), false};
  };
  const Interval reference = evaluate_interval(expression, side(0), side(1), side(2));
  for (const float value : values(*make_field(expression), Samples(box, 400))) {
    RC_ASSERT(tape.contains(value));
    RC_ASSERT(reference.contains(value));
  }
}

RC_GTEST_PROP(Frep, PrunedEqualsUnpruned, ()) {
  const Expression expression = random_expression(draw(5, 80));
  const FieldPtr whole = make_field(expression);
  const Box box = random_box();
  Box inner = box;
  inner.upper = box.centre();
  const FieldPtr once = whole->restricted(box).field, twice = once->restricted(inner).field;
  const FieldPtr sign = whole->restricted(box, Purpose::occupancy).field->restricted(inner, Purpose::occupancy).field;
  const Samples samples(inner, 150);
  std::vector<float> a(samples.x.size()), ax(a), ay(a), az(a), b(a), bx(a), by(a), bz(a);
  whole->gradients(samples.points(), a.data(), {ax.data(), ay.data(), az.data()});
  for (const FieldPtr& field : {once, twice}) {
    field->gradients(samples.points(), b.data(), {bx.data(), by.data(), bz.data()});
    for (std::size_t i = 0; i < a.size(); ++i) {
      RC_ASSERT(same(a[i], b[i]));
      RC_ASSERT(same(ax[i], bx[i]) && same(ay[i], by[i]) && same(az[i], bz[i]));
    }
  }
  const std::vector<float> signs = values(*sign, samples);
  for (std::size_t i = 0; i < a.size(); ++i) RC_ASSERT((a[i] < 0) == (signs[i] < 0));
}

RC_GTEST_PROP(Frep, RestrictingManyIsRestrictingEach, ()) {
  const Expression expression = random_expression(draw(1, 60));
  const Purpose purpose = draw(0, 2) == 0 ? Purpose::value : Purpose::occupancy;
  std::vector<Box> boxes;
  for (int i = draw(1, 40); i-- > 0;) boxes.push_back(random_box());
  std::vector<Restriction> many(boxes.size());
  const FieldPtr slow = make_field(expression, Evaluator::reference);
  const std::vector<Evaluator> evaluators = all_evaluators();
  const FieldPtr fast =
      make_field(expression, evaluators[static_cast<std::size_t>(draw(0, static_cast<int>(evaluators.size())))]);
  fast->restrict_all(boxes, purpose, many);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Restriction one = slow->restricted(boxes[i], purpose);  // one box at a time
    RC_ASSERT(many[i].range == one.range);
    RC_ASSERT(active_nodes(*many[i].field) == active_nodes(*one.field));
    const Samples samples(boxes[i], 20);
    const std::vector<float> a = values(*many[i].field, samples), b = values(*one.field, samples);
    for (std::size_t k = 0; k < a.size(); ++k) RC_ASSERT(same(a[k], b[k]));
  }
}

RC_GTEST_PROP(Frep, TextFormsReadBackTheSameExpression, ()) {
  const Expression expression = random_expression(draw(0, 25));
  RC_ASSERT(parse_math(print_math(expression)) == expression);
  RC_ASSERT(parse_vm(print_vm(expression)) == expression);
  RC_ASSERT(parse_infix(print_infix(expression)) == expression);
}

/// Texts of the language's words, and texts cut and joined at random.
std::string random_text() {
  // clang-format off
  static const std::string_view pieces[] = {
      "sphere(", "box(1, 2, 3)", "a", "b", " = ", "f(a, b) = ", "part(", "\"n\"", "\"red\"", ")", ", ", "\n", "\n",
      "; ", " + ", " - ", " | ", "2.5", "1e99", "(", "# 1 to 2", "open(\"f\")", "½", "\"", "@", "\t", "x", "spheer(",
      "dx = ", "-3", "!", "q", "f(2)", "e", " // ", "\xff", "1.5.5x", "a = 2\n", "union(", " * "};
  // clang-format on
  std::string text;
  const int count = draw(0, 40);
  for (int i = 0; i < count; ++i) text += pieces[draw(0, static_cast<int>(std::size(pieces)))];
  if (draw(0, 2) == 0) text += print_infix(random_expression(draw(0, 10)));
  if (!text.empty()) {
    const int changes = draw(0, 3);
    for (int i = 0; i < changes; ++i)
      text[static_cast<std::size_t>(draw(0, static_cast<int>(text.size())))] = static_cast<char>(draw(0, 256));
  }
  return text;
}

RC_GTEST_PROP(Frep, EditorsAndParserAgreeOnTexts, ()) {
  const std::string text = random_text();
  std::string rest = text;
  std::size_t end = 0;
  for (const Token& token : tokens(text)) {
    RC_ASSERT(token.length > 0 && token.offset >= end);
    end = token.offset + token.length;
    RC_ASSERT(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(token.offset), '\n') + 1 ==
              static_cast<std::ptrdiff_t>(token.line));
    std::fill_n(rest.begin() + static_cast<std::ptrdiff_t>(token.offset), token.length, ' ');
  }
  RC_ASSERT(rest.find_first_not_of(" \t\r\n") == std::string::npos);

  std::string thrown;
  try {
    parse_parts(text, "t");
  } catch (const Error& error) {
    thrown = printable(error.what());
  }
  const std::vector<Diagnostic> found = diagnostics(text);
  RC_ASSERT(found.empty() == thrown.empty());
  for (const Diagnostic& each : found) RC_ASSERT(each.offset + each.length <= text.size());
  if (!found.empty()) RC_ASSERT(fmt::format("t:{}:{}: {}", found[0].line, found[0].column, found[0].message) == thrown);

  for (const TextParameter& each : parameters(text))
    RC_ASSERT(evaluate(parse_infix(text.substr(each.value_offset, each.value_length)), 0, 0, 0) ==
              static_cast<float>(each.value));
  words(text);
  const auto offset = static_cast<std::size_t>(draw(0, static_cast<int>(text.size()) + 2));
  const Completions fitting = completions(text, offset);
  RC_ASSERT(fitting.offset + fitting.length == std::min(offset, text.size()));
  if (const auto word = word_at(text, offset)) RC_ASSERT(text.substr(word->offset, word->length) == word->name);
}

RC_GTEST_PROP(Frep, SimplifyingKeepsTheValue, ()) {
  // Operations without cancellation or discontinuities, so that rounding errors stay small.
  std::vector<Expression> parts{Expression::x(),  Expression::y(), Expression::z(), 0.0, 1.0, -1.0, 2.0,
                                random_constant()};
  const auto any = [&] { return parts[static_cast<std::size_t>(draw(0, static_cast<int>(parts.size())))]; };
  constexpr Opcode calm[] = {Opcode::minimum, Opcode::maximum, Opcode::negate,   Opcode::absolute, Opcode::multiply,
                             Opcode::square,  Opcode::add,     Opcode::subtract, Opcode::divide,   Opcode::power};
  for (int i = 0; i < 12; ++i) {
    const Opcode op = calm[draw(0, 10)];
    parts.push_back(info(op).arity == 1 ? Expression::make(op, any()) : Expression::make(op, any(), any()));
  }
  const Expression before = parts.back(), after = simplify(before);
  RC_ASSERT(node_count(after) <= node_count(before));
  const auto exact = [](const Expression& e, float x, float y, float z) {
    // In double precision, so that only differences due to the simplification are visible.
    const Flat flat = flatten(e);
    std::vector<double> v;
    double largest = 1;
    for (const Flat::Entry& n : flat.order) {
      const double a = n.a < v.size() ? v[n.a] : 0, b = n.b < v.size() ? v[n.b] : 0;
      switch (n.op) {
        case Opcode::constant: v.push_back(n.constant); break;
        case Opcode::x: v.push_back(x); break;
        case Opcode::y: v.push_back(y); break;
        case Opcode::z: v.push_back(z); break;
        case Opcode::minimum: v.push_back(a != a ? a : a <= b ? a : b); break;
        case Opcode::maximum: v.push_back(a != a ? a : a >= b ? a : b); break;
        case Opcode::negate: v.push_back(-a); break;
        case Opcode::absolute: v.push_back(std::fabs(a)); break;
        case Opcode::multiply: v.push_back(a * b); break;
        case Opcode::square: v.push_back(a * a); break;
        case Opcode::add: v.push_back(a + b); break;
        case Opcode::subtract: v.push_back(a - b); break;
        case Opcode::divide: v.push_back(a / b); break;
        default: v.push_back(std::pow(a, b)); break;
      }
      largest = std::isfinite(v.back()) ? std::max(largest, std::fabs(v.back())) : INFINITY;
    }
    return std::pair(v.back(), largest);
  };
  const Samples samples({Vec3::Constant(-2), Vec3::Constant(2)}, 20);
  for (std::size_t i = 0; i < samples.x.size(); ++i) {
    const auto [a, scale] = exact(before, samples.x[i], samples.y[i], samples.z[i]);
    const auto [b, other] = exact(after, samples.x[i], samples.y[i], samples.z[i]);
    if (std::isfinite(a) && scale < 1e9) RC_ASSERT(std::fabs(a - b) <= 1e-6 * scale);
  }
}

}  // namespace
}  // namespace fieldfab::frep
