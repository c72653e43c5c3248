// The .frep language for editors: tokens, parameters, mistakes, completions, meanings.
#include "fieldfab/frep/language.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fieldfab/core/error.h"

namespace fieldfab::frep {
namespace {

using Places = std::vector<std::pair<std::size_t, std::size_t>>;

/// Line and column of each mistake.
Places mistakes(std::string_view text) {
  Places places;
  for (const Diagnostic& found : diagnostics(text)) places.emplace_back(found.line, found.column);
  return places;
}

/// Completions at the position `|` of a text.
std::vector<std::string> inserts(std::string text, std::span<const Word> options = {}) {
  const std::size_t at = text.find('|');
  text.erase(at, 1);
  std::vector<std::string> all;
  for (const Completions::Entry& entry : completions(text, at, options).entries) all.push_back(entry.insert);
  return all;
}

bool has(const std::vector<std::string>& all, const std::string& name) {
  return std::ranges::find(all, name) != all.end();
}

TEST(Language, DividesATextIntoTokens) {
  const std::string text = "r = 1.5e3 # rad\n  text(\"é\\n\", h) // ½\n\"open ½ 2x.5";
  std::string kinds;
  for (const Token& token : tokens(text)) kinds += "#\"1ns?"[static_cast<int>(token.kind)];
  EXPECT_EQ(kinds, "ns1#ns\"sns#\"");
  EXPECT_EQ(tokens("2x.5 ½½@ a").size(), 6U) << "a number, a name, a number, two that are unknown, a name";
  const Token last = tokens(text).back();
  EXPECT_EQ(last.line, 3U);
  EXPECT_EQ(last.column, 1U);
  EXPECT_EQ(text.substr(last.offset, last.length), "\"open ½ 2x.5");
}

TEST(Language, FindsTheNumbersThatATextNames) {
  const std::string text =
      "size = 20  # 5 to 40, outer size\nangle = -1.5e1 // -90 to 90\nhole=3 # radius\nx = 3\na = 1; b = 2 # both\n"
      "twice = 1\ntwice = 2\nr = size\nf(h) = 3\nbox(\ndx = 3)\nneg = 1 - 2\nlate = 7 # 9 to 3\nopen = (\nlast = 4";
  const std::vector<TextParameter> found = parameters(text);
  std::string names;
  for (const TextParameter& each : found) names += each.name + " ";
  EXPECT_EQ(names, "size angle hole a b late last ");
  EXPECT_EQ(text.substr(found[1].value_offset, found[1].value_length), "-1.5e1");
  EXPECT_EQ(text.substr(found[1].name_offset, 5), "angle");
  EXPECT_EQ(found[1].value, -15);
  EXPECT_EQ(found[0].range->low, 5);
  EXPECT_EQ(found[0].range->high, 40);
  EXPECT_EQ(found[0].comment, "outer size");
  EXPECT_EQ(found[1].range->low, -90);
  EXPECT_EQ(found[1].comment, "");
  EXPECT_FALSE(found[2].range);
  EXPECT_EQ(found[2].comment, "radius");
  EXPECT_EQ(found[3].comment, "") << "the comment is of the last statement of its line";
  EXPECT_EQ(found[4].comment, "both");
  EXPECT_FALSE(found[5].range) << "low is not less than high";
  EXPECT_EQ(found[5].comment, "9 to 3");
}

TEST(Language, TellsAllMistakes) {
  EXPECT_EQ(mistakes("a = spheer(1)\nb = 1 +\nbox(q, a, b)"), (Places{{1, 5}, {2, 8}, {3, 5}}));
  EXPECT_EQ(mistakes("a = @\nb = a * sphere(a)\npeg(h) = cylinder(h, q)\npart(peg(3), \"n\", a) | b"),
            (Places{{1, 5}, {3, 22}, {4, 19}}))
      << "what is made of a wrong definition is no mistake, but for the words that part() wants";
  EXPECT_EQ(mistakes("a = box(1, 2\nb = 3\nc = spheer(b)\na | c"), (Places{{2, 1}, {3, 5}}))
      << "a parenthesis left open";
  EXPECT_EQ(mistakes("a = union(\nbox(1, q),\nsphere(3))\na | p"), (Places{{2, 8}, {4, 5}}));
  EXPECT_EQ(mistakes("sphere(1)\nsphere(2)\nsphere(q)"), (Places{{1, 1}, {2, 1}, {3, 8}})) << "values that are lost";
  EXPECT_EQ(mistakes("a = \"open\nb = 2x\nsphere(a, b, 3)"), (Places{{1, 5}, {2, 6}, {3, 11}}));
  EXPECT_EQ(mistakes("a = open(\"a.stl\")\na"), (Places{{1, 5}})) << "there is no opener";
  EXPECT_EQ(mistakes("sphere(1)"), Places());
  EXPECT_EQ(mistakes("# text"), (Places{{1, 7}}));
  const std::vector<Diagnostic> found = diagnostics("# ½\nb = spheer(3)\nbox(");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].offset, 9U);
  EXPECT_EQ(found[0].length, 6U);
  EXPECT_EQ(found[0].message, "unknown function 'spheer'; did you mean 'sphere'?");
  EXPECT_EQ(found[1].length, 0U) << "a value is missing there";
  std::string many;
  for (int i = 0; i < 300; ++i) many += "q\n";
  EXPECT_EQ(diagnostics(many).size(), 100U);
}

