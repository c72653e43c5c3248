// Names in files: tool shapes, kinds of machines and of files.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "../../cam/base/chords.h"
#include "../../cam/base/toml_table.h"
#include "../../cam/base/tool_table.h"
#include "fieldfab/cam/base/chip_load.h"
#include "fieldfab/cam/base/tool.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/cam/plan/program.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

/// The message of the error that a call throws, including its place.
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    return error.what();
  }
  return "nothing";
}

TEST(Chords, LieWithinTheToleranceOfTheirArc) {
  const auto sagitta = [](double radius, double angle) { return radius * (1 - std::cos(angle / 2)); };
  EXPECT_NEAR(chord_angle(1, 1 - std::numbers::sqrt3 / 2), std::numbers::pi / 3, 1e-12);  // a hexagon's side
  EXPECT_DOUBLE_EQ(chord_arc_length(50, 0.01), 2);
  for (const double radius : {0.02, 0.5, 10.0, 3000.0})
    for (const double tolerance : {0.001, 0.01}) {
      const double angle = chord_angle(radius, tolerance), length = chord_arc_length(radius, tolerance);
      EXPECT_NEAR(sagitta(radius, angle), tolerance, 1e-6 * tolerance) << radius;
      EXPECT_LE(sagitta(radius, length / radius), tolerance * (1 + 1e-6)) << radius;
      EXPECT_GT(length, 0.9 * radius * angle) << radius;
    }
}

TEST(Chords, OfCirclesBelowTheTolerance) {
  for (const double radius : {0.0, 0.005, 0.01, std::nan("")})
    EXPECT_DOUBLE_EQ(chord_angle(radius, 0.01), std::numbers::pi) << radius;
  EXPECT_DOUBLE_EQ(chord_arc_length(0, 0.01), chord_arc_length(0.01, 0.01));
}

TEST(Names, AreReadBack) {
  for (const ToolShape shape : {ToolShape::flat, ToolShape::ball, ToolShape::bull, ToolShape::v, ToolShape::tapered,
                                ToolShape::drill, ToolShape::profile, ToolShape::form})
    EXPECT_EQ(tool_shape_named(name_of(shape), "here"), shape);
  for (const Coolant coolant : {Coolant::none, Coolant::mist, Coolant::flood})
    EXPECT_EQ(coolant_named(name_of(coolant), "here"), coolant);
  EXPECT_EQ(name_of(Kinematics::Kind::head_table), "head-table");
  EXPECT_EQ(name_of(MachineInput::height_map), "height map");
}

TEST(Names, UnknownOnesAreRefusedWithTheNearest) {
  EXPECT_EQ(
      refusal([] { (void)tool_shape_named("bal", "job.toml:3"); }),
      "job.toml:3: shape is 'bal'; it must be one of flat, ball, bull, v, tapered, drill, profile, form; did you mean "
      "'ball'?");
  EXPECT_EQ(refusal([] { (void)coolant_named("water", "x"); }),
            "x: coolant is 'water'; it must be one of none, mist, flood");
}

// Each error names its line when the file is read.
TEST(Names, OfMachineFiles) {
  const auto read = [](const std::string& toml) {
    return refusal([&] { (void)read_machine("name = \"m\"\nextension = \".nc\"\n" + toml, "m.toml"); });
  };
  EXPECT_EQ(read("format = \"svgg\"\n"),
            "m.toml:3: format is 'svgg'; it must be one of text, dxf, svg, png, stl; did you mean 'svg'?");
  EXPECT_EQ(read("takes = \"path\"\n"),
            "m.toml:3: takes is 'path'; it must be one of paths, flat paths, height map, mesh; did you mean 'paths'?");
  EXPECT_EQ(read("[kinematics]\nkind = \"table\"\n"),
            "m.toml:4: kind is 'table'; it must be one of none, head-head, table-table, head-table");
}

/// Files in a temporary folder.
class ToolLibraries : public ::testing::Test {
 protected:
  ToolLibraries() { std::filesystem::create_directories(folder_); }
  ~ToolLibraries() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    write_file(folder_ / name, text);
    return folder_ / name;
  }
  std::vector<Tool> tools(const std::string& toml) { return read_tools(TomlTable::parse(toml, "job.toml"), folder_); }
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("fieldfab_tools_{}", ::getpid());
};

std::string bit(const std::string& shape, const std::string& parameters) {
  return fmt::format(
      R"({{"version": 2, "name": "a tool", "shape": "{}.fcstd", "parameter": {{{}}}, "attribute": {{}}}})", shape,
      parameters);
}

