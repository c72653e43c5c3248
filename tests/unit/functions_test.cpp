// The transcendental functions: accuracy, special values, and the same bits and intervals from all
// evaluators.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "fieldfab/frep/expression.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/reference.h"

namespace fieldfab::frep {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
constexpr float least = std::numeric_limits<float>::denorm_min(), largest = std::numeric_limits<float>::max();

constexpr Opcode of_one[] = {Opcode::sine,      Opcode::cosine,     Opcode::tangent,     Opcode::arcsine,
                             Opcode::arccosine, Opcode::arctangent, Opcode::exponential, Opcode::logarithm};
constexpr Opcode of_two[] = {Opcode::power, Opcode::arctangent2};

std::vector<Opcode> all_functions() {
  std::vector<Opcode> all;
  for (const Opcode op : of_one) all.push_back(op);
  for (const Opcode op : of_two) all.push_back(op);
  return all;
}

std::vector<Evaluator> all_evaluators() {
  std::vector<Evaluator> all;
  for (int i = 1; i <= static_cast<int>(Evaluator::jit_avx512); ++i)
    if (available(static_cast<Evaluator>(i))) all.push_back(static_cast<Evaluator>(i));
  return all;
}

Expression expression_of(Opcode op) {
  return info(op).arity == 1 ? Expression::make(op, Expression::x())
                             : Expression::make(op, Expression::x(), Expression::y());
}

/// The bits of a number; the same for all NaN.
std::uint32_t bits(float number) { return std::bit_cast<std::uint32_t>(number != number ? nan : number); }

/// Numbers at which something changes, of both signs.
std::vector<float> edges() {
  std::vector<float> all{0, least, 3 * least, 1.17549421e-38F, 1.17549435e-38F, 1e-30F, 1e-8F, 0.25F, 0.41421357F};
  for (const float number : {0.5F, 0.7071068F, 0.99999994F, 1.0F, 1.0000001F, 1.4142135F, 1.5F, 1.5707964F, 2.0F})
    all.push_back(number);
  for (const float number : {2.4142137F, 3.0F, 3.1415927F, 4.0F, 87.3F, 88.72284F, 88.72285F, 89.0F, 103.97F, 104.0F})
    all.push_back(number);
  for (const float number : {1e6F, 1000000.1F, 8388607.5F, 16777215.0F, 16777216.0F, 4e9F, 1e30F, largest, infinity})
    all.push_back(number);
  for (std::size_t i = all.size(); i-- > 0;) all.push_back(-all[i]);
  all.push_back(nan);
  return all;
}

/// Pairs of numbers: all pairs of edges, random bits, and random numbers of moderate size.
struct Samples {
  std::vector<float> x, y, z;
  Samples() {
    for (const float a : edges())
      for (const float b : edges()) add(a, b);
    std::mt19937 random(3);
    for (int i = 0; i < 20000; ++i)
      add(std::bit_cast<float>(static_cast<std::uint32_t>(random())),
          std::bit_cast<float>(static_cast<std::uint32_t>(random())));
    std::uniform_real_distribution<float> some(-5, 5);
    for (int i = 0; i < 20003; ++i) add(some(random), i % 2 == 0 ? some(random) : std::round(some(random)));
    z.resize(x.size());
  }
  void add(float a, float b) { x.push_back(a), y.push_back(b); }
  [[nodiscard]] Points points() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

TEST(Functions, HaveTheSameBitsInAllEvaluators) {
  const Samples samples;
  std::vector<float> out(samples.x.size());
  for (const Opcode op : all_functions())
    for (const Evaluator evaluator : all_evaluators()) {
      make_field(expression_of(op), evaluator)->values(samples.points(), out.data());
      for (std::size_t i = 0; i < out.size(); ++i)
        ASSERT_EQ(bits(out[i]), bits(apply(op, samples.x[i], samples.y[i])))
            << info(op).infix << '(' << samples.x[i] << ", " << samples.y[i] << ") by " << name(evaluator);
    }
}

TEST(Functions, HaveTheSameGradientsInAllEvaluators) {
  const Samples samples;
  std::vector<float> out(samples.x.size()), dx(out), dy(out), dz(out);
  for (const Opcode op : all_functions()) {
    const Expression expression = expression_of(op);
    std::vector<ValueAndGradient> expected;
    for (std::size_t i = 0; i < out.size(); ++i)
      expected.push_back(evaluate_gradient(expression, samples.x[i], samples.y[i], 0));
    for (const Evaluator evaluator : all_evaluators()) {
      make_field(expression, evaluator)->gradients(samples.points(), out.data(), {dx.data(), dy.data(), dz.data()});
      for (std::size_t i = 0; i < out.size(); ++i) {
        ASSERT_EQ(bits(out[i]), bits(expected[i].value));
        ASSERT_EQ(bits(dx[i] + 0.0F), bits(expected[i].gradient[0] + 0.0F))
            << info(op).infix << '(' << samples.x[i] << ", " << samples.y[i] << ") by " << name(evaluator);
        ASSERT_EQ(bits(dy[i] + 0.0F), bits(expected[i].gradient[1] + 0.0F));
      }
    }
  }
}

TEST(Functions, TakeNumbersForAllPoints) {
  // One argument is a constant, which is no array.
  const Samples samples;
  std::vector<float> out(samples.x.size());
  for (const Opcode op : of_two)
    for (const Evaluator evaluator : all_evaluators())
      for (const double number : {0.0, 2.5, 3.0, -1.0}) {
        make_field(Expression::make(op, Expression::x(), number), evaluator)->values(samples.points(), out.data());
        for (std::size_t i = 0; i < out.size(); ++i)
          ASSERT_EQ(bits(out[i]), bits(apply(op, samples.x[i], static_cast<float>(number)))) << name(evaluator);
      }
}

/// Functions of the C library in extended precision.
long double precise(Opcode op, long double a, long double b) {
  switch (op) {
    case Opcode::sine: return std::sin(a);
    case Opcode::cosine: return std::cos(a);
    case Opcode::tangent: return std::tan(a);
    case Opcode::arcsine: return std::asin(a);
    case Opcode::arccosine: return std::acos(a);
    case Opcode::arctangent: return std::atan(a);
    case Opcode::exponential: return std::exp(a);
    case Opcode::logarithm: return std::log(a);
    case Opcode::power: return std::pow(a, b);
    default: return std::atan2(a, b);
  }
}

/// Counts results, and those that are not the nearest float.
struct Accuracy {
  long count = 0, others = 0;
  double worst = 0;  ///< error of a result in units of the last place

