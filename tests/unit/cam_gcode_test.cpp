// Readings of G-code, feature by feature, against closed forms. tests/hosts/gcode_test.py compares
// with LinuxCNC's interpreter.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>

#include "cam_readings.h"
#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

TEST(gcode, words_are_read_in_any_order_and_spacing) {
  const Reading r =
      gcode("%\nN10 g 21 (set) g90 ; rest (\nX 1 2 . 5 y   7.417Z-.5 g0\n/ g0 x99\nn20.1 G01 F1 0 0 X+3\n%\nG0 X5\n");
  ASSERT_EQ(r.motions.size(), 3U);
  near(r.at(0), {12.5, 7.417, -0.5});
  near(r.at(1), {3, 7.417, -0.5});
  EXPECT_EQ(r.motions[1].line, 5);
  EXPECT_DOUBLE_EQ(r.motions[1].feed, 100);
  EXPECT_EQ(r.motions[2].kind, Kind::end);
  EXPECT_TRUE(r.notes.empty());
}

TEST(gcode, block_delete_and_a_missing_end) {
  ReadingOptions options;
  options.block_delete = false;
  const Reading r = gcode("/G0 X1\n", options);
  EXPECT_EQ(r.motions.size(), 1U);
  EXPECT_TRUE(r.noted("without M2"));
  EXPECT_TRUE(gcode("/G0 X1\n").motions.empty());
  EXPECT_TRUE(gcode("").noted("without M2"));
}

double value_of(const std::string& expression) {
  return gcode("#1=3 #2=-1.5\n#<a>=2 #<_up>=7\nG0 X" + expression + "\nM2\n").at(0).x();
}

TEST(gcode, expressions) {
  const std::vector<std::pair<std::string, double>> cases{{"[2+3*4-1]", 13},
                                                          {"[2**3**2]", 64},
                                                          {"[-2**2]", 4},
                                                          {"[10-2-3]", 5},
                                                          {"[7 MOD -3]", 1},
                                                          {"[-7 MOD 3]", 2},
                                                          {"[2*3 EQ 6 AND 1]", 1},
                                                          {"[1 LT 2]", 1},
                                                          {"[1.00001 EQ 1]", 1},
                                                          {"[1 NE 2]", 1},
                                                          {"[2 GE 2]", 1},
                                                          {"[2 GT 2]", 0},
                                                          {"[1 LE 0]", 0},
                                                          {"[2 XOR 1]", 0},
                                                          {"[0 OR 2]", 1},
                                                          {"ATAN[1]/[-1]", 135},
                                                          {"SIN[30]", 0.5},
                                                          {"COS[60]", 0.5},
                                                          {"TAN[45]", 1},
                                                          {"ASIN[1]", 90},
                                                          {"ACOS[0]", 90},
                                                          {"ABS[-3]", 3},
                                                          {"FIX[-2.5]", -3},
                                                          {"FUP[-2.5]", -2},
                                                          {"ROUND[-2.5]", -3},
                                                          {"EXP[0]", 1},
                                                          {"LN[EXP[2]]", 2},
                                                          {"SQRT[9]", 3},
                                                          {"#1", 3},
                                                          {"-#2", 1.5},
                                                          {"--1", 1},
                                                          {"#[1+1]", -1.5},
                                                          {"##1", 0},
                                                          {"#<A>", 2},
                                                          {"#<_ U P>", 7},
                                                          {"[EXISTS[#<a>]+EXISTS[#<b>]]", 1},
                                                          {"[EXISTS[#5]]", 1},
                                                          {"[#<_metric>]", 1},
                                                          {"[#<_line>]", 3},
                                                          {"[#<_coord_system>]", 540},
                                                          {"[#<_plane>]", 170}};
  for (const auto& [text, expected] : cases) EXPECT_NEAR(value_of(text), expected, 1e-12) << text;
}

TEST(gcode, bad_expressions_name_their_line) {
  refused("\nG0 X[1/0]", 2, "division by zero");
  refused("G0 X[5 MOD 0]", 1, "zero");
  refused("G0 XSQRT[-1]", 1, "SQRT");
  refused("G0 XLN[0]", 1, "LN");
  refused("G0 XACOS[2]", 1, "ACOS");
  refused("G0 XASIN[2]", 1, "ASIN");
  refused("G0 X[[-8]**.5]", 1, "negative");
  refused("G0 X[10**400]", 1, "finite");
  refused("G0 XEXP[1000]", 1, "finite");
  refused("G0 X[1", 1, "]");
  refused("G0 X[1+", 1, "value");
  refused("G0 X[1 FOO 2]", 1, "operator");
  refused("G0 XFOO[1]", 1, "value");
  refused("G0 X", 1, "value");
  refused("G0 X.", 1, "number");
  refused("G0 X#<b>", 1, "no value");
  refused("#0=1", 1, "#0");
  refused("#5603=1", 1, "#5603");
  refused("G0 X#1.5", 1, "whole");
  refused("#5420=1", 1, "cannot be set");
  refused("#<_x>=1", 1, "cannot be set");
  refused("#1 2", 1, "=");
  refused("G0 X1E5", 1, "E word");
  refused("G0 X" + std::string(5000, '[') + "1" + std::string(5000, ']'), 1, "brackets");
  refused("G0 X" + std::string(5000, '-') + "1", 1, "brackets");
}

