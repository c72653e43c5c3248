// Programs written by this CAM, read back; ShopBot, RML and HPGL, feature by feature.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>
#include <sstream>

#include "cam_readings.h"
#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

// ---------- What our own CAM writes

Program square() {
  Program program;
  program.name = "square";
  Section section;
  section.name = "outline";
  section.tool.number = 1;
  section.spindle = 9000;
  section.clearance = 5;
  section.moves = {{{10, 10, 5}, 0},    {{10, 10, 1}, 0},    {{10, 10, -1}, 120}, {{30, 10, -1}, 300},
                   {{30, 20, -1}, 300}, {{20, 30, -1}, 300}, {{10, 10, -1}, 300}, {{10, 10, 5}, 0}};
  program.sections.push_back(section);
  return program;
}

std::string written(const Program& program, const std::string& machine) {
  const Machine loaded = load_machine(machine);
  Values values;
  for (const Setting& setting : loaded.settings) values.given[setting.name] = {setting.standard, "default", ""};
  return write_program(program, loaded, values);
}
std::string written(const std::string& machine) { return written(square(), machine); }

void same_way(const std::vector<Motion>& motions, double within, bool rapids) {
  std::vector<Motion> moved;
  for (const Motion& m : motions)
    if (m.kind == Kind::rapid || m.kind == Kind::feed) moved.push_back(m);
  const std::vector<Move> expected = square().sections[0].moves;
  std::size_t k = 0;
  for (const Move& move : expected) {
    while (k < moved.size() && (moved[k].end.xyz() - move.to).norm() > within) ++k;
    ASSERT_LT(k, moved.size()) << move.to.transpose();
    if (!rapids) continue;
    EXPECT_EQ(moved[k].kind == Kind::rapid, move.rapid());
    EXPECT_NEAR(moved[k].feed, move.feed, 0.05 * move.feed);
  }
}

TEST(written_programs, comments_are_ascii) {
  Program program = square();
  program.name = "Grundkörper (Maß 5 × 3 mm; 日本)";
  program.sections[0].name = "Planfräsen";
  for (const char* machine : {"linuxcnc", "grbl", "mach3", "marlin"}) {
    const std::string text = written(program, machine);
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; }));
    EXPECT_NE(text.find("Planfraesen"), std::string::npos) << text;
    EXPECT_NE(text.find("Grundkoerper  Mass 5 x 3 mm  ??"), std::string::npos) << text;
  }
}

TEST(written_programs, gcode_machines) {
  for (const char* machine : {"linuxcnc", "grbl", "mach3", "marlin", "othermill", "gcode_inch"}) {
    std::vector<Motion> motions;
    const auto notes =
        read_gcode(written(machine), machine, with_tools(), [&](const Motion& m) { motions.push_back(m); });
    same_way(motions, 2e-3, true);
  }
}

/// Two tools on a stock.
Program two_tools() {
  Program program = square();
  program.name = "lid (left)";
  program.stock = {{-2, -3, -20}, {38, 37, 1}};
  program.sections.push_back(program.sections[0]);
  Tool &first = program.sections[0].tool, &second = program.sections[1].tool;
  first.name = "rougher", first.diameter = 6, first.length = 45.5;
  second.number = 2, second.shape = ToolShape::ball, second.diameter = 3;
  return program;
}

/// The program's lines from each tool change to the first feed, joined by '/'.
std::vector<std::string> approaches(const std::string& text, const std::string& change) {
  std::vector<std::string> found;
  bool inside = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.find(change) != std::string::npos) inside = true, found.emplace_back();
    if (line.starts_with("G1") || line.starts_with("M3,")) inside = false;
    if (inside && (line.find("G0") != std::string::npos || line.starts_with("J"))) found.back() += line + "/";
  }
  return found;
}

TEST(written_programs, go_up_and_over_and_then_down_after_a_tool_change) {
  const auto same = [](const std::string& machine, const std::string& change, const std::string& expected) {
    const std::vector<std::string> found = approaches(written(two_tools(), machine), change);
    EXPECT_EQ(found, (std::vector<std::string>{expected, expected})) << machine;
  };
  same("linuxcnc", "M6", "G53 G0 Z0/G0 X10 Y10/G0 Z5/G0 Z1/");
  same("mach3", "M6", "G53 G0 Z0/G0 X10 Y10/G0 Z5/G0 Z1/");
  same("grbl", "M0", "G0 Z5/G0 X10 Y10/G0 Z1/");
  same("marlin", "M0", "G0 Z5/G0 X10 Y10/G0 Z1/");
  same("shopbot_mm", "&Tool", "JZ,5/J3,10,10,5/J3,10,10,1/");
}

