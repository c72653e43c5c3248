// Programs from practice for controls other than LinuxCNC's, and projects of CAMotics.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "cam_readings.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/cam/simulate/setup.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

ReadingOptions of(Dialect dialect) {
  ReadingOptions options = with_tools();
  options.dialect = dialect;
  return options;
}

const auto forgiving = {Dialect::fanuc, Dialect::grbl, Dialect::mach3};

TEST(Dialects, HaveNames) {
  for (const char* name : {"linuxcnc", "fanuc", "grbl", "mach3"}) EXPECT_EQ(name_of(dialect_named(name, "here")), name);
  try {
    (void)dialect_named("fanoc", "here");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("fanuc"), std::string::npos);
    EXPECT_EQ(error.place(), "here");
  }
}

TEST(Dialects, TakeTheHeaderThatMostPostsWrite) {
  const std::string header =
      "%\nO1000 (PART)\nN1 G00 G17 G21 G40 G49 G80 G90\nN2 T1 M6\nN3 G43 H1 Z5 M8\nN4 X1 Y2\nM30\n%\n";
  refused(header, 3, "G0 and G80");
  for (const Dialect dialect : forgiving) {
    const Reading r = gcode(header, of(dialect));
    ASSERT_EQ(r.motions.size(), 4U);
    EXPECT_EQ(r.motions[2].kind, Kind::rapid);
    near(r.at(2), {1, 2, 5});
    EXPECT_EQ(r.motions[2].tool_offset, Vec3(0, 0, 10));
    EXPECT_TRUE(r.notes.empty());
  }
}

TEST(Dialects, GoBackToThePlainMotionAfterACycle) {
  for (const Dialect dialect : forgiving) {
    const Reading r =
        gcode("G21 G90 F100\nG0 Z5\nG81 X1 Y1 Z-1 R2\nG80 X7 Y7\nG1 X8\nG81 X9 Z-1 R2\nG80\nX10\nM30\n", of(dialect));
    const auto at = [&](int line) {
      for (const Motion& motion : r.motions)
        if (motion.line == line) return motion;
      ADD_FAILURE() << "no motion in line " << line;
      return Motion{};
    };
    EXPECT_EQ(at(4).kind, Kind::rapid);
    near(at(4).end.xyz(), {7, 7, 5});
    EXPECT_EQ(at(8).kind, Kind::feed);
  }
}

TEST(Dialects, PassOverWhatMovesNothing) {
  const Reading r = gcode("G5 P10000\nG187 P3\nM10 M88 M3 S500\nG0 X1 H4\nM120\nM30\n", of(Dialect::fanuc));
  ASSERT_EQ(r.motions.size(), 2U);
  near(r.at(0), {1, 0, 0});
  EXPECT_DOUBLE_EQ(r.motions[0].spindle, 500);
  for (const char* said : {"G5 ", "G187", "M10", "M88", "M120", "H in a block"}) EXPECT_TRUE(r.noted(said)) << said;
  refused("G187 P3\nM30\n", 1, "G187");
  refused("G0 X1 H4\nM30\n", 1, "H word");
}

TEST(Dialects, RefuseWhatMayMoveOrChangeTheFlow) {
  for (const Dialect dialect : forgiving)
    for (const char* line :
         {"G12 I5 F100", "G65 P9000 X1", "G51 X2", "M97 P5", "IF [#1 EQ 2] GOTO 5", "WHILE [#1 LT 3] DO1", "GOTO 7"})
      refused(std::string("G21\n") + line + "\nM30\n", 2, "", of(dialect));
}

TEST(Dialects, TakeTheLastCodeOfAGroup) {
  const Reading r = gcode("G0 G1 X1 F100\nM3 M5 M9 M8\nM30\n", of(Dialect::fanuc));
  EXPECT_EQ(r.motions[0].kind, Kind::feed);
  EXPECT_TRUE(r.noted("G0 and G1"));
  EXPECT_TRUE(r.noted("M3 and M5"));
  refused("G28 G92 X0\n", 1, "exclude", of(Dialect::fanuc));
}

TEST(Dialects, GiveTheAxisWordsToG28) {
  for (const Dialect dialect : forgiving) {
    const Reading r = gcode("G21 G90\nG0 X3 Z2\nG91 G0 G28 Z0\nG90 X5\nM30\n", of(dialect));
    near(r.motions[r.motions.size() - 2].end.xyz(), {5, 0, 0});
  }
}