TEST(gcode, settings_take_effect_behind_their_block) {
  near(moves("#1=5\n#1=7 G0 X#1 (5)\nG0 Y#1\n").at(1), {5, 7, 0});
  near(moves("#1=1 #1=2\nG0 X#1\n").at(0), {2, 0, 0});
}

TEST(gcode, blocks_that_contradict_themselves) {
  refused("G0 G1 X1", 1, "exclude");
  refused("G17 G18", 1, "exclude");
  refused("M3 M4", 1, "exclude");
  refused("M0 M2", 1, "exclude");
  refused("G0 X1 X2", 1, "two X");
  refused("X1", 1, "no G code in force");
  refused("G80 X1", 1, "G80");
  refused("G28 G1 X1", 1, "both want");
  refused("G1 X1", 1, "feed rate");
  refused("F0\nG1 X1", 2, "feed rate");
  refused("F-1", 1, "below 0");
  refused("S-1", 1, "below 0");
  refused("G93 G1 X1", 1, "G93");
  refused("G93 G1 X1 F2\nX2", 2, "G93");
  refused("G95 F.1\nG1 X1", 2, "spindle");
  refused("G0 X1 (foo", 1, "')'");
  refused("G0 X1 )", 1, "cannot begin a word");
  refused("G1.05 X1", 1, "G1.05");
  refused("G12 X1", 1, "G12");
  refused("G50", 1, "G50");
  refused("G51 X1", 1, "G51");
  refused("M10", 1, "M10");
  refused("M3.5", 1, "whole");
  refused("G0 P1", 1, "P word");
  refused("G0 X1 L2", 1, "L word");
  refused("G0 X1 H1", 1, "H word");
  refused("G4", 1, "P");
  refused("G4 P-1", 1, "dwell");
  refused("G43 H9", 1, "tool 9");
  refused("G53 G2 X1 I.5", 1, "G53");
  refused("G0 X1e", 1, "");
  refused("G0 X99999999999999999", 1, "reach");
  refused("; py\n;py,print()", 2, "Python");
}

TEST(gcode, straight_moves_units_and_distance) {
  const Reading r =
      moves("G0 X1 Y2 Z3 A90 B-45 C720 U1 V2 W3\nG91 G1 X1 A90\nG20 X1 F10\nG21 G90 X0 A0 F100\nG1 A90\n");
  near(r.at(0), {1, 2, 3});
  EXPECT_NEAR(r.motions[0].end[Axis::a], pi / 2, 1e-12);
  EXPECT_NEAR(r.motions[0].end[Axis::c], 4 * pi, 1e-12);
  EXPECT_EQ(r.motions[0].end[Axis::w], 3);
  near(r.at(1), {2, 2, 3});
  EXPECT_NEAR(r.motions[1].end[Axis::a], pi, 1e-12);
  near(r.at(2), {27.4, 2, 3});
  EXPECT_DOUBLE_EQ(r.motions[2].feed, 10);  // F has the unit from before G20
  EXPECT_TRUE(r.noted("units before"));
  near(r.at(3), {0, 2, 3});
  // degrees per minute if only a rotary axis moves
  EXPECT_NEAR(r.motions[4].feed, 100 * pi / 180, 1e-12);
  EXPECT_DOUBLE_EQ(gcode("G20\nF10 G1 X1\nM2").motions[0].feed, 254);
}

TEST(gcode, inverse_time_and_feed_per_revolution) {
  const Reading r =
      moves("G93 G1 X10 F2\nX10 Y5 A90 F.5\nA180 F1\nG2 X10 Y15 J5 F1\nG94 F60 G1 X0\nG95 F.2 S100 M3\nX5\n");
  EXPECT_DOUBLE_EQ(r.motions[0].feed, 20);
  EXPECT_DOUBLE_EQ(r.motions[0].seconds, 30);
  EXPECT_DOUBLE_EQ(r.motions[1].feed, 2.5);
  EXPECT_DOUBLE_EQ(r.motions[1].seconds, 120);
  EXPECT_NEAR(r.motions[2].feed, pi / 2, 1e-12);
  EXPECT_DOUBLE_EQ(r.motions[2].seconds, 60);
  EXPECT_NEAR(r.motions[3].feed, 5 * pi, 1e-9);
  EXPECT_NEAR(r.motions[3].seconds, 60, 1e-9);
  EXPECT_EQ(r.motions[4].seconds, 0);
  EXPECT_DOUBLE_EQ(r.motions[5].feed, 20);
  EXPECT_EQ(r.motions[5].spindle, 100);
}