TEST_F(ToolLibraries, OfFreeCad) {
  write("Bit/end.fctb",
        bit("endmill", R"("CuttingEdgeHeight": "30.0000 mm", "Diameter": "1/4 in", "Length": "50.0000 mm",
    "ShankDiameter": "3.0000 mm")"));
  write("Bit/bull.fctb",
        bit("bullnose", R"("Diameter": "6.0000 mm", "FlatRadius": "1.0000 mm", "CuttingEdgeHeight": "20 mm")"));
  write("Bit/v.fctb",
        bit("v-bit", R"("Diameter": "10.0000 mm", "TipDiameter": "1.0000 mm", "CuttingEdgeAngle": "60.0000 \u00b0",
    "CuttingEdgeHeight": "1.0000 mm")"));
  write("Bit/probe.fctb", bit("probe", R"("Diameter": "6.0000 mm")"));
  write("Library/all.fctl", R"({"version": 1, "tools": [{"nr": 1, "path": "end.fctb"}, {"nr": 4, "path": "bull.fctb"},
    {"nr": 7, "path": "v.fctb"}, {"nr": 8, "path": "probe.fctb"}]})");
  const std::vector<Tool> all = tools("[[tool]]\nlibrary = \"Library/all.fctl\"\n");
  ASSERT_EQ(all.size(), 3u);  // a probe is not a cutting tool
  EXPECT_EQ(all[0].shape, ToolShape::flat);
  EXPECT_DOUBLE_EQ(all[0].diameter, 6.35);
  EXPECT_DOUBLE_EQ(all[0].flute, 30);
  EXPECT_DOUBLE_EQ(all[0].length, 50);
  EXPECT_DOUBLE_EQ(all[0].shank, 3);
  EXPECT_EQ(all[1].number, 4);
  EXPECT_EQ(all[1].shape, ToolShape::bull);
  EXPECT_DOUBLE_EQ(all[1].corner_radius, 2);
  EXPECT_EQ(all[2].shape, ToolShape::v);
  EXPECT_NEAR(all[2].angle, std::numbers::pi / 3, 1e-12);
  EXPECT_NEAR(all[2].flute, 4.5 / std::tan(std::numbers::pi / 6), 1e-9);  // up to the end of its edge
  // One of them, with settings of its own; and a single tool, with the next number.
  const std::vector<Tool> some = tools(
      "[[tool]]\nlibrary = \"Library/all.fctl\"\nnumber = 4\nlength = 33\n[[tool]]\nlibrary = \"Bit/end.fctb\"\n");
  ASSERT_EQ(some.size(), 2u);
  EXPECT_EQ(some[0].number, 4);
  EXPECT_DOUBLE_EQ(some[0].length, 33);
  EXPECT_DOUBLE_EQ(some[0].corner_radius, 2);
  EXPECT_EQ(some[1].number, 5);
}

TEST_F(ToolLibraries, OfFusion) {
  write("tools.json", R"({"version": 1, "data": [
    {"type": "bull nose end mill", "unit": "millimeters", "description": "10 mm", "post-process": {"number": 2},
     "geometry": {"DC": 10, "LB": 50, "LCF": 35, "NOF": 3, "OAL": 80, "SFDM": 12, "RE": 1.5},
     "holder": {"unit": "millimeters", "segments": [{"height": 4, "lower-diameter": 38, "upper-diameter": 50},
                                                    {"height": 21, "lower-diameter": 50, "upper-diameter": 50}]},
     "start-values": {"presets": [{"n": 12000, "v_f": 3600, "v_f_plunge": 200}]}},
    {"type": "chamfer mill", "unit": "inches", "post-process": {"number": 3},
     "geometry": {"DC": 0.5, "LCF": 0.25, "TA": 45, "tip-diameter": 0.1}},
    {"type": "probe", "unit": "millimeters", "post-process": {"number": 9}, "geometry": {"DC": 6}}]})");
  const std::vector<Tool> all = tools("[[tool]]\nlibrary = \"tools.json\"\n");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].number, 2);
  EXPECT_EQ(all[0].name, "10 mm");
  EXPECT_EQ(all[0].shape, ToolShape::bull);
  EXPECT_DOUBLE_EQ(all[0].corner_radius, 1.5);
  EXPECT_DOUBLE_EQ(all[0].length, 50);
  EXPECT_DOUBLE_EQ(all[0].holder_diameter, 50);
  EXPECT_DOUBLE_EQ(all[0].holder_length, 25);
  EXPECT_EQ(all[0].flutes, 3);
  EXPECT_DOUBLE_EQ(all[0].feed, 3600);
  EXPECT_DOUBLE_EQ(all[1].diameter, 12.7);
  EXPECT_DOUBLE_EQ(all[1].tip_diameter, 2.54);
  EXPECT_NEAR(all[1].angle, std::numbers::pi / 2, 1e-12);
}