TEST(Dialects, BeginWithRapidsAndNeedNoFeed) {
  for (const Dialect dialect : forgiving) {
    const Reading r = gcode("X1\nG1 X2\nM30\n", of(dialect));
    EXPECT_EQ(r.motions[0].kind, Kind::rapid);
    EXPECT_EQ(r.motions[1].feed, 0);
    EXPECT_TRUE(r.noted("feed rate"));
  }
  refused("X1\n", 1, "axis words");
  refused("G1 X1\n", 1, "feed rate");
}

TEST(Dialects, DwellAsTheControlDoes) {
  const auto seconds = [](const std::string& words, Dialect dialect) {
    return gcode("G4 " + words + "\nM30\n", of(dialect)).motions.at(0).seconds;
  };
  EXPECT_DOUBLE_EQ(seconds("P1500", Dialect::fanuc), 1.5);
  EXPECT_DOUBLE_EQ(seconds("P1.5", Dialect::fanuc), 1.5);
  EXPECT_DOUBLE_EQ(seconds("X2.", Dialect::fanuc), 2);
  EXPECT_DOUBLE_EQ(seconds("U0.5", Dialect::fanuc), 0.5);
  EXPECT_DOUBLE_EQ(seconds("P2", Dialect::grbl), 2);
  EXPECT_DOUBLE_EQ(seconds("P2", Dialect::mach3), 2);
}

TEST(Dialects, HaveTheNamedToolInTheSpindleOfGrbl) {
  const std::string program = "G21 G90 M3 S100 T2\nG0 X1\nT2 M6\nG0 X2\nT3\nX3\nM30\n";
  const auto tools = [&](Dialect dialect) {
    std::vector<int> found;
    for (const Motion& motion : gcode(program, of(dialect)).motions)
      if (motion.kind == Kind::rapid) found.push_back(motion.tool);
    return found;
  };
  EXPECT_EQ(tools(Dialect::grbl), (std::vector<int>{2, 2, 3}));
  EXPECT_EQ(tools(Dialect::mach3), (std::vector<int>{0, 2, 2}));
  EXPECT_NE(gcode(program, of(Dialect::grbl)).motions[1].spindle, 0);
}

TEST(Dialects, IgnoreOffsetsAcrossThePlaneOfArcs) {
  const std::string arc = "G21 G90 G17 F100\nG1 X7 Y10\nG2 X10 Y13 Z-2 I3 J0 K";
  refused(arc + "0\n", 3, "K in an arc");
  for (const Dialect dialect : forgiving) {
    const Reading r = gcode(arc + "0\nM30\n", of(dialect)), other = gcode(arc + "1\nM30\n", of(dialect));
    ASSERT_EQ(r.motions.size(), 3U);
    EXPECT_EQ(r.motions[1].kind, Kind::arc);
    near({r.motions[1].centre.x(), r.motions[1].centre.y(), 0}, {10, 10, 0});
    EXPECT_FALSE(r.noted("passed over"));
    EXPECT_TRUE(other.noted("K of an arc"));
    const Reading both = gcode("G21 G90 G18 F100\nG1 X0 Z0\nG2 X10 Z0 R5 I4 J0 K0\nM30\n", of(dialect));
    near({both.motions[1].centre.x(), both.motions[1].centre.y(), 0}, {0, 5, 0});
    EXPECT_TRUE(both.noted("I of an arc"));
  }
}

TEST(Dialects, LeaveOutCommandsToTheControl) {
  const Reading r = gcode("$H\n$X\nG21\n!\nG0 X1\nM2\n", of(Dialect::grbl));
  ASSERT_EQ(r.motions.size(), 2U);
  EXPECT_TRUE(r.noted("$h"));
  refused("$H\n", 1, "", of(Dialect::fanuc));
}

TEST(Dialects, AreForgivingOfComments) {
  const Reading r =
      gcode("%1234\n:77\nG0 X1 (never closed\nG0 X2\nM30\nthis is not G-code any more (\n", of(Dialect::mach3));
  ASSERT_EQ(r.motions.size(), 3U);
  EXPECT_TRUE(r.noted("without its ')'"));
}

TEST(Dialects, OfOurMachinesAreSaid) {
  EXPECT_EQ(load_machine("grbl").dialect, Dialect::grbl);
  EXPECT_EQ(load_machine("mach3").dialect, Dialect::mach3);
  EXPECT_EQ(load_machine("linuxcnc").dialect, Dialect::linuxcnc);
}