TEST(gcode, arcs_by_centre_and_radius_in_all_planes) {
  Reading r = moves("G2 X2 I1\nG3 X0 I-1 P2 Z4\nG2 X2 R2\nG2 X0 R-2\nG2 I1\nG90.1 G3 X2 Y0 I1 J0\n");
  EXPECT_EQ(r.motions[0].kind, Kind::arc);
  EXPECT_EQ(r.motions[0].turns, -1);
  EXPECT_EQ(r.motions[0].centre, Vec2(1, 0));
  EXPECT_EQ(r.motions[1].turns, 2);
  near(r.at(1), {0, 0, 4});
  EXPECT_NEAR((r.motions[2].centre - Vec2(1, -std::sqrt(3))).norm(), 0, 1e-12);
  EXPECT_NEAR((r.motions[3].centre - Vec2(1, -std::sqrt(3))).norm(), 0, 1e-12);
  near(r.at(4), {0, 0, 4});  // full circle
  EXPECT_EQ(r.motions[5].centre, Vec2(1, 0));
  r = moves("G18 G2 X2 I1 Y3\nG19 G3 Y5 Z2 J1 K1\n");
  EXPECT_EQ(r.motions[0].plane, ArcPlane::zx);
  EXPECT_EQ(r.motions[0].centre, Vec2(0, 1));  // z, x
  EXPECT_EQ(r.motions[1].plane, ArcPlane::yz);
  EXPECT_EQ(r.motions[1].centre, Vec2(4, 1));  // y, z
  near(r.at(1), {2, 5, 2});
  r = moves("G91 G2 X2 I1 A5 B7 Z3\nG7 G90 G1 X10\nG8 X10\n");
  EXPECT_NEAR(r.motions[0].end[Axis::b], 7 * pi / 180, 1e-12);
  EXPECT_EQ(r.at(1).x(), 5);
  EXPECT_EQ(r.at(2).x(), 10);
}

TEST(gcode, arcs_that_do_not_fit) {
  const std::string start = "G21 F100\n";
  refused(start + "G2 X2", 2, "without R");
  refused(start + "G2 X20 I10.05", 2, "begins");
  refused(start + "G2 X2 R.9", 2, "too small");
  refused(start + "G2 X2 R1 I1", 2, "R and a centre");
  refused(start + "G2 X0 R1", 2, "ends where it begins");
  refused(start + "G2 R1", 2, "no place to end");
  refused(start + "G2 X2 I1 K1", 2, "another plane");
  refused(start + "G2 X2 J0", 2, "radius of 0");
  refused(start + "G90.1 G2 X2 I1", 2, "needs I and J");
  refused(start + "G2 X2 I1 P0", 2, "turns");
  refused(start + "G2 X2 I1 P1.5", 2, "whole");
}

TEST(gcode, work_offsets_and_their_rotation) {
  ReadingOptions options = with_tools();
  options.work_offsets[0].at = {1, 2, 3, pi / 2};
  options.work_offsets[1].at = {100};
  Reading r = moves("G0 X1 Y1 Z1 A0\nG55 X1\nG59.3 X7\n", options);
  near(r.at(0), {2, 3, 4});
  EXPECT_NEAR(r.motions[0].end[Axis::a], pi / 2, 1e-12);
  near(r.at(1), {101, 3, 4});
  near(r.at(2), {7, 3, 4});
  r = moves("G10 L2 P1 X10 Y20 R30\nG0 X2 Y0\nG1 X2 Y2\nG2 X4 Y2 I1\n");
  const double c = std::cos(pi / 6), s = std::sin(pi / 6);
  near(r.at(0), {10 + 2 * c, 20 + 2 * s, 0});
  near(r.at(1), {10 + 2 * c - 2 * s, 20 + 2 * s + 2 * c, 0});
  EXPECT_NEAR((r.motions[2].centre - Vec2(10 + 3 * c - 2 * s, 20 + 3 * s + 2 * c)).norm(), 0, 1e-12);
  r = moves("G0 X5 Y6\nG10 L20 P1 X1 Y1\nG0 X0 Y0\nG10 L20 P2 X0\nG55 X3\n");
  near(r.at(1), {4, 5, 0});
  near(r.at(2), {7, 5, 0});
  refused("G10 L2 P10 X1", 1, "P10");
  refused("G10 L5 P1 X1", 1, "L5");
  refused("G10 P1", 1, "L");
  refused("G10 L2 X1", 1, "P");
}

TEST(gcode, axis_offsets_and_machine_coordinates) {
  Reading r =
      moves("G0 X5 Y5\nG92 X1 Y0\nG0 X0 Y0\nG92.2\nG0 X0\nG92.3\nG0 X0\nG92.1\nG0 X0\nG52 X3\nG0 X0\nG53 G0 X1\n");
  near(r.at(1), {4, 5, 0});
  near(r.at(2), {0, 5, 0});
  near(r.at(3), {4, 5, 0});
  near(r.at(4), {0, 5, 0});
  near(r.at(5), {3, 5, 0});
  near(r.at(6), {1, 5, 0});
  refused("G92", 1, "axis words");
  refused("G91 G53 G0 X1", 1, "G90");
}

