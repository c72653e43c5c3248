// OpenSCAD's .csg files: valid and invalid files, places of errors, and the resulting solids.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "fieldfab/contour/contour.h"
#include "fieldfab/core/error.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/openscad/design.h"

namespace fieldfab::openscad {
namespace {

OpenedSolid design(std::string_view text, const DesignOptions& options = {}) {
  return *make_design(parse_csg(text, "t"), "/nowhere", options);
}
FieldPtr solid(std::string_view text, const DesignOptions& options = {}) { return design(text, options).field; }

std::string refusal(const std::string& text) {
  try {
    design(text);
  } catch (const Error& error) {
    EXPECT_NE(error.kind(), ErrorKind::internal);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "accepted";
}

double volume(std::string_view text, double voxel, const DesignOptions& options = {}) {
  const OpenedSolid made = design(text, options);
  return contour(*made.field, made.field->known_bounds().grown(voxel), {voxel, -1, true}).volume();
}

TEST(CsgText, IsReadWithModifiersAndValues) {
  const Tree tree = parse_csg(
      "%group(){#cube(size=[1,2.5,-3e-2],center=true);*sphere(r=inf);}!text(text=\"a\"b\", t = undef);// end", "t");
  ASSERT_EQ(tree.nodes.size(), 5U);
  EXPECT_TRUE(tree.nodes[1].background);
  EXPECT_TRUE(tree.nodes[2].highlight && !tree.nodes[1].highlight);
  EXPECT_EQ(tree.nodes[2].arguments[0].value.list()->at(2).number()[0], -0.03);
  EXPECT_TRUE(*tree.nodes[2].arguments[1].value.truth());
  EXPECT_TRUE(tree.nodes[3].disabled);
  EXPECT_TRUE(tree.nodes[4].root);
  EXPECT_EQ(*tree.nodes[4].arguments[0].value.text(), "a\"b");
  EXPECT_TRUE(tree.nodes[4].arguments[1].value.is_undef());
}

TEST(CsgText, IsPrintedWithItsModifiersOnRequest) {
  const Tree tree = parse_csg("%group() { #cube(size = [1, 2, 3]); *!sphere(r = 2); }", "t");
  EXPECT_EQ(print_csg(tree, 1), "group() {\ncube(size = [1, 2, 3]);\nsphere(r = 2);\n}\n");
  EXPECT_EQ(print_csg(tree, 1, Modifiers::kept), "%group() {\n#cube(size = [1, 2, 3]);\n*!sphere(r = 2);\n}\n");
  EXPECT_EQ(dimensions_of(parse_csg("group(); group() { square(); } union() { *square(); cube(); }", "t")),
            (std::vector<int>{2, 0, 2, 2, 3, 2, 3}));
}

TEST(CsgText, IsRefusedWithItsPlace) {
  EXPECT_EQ(refusal("cube(\n size = [1, 2 3]);"), "t:2:15: expected ',' or ']' in a list, found '3'");
  EXPECT_EQ(refusal("cube()"), "t:1:7: expected ';', found the end of the text");
  EXPECT_EQ(refusal("group() {\n cube(); "), "t:1: the text ends before the '}' of this group");
  EXPECT_EQ(refusal("cube(); }"), "t:1:9: there is a '}' without its '{'");
  EXPECT_EQ(refusal("cube(size = oops);"), "t:1:13: expected a value, found 'oops'");
  EXPECT_EQ(refusal("cube();\nteapot();"), "t:2: 'teapot' is not known");
  EXPECT_NE(refusal("import(file = \"gone.stl\");").find("there is no such file"), std::string::npos);
  EXPECT_NE(refusal("polygon(points = [[0,0],[1,0],[1,1]], paths = [[0,1,7]]);").find("names point 7, and there are 3"),
            std::string::npos);
  EXPECT_NE(refusal("sphere(r = \"big\");").find("t:1: sphere: r must be a number"), std::string::npos);
}

TEST(CsgText, OfAnyDepthIsReadOrRefusedInOneLine) {
  std::string chain, bush, lists(100'000, '[');
  for (int i = 0; i < 100'000; ++i) chain += "group() {", bush += "union() { cube(); ";
  EXPECT_NEAR(solid(chain + "sphere(r = 2, $fn = 8);" + std::string(100'000, '}'))->value({0, 0, 0}), -1.8, 0.1);
  EXPECT_NE(refusal(bush + "cube();" + std::string(100'000, '}')).find("nodes deep within others"), std::string::npos);
  EXPECT_NE(refusal("cube(size = " + lists).find("lists are not read"), std::string::npos);
}

TEST(CsgText, PrintsAndReadsBack) {
  const Tree tree =
      parse_csg("group() { cube(size = [1, 2, 3], center = false); text(text = \"q\\\"\", size = 0.1); }", "t");
  const std::string text = print_csg(tree, 0);
  const Tree again = parse_csg(text, "t");
  EXPECT_EQ(print_csg(again, again.top().children[0]), text);
}

TEST(CsgSolids, HaveTheirDistances) {
  const FieldPtr cube = solid("cube(size = [2, 4, 6], center = true);");
  EXPECT_NEAR(cube->value({0, 0, 0}), -1, 1e-4);
  EXPECT_NEAR(cube->value({3, 0, 0}), 2, 1e-4);
  const FieldPtr plate = solid("linear_extrude(height = 2) { square(size = [4, 4], center = true); }");
  EXPECT_NEAR(plate->value({5, 0, 6}), 5, 1e-4);  // 3 out, 4 up: exact
  EXPECT_NEAR(plate->value({0, 0, 1.5}), -0.5, 1e-4);
  const FieldPtr ring =
      solid("linear_extrude(height = 2) { difference() { circle(r = 4, $fn = 4); circle(r = 2, $fn = 4); } }");
  EXPECT_GT(ring->value({0, 0, 1}), 1.4);
  EXPECT_LT(ring->value({3, 0, 1}), 0);
  const FieldPtr ball = solid("sphere(r = 3);", {true, false});
  EXPECT_NEAR(ball->value({0, 3, 4}), 2, 1e-4);
}

TEST(CsgSolids, KeepWhatModifiersSay) {
  EXPECT_GT(solid("%cube(size = 9); sphere(r = 1);")->value({5, 5, 5}), 0);
  EXPECT_GT(solid("*cube(size = 9); sphere(r = 1);")->value({5, 5, 5}), 0);
  EXPECT_LT(solid("#cube(size = 9); sphere(r = 1);")->value({5, 5, 5}), 0);
  EXPECT_GT(solid("cube(size = 9); group() { !sphere(r = 1); }")->value({5, 5, 5}), 0);
  EXPECT_EQ(solid("difference() { group(); cube(size = 9); }"), nullptr);
  for (const char* empty :
       {"group();", "union();", "hull();", "linear_extrude(height = 2);", "projection();", "square(size = 1);"})
    for (const char* text : {"intersection() { cube(size = 1); ", "intersection() { "})
      EXPECT_EQ(solid(text + std::string(empty) + " cube(size = 1); }"), nullptr) << text << empty;
  // an empty shape is neither flat nor solid
  EXPECT_NE(solid("projection(); cube(size = 1);"), nullptr);
  EXPECT_NE(solid("minkowski() { sphere(r = 0); cube(size = 1); }"), nullptr);
  EXPECT_NE(solid("linear_extrude(height = 1) { offset(r = -9) { square(size = 2); } } cube(size = 1);"), nullptr);
}

TEST(CsgSolids, TouchWithoutSkinsBetweenThem) {
  // Common faces coincide with lattice planes here.
  const OpenedSolid two = design(
      "cube(size = [4, 4, 4]); multmatrix([[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { cube(size = [4, 4, 4]); }");
  const TriangleMesh joined = contour(*two.field, {{-1, -1, -1}, {9, 5, 5}}, {0.5, -1, true});
  EXPECT_NEAR(joined.volume(), 128, 0.05);
  EXPECT_NEAR(joined.area(), 2 * (16 + 32 + 32), 0.05);
  const OpenedSolid open = design(
      "difference() { cube(size = [4, 4, 4]); multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,0],[0,0,0,1]]) { cube(size = [2, "
      "2, 4]); } "
      "}");
  const TriangleMesh tube = contour(*open.field, {{-1, -1, -1}, {5, 5, 5}}, {0.5, -1, true});
  EXPECT_NEAR(tube.volume(), 48, 0.05);
  EXPECT_NEAR(tube.area(), 4 * 16 + 4 * 8 + 2 * 12, 0.1);
}

TEST(CsgSolids, HaveTheVolumesOfTheirFacets) {
  const double six = 6 * std::sin(std::numbers::pi / 3) / 2;  // area of a hexagon of radius 1
  EXPECT_NEAR(volume("cylinder($fn = 6, h = 2, r1 = 5, r2 = 5);", 0.3), 50 * six, 0.3);
  EXPECT_NEAR(volume("cylinder($fn = 60, h = 2, r1 = 5, r2 = 5);", 0.3), 50 * 30 * std::sin(std::numbers::pi / 30),
              0.3);
  EXPECT_NEAR(volume("cylinder(h = 2, r1 = 5, r2 = 5);", 0.3, {true, false}), 50 * std::numbers::pi, 0.3);
  EXPECT_NEAR(
      volume("hull() { cube(size = 1); multmatrix([[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { cube(size = 1); } }",
             0.1),
      5, 0.02);
  EXPECT_NEAR(volume("minkowski() { cube(size = 2); cube(size = [1, 2, 3]); }", 0.2), 60, 0.1);
  EXPECT_NEAR(volume("resize(newsize = [8, 0, 0], auto = [0, 1, 0]) { cube(size = [2, 1, 1]); }", 0.2), 32, 0.1);
  // Half a ring of square section: Pappus's theorem with the factor of hexagonal sides.
  EXPECT_NEAR(volume("rotate_extrude(angle = 180, $fn = 12) { polygon(points = [[2,0],[4,0],[4,2],[2,2]]); }", 0.1),
              6 * 0.5 * std::sin(std::numbers::pi / 6) * 12 * 2, 0.1);
  const double rounded = 8 + 6 * 4 * 1 + 12 * 2 * std::numbers::pi / 4 + 4 * std::numbers::pi / 3;
  EXPECT_NEAR(volume("minkowski() { cube(size = 2); sphere(r = 1); }", 0.1, {true, false}), rounded, 0.2);
  // A hollow block plus a cube.
  EXPECT_NEAR(
      volume(
          "minkowski() { difference() { cube(size = [6,6,2]); multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,-1],[0,0,0,1]]) { "
          "cube(size = [4,4,4]); } } cube(size = 1); }",
          0.2),
      (49 - 9) * 3, 0.3);
}

/// All nodes with a Field of their own.
constexpr const char* zoo = R"(
multmatrix([[0.8,-0.6,0,1],[0.6,0.8,0,2],[0,0,1,3],[0,0,0,1]]) { sphere($fn = 40, r = 5); }
linear_extrude(height = 9) { difference() { circle($fn = 9, r = 8); circle($fn = 30, r = 3); } }
multmatrix([[1,0,0,15],[0,2,0,0],[0,0,0.5,0],[0,0,0,1]]) {
  rotate_extrude(angle = 250, $fn = 30) { polygon(points = [[2,0],[5,1],[3,4]]); }
}
multmatrix([[1,0,0,0],[0,1,0,18],[0,0,1,0],[0,0,0,1]]) {
  linear_extrude(height = 9, twist = 70) { square(size = [6, 3], center = true); }
}
difference() { cube(size = [3, 30, 3]); cylinder($fn = 5, h = 9, r1 = 2, r2 = 1); }
)";

TEST(CsgFields, AgreeWithTheirIntervalsAndRestrictions) {
  for (const bool smooth : {false, true}) {
    const FieldPtr field = solid(zoo, {smooth, false});
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-12, 24), share(0, 1);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 corner(place(random), place(random), place(random));
      const float size = std::pow(2.0F, -8 * share(random)) * 20;
      const Box box{corner, corner + Vec3(size, size * share(random), size * share(random))};
      const Restriction inside = field->restricted(box), sign = field->restricted(box, Purpose::occupancy);
      for (int k = 0; k < 4; ++k) {
        const Vec3 p = (box.lower + Vec3(share(random), share(random), share(random)).cwiseProduct(box.size()))
                           .cast<float>()
                           .cast<double>();
        if (!box.contains(p)) continue;
        const float value = field->value(p);
        EXPECT_TRUE(inside.range.contains(value)) << p.transpose() << " " << value;
        EXPECT_EQ(inside.field->value(p), value) << p.transpose();
        EXPECT_EQ(sign.field->value(p) < 0, value < 0) << p.transpose();
      }
    }
  }
}

TEST(CsgFields, NeverExceedTheDistance) {
  const FieldPtr field = solid(zoo);
  std::mt19937 random(9);
  std::uniform_real_distribution<float> place(-12, 24), step(-1, 1);
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p(place(random), place(random), place(random)), q = p + Vec3(step(random), step(random), step(random));
    const double apart = (p.cast<float>() - q.cast<float>()).norm();
    EXPECT_LE(std::abs(field->value(p) - field->value(q)), apart * 1.0001 + 1e-5);
  }
}

TEST(CsgFormulas, AreTheSameSolids) {
  const char* const text =
      "difference() { cylinder($fn = 50, h = 9, r1 = 6, r2 = 5); linear_extrude(height = 20, center = true) { "
      "difference() { "
      "circle(r = "
      "4, $fn = 8); circle(r = 2, $fn = 5); } } }";
  const FieldPtr field = solid(text), formula = solid(text, {false, true});
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-8, 12);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p(place(random), place(random), place(random));
    if (std::abs(field->value(p)) < 1e-3) continue;
    EXPECT_EQ(field->value(p) < 0, formula->value(p) < 0) << p.transpose();
  }
  EXPECT_TRUE(design(text, {false, true}).formula.has_value());
  EXPECT_THROW(solid("rotate_extrude() { polygon(points = [[2,0],[4,0],[4,2]]); }", {false, true}), Error);
}

}  // namespace
}  // namespace fieldfab::openscad