TEST(written_programs, go_up_before_and_after_the_part_is_turned_by_hand) {
  Program program = square();
  program.sections.push_back(program.sections[0]);
  program.sections[1].setup = "bottom";
  const std::string text = written(program, "linuxcnc");
  const std::size_t stop = text.find("M0\n");
  ASSERT_NE(stop, std::string::npos);
  const std::size_t up = text.rfind("G53 G0 Z0", stop);
  ASSERT_NE(up, std::string::npos);
  EXPECT_EQ(text.find("G1", up) > stop && text.find("G0 X", up) > stop, true) << text;
  EXPECT_EQ(approaches(text, "M0"), std::vector<std::string>{"G53 G0 Z0/G0 X10 Y10/G0 Z5/G0 Z1/"}) << text;
}

TEST(written_programs, name_stock_zero_tools_and_time) {
  const std::string text = written(two_tools(), "linuxcnc");
  EXPECT_NE(text.find("(lid  left )\n"
                      "(stock: 40 x 40 x 21 mm)\n"
                      "(zero: 2 mm from its left, 3 mm from its front, 1 mm below its top)\n"
                      "(T1: rougher, diameter 6 mm, stickout 45.5 mm)\n"
                      "(T2: ball, diameter 3 mm)\n"
                      "(time: about "),
            std::string::npos)
      << text.substr(0, 400);
  EXPECT_NE(written(two_tools(), "gcode_inch").find("(stock: 1.575 x 1.575 x 0.827 in)\n"), std::string::npos);
  EXPECT_EQ(written("linuxcnc").find("stock"), std::string::npos) << "an unknown stock is not listed";
}

TEST(written_programs, shopbot) {
  for (const auto& [machine, unit] :
       std::vector<std::pair<std::string, double>>{{"shopbot", 25.4}, {"shopbot_mm", 1}}) {
    std::vector<Motion> motions;
    const auto notes = read_sbp(written(machine), machine, {}, unit, [&](const Motion& m) { motions.push_back(m); });
    same_way(motions, 1e-3, true);
    EXPECT_EQ(motions.back().kind, Kind::end);
    EXPECT_TRUE(notes.empty()) << notes[0].message;
    bool turning = false;
    for (const Motion& m : motions) turning |= m.spindle == 9000;
    EXPECT_TRUE(turning);
  }
}

TEST(written_programs, rml) {
  for (const auto& [machine, tick] : std::vector<std::pair<std::string, double>>{
           {"modela", 0.025}, {"srm20", 0.01}, {"mdx40", 0.01}, {"imodela", 0.01}}) {
    std::vector<Motion> motions;
    const auto notes = read_rml(written(machine), machine, {}, tick, [&](const Motion& m) { motions.push_back(m); });
    same_way(motions, tick, false);
    EXPECT_TRUE(notes.empty()) << notes[0].message;
    EXPECT_EQ(motions[0].spindle, 9000);
    double least = 1e9;
    for (const Motion& m : motions)
      if (m.kind == Kind::feed) least = std::min(least, m.feed);
    EXPECT_NEAR(least, 120, 6);
  }
}

TEST(written_programs, hpgl) {
  for (const auto& [machine, tick] : std::vector<std::pair<std::string, double>>{{"hpgl", 0.025},
                                                                                 {"gcc_vinyl", 0.025},
                                                                                 {"gcc_laser", 0.1},
                                                                                 {"roland_vinyl", 0.025},
                                                                                 {"epilog", 25.4 / 600}}) {
    std::vector<Motion> motions;
    const auto notes =
        read_hpgl(written(machine), machine, {}, tick, 5, -1, [&](const Motion& m) { motions.push_back(m); });
    std::vector<Vec3> cut;
    for (const Motion& m : motions)
      if (m.kind == Kind::feed) cut.push_back(m.end.xyz());
    const std::vector<Vec3> expected{{10, 10, -1}, {30, 10, -1}, {30, 20, -1}, {20, 30, -1}, {10, 10, -1}};
    ASSERT_EQ(cut.size(), expected.size()) << machine;
    for (std::size_t i = 0; i < cut.size(); ++i) near(cut[i], expected[i], tick);
    EXPECT_EQ(motions.back().end[Axis::z], 5) << machine;
  }
}

// ---------- ShopBot