TEST(gcode, tool_lengths) {
  Reading r = gcode(
      "T1 M6\nG43\nG0 Z0\nG43.2 H2\nG0 Z0\nG49 G0 Z0\nG43.1 X1 Z2\nG53 G0 Z5\nM61 Q2\nG43 H0 G0 Z1\nG10 L1 P3 Z7 "
      "R2\nG43 H3 G0 "
      "Z1\nM2");
  EXPECT_EQ(r.motions[0].kind, Kind::tool_change);
  EXPECT_EQ(r.motions[0].tool, 1);
  near(r.at(1), {0, 0, 0});  // the tip; the axes are 10 higher
  near(r.motions[1].tool_offset, {0, 0, 10});
  near(r.motions[2].tool_offset, {0, 0, 35});
  near(r.motions[3].tool_offset, {0, 0, 0});
  near(r.motions[4].tool_offset, {1, 0, 2});
  near(r.at(4), {-1, 0, 3});  // G53 gives axis positions
  EXPECT_EQ(r.motions[5].tool, 2);
  near(r.motions[6].tool_offset, {0, 0, 25});
  near(r.motions[7].tool_offset, {0, 0, 7});
  r = moves("G0 Z9\nG10 L10 P1 Z2\nG43 H1\nG0 Z2\n");
  near(r.motions[1].tool_offset, {0, 0, 7});
  near(r.at(1), {0, 0, 2});
}

TEST(gcode, homes) {
  ReadingOptions options;
  options.home[0].at = {1, 2, 3};
  options.home[1].at = {4, 5, 6};
  const Reading r = moves("G28 Z50\nG30\nG53 G0 X7\nG28.1\nG0 X0 Y0 Z0\nG28\n", options);
  near(r.at(0), {0, 0, 50});
  near(r.at(1), {0, 0, 3});
  near(r.at(2), {4, 5, 6});
  near(r.at(5), {7, 5, 6});
}