TEST(Dialects, CountInInchesWhereToldTo) {
  ReadingOptions options = of(Dialect::fanuc);
  options.inch = true;
  near(gcode("X1\nG21 X1\nM30\n", options).at(0), {25.4, 0, 0});
  near(gcode("X1\nG21 X1\nM30\n", options).at(1), {1, 0, 0});
}

/// A folder with a project.
struct Project {
  Project(const std::string& text, const std::string& program = "") {
    folder = std::filesystem::temp_directory_path() / ("fieldfab_camotics_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    write_file(folder / "part.camotics", text);
    write_file(folder / "part.nc", program);
  }
  ~Project() { std::filesystem::remove_all(folder); }
  [[nodiscard]] SimulationSetup read() const { return read_simulation_setup(folder / "part.camotics"); }
  std::filesystem::path folder;
};

constexpr const char* tools = R"("tools": {"1": {"units": "metric", "shape": "conical", "length": 10, "diameter": 20},
  "2": {"units": "imperial", "shape": "ballnose", "length": 1, "diameter": 0.25},
  "3": {"shape": "snubnose", "length": 10, "diameter": 24, "snub_diameter": 4}})";

TEST(Camotics, ProjectsAreSetups) {
  const Project project(std::string("{\"units\": \"imperial\", \"resolution\": 0.1, ") + tools +
                        R"(, "workpiece": {"automatic": false, "bounds": {"min": [0, -1, -5], "max": [50, 60, 0]}}})");
  const SimulationSetup setup = project.read();
  EXPECT_TRUE(setup.inch);
  EXPECT_DOUBLE_EQ(setup.sampling.cell, 0.1);
  EXPECT_EQ(setup.stock_box.lower, Vec3(0, -1, -5));
  EXPECT_EQ(setup.stock_box.upper, Vec3(50, 60, 0));
  ASSERT_EQ(setup.tools.size(), 3U);
  EXPECT_EQ(setup.tools.at(1).shape, ToolShape::v);
  EXPECT_NEAR(setup.tools.at(1).angle, pi / 2, 1e-12);
  EXPECT_EQ(setup.tools.at(2).shape, ToolShape::ball);
  EXPECT_DOUBLE_EQ(setup.tools.at(2).diameter, 6.35);
  EXPECT_DOUBLE_EQ(setup.tools.at(2).flute, 25.4);
  EXPECT_DOUBLE_EQ(setup.tools.at(3).tip_diameter, 4);
  EXPECT_NEAR(setup.tools.at(3).angle, pi / 2, 1e-12);
}

TEST(Camotics, WorkpiecesFollowThePathsWhereTheyAreTold) {
  const Project project(
      std::string("{") + tools + R"(, "workpiece": {"automatic": true, "margin": 10}, "files": ["part.nc"]})",
      "G21 G90 F100\nG0 X-50 Z5\nG0 X0\nG1 Z-2\nG1 X20\nG1 Y10\nM2\n");
  const Box box = project.read().stock_box;
  EXPECT_EQ(box.lower, Vec3(-2, -2, -4));
  EXPECT_EQ(box.upper, Vec3(22, 12, 0));
}

TEST(Camotics, NonsenseIsRefusedInALine) {
  const std::string box = R"(, "workpiece": {"bounds": {"min": [0, 0, -5], "max": [5, 6, 0]}}})";
  for (const std::string& text :
       {std::string("{"), std::string("[1, 2]"), "{\"tools\": {}" + box, "{\"tools\": 5" + box,
        std::string("{") + tools + "}", std::string("{\"units\": \"furlongs\", ") + tools + box,
        "{\"tools\": {\"1\": {\"shape\": \"spoon\", \"length\": 1, \"diameter\": 1}}" + box,
        "{\"tools\": {\"1\": {\"shape\": \"conical\", \"length\": \"x\", \"diameter\": 1}}" + box,
        std::string("{") + tools + R"(, "workpiece": {"bounds": {"min": [0, 0, 0], "max": [5, 6, 0]}}})",
        std::string("{") + tools + R"(, "workpiece": {"automatic": true}, "files": ["part.tpl"]})"})
    try {
      (void)Project(text).read();
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input) << text;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace fieldfab::cam
