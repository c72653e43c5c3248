// Expressions and their three text forms: valid and invalid texts, places of errors, and unlimited
// depth.
#include <gtest/gtest.h>

#include <filesystem>

#include "../family.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/reference.h"
#include "fieldfab/frep/text.h"

namespace fieldfab::frep {
namespace {

const Expression x = Expression::x(), y = Expression::y(), z = Expression::z();

std::string refusal(Expression (*parse)(std::string_view, std::string_view), std::string_view text) {
  try {
    parse(text, "t");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.place();
  }
  return "accepted";
}

TEST(Expressions, ThatAreEqualAreOneNode) {
  EXPECT_EQ(square(x) + y, square(Expression::x()) + y);
  EXPECT_FALSE(x + y == y + x);
  EXPECT_EQ(node_count(max(square(x) + square(y) - 1.0, -(square(x) + square(y) - 0.5))), 11U);  // Fig. 3-2b
  EXPECT_THROW(Expression{std::numeric_limits<double>::infinity()}, Error);
  EXPECT_THROW(Expression{std::numeric_limits<double>::quiet_NaN()}, Error);
  EXPECT_EQ(Expression(0.0), Expression(-0.0));
}

TEST(Expressions, AreSimplified) {
  const Expression plain = Expression::make(Opcode::add, x, 0.0);
  EXPECT_EQ(simplify(plain), x);
  EXPECT_EQ(x + 0.0, x);
  EXPECT_EQ(1.0 * x, x);
  EXPECT_EQ(-(-x), x);
  EXPECT_EQ(square(-x), square(x));
  EXPECT_EQ(x - x, Expression(0.0));
  EXPECT_EQ(x * x, square(x));
  EXPECT_EQ(sqrt(4.0), Expression(2.0));
  EXPECT_EQ(sqrt(Expression(-1.0)).opcode(), Opcode::square_root);  // not folded into NaN
}

TEST(MathStrings, AreReadAsKokopelliReadsThem) {
  EXPECT_EQ(parse_math("-+qXqYf1"),
            Expression::make(Opcode::subtract, Expression::make(Opcode::add, square(x), square(y)), 1.0));
  EXPECT_EQ(parse_math("m+XYX X"), Expression::make(Opcode::add, x, y));  // the example of Appendix A
  EXPECT_EQ(parse_math("mY  +XZ"), Expression::make(Opcode::add, y, z));
  EXPECT_EQ(parse_math("m+Xf1  m+Xf2  X"), Expression::make(Opcode::add, Expression::make(Opcode::add, x, 1.0), 2.0));
  EXPECT_EQ(parse_math("+m  YZX"), Expression::make(Opcode::add, y, x));  // the map ends with its body
  EXPECT_EQ(parse_math("f-0"), Expression(0.0));
  EXPECT_EQ(parse_math("+f.5f6.5e-3"), Expression::make(Opcode::add, 0.5, 6.5e-3));
  // 0, then exp: not hexadecimal
  EXPECT_EQ(parse_math("+f0xX"), Expression::make(Opcode::add, 0.0, exp(x)));
  EXPECT_EQ(parse_math("f+3"), Expression(3.0));
  EXPECT_EQ(parse_math("X\n"), x);
}

TEST(MathStrings, ThatAreWrongAreRefusedWhereTheyAre) {
  EXPECT_EQ(refusal(parse_math, "+X?"), "t:1:3");
  EXPECT_EQ(refusal(parse_math, "+X"), "t:1:3");
  EXPECT_EQ(refusal(parse_math, "XX"), "t:1:2");
  EXPECT_EQ(refusal(parse_math, ""), "t:1:1");
  EXPECT_EQ(refusal(parse_math, "+X Y"), "t:1:3");
  EXPECT_EQ(refusal(parse_math, "finf"), "t:1:2");
  EXPECT_EQ(refusal(parse_math, "fnan"), "t:1:2");
  EXPECT_EQ(refusal(parse_math, "f1e39"), "t:1:2");
  EXPECT_EQ(refusal(parse_math, "f1e999"), "t:1:2");
  EXPECT_EQ(refusal(parse_math, "m X"), "t:1:4");
  EXPECT_EQ(refusal(parse_math, std::string_view("\0\1", 2)), "t:1:1");
}

TEST(VmPrograms, AreReadAndRefused) {
  EXPECT_EQ(parse_vm("# circle\n_0 var-x\n a square _0\r\n\n"), square(x));
  EXPECT_EQ(refusal(parse_vm, "_0 var-x\n_1 add _0 _9\n"), "t:2:11");
  EXPECT_EQ(refusal(parse_vm, "_0 var-x\n_0 var-y\n"), "t:2:1");
  EXPECT_EQ(refusal(parse_vm, "_0 frob"), "t:1:4");
  EXPECT_EQ(refusal(parse_vm, "_0 const"), "t:1:9");
  EXPECT_EQ(refusal(parse_vm, "_0 const inf"), "t:1:10");
  EXPECT_EQ(refusal(parse_vm, "_0 const 1x"), "t:1:11");
  EXPECT_EQ(refusal(parse_vm, "_0 var-x _0"), "t:1:10");
  EXPECT_EQ(refusal(parse_vm, "# nothing\n"), "t:2:1");
  EXPECT_EQ(refusal(parse_vm, std::string_view("\0\1\2", 3)), "t:1:1");
}

Expression parse_text(std::string_view text, std::string_view name) { return parse_infix(text, name); }

float at(std::string_view text, float px, float py = 0, float pz = 0) {
  return evaluate(parse_infix(text), px, py, pz);
}

TEST(FrepText, HasTheUsualPrecedence) {
  EXPECT_EQ(at("1 + 2 * 3", 0), 7);
  EXPECT_EQ(at("-2 ^ 2", 0), -4);
  EXPECT_EQ(at("2 ^ 3 ^ 2", 0), 512);
  EXPECT_EQ(at("2 - 3 - 4", 0), -5);
  EXPECT_EQ(at("8 / 4 / 2", 0), 1);
  EXPECT_EQ(at("(1 + 2) * -x", 2), -6);
  EXPECT_EQ(at("x - 1 | x - 2 & x", 5), 4);
  EXPECT_EQ(at("2 ^ -1", 0), 0.5F);
}

TEST(FrepText, HasNamesFunctionsAndDefaults) {
  EXPECT_EQ(at("r = 2  # radius\nsphere(r)", 3), 1);
  EXPECT_EQ(at("sphere(r = 2)", 3), 1);
  EXPECT_EQ(at("sphere()", 3), 2);
  EXPECT_EQ(at("double(a) = a * 2\nquad(a) = double(double(a)); quad(x)", 3), 12);
  EXPECT_EQ(at("max(1, x,\n  2)", 7), 7);
  EXPECT_EQ(at("move(sphere(1), dx = 5)", 5), -1);
  EXPECT_EQ(at("difference(box(4, 4, 4), sphere(1))", 0), 1);
  EXPECT_NEAR(at("rotate_z(move(sphere(1), 5), 90)", 0, 5), -1, 1e-5);
  EXPECT_EQ(at("map(x, y, x, z)", 1, 2), 2);
}

TEST(FrepText, TellsSolidsFromNumbers) {
  EXPECT_EQ(at("sphere(3) - sphere(1)", 0), 1) << "the difference of sets";
  EXPECT_EQ(at("value(sphere(3)) - value(sphere(1))", 0), -2) << "numbers are subtracted";
  EXPECT_EQ(at("sphere(3) - 1", 0), -4);
  EXPECT_EQ(at("solid(x) - solid(x - 1)", 0.5F), 0.5F);
  EXPECT_EQ(at("x - (x - 1)", 0.5F), 1);
  EXPECT_EQ(at("f(a) = a - sphere(1)\nf(sphere(3))", 0), 1) << "a parameter is what it is given";
  EXPECT_EQ(at("min(sphere(3), sphere(2)) - sphere(1)", 0), 1);
  EXPECT_EQ(at("(x | y) - solid(z)", 1, 2, 3), 1);
  EXPECT_EQ(refusal(parse_text, "sphere(1) + box(1, 1, 1)"), "t:1:11");
  EXPECT_EQ(refusal(parse_text, "sphere(1) * box(1, 1, 1)"), "t:1:11");
}

TEST(FrepText, MakesNamedParts) {
  const auto parts = parse_parts(
      "a = part(sphere(1), \"ball\", \"tomato\")\npart(move(a, 3), name = \"other\", colour = \"#102030\")");
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].name, "ball");
  EXPECT_EQ(*parts[0].colour, (Colour{255, 99, 71}));
  EXPECT_EQ(*parts[1].colour, (Colour{16, 32, 48}));
  const auto again = parse_parts(print_parts(parts));
  ASSERT_EQ(again.size(), 2U);
  EXPECT_EQ(again[1].shape, parts[1].shape);
  EXPECT_EQ(again[1].name, "other");
  EXPECT_EQ(again[1].colour, parts[1].colour);
  EXPECT_EQ(refusal(parse_text, "part(sphere(1), \"a\")\npart(sphere(2), \"a\")"), "t:2:1");
  EXPECT_EQ(refusal(parse_text, "part(sphere(1), \"a\", \"blurple\")"), "t:1:22");
  EXPECT_EQ(refusal(parse_text, "part(sphere(1))"), "t:1:1");
  EXPECT_EQ(refusal(parse_text, "part(sphere(1), \"a\")\nsphere(2)"), "t:2:1")
      << "a shape that is no part would be lost";
  EXPECT_EQ(refusal(parse_text, "sphere(1)\nsphere(2)"), "t:1:1") << "the first would be lost";
  EXPECT_EQ(parse_parts("f(r) = part(sphere(r), \"one\")\nf(2)").size(), 1U) << "trying a function makes no part";
}