TEST(Language, ParametersOfFunctionsMayBePlainNumbers) {
  EXPECT_EQ(parse_infix("f(n) = array_polar(move(sphere(1), 4), n)\nf(5)"),
            parse_infix("array_polar(move(sphere(1), 4), 5)"));
  EXPECT_EQ(mistakes("f(n) = array_polar(move(sphere(1), 4), n)\na = f(x)\nf(y)"), (Places{{1, 8}})) << "told once";
}

TEST(Language, OffersWhatFits) {
  EXPECT_EQ(inserts("roundness = 2\nROU|"),
            (std::vector<std::string>{"rounded_box()", "rounded_rectangle()", "roundness"}));
  EXPECT_EQ(inserts("rounded_b|(3)"), (std::vector<std::string>{"rounded_box"})) << "it has its parentheses";
  const auto arguments = inserts("box(1, |)");
  EXPECT_EQ(std::vector(arguments.begin(), arguments.begin() + 2), (std::vector<std::string>{"dy = ", "dz = "}));
  EXPECT_FALSE(has(arguments, "dx = "));
  EXPECT_TRUE(has(arguments, "sphere()"));
  EXPECT_EQ(inserts("rounded_box(dz = 3, d|)").front(), "dx = ");
  EXPECT_FALSE(has(inserts("rounded_box(dz = 3, d|)"), "dz = "));
  EXPECT_FALSE(has(inserts("box(dx = d|)"), "dx = "));
  EXPECT_EQ(inserts("peg(height) = cylinder(3, hei|)"), (std::vector<std::string>{"height"}));
  EXPECT_EQ(inserts("peg(height) = cylinder(3, height)\npeg(hei|"), (std::vector<std::string>{"height = "}));
  EXPECT_FALSE(has(inserts("|\nlater = 3"), "later")) << "it is defined below";
  EXPECT_EQ(inserts("part(sphere(3), \"n\", \"tom|"), (std::vector<std::string>{"tomato"}));
  EXPECT_EQ(inserts("part(sphere(3), colour = \"Tom|\", name = \"a\")"), (std::vector<std::string>{"tomato"}));
  EXPECT_TRUE(inserts("part(sphere(3), \"tom|").empty());
  const std::vector<Word> options{{"threshold", WordKind::option, "threshold", "the density", ""}};
  EXPECT_EQ(inserts("open(\"scan.nrrd\", |", options), (std::vector<std::string>{"threshold = "}));
  EXPECT_TRUE(inserts("open(|", options).empty());
  for (const char* const nothing : {"# sph|", "1.5e|", "1.5|", "sphere(3) sph|", "text(\"sph|", "sphere(3)|"})
    EXPECT_TRUE(inserts(nothing).empty()) << nothing;
  EXPECT_TRUE(has(inserts("sphere(3)\n|"), "box()")) << "a new statement";
}

TEST(Language, TellsWhatWordsMean) {
  const std::string text = "r = 2 # radius\npeg(h) = cylinder(r, h)\nmove(peg(3), dx = pi)";
  const auto at = [&](std::string_view word) { return word_at(text, text.rfind(word)); };
  EXPECT_EQ(at("cylinder")->signature, "cylinder(r = 1, h = 1)");
  EXPECT_EQ(at("peg")->signature, "peg(h)");
  EXPECT_EQ(at("peg")->meaning, "peg(h) = cylinder(r, h)");
  EXPECT_EQ(at("h)")->meaning, "peg(h) = cylinder(r, h)");
  EXPECT_EQ(word_at(text, 0)->meaning, "r = 2 # radius");
  EXPECT_EQ(at("dx")->kind, WordKind::parameter);
  EXPECT_EQ(at("dx")->signature, "dx = 0");
  EXPECT_EQ(at("pi")->kind, WordKind::constant);
  EXPECT_FALSE(word_at(text, 2)) << "a sign";
  EXPECT_FALSE(word_at(text, 8)) << "a comment";
  EXPECT_FALSE(word_at(text, 1000));
  EXPECT_EQ(word_at("rotate_x(sphere(3), 4)", 0)->signature, "rotate_x(shape, angle°)");
  EXPECT_EQ(word_at("a = 1\nb = a\na = 2\na", 10)->meaning, "a = 1");
}

}  // namespace
}  // namespace fieldfab::frep