  void add(Opcode op, float a, float b = 0) {
    const long double exact = precise(op, a, b);
    const auto nearest = static_cast<float>(exact);
    const float result = apply(op, a, b);
    ++count;
    if (nearest != nearest || std::isinf(nearest) || nearest == 0) {
      // The C library's tanl() and the like decide on infinities, NaN and zeros, and on their signs.
      EXPECT_EQ(bits(result), bits(nearest)) << info(op).infix << '(' << a << ", " << b << ')';
      return;
    }
    others += result != nearest;
    const float size = std::fabs(nearest);
    const long double unit = static_cast<long double>(std::nextafter(size, infinity)) - size;
    if (size < largest) worst = std::max(worst, static_cast<double>(std::fabs(result - exact) / unit));
  }
};

TEST(Functions, AreTheNearestFloatButForOneCaseOfAMillion) {
  for (const Opcode op : of_one) {
    const bool wave = op == Opcode::sine || op == Opcode::cosine || op == Opcode::tangent;
    Accuracy accuracy;
    for (std::uint64_t number = 0; number < std::uint64_t{1} << 32; number += 2999) {
      const auto a = std::bit_cast<float>(static_cast<std::uint32_t>(number));
      if (!wave || std::fabs(a) <= 1e6F) accuracy.add(op, a);
    }
    EXPECT_LE(static_cast<double>(accuracy.others), 1e-6 * static_cast<double>(accuracy.count)) << info(op).infix;
    EXPECT_LE(accuracy.worst, 0.5001) << info(op).infix;
  }
}

TEST(Functions, OfTwoArgumentsAreTheNearestFloatButForOneCaseOfAMillion) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> some(-8, 8);
  for (const Opcode op : of_two) {
    Accuracy accuracy;
    for (int i = 0; i < 2'000'000; ++i) {
      float a = some(random), b = some(random);
      if (i % 2 == 0) a = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
      if (i % 4 == 0) b = std::round(b);
      if (i % 7 == 0) b = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
      accuracy.add(op, a, b);
    }
    EXPECT_LE(static_cast<double>(accuracy.others), 1e-6 * static_cast<double>(accuracy.count)) << info(op).infix;
    EXPECT_LE(accuracy.worst, 0.5001) << info(op).infix;
  }
}

TEST(Functions, HaveTheSpecialValuesOfC) {
  for (const Opcode op : all_functions())
    for (const float a : edges())
      for (const float b : edges()) {
        Accuracy accuracy;
        accuracy.add(op, a, b);
        EXPECT_LE(accuracy.worst, 1) << info(op).infix << '(' << a << ", " << b << ')';
      }
}

/// A random interval: long or short, often with ends at which something changes.
Interval random_interval(std::mt19937& random) {
  static const std::vector<float> special = edges();
  std::uniform_real_distribution<float> unit(-1, 1);
  const auto end = [&] {
    const auto kind = random() % 8;
    if (kind == 0) return special[random() % (special.size() - 1)];
    if (kind == 1) return std::round(5 * unit(random));
    return unit(random) * std::exp2(static_cast<float>(random() % 24) - 8);
  };
  const float a = end();
  const auto kind = random() % 4;
  const float b = kind == 0 ? a : kind == 1 ? a + std::fabs(a) * unit(random) * 0.01F : end();
  return {std::min(a, b), std::max(a, b), false};
}

TEST(Functions, HaveTheSameIntervalsInAllEvaluators) {
  std::mt19937 random(9);
  for (const Opcode op : all_functions()) {
    for (int round = 0; round < 300; ++round) {
      std::vector<Box> boxes;
      std::vector<Interval> expected;
      const Interval same = random_interval(random);
      for (int i = 0; i < 16; ++i) {
        const Interval x = random_interval(random), y = round % 2 == 0 ? same : random_interval(random);
        if (!std::isfinite(x.lower + x.upper + y.lower + y.upper)) continue;
        boxes.push_back({Vec3(x.lower, y.lower, 0), Vec3(x.upper, y.upper, 0)});
        expected.push_back(apply(op, x, y));
      }
      std::vector<Restriction> out(boxes.size());
      for (const Evaluator evaluator : all_evaluators()) {
        make_field(expression_of(op), evaluator)->restrict_all(boxes, Purpose::value, out);
        for (std::size_t i = 0; i < boxes.size(); ++i)
          ASSERT_EQ(out[i].range, expected[i])
              << info(op).infix << " over " << boxes[i].lower.transpose() << " to " << boxes[i].upper.transpose()
              << ": " << out[i].range.lower << ' ' << out[i].range.upper << ", not " << expected[i].lower << ' '
              << expected[i].upper << ", by " << name(evaluator);
      }
      for (std::size_t i = 0; i < boxes.size(); ++i)
        for (int sample = 0; sample < 20; ++sample) {
          std::uniform_real_distribution<double> part(0, 1);
          const double s = sample < 4 ? sample % 2 : part(random), t = sample < 4 ? sample / 2 : part(random);
          const auto at = [](double lower, double upper, double share) {
            return static_cast<float>(std::clamp(lower + share * (upper - lower), lower, upper));
          };
          const float x = at(boxes[i].lower.x(), boxes[i].upper.x(), s),
                      y = at(boxes[i].lower.y(), boxes[i].upper.y(), t);
          ASSERT_TRUE(expected[i].contains(apply(op, x, y)))
              << info(op).infix << " (" << x << ", " << y << ") is " << apply(op, x, y) << ", not from "
              << expected[i].lower << " to " << expected[i].upper;
        }
    }
  }
}

}  // namespace
}  // namespace fieldfab::frep