TEST(FrepText, OpensFilesOnlyWhereItMay) {
  EXPECT_EQ(refusal(parse_text, "1 + open(\"a.stl\")"), "t:1:5");
  std::vector<OpenOption> given;
  const Opener opener = [&](const std::string& path, std::span<const OpenOption> options) {
    EXPECT_EQ(path, "a.nrrd");
    given.assign(options.begin(), options.end());
    return Expression::x();
  };
  EXPECT_EQ(parse_infix("open(\"a.nrrd\", threshold = 3 * 100, denoise = \"median\")", "t", opener), Expression::x());
  ASSERT_EQ(given.size(), 2U);
  EXPECT_EQ(std::get<double>(given[0].value), 300);
  EXPECT_EQ(std::get<std::string>(given[1].value), "median");
  for (const char* text : {"open()", "open(3)", "open(\"a\", 3)", "open(\"a\", threshold = x)", "open(name = \"a\")"})
    EXPECT_THROW(parse_infix(text, "t", opener), Error) << text;
}

TEST(FrepText, IsRefusedWithLineAndColumn) {
  EXPECT_EQ(refusal(parse_text, "sphere("), "t:1:8");
  EXPECT_EQ(refusal(parse_text, "a = 1\nb = a +\n"), "t:2:8");
  EXPECT_EQ(refusal(parse_text, "spheer(1)"), "t:1:1");
  EXPECT_EQ(refusal(parse_text, "x + q"), "t:1:5");
  EXPECT_EQ(refusal(parse_text, "sphere(1, 2)"), "t:1:11");
  EXPECT_EQ(refusal(parse_text, "sphere(q = 1)"), "t:1:8");
  EXPECT_EQ(refusal(parse_text, "sphere(1, r = 1)"), "t:1:11");
  EXPECT_EQ(refusal(parse_text, "move()"), "t:1:1");
  EXPECT_EQ(refusal(parse_text, "x = 3"), "t:1:1");
  EXPECT_EQ(refusal(parse_text, "f(a) = f(a)\nf(1)"), "t:1:8");
  EXPECT_EQ(refusal(parse_text, "x y"), "t:1:3");
  EXPECT_EQ(refusal(parse_text, "1e99"), "t:1:1");
  EXPECT_EQ(refusal(parse_text, "x @ y"), "t:1:3");
  EXPECT_EQ(refusal(parse_text, ""), "t:1:1");
  try {
    parse_infix("spheer(1)");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'sphere'?"), std::string::npos);
  }
}