TEST(gcode, rotation_g68) {
  // Anticlockwise about (10, 0) by 90 degrees.
  Reading r = moves("G0 X10 Y0\nG68 X10 Y0 R90\nG1 X20 Y0\nG3 X10 Y10 I-10\nG69\nG1 X1 Y1\n");
  near(r.at(1), {10, 10, 0});
  near(r.at(2), {0, 0, 0});
  EXPECT_NEAR((r.motions[2].centre - Vec2(10, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(r.motions[2].turns, 1);
  near(r.at(3), {1, 1, 0});
  r = moves("G0 X3 Y4\nG68 X0 Y0 R30\nG91 G1 X1\n");  // increments are rotated, too
  near(r.at(1), {3 + std::cos(pi / 6), 4 + std::sin(pi / 6), 0}, 1e-12);
  r = moves("G18 G68 Z0 X0 R90\nG1 Z2 X1\n");  // z, x: z is mapped to x
  near(r.at(0), {2, 0, -1}, 1e-12);
  r = moves("G10 L2 P1 X5\nG0 X0\nG68 X1 Y0 R180\nG0 X3\n");
  near(r.at(1), {5 - 1, 0, 0}, 1e-12);
  refused("G68 X1", 1, "R");
  refused("G68 Z1 R5", 1, "plane");
  refused("G68 X0 Y0 R5\nG28", 2, "G68");
  refused("G68 X0 Y0 R5\nG53 G0 X1", 2, "G68");
  refused("G68 X0 Y0 R5\nG92 X1", 2, "G68");
  refused("G68 X0 Y0 R5\nG55", 2, "G68");
}

TEST(gcode, arcs_that_a_rotation_takes_out_of_their_plane_become_chords) {
  const Reading r = moves("G10 L2 P1 R90\nG18 G3 X0 Z20 K10\n");
  EXPECT_TRUE(r.noted("short straight feeds"));
  ASSERT_GT(r.motions.size(), 100U);
  for (const Motion& m : r.motions) {  // the arc is now in the y-z plane
    EXPECT_EQ(m.kind, Kind::feed);
    EXPECT_NEAR(std::hypot(m.end[Axis::y], m.end[Axis::z] - 10), 10, 1e-9);
    EXPECT_NEAR(m.end[Axis::x], 0, 1e-9);
    EXPECT_LE(m.end[Axis::y], 1e-9);
  }
  near(r.at(r.motions.size() - 1), {0, 0, 20});
}

TEST(gcode, kinematics_of_the_control) {
  const Reading r = gcode("G0 X1\nM428\nX2\nM429\nX3\nM430\nX4\nG43.4 H1\nX5\nG49\nX6\nM2");
  const std::vector<ControlMode> expected{ControlMode::machine, ControlMode::tip, ControlMode::axes,
                                          ControlMode::user,    ControlMode::tip, ControlMode::axes};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(r.motions[i].mode, expected[i]) << i;
  near(r.motions[4].tool_offset, {0, 0, 10});
}

TEST(gcode, drilling_cycles) {
  Reading r = moves("G0 Z20\nG98 G81 X1 Y2 Z-1 R5\nX3\nG99 X4\nX5 L2\n");
  const std::vector<Vec3> expected{{0, 0, 20}, {1, 2, 20}, {1, 2, 5},  {1, 2, -1}, {1, 2, 20}, {3, 2, 20}, {3, 2, 5},
                                   {3, 2, -1}, {3, 2, 20}, {4, 2, 20}, {4, 2, 5},  {4, 2, -1}, {4, 2, 5},  {5, 2, 5},
                                   {5, 2, -1}, {5, 2, 5},  {5, 2, 5},  {5, 2, -1}, {5, 2, 5}};
  ASSERT_EQ(r.motions.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) near(r.at(i), expected[i]);
  r = moves("G0 Z20\nG83 X1 Z-1 R5 Q2.5\n");
  const std::vector<double> pecks{20, 20, 5, 2.5, 5, 2.754, 0, 5, 0.254, -1, 5};
  ASSERT_EQ(r.motions.size(), pecks.size());
  for (std::size_t i = 0; i < pecks.size(); ++i) EXPECT_NEAR(r.at(i).z(), pecks[i], 1e-12) << i;
  r = moves("G0 Z20\nG73 X1 Z-1 R5 Q2.5\n");
  const std::vector<double> breaks{20, 20, 5, 2.5, 2.754, 0, 0.254, -1, 5};
  ASSERT_EQ(r.motions.size(), breaks.size());
  for (std::size_t i = 0; i < breaks.size(); ++i) EXPECT_NEAR(r.at(i).z(), breaks[i], 1e-12) << i;
  r = moves("G0 Z20\nG91 G81 X1 Y2 Z-1 R-5 L3\n");
  near(r.at(r.motions.size() - 1), {3, 6, 15});
  r = moves("G0 X20\nG19 G98 G81 X-3 R5 Y1 Z2\n");
  near(r.at(1), {20, 1, 2});
  near(r.at(2), {5, 1, 2});
  near(r.at(3), {-3, 1, 2});
  near(r.at(4), {20, 1, 2});
  r = moves("G18 G0 Y9\nG82 X1 Y-2 Z3 R4 P1\n");
  near(r.at(3), {1, -2, 3});
}

TEST(gcode, cycles_with_the_spindle) {
  // rs274 itself confuses axes in G18 and G19 here
  for (const std::string plane : {"G17", "G18", "G19"}) {
    const Reading r = gcode(plane + " F100 S500 M3 G0 X9 Y9 Z9\nG84 G99 X1 Y1 Z1 R5\nM2");
    EXPECT_EQ(r.motions[3].kind, Kind::feed);
    EXPECT_EQ(r.motions[3].spindle, 500);
    near(r.at(3), {1, 1, 1});
    EXPECT_EQ(r.motions[5].kind, Kind::feed);
    EXPECT_EQ(r.motions[5].spindle, -500);
    EXPECT_EQ(r.motions[5].end.at[plane == "G17" ? 2 : plane == "G18" ? 1 : 0], 5);
  }
  Reading r = gcode("F100 S500 M3 G0 Z9\nG86 X1 Z1 R5 P2\nG0 X0\nM2");
  EXPECT_EQ(r.motions[4].kind, Kind::dwell);
  EXPECT_EQ(r.motions[4].seconds, 2);
  EXPECT_EQ(r.motions[5].spindle, 0);
  EXPECT_EQ(r.motions[6].spindle, 500);
  r = gcode("F100 S500 M3 G0 Z9\nG87 X1 Y2 Z-1 R5 I1 J.5 K2\nM2");
  const std::vector<Vec3> bore{{0, 0, 9}, {1, 2, 9},  {1, 2, 5},    {2, 2.5, 5}, {2, 2.5, -1}, {1, 2, -1},
                               {1, 2, 2}, {1, 2, -1}, {2, 2.5, -1}, {2, 2.5, 5}, {1, 2, 5}};
  for (std::size_t i = 0; i < bore.size(); ++i) near(r.at(i), bore[i]);
  r = gcode("F100 S500 M3 G0 Z9\nG88 X1 Z-1 R5 P2\nM2");
  EXPECT_EQ(r.motions[5].kind, Kind::stop);
  near(r.at(6), {1, 0, 5});  // retracted by hand
  EXPECT_TRUE(r.noted("G88"));
}

TEST(gcode, cycles_that_cannot_be) {
  const std::string start = "G21 F100 G0 Z9\n";
  refused(start + "G81 X1 Z1", 2, "needs R");
  refused(start + "G81 X1 R1", 2, "needs Z");
  refused(start + "G81 X1 Z3 R2", 2, "below the hole's bottom");
  refused(start + "G81 X1 Z1 R2 L0", 2, "repeats");
  refused(start + "G81 X1 Z1 R2 A5", 2, "X, Y and Z only");
  refused(start + "G83 X1 Z1 R2", 2, "needs Q");
  refused(start + "G83 X1 Z1 R2 Q0", 2, "Q0");
  refused(start + "G83 X1 Z1 R2 Q.0000001", 2, "pecks");
  refused(start + "G82 X1 Z1 R2", 2, "needs P");
  refused(start + "G84 X1 Z1 R2", 2, "clockwise");
  refused(start + "G86 X1 Z1 R2 P1", 2, "stands still");
  refused(start + "G93 G81 X1 Z1 R2 F1", 2, "G93");
  refused(start + "G81 X1 Z1 R2\nG82 X2 P1", 3, "needs R");
  refused("G81 X1 Z1 R2", 1, "feed rate");
}

TEST(gcode, threads_and_synchronous_moves) {
  Reading r = moves("S100 M3\nG0 X2\nG33 Z-5 K2\nG33.1 Z-9 K1\n");
  EXPECT_EQ(r.motions[1].feed, 200);
  near(r.at(2), {2, 0, -9});
  near(r.at(3), {2, 0, -5});
  EXPECT_EQ(r.motions[3].spindle, -100);
  r = moves("S100 M3 G0 X10\nG76 P1 Z-10 I-1 J.2 R1 K.5 Q30 H1\n");
  const double t = std::tan(pi / 6);
  near(r.at(1), {10.3, 0, -0.2 * t});
  near(r.at(2), {8.8, 0, -0.2 * t});
  near(r.at(3), {8.8, 0, -10 + 0.3 * t});
  EXPECT_EQ(r.motions[3].feed, 100);
  near(r.at(r.motions.size() - 1), {10, 0, -10});
  EXPECT_EQ(r.motions.size(), 2U + 4 * 4);
  refused("G33 Z-5 K1", 1, "stands still");
  refused("S1 M3\nG33 Z-5", 2, "K");
  refused("S1 M3\nG76 Z-5 P1 I1 J2 K1", 2, "K, the full depth");
}

TEST(gcode, splines_stay_near_the_curve) {
  // The second cubic starts in the direction of the first one's end: its first control point is
  // (10, -10).
  Reading r = moves("G5 X10 Y0 I0 J10 P0 Q10\nG5 X20 Y0 P0 Q-10\n");
  ASSERT_GT(r.motions.size(), 20U);
  Vec3 last(0, 0, 0);
  for (const Motion& m : r.motions) {
    const bool second = m.line == 3;
    const double x = m.end[Axis::x] - (second ? 10 : 0);
    double low = 0, high = 1;  // bisection for the parameter: x = 30 t^2 - 20 t^3 increases
    for (int i = 0; i < 60; ++i) {
      const double t = (low + high) / 2;
      (30 * t * t - 20 * t * t * t < x ? low : high) = t;
    }
    EXPECT_NEAR(m.end[Axis::y], 30 * low * (1 - low) * (second ? -1 : 1), 1e-5);
    EXPECT_LT((m.end.xyz() - last).norm(), 2);
    last = m.end.xyz();
  }
  near(last, {20, 0, 0});
  r = moves("G5.1 X2 Y0 I1 J2\n");  // y = 2 x - x^2
  for (const Motion& m : r.motions)
    EXPECT_NEAR(m.end[Axis::y], 2 * m.end[Axis::x] - m.end[Axis::x] * m.end[Axis::x], 1e-9);
  // A quarter circle as a NURBS curve of order 3.
  r = moves("G0 X1 Y0\nG5.2 P1 L3\nX1 Y1 P" + std::to_string(std::sqrt(0.5)) + "\nX0 Y1 P1\nG5.3\nG1 X5\n");
  for (std::size_t i = 1; i + 1 < r.motions.size(); ++i) EXPECT_NEAR(r.at(i).norm(), 1, 1e-6);
  near(r.at(r.motions.size() - 2), {0, 1, 0});
  refused("F1 G5 X1 P1 Q1", 1, "I and J");
  refused("F1 G18 G5.1 X1 I1 J1", 1, "G17");
  refused("F1\nG5.2 X1 Y1 P1\nG1 X1", 3, "G5.3");
  refused("G5.3", 1, "G5.2");
  refused("F1\nG5.2 X1 Y1 P-1", 2, "weight");
}

TEST(gcode, cutter_compensation_of_a_square) {
  Reading r = moves("G0 X0 Y-10\nG41 D1 G1 X0 Y0\nY20\nX20\nG40 G1 Y30\n");  // left: outer corners
  near(r.at(1), {-3, 0, 0});
  near(r.at(2), {-3, 20, 0});
  EXPECT_EQ(r.motions[3].kind, Kind::arc);
  EXPECT_EQ(r.motions[3].turns, -1);
  EXPECT_EQ(r.motions[3].centre, Vec2(0, 20));
  near(r.at(3), {0, 23, 0});
  near(r.at(4), {20, 23, 0});
  near(r.at(5), {20, 30, 0});
  r = moves("G0 X0 Y-10\nG42.1 D6 G1 X0 Y0\nY20\nX20 Z1\nZ2\nY0\nG40\n");  // right: inner corners
  near(r.at(2), {3, 17, 0});
  near(r.at(3), {17, 17, 1});
  near(r.at(4), {17, 17, 2});
  near(r.at(5), {17, 0, 2});
  r = moves("G41.1 D4 G1 X5 Y0\nX20\nG2 X30 I5\nG1 X50\nG40\n");  // intersection of a line and a circle
  near(r.at(1), {25 - std::sqrt(45), 2, 0});
  EXPECT_EQ(r.motions[2].centre, Vec2(25, 0));
  near(r.at(2), {25 + std::sqrt(45), 2, 0});
  r = moves("G93\nG41.1 D4 G1 X5 Y0 F1\nX20 F2\nY20 F3\nG40\n");
  EXPECT_DOUBLE_EQ(r.motions[1].feed, 30);
  EXPECT_NEAR(r.motions[1].seconds, 60 * 13 / 30.0, 1e-9);  // shorter than the path, at the same feed
}

TEST(gcode, cutter_compensation_that_cannot_be) {
  const std::string start = "G21 F100\nG41.1 D4 G1 X5 Y0\n";
  refused("G21 F100\nG41.1 D4 G1 X1", 2, "entry move");
  refused(start + "X20\nY1\nX10\nY10", 5, "gouging");
  refused(start + "G3 X5 J1", 3, "radius");
  refused(start + "G41", 3, "while cutter compensation is on");
  refused(start + "G18", 3, "while cutter compensation is on");
  refused(start + "G81 X1 Y1 R1 Z0", 3, "while cutter compensation is on");
  refused(start + "G28", 3, "while cutter compensation is on");
  refused(start + "G55", 3, "while cutter compensation is on");
  refused(start + "G92 X0", 3, "while cutter compensation is on");
  refused(start + "G53 G1 X1", 3, "while cutter compensation is on");
  refused(start + "T1 M6", 3, "while cutter compensation is on");
  refused(start + "G0 X#5420", 3, "while cutter compensation is on");
  refused("G19 G41 D1", 1, "planes");
  refused("G41.1", 1, "D");
}

TEST(gcode, dwells_stops_spindle_and_tools) {
  const Reading r =
      gcode("G4 P1.5\nM0\nM1\nM60\nS100 M4\nG0 X1\nM5 X2\nT2\nM6\nG96 S100 D2000 M3\nX10\nX.1\nM30\nG0 X9");
  EXPECT_EQ(r.motions[0].seconds, 1.5);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(r.motions[i].kind, Kind::stop);
  EXPECT_EQ(r.motions[4].spindle, -100);
  EXPECT_EQ(r.motions[5].spindle, 0);
  EXPECT_EQ(r.motions[6].tool, 2);
  EXPECT_NEAR(r.motions[7].spindle, 100 * 1000 / (2 * pi * 10), 1e-9);
  EXPECT_EQ(r.motions[8].spindle, 2000);
  EXPECT_EQ(r.motions[9].kind, Kind::end);
  EXPECT_EQ(r.motions.size(), 10U);
}

TEST(gcode, what_has_no_meaning_here_is_noted_once) {
  const Reading r = gcode(
      "M101\nM101\nM400\nM62 P1\nM66 P0 L0\nG0 X#5399\nG4 S3\n#1=#<_hal[foo.bar]>\n#2=#<_ini[a]b>\nG38.2 Z-5 "
      "F9\nT7\nM2");
  EXPECT_TRUE(r.noted("M101"));
  EXPECT_TRUE(r.noted("M400"));
  EXPECT_TRUE(r.noted("M62"));
  EXPECT_TRUE(r.noted("_hal[foo.bar]"));
  EXPECT_TRUE(r.noted("_ini[a]b"));
  EXPECT_TRUE(r.noted("G38"));
  EXPECT_TRUE(r.noted("tool 7"));
  EXPECT_TRUE(r.noted("G4 with S"));
  EXPECT_EQ(r.notes.size(), 9U);
  EXPECT_EQ(r.notes[0].line, 1);
  EXPECT_EQ(r.at(0).x(), -1);
  EXPECT_EQ(r.motions[1].seconds, 3);
}

TEST(gcode, modes_kept_and_brought_back) {
  Reading r = moves("M70\nG91 G20 F5\nM72\nG1 X1\nX1\n");
  near(r.at(1), {1, 0, 0});
  EXPECT_EQ(r.motions[0].feed, 100);
  r = moves("o1 sub\nM73\nG91 G20 G55 F7\no1 endsub\no1 call\nG1 X1\nX1\n");
  near(r.at(1), {1, 0, 0});
  EXPECT_EQ(r.motions[0].feed, 100);
  refused("M72", 1, "M70");
}

TEST(gcode, conditions_and_loops) {
  near(moves("o1 if [0]\nG0 X1 garbage\no1 elseif [1]\nG0 X2\no1 else\nG0 X3\no1 endif\n").at(0), {2, 0, 0});
  near(moves("o1 if [0]\nG0 X1\no1 elseif [0]\nG0 X2\no1 else\nG0 X3\no1 endif\n").at(0), {3, 0, 0});
  Reading r = moves(
      "#1=0\no1 while [#1 lt 5]\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 endif\no3 if [#1 eq 4]\no1 break\no3 "
      "endif\nG0 "
      "X#1\no1 endwhile\nG0 Z1\n");
  ASSERT_EQ(r.motions.size(), 3U);
  near(r.at(1), {3, 0, 0});
  r = moves("#1=0\no1 do\n#1=[#1+1]\nG0 X#1\no1 while [#1 lt 3]\n");
  EXPECT_EQ(r.motions.size(), 3U);
  r = moves("#1=0\no1 repeat [4]\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 endif\nG91 G0 X1\no1 endrepeat\n");
  EXPECT_EQ(r.motions.size(), 3U);
  EXPECT_TRUE(moves("o1 repeat [-1]\nG0 X1\no1 endrepeat\n").motions.empty());
  refused("o1 if [0]", 1, "no end");
  refused("o1 while [0]\n", 1, "no end");
  refused("o1 endif", 1, "none has begun");
  refused("o1 endwhile", 1, "none has begun");
  refused("o1 break", 1, "outside");
  refused("o1 foo", 1, "foo");
  refused("o1 if 1", 1, "brackets");
  refused("G0 X1 o1 if [1]", 1, "beginning");
  refused("\no1 while [1]\nG4 P0\no1 endwhile", 2, "no end", [] {
    ReadingOptions options;
    options.most_blocks = 1000;
    return options;
  }());
}

TEST(gcode, repeats_count_as_blocks) {
  ReadingOptions options;
  options.most_blocks = 1000;
  refused("F9 G81 X1 Z1 R2 L1000000000", 1, "no end", options);
  refused("F9 G83 X1 Z1 R2 Q.0001", 1, "no end", options);
}

TEST(gcode, entry_of_compensation_along_an_arc) {
  // The arc ends beside the path's end, tangent to it, and starts at the tool's position.
  const Reading r = moves("G0 X0 Y-10\nG41.1 D4\nG3 X10 Y0 I0 J10\nG1 Y20\nG40\n");
  near(r.at(1), {8, 0, 0});
  EXPECT_NEAR(r.motions[1].centre.y(), 0, 1e-12);
  EXPECT_NEAR((r.motions[1].centre - Vec2(0, -10)).norm(), (r.motions[1].centre - Vec2(8, 0)).norm(), 1e-12);
  near(r.at(2), {8, 20, 0});
}

TEST(gcode, subroutines) {
  Reading r = moves(
      "o<Move> sub\nG0 X#1 Y#2\n#2=9\n#<in>=1\no<move> return [5]\nG0 X9\no<move> endsub\n#2=4\no<move> call [1] "
      "[3]\nG0 "
      "X#<_value> Z#2\n");
  ASSERT_EQ(r.motions.size(), 2U);
  near(r.at(0), {1, 3, 0});
  near(r.at(1), {5, 3, 4});
  near(moves("o1 call\nG0 Y2\nM2\no1 sub\nG0 X1\no1 endsub\n").at(1), {1, 2, 0});  // defined later
  near(moves("o1 sub\n#<_g>=8\n#<l>=3\no1 endsub\no1 call\nG0 X[#<_g>+EXISTS[#<l>]]\n").at(0), {8, 0, 0});
  near(moves("#1=100\no#1 sub\nG0 X1\no#1 endsub\no[99+1] call\n").at(0), {1, 0, 0});
  refused("o1 call", 1, "no subroutine");
  refused("o1 sub\nG0 X1", 1, "no end");
  refused("o1 return", 1, "no subroutine was called");
  refused("o1 sub\no1 call\no1 endsub\no1 call", 2, "within each other");
  refused("o1 sub\no2 sub\no2 endsub\no1 endsub\no1 call", 2, "within another");
}

TEST(gcode, programs_called_by_number) {
  Reading r = moves("M98 P1000 L3\nM30\nO1000\nG91 G0 X1\nM99\n");
  ASSERT_EQ(r.motions.size(), 3U);
  near(r.at(2), {3, 0, 0});
  r = moves("O1\nG0 X1\nM98 P7\nG0 Z1\nM2\nO7 (drill)\n#5=2\nG0 Y#5\nM99\n");
  near(r.at(2), {1, 2, 1});
  EXPECT_TRUE(gcode("G0 X1\nM99\n").noted("M99"));
  refused("M98 P5", 1, "O5");
  refused("O5\nM98 P5\nM99\n", 2, "within each other");
}

TEST(gcode, subroutine_files) {
  const auto folder = std::filesystem::temp_directory_path() / ("gcode_test_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "more");
  write_file(folder / "one.ngc", "(a comment)\no<one> sub\nG0 X#1\no<two> call\no<one> endsub\nM2\n");
  write_file(folder / "more" / "two.ngc", "o<two> sub\nG0 Y2\nG1 X1\no<two> endsub\n");
  ReadingOptions options;
  options.folders = {folder / "more"};
  std::vector<Motion> motions;
  const auto read = [&](const std::string& text) {
    return read_gcode(text, (folder / "part.ngc").string(), options, [&](const Motion& m) { motions.push_back(m); });
  };
  read("F9\no<one> call [7]\nM2\n");
  ASSERT_EQ(motions.size(), 4U);
  near(motions[1].end.xyz(), {7, 2, 0});
  EXPECT_EQ(motions[1].line, 2);
  try {
    read("o<one> call [7]\nM2\n");
    ADD_FAILURE();
  } catch (const Error& error) {
    // line of the missing feed
    EXPECT_EQ(error.place(), (folder / "more" / "two.ngc").string() + ":3");
  }
  std::filesystem::remove_all(folder);
}

TEST(gcode, polar_words) {
  const Reading r = moves("G0 @5 ^30\nG1 @10\n^60\nG91 ^30\n");
  near(r.at(1), {10 * std::cos(pi / 6), 5, 0});
  near(r.at(2), {5, 10 * std::sin(pi / 3), 0});
  near(r.at(3), {0, 10, 0});
  refused("G0 @5 X1", 1, "@");
}

TEST(gcode, cancelled_in_time) {
  Progress progress;
  progress.cancel();
  std::string text;
  for (int i = 0; i < 3000; ++i) text += "G0 X1\n";
  try {
    read_gcode(
        text, "part.ngc", {}, [](const Motion&) {}, progress);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
}

}  // namespace
}  // namespace fieldfab::cam