TEST_F(ToolLibraries, RefuseNonsense) {
  write("end.fctb", bit("endmill", R"("Diameter": "6 mm")"));
  write("number.fctb", bit("endmill", R"("Diameter": "six mm")"));
  write("unit.fctb", bit("endmill", R"("Diameter": "6 parsec")"));
  write("probe.fctb", bit("probe", R"("Diameter": "6 mm")"));
  write("text.json", "tools");
  write("list.json", "{\"tools\": 3}");
  write("wrong.json", R"({"data": [{"type": "drill", "geometry": {"DC": "x"}}]})");
  write("one.fctl", R"({"tools": [{"nr": 1, "path": "end.fctb"}]})");
  const auto said = [&](const std::string& rest) {
    return refusal([&] { (void)tools("[[tool]]\nlibrary = " + rest); });
  };
  EXPECT_NE(said("\"number.fctb\"").find("Diameter is 'six mm'"), std::string::npos);
  EXPECT_NE(said("\"unit.fctb\"").find("a number with a unit"), std::string::npos);
  EXPECT_NE(said("\"probe.fctb\"").find("shape 'probe.fcstd'"), std::string::npos);
  EXPECT_NE(said("\"text.json\"").find("no tool library"), std::string::npos);
  EXPECT_NE(said("\"list.json\"").find("no tool library"), std::string::npos);
  EXPECT_NE(said("\"wrong.json\"").find("'DC' is no number"), std::string::npos);
  EXPECT_NE(said("\"one.fctl\"\nnumber = 3").find("has no tool 3"), std::string::npos);
  // ambiguous: the library has several tools
  EXPECT_NE(said("\"one.fctl\"\nlength = 3").find("length"), std::string::npos);
  EXPECT_NE(said("\"one.fctl\"\n[[tool]]\nlibrary = \"one.fctl\"").find("two tools with number 1"), std::string::npos);
}

// The chart's values at its diameters, in between and beyond them.
TEST(ChipLoads, AreThoseOfTheChart) {
  EXPECT_NEAR(chip_load("hardwood", 6.35), 0.009 * 25.4, 1e-12);
  EXPECT_NEAR(chip_load("hardwood", 12.7), 0.019 * 25.4, 1e-12);
  EXPECT_NEAR(chip_load("aluminium", 4.7625), 0.004 * 25.4, 1e-12);
  EXPECT_NEAR(chip_load("aluminium", 1), 0.003 * 25.4 / 3.175, 1e-12);
  EXPECT_NEAR(chip_load("mdf", 25), 0.025 * 25.4, 1e-12);
  for (const std::string& material : cut_materials())
    for (double diameter = 0.1; diameter < 14; diameter += 0.1)
      EXPECT_LE(chip_load(material, diameter), chip_load(material, diameter + 0.1)) << material;
  EXPECT_NE(refusal([] { (void)chip_load("aluminum", 3); }).find("did you mean 'aluminium'?"), std::string::npos);
  EXPECT_NE(refusal([] { (void)chip_load("mdf", 0); }).find("needs a diameter"), std::string::npos);
}

// Within all limits the feed is spindle times edges times chip; a slow machine turns slower, but not below the least
// cutting speed.
TEST(ChipLoads, MakeFeedsWithinTheMachinesLimits) {
  for (const std::string& material : cut_materials())
    for (const double diameter : {0.5, 1.0, 3.0, 6.0, 10.0, 20.0})
      for (const double max_feed : {0.0, 500.0, 3000.0, 20000.0})
        for (const double max_spindle : {0.0, 8000.0, 30000.0}) {
          Tool tool;
          tool.diameter = diameter, tool.flutes = 3;
          const CuttingValues v = cutting_values(material, tool, max_feed, max_spindle);
          const double chip = 3 * chip_load(material, diameter);
          const double most = max_spindle > 0 ? max_spindle : 24000;
          EXPECT_LE(v.spindle, most);
          EXPECT_LE(v.feed, std::max(1.0, v.spindle * chip));
          EXPECT_GE(v.feed, std::min(v.spindle * chip, max_feed > 0 ? max_feed : 1e9) - 1);
          if (max_feed > 0) EXPECT_LE(v.feed, max_feed);
          EXPECT_NEAR(v.plunge, v.feed / 3, 1);
          const double speed = v.spindle * std::numbers::pi * diameter / 1000;
          EXPECT_LE(speed, 600.0);
          if (max_feed == 0) EXPECT_TRUE(speed > 200 || v.spindle > most - 10) << material << diameter;
          tool.spindle = 5000;
          EXPECT_EQ(cutting_values(material, tool, max_feed, max_spindle).spindle, 5000);
        }
}

}  // namespace
}  // namespace fieldfab::cam