Reading sbp(const std::string& text, double unit = 1) {
  Reading reading;
  reading.notes =
      read_sbp(text, "part.sbp", {}, unit, [&](const Motion& motion) { reading.motions.push_back(motion); });
  return reading;
}
template <class Read>
void refuses(const Read& read, const std::string& text, const std::string& place, const std::string& message) {
  try {
    read(text);
    ADD_FAILURE() << "read without an error: " << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.place(), place) << error.what();
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(sbp, moves_and_jogs) {
  const Reading r =
      sbp("'a part\nSA\nMS,1,.5\nJ3,1,2,3\nM2,,5\nMZ,-1 'down\nM5,,,,90,-45\nSR\nMX,1\nm3, 1, 1, "
          "1\nSA\nJH\nPAUSE,2\nPAUSE\nEND\nM2,9,9\n",
          25.4);
  near(r.at(0), {25.4, 50.8, 76.2});
  EXPECT_EQ(r.motions[0].kind, Kind::rapid);
  near(r.at(1), {25.4, 127, 76.2});
  EXPECT_DOUBLE_EQ(r.motions[1].feed, 1524);
  EXPECT_DOUBLE_EQ(r.motions[2].feed, 762);
  EXPECT_NEAR(r.motions[3].end[Axis::a], pi / 2, 1e-12);
  EXPECT_NEAR(r.motions[3].end[Axis::b], -pi / 4, 1e-12);
  near(r.at(4), {50.8, 127, -25.4});
  near(r.at(5), {76.2, 152.4, 0});
  near(r.at(6), {0, 0, 0});
  EXPECT_EQ(r.motions[7].seconds, 2);
  EXPECT_EQ(r.motions[8].kind, Kind::stop);
  EXPECT_EQ(r.motions[9].kind, Kind::end);
  EXPECT_EQ(r.motions.size(), 10U);
  EXPECT_TRUE(r.noted("rotary"));
}

TEST(sbp, circles) {
  Reading r =
      sbp("MS,10,5\nCG,,2,0,1,0,T,1\nCG,,0,0,-1,0,T,-1\nCG,2,2,0,,,T,1\nJ2,0,0\nCG,,0,0,5,0,T,1,-2,2,,,3,1\nEND");
  EXPECT_EQ(r.motions[0].turns, -1);
  EXPECT_EQ(r.motions[0].centre, Vec2(1, 0));
  EXPECT_DOUBLE_EQ(r.motions[0].feed, 600);
  EXPECT_EQ(r.motions[1].turns, 1);
  EXPECT_EQ(r.motions[2].centre, Vec2(1, 0));
  near(r.at(4), {0, 0, -2});  // a helix
  near(r.at(5), {0, 0, -4});
  r = sbp("MS,10,5\nJ3,0,5,1\nCP,10,0,0,T,1,0,90,-2\nEND");  // angles from the top, clockwise
  near(r.at(1), {0, 5, -1});
  EXPECT_DOUBLE_EQ(r.motions[1].feed, 300);
  near(r.at(2), {5, 0, -1});
  EXPECT_EQ(r.motions[2].turns, -1);
  near(r.at(3), {5, 0, 1});  // retracted
  r = sbp("MS,10,5\nJZ,1\nCP,10,0,0,T,-1\nEND");
  near(r.at(1), {0, 5, 1});
  EXPECT_EQ(r.motions[2].turns, 1);
  near(r.at(2), {0, 5, 1});
  EXPECT_TRUE(r.noted("CP"));
}

TEST(sbp, variables_labels_and_conditions) {
  const Reading r =
      sbp("IF %(25)=1 THEN GOTO WRONG\n&a = 2\n&B=(&A+1)*2 - -1\nGOSUB Go\nagain:\n&a=&a+1\nIF &a < 5 THEN GOTO "
          "again\nJX,&a\nEND\nGO:\nJY,&b\nRETURN\nWRONG:\nC#,91\nEND\n");
  near(r.at(0), {0, 7, 0});
  near(r.at(1), {5, 7, 0});
  EXPECT_TRUE(r.noted("%(25)"));
  EXPECT_TRUE(sbp("C6\nEND").noted("C6"));
  const Reading zeroed = sbp("J3,1,2,3\nZZ\nJ3,0,0,0\nVA,10,20\nJ2,0,0\nEND");
  near(zeroed.at(1), {0, 0, 3});
  near(zeroed.at(2), {-10, -20, 3});
}

TEST(sbp, what_it_refuses) {
  const auto refused_sbp = [](const std::string& text, int line, const std::string& message) {
    refuses([](const std::string& t) { sbp(t); }, text, "part.sbp:" + std::to_string(line), message);
  };
  refused_sbp("\nXY,1", 2, "not known");
  refused_sbp("M2,1,2,3", 1, "more parameters");
  refused_sbp("MX,&a", 1, "no value");
  refused_sbp("MX,%(1)", 1, "%");
  refused_sbp("GOTO there", 1, "no label");
  refused_sbp("RETURN", 1, "GOSUB");
  refused_sbp("A:\nGOSUB A", 2, "within each other");
  refused_sbp("FP,other.sbp", 1, "FP");
  refused_sbp("MS,1\nCG,,5,0,1,0,T,1", 2, "begins");
  refused_sbp("CG,,2,0,1,0,O,1", 1, "diameter");
  refused_sbp("MX,1/0", 1, "zero");
  refused_sbp("MX,(1", 1, ")");
  ReadingOptions options;
  options.most_blocks = 100;
  EXPECT_THROW(read_sbp("A:\nGOTO A\n", "part.sbp", options, 1, [](const Motion&) {}), Error);
}

// ---------- RML and HPGL

TEST(rml, pens_and_places) {
  std::vector<Motion> m;
  const auto sink = [&](const Motion& motion) { m.push_back(motion); };
  read_rml("PA;VS10;!VZ5;!PZ-40,80;!RC8000;!MC1;PU100,0;PD200,0,200,100;PR;Z0,0,-40;PA;PU;H;!MC0;", "a.rml", {}, 0.025,
           sink);
  near(m[0].end.xyz(), {0, 0, 2});
  near(m[1].end.xyz(), {2.5, 0, 2});
  EXPECT_EQ(m[1].kind, Kind::rapid);
  EXPECT_EQ(m[1].spindle, 8000);
  near(m[2].end.xyz(), {2.5, 0, -1});
  EXPECT_DOUBLE_EQ(m[2].feed, 300);
  near(m[4].end.xyz(), {5, 2.5, -1});
  EXPECT_DOUBLE_EQ(m[4].feed, 600);
  near(m[5].end.xyz(), {5, 2.5, -2});
  near(m[7].end.xyz(), {0, 0, 2});
  EXPECT_EQ(m.back().kind, Kind::end);
  const auto read = [&](const std::string& text) { read_rml(text, "a.rml", {}, 0.025, sink); };
  refuses(read, "PA;\nZ1,2;", "a.rml:2", "x, y and z");
  refuses(read, "PD1,2", "a.rml:1", "!PZ");
  refuses(read, "=1", "a.rml:1", "instruction");
  refuses(read, "VS0", "a.rml:1", "above 0");
}

TEST(hpgl, lines_arcs_and_circles) {
  std::vector<Motion> m;
  const auto sink = [&](const Motion& motion) { m.push_back(motion); };
  read_hpgl("IN;SP1;VS2;PU400,0;PD;AA0,0,90;PR-40,0;PA;AA0,0,-720;PU;PA0,0;CI40;SP0;", "a.hpgl", {}, 0.025, 5, -1,
            sink);
  EXPECT_EQ(m[0].kind, Kind::rapid);
  EXPECT_EQ(m[1].kind, Kind::tool_change);
  near(m[2].end.xyz(), {10, 0, 5});
  near(m[3].end.xyz(), {10, 0, -1});
  EXPECT_DOUBLE_EQ(m[3].feed, 1200);
  near(m[4].end.xyz(), {0, 10, -1});
  EXPECT_EQ(m[4].turns, 1);
  near(m[5].end.xyz(), {-1, 10, -1});
  EXPECT_EQ(m[6].turns, -2);
  near(m[6].end.xyz(), {-1, 10, -1});
  EXPECT_EQ(m[11].turns, 1);
  EXPECT_EQ(m[11].centre, Vec2(0, 0));
  near(m[11].end.xyz(), {1, 0, -1});
  EXPECT_EQ(m.back().end[Axis::z], 5);
  const auto read = [&](const std::string& text) { read_hpgl(text, "a.hpgl", {}, 0.025, 5, -1, sink); };
  refuses(read, "IN;\nLBtext", "a.hpgl:2", "LB");
  refuses(read, "PD1", "a.hpgl:1", "pairs");
  refuses(read, "SC0,1,0,1", "a.hpgl:1", "SC");
}

}  // namespace
}  // namespace fieldfab::cam