TEST(Models, OfKokopelliAreDeduplicatedAsInTable41) {
  std::size_t plain = 0, simplified = 0, bytes = 0;
  for (const auto& file : std::filesystem::directory_iterator(TEST_DATA "/frep/mtm_az")) {
    if (file.path().extension() != ".math") continue;
    const std::string text = read_file(file.path());
    bytes += text.size();
    const Expression part = parse_math(text);
    plain += node_count(part);
    simplified += node_count(simplify(part));
  }
  EXPECT_EQ(bytes, 7401U);
  EXPECT_EQ(plain, 2167U);
  EXPECT_LT(simplified, 2167U);
}

TEST(Depth, HasNoLimitButMemory) {
  const std::size_t deep = sample_or_all<std::size_t>(300'000, 1'000'000);
  Expression chain = x;
  for (std::size_t i = 0; i < deep; ++i) chain = Expression::make(i % 2 == 0 ? Opcode::sine : Opcode::negate, chain);
  EXPECT_EQ(node_count(chain), deep + 1);
  EXPECT_EQ(parse_math(print_math(chain)), chain);
  EXPECT_EQ(parse_vm(print_vm(chain)), chain);
  EXPECT_EQ(parse_infix(print_infix(chain)), chain);
  const FieldPtr field = make_field(chain);
  EXPECT_EQ(field->value({0.5, 0, 0}), evaluate(chain, 0.5, 0, 0));
  EXPECT_EQ(parse_infix(std::string(deep, '(') + "x" + std::string(deep, ')')), x);
  EXPECT_EQ(node_count(simplify(parse_math(std::string(deep, 'n') + "X"))), 1U);
  EXPECT_NE(refusal(parse_math, std::string(20'000'000, 'n')), "accepted");
}

TEST(Intervals, AreWhatTheyShouldBe) {
  const Interval i{-2, 3, false};
  EXPECT_EQ(apply(Opcode::square, i), (Interval{0, 9, false}));
  EXPECT_EQ(apply(Opcode::absolute, i), (Interval{0, 3, false}));
  EXPECT_TRUE(apply(Opcode::square_root, i).maybe_nan);
  EXPECT_EQ(apply(Opcode::square_root, i).upper, std::sqrt(3.0F));
  EXPECT_FALSE(apply(Opcode::divide, {1, 2, false}, i).maybe_nan);
  EXPECT_EQ(apply(Opcode::divide, {1, 2, false}, i).upper, std::numeric_limits<float>::infinity());
  EXPECT_TRUE(apply(Opcode::divide, i, i).maybe_nan);
  EXPECT_EQ(apply(Opcode::sine, {0, 2, false}).upper, 1);
  EXPECT_NEAR(apply(Opcode::power, {2, 3, false}, {2, 2, false}).upper, 9, 1e-4);
  EXPECT_EQ(apply(Opcode::compare, {1, 2, false}, {3, 4, false}), (Interval{-1, -1, false}));
}

TEST(Pruning, DropsWhatCannotMatter) {
  const Expression two = min(sqrt(square(x - 10.0) + square(y)) - 1.0, sqrt(square(x + 10.0) + square(y)) - 1.0);
  const FieldPtr whole = make_field(two);
  const FieldPtr part = whole->restricted({{8, -1, 0}, {12, 1, 0}}).field;
  EXPECT_LT(active_nodes(*part), active_nodes(*whole) / 2 + 1);
  // Alg. 3.4: if only the sign matters, an argument of known sign is removed even if its value may
  // be selected.
  const FieldPtr both = make_field(max(x, y - 5.0));
  const Box box{{-3, 4, 0}, {-1, 6, 0}};
  EXPECT_EQ(active_nodes(*both->restricted(box).field), active_nodes(*both));
  EXPECT_LT(
      active_nodes(
          *make_field(max(sin(x) - 2.0, y - 5.0))->restricted({{-3, 2, 0}, {-1, 6, 0}}, Purpose::occupancy).field),
      4U);
}

}  // namespace
}  // namespace fieldfab::frep
