// Playback of simulations, against programs that end early.
#include "fieldfab/cam/simulate/simulate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <random>

#include "fieldfab/cam/simulate/playback.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/operations.h"

namespace fieldfab::cam {
namespace {

/// Two tools on a block of 20 x 20 x 8 mm.
SimulationSetup setup() {
  SimulationSetup made;
  made.stock_box = {{0, 0, -8}, {20, 20, 0}};
  made.sampling.cell = 0.25;
  for (const int number : {1, 2}) {
    Tool tool;
    tool.number = number;
    tool.shape = number == 1 ? ToolShape::flat : ToolShape::ball;
    tool.diameter = 3;
    tool.flute = 4;
    tool.length = 20;
    tool.shank = 2.5;
    made.tools[number] = tool;
  }
  return made;
}

class SimulationFiles : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::vector<std::string>& lines) {
    const auto path = folder_.path() / name;
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    write_file(path, text);
    return path;
  }
  struct Folder {
    std::filesystem::path at =
        std::filesystem::temp_directory_path() / fmt::format("fieldfab_simulation_{}", ::getpid());
    Folder() { std::filesystem::create_directories(at); }
    ~Folder() { std::filesystem::remove_all(at); }
    [[nodiscard]] const std::filesystem::path& path() const { return at; }
  } folder_;
};

/// Random feeds and rapids with two tools; some too deep for the flutes.
std::vector<std::string> program(int moves) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> across(0, 20), deep(-6, 1);
  std::vector<std::string> lines{"G21 G90 G17", "T1 M6", "S1000 M3", "G0 X-5 Y-5 Z5"};
  for (int i = 0; i < moves; ++i) {
    if (i == moves / 2) lines.emplace_back("T2 M6"), lines.emplace_back("G0 X-5 Y-5 Z5");
    if (i % 17 == 0) lines.push_back(fmt::format("G0 X{:.3f} Y{:.3f} Z5", across(random), across(random)));
    lines.push_back(fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f} F600", across(random), across(random), deep(random)));
  }
  lines.emplace_back("M2");
  return lines;
}

TEST_F(SimulationFiles, AnyMomentIsWhatAProgramLeavesThatEndsThere) {
  const std::vector<std::string> lines = program(120);
  const SimulationResult result = simulate(setup(), write("whole.nc", lines), {.remember = true});
  const Playback& playback = *result.playback();
  Playhead head(result.playback());
  EXPECT_GT(playback.moves(), 120u);
  EXPECT_EQ(head.stock_after(playback.moves()).mesh().triangles, result.stock().mesh().triangles);
  for (const int line : {50, 4, 131, 62, 64, 130, 90, 7}) {
    const SimulationResult shorter = simulate(setup(), write("shorter.nc", {lines.begin(), lines.begin() + line}));
    const std::size_t done = playback.done_after_line(line);
    const TriangleMesh then = head.stock_after(done).mesh(), ended = shorter.stock().mesh();
    // Strokes that are grouped differently may be rounded differently.
    ASSERT_EQ(then.vertices.size(), ended.vertices.size()) << line;
    EXPECT_EQ(then.triangles, ended.triangles) << line;
    for (std::size_t v = 0; v < then.vertices.size(); ++v)
      for (std::size_t a = 0; a < 3; ++a) ASSERT_NEAR(then.vertices[v][a], ended.vertices[v][a], 1e-5) << line;
    ASSERT_GT(done, 0u);
    EXPECT_EQ(playback.move(done - 1).line, shorter.report().lines.back().line);
    EXPECT_NEAR(playback.move(done - 1).seconds, shorter.report().seconds, 1e-6);
    EXPECT_EQ(playback.done_after_seconds(playback.move(done - 1).seconds + 1e-9), done);
  }
  EXPECT_EQ(head.stock_after(0).volume(), Stock(setup().stock_box, setup().sampling).volume());
}

// Many copies and little memory: every moment is still correct.
TEST(Playback, IsRightHoweverFewCopiesItKeeps) {
  Tool cutter;
  cutter.diameter = 3;
  cutter.flute = 8;
  const auto tool = std::make_shared<const ToolSolid>(tool_solid(cutter));
  StockSettings sampling;
  sampling.cell = 0.4;
  sampling.brick = 8;
  const Stock blank({{0, 0, -8}, {20, 20, 0}}, sampling);
  Stock stock = blank;
  const auto plenty = std::make_shared<Playback>(blank), scarce = std::make_shared<Playback>(blank, 100'000);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> across(0, 20), deep(-6, -1);
  std::vector<double> volumes{stock.volume()};
  ToolPose at{{10, 10, 1}, Vec3::UnitZ()};
  for (int i = 0; i < 300; ++i) {
    const ToolPose to{{across(random), across(random), deep(random)}, Vec3::UnitZ()};
    const auto cut = static_cast<std::uint32_t>(2 * i + 1);
    std::vector<Stroke> strokes;
    add_strokes(*tool, ToolRole::cutting, at, to, cut, true, strokes);
    stock.cut(strokes);
    for (Playback* p : {plenty.get(), scarce.get()}) {
      p->add({i + 1, 1, false, i + 1.0}, tool, cut, std::array{at, to});
      p->keep(stock);
    }
    volumes.push_back(stock.volume());
    at = to;
  }
  Playhead head_of_plenty(plenty), head_of_scarce(scarce);
  for (int k = 0; k < 60; ++k) {
    const auto moment = static_cast<std::size_t>(std::uniform_int_distribution<int>(0, 300)(random));
    // of 2000 mm3
    EXPECT_NEAR(head_of_plenty.stock_after(moment).volume(), volumes[moment], 1e-3) << moment;
    EXPECT_NEAR(head_of_scarce.stock_after(moment).volume(), volumes[moment], 1e-3) << moment;
  }
}

TEST_F(SimulationFiles, CancelledMomentsDoNoHarm) {
  const SimulationResult result = simulate(setup(), write("whole.nc", program(60)), {.remember = true});
  Playhead head(result.playback());
  Progress stopped;
  stopped.cancel();
  const double before = head.stock_after(20).volume();
  EXPECT_ANY_THROW(head.stock_after(50, stopped));
  EXPECT_EQ(head.stock_after(20).volume(), before);
}

TEST_F(SimulationFiles, TheFirstMoveIsHeldAgainstLimitsAsWell) {
  SimulationSetup limited = setup();
  limited.limits[0] = {0, 20};
  const SimulationResult result =
      simulate(limited, write("far.nc", {"G21 G90", "T1 M6", "G0 X-5 Y3 Z5", "G1 X5 F100", "M2"}));
  ASSERT_EQ(result.events().size(), 1u);
  EXPECT_EQ(result.events()[0].move.line, 3);
  EXPECT_EQ(name_of(result.events()[0].kind), "over-travel");
}

TEST_F(SimulationFiles, TheMachinesZeroIsAboveTheWorkWhereNobodySaysWhereItIs) {
  const auto program = write("home.ngc", {"G21 G90 G17", "T1 M6", "G43 H1", "S1000 M3", "G53 G0 Z0", "G0 X5 Y5",
                                          "G0 Z2", "G1 Z-1 F300", "G1 X15", "G28 G91 Z0", "G90 G0 X-5 Y-5", "M2"});
  const std::string set_up =
      "[stock]\nlower = [0, 0, -8]\nupper = [20, 20, 0]\n"
      "[[tool]]\nnumber = 1\nshape = \"flat\"\ndiameter = 3\nflute = 6\nlength = 20\n";
  const auto events = [&](const std::string& more) {
    const SimulationSetup read = read_simulation_setup(write("setup.toml", {more, set_up}));
    return simulate(read, program).events().size();
  };
  EXPECT_EQ(events(""), 0u);
  // There, axes at 0 are a tip 20 mm below the stock's top: rapids in the material.
  EXPECT_GT(events("zero = [0, 0, 0]"), 0u);
}

// A contact is as deep as the tool goes, also between the planes of the lattice, which are 0.25 mm apart.
TEST_F(SimulationFiles, ContactsCountFromTheirLeastDepthOn) {
  SimulationSetup fine = setup();
  fine.touch = 0.02;
  const auto events = [&](double z) {
    const auto path = write(
        "low.nc", {"G21 G90", "T1 M6", "S1000 M3", "G0 X-5 Y10 Z5", fmt::format("G0 Z{}", z), "G0 X30", "G0 Z5", "M2"});
    return simulate(fine, path).events();
  };
  EXPECT_TRUE(events(0).empty());
  EXPECT_TRUE(events(-0.015).empty());
  for (const double z : {-0.03, -0.1, -0.2, -0.26}) {
    const auto found = events(z);
    ASSERT_EQ(found.size(), 1u) << z;
    EXPECT_EQ(name_of(found[0].kind), "rapid contact");
    EXPECT_EQ(found[0].move.line, 6);
    EXPECT_NEAR(found[0].amount, 20 * 2.96 * (-z - 0.02), 0.1 * 60 * (-z - 0.02)) << z;
    EXPECT_LE(found[0].place.z(), 0);
    EXPECT_GE(found[0].place.z(), z);
  }
}

// Nobody said how high the tool hangs before the program moves Z: a rapid to the first place and length compensation
// are no contacts. What follows is examined.
TEST_F(SimulationFiles, TheHeightIsUnknownUntilZMoves) {
  const std::string set_up =
      "[stock]\nlower = [0, 0, -8]\nupper = [20, 20, 4]\n"
      "[[tool]]\nnumber = 1\nshape = \"flat\"\ndiameter = 3\nflute = 16\nlength = 60\n";
  const auto lines_of = [&](const std::vector<std::string>& lines, const std::string& more) {
    const SimulationSetup read = read_simulation_setup(write("setup.toml", {more, set_up}));
    const SimulationResult result = simulate(read, write("begin.nc", lines));
    std::vector<int> found;
    for (const SimulationEvent& event : result.events()) found.push_back(event.move.line);
    return found;
  };
  const std::vector<std::string> first{"G21 G90", "T1 M6", "S1000 M3", "G54 G0 X5 Y5", "G43 H1 Z10"};
  const std::vector<std::string> second{"G21 G90", "T1 M6", "S1000 M3", "G43 H1", "G0 X5 Y5", "G0 Z10"};
  for (std::vector<std::string> lines : {first, second}) {
    lines.insert(lines.end(), {"G1 Z-1 F300", "X15", "M2"});
    EXPECT_EQ(lines_of(lines, ""), std::vector<int>{});
    lines.insert(lines.end() - 1, {"G0 Y15", "Z10"});
    EXPECT_EQ(lines_of(lines, ""), std::vector<int>{static_cast<int>(lines.size()) - 2});
    // Given heights are examined from the start.
    EXPECT_GT(lines_of(lines, "start = [0, 0, 2]").size(), 1u);
  }
  // A cutter that never moves along Z is at Z 0.
  EXPECT_EQ(lines_of({"G21 G90", "T1 M6", "S1000 M3", "G0 X-5 Y5", "G1 X5 F300", "G0 X15", "M2"}, ""),
            std::vector<int>{6});
}

// The shank meets the wall on lines of two passes, the deeper ones last: two events, each with its
// lines and worst place.
TEST_F(SimulationFiles, EventsOfOneKindAlongAPassAreOne) {
  SimulationSetup wide = setup();
  wide.tools[1].shank = 4;
  const SimulationResult result =
      simulate(wide, write("two.nc", {"G21 G90", "T1 M6", "S1000 M3", "G0 X-5 Y4 Z5", "Z-4.5", "G1 X8 F600", "X12 Z-5",
                                      "X30 Z-6", "G0 Z5", "X-5 Y14", "Z-5", "G1 X30", "G0 Z5", "M2"}));
  ASSERT_EQ(result.events().size(), 2u);
  const SimulationEvent &first = result.events()[0], &second = result.events()[1];
  EXPECT_EQ(first.kind, SimulationEvent::Kind::shank_contact);
  EXPECT_EQ(first.first_line, 6);
  EXPECT_EQ(first.last_line, 8);
  EXPECT_EQ(first.move.line, 8);  // the longest and deepest
  EXPECT_GT(first.place.x(), 11);
  EXPECT_NE(first.message.find("; it is the worst of lines 6 to 8"), std::string::npos) << first.message;
  EXPECT_EQ(second.first_line, 12);
  EXPECT_EQ(second.last_line, 12);
  EXPECT_EQ(second.message.find("worst of"), std::string::npos);
}

// Gouges are found at the end, but belong to the passes that cut them.
TEST_F(SimulationFiles, GougesOfOnePassAreOne) {
  SimulationSetup aimed = setup();
  aimed.target = box_field({{0, 0, -8}, {20, 20, -2}});
  const SimulationResult result =
      simulate(aimed, write("deep.nc", {"G21 G90", "T1 M6", "S1000 M3", "G0 X-5 Y4 Z5", "Z-2.2", "G1 X8 F600",
                                        "X12 Z-3", "X30", "G0 Z5", "X-5 Y14", "Z-2.5", "G1 X30", "M2"}));
  ASSERT_EQ(result.events().size(), 2u);
  EXPECT_EQ(result.events()[0].first_line, 6);
  EXPECT_EQ(result.events()[0].last_line, 8);
  EXPECT_NEAR(result.events()[0].amount, 1, 1e-3);
  EXPECT_EQ(result.events()[1].move.line, 12);
  EXPECT_NEAR(result.events()[1].amount, 0.5, 1e-3);
}

// Two consecutive programs leave the same material as one combined program, and events name the
// program.
TEST_F(SimulationFiles, ProgramsInARow) {
  const std::vector<std::string> head{"G21 G90", "T1 M6", "S1000 M3"};
  const std::vector<std::string> one{"G0 X-5 Y4 Z5", "Z-3", "G1 X30 F600", "G0 Z5"},
      two{"G0 X-5 Y14 Z5", "Z-3", "G0 X30", "Z5"};
  const auto joined = [&](std::vector<std::string> lines, const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
  };
  SimulationSetup both = setup();
  // the tool stays in the spindle
  both.programs = {write("one.nc", joined(head, one)), write("two.nc", joined({"G21 G90", "S1000 M3"}, two))};
  const SimulationResult row = simulate(both, std::vector<std::filesystem::path>{}, {.remember = true});
  const SimulationResult whole = simulate(setup(), write("whole.nc", joined(joined(head, one), two)));
  EXPECT_EQ(row.stock().volume(), whole.stock().volume());
  EXPECT_EQ(row.surface().mesh.triangles, whole.surface().mesh.triangles);
  EXPECT_EQ(row.report().programs, both.programs);
  ASSERT_EQ(row.events().size(), 1u);  // the rapid through material
  EXPECT_EQ(row.events()[0].move.program, 1);
  EXPECT_EQ(row.events()[0].move.line, 5);
  const Playback& playback = *row.playback();
  EXPECT_EQ(playback.done_after_line(7, 0), 4u);
  EXPECT_EQ(playback.done_after_line(1, 1), 4u);
  EXPECT_EQ(playback.done_after_line(5, 1), 7u);
  EXPECT_EQ(row.report().lines.back().program, 1);
  EXPECT_THROW((void)simulate(setup(), std::vector<std::filesystem::path>{}), Error);
  // Programs in JavaScript are reported as such, whether the files exist or not.
  try {
    (void)simulate(setup(), "missing.tpl");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
  }
}

// A result is a value: it outlives its sources, and two positions in its playback are independent.
TEST_F(SimulationFiles, ResultsAreValues) {
  std::optional<SimulationResult> first = simulate(setup(), write("part.nc", program(40)), {.remember = true});
  const SimulationResult copy = *first;
  Playhead early(first->playback()), late(copy.playback());
  first.reset();
  const double left = late.stock_after(copy.playback()->moves()).volume(), blank = early.stock_after(0).volume();
  EXPECT_GT(blank, left);
  EXPECT_EQ(late.stock_after(copy.playback()->moves()).volume(), left);
  EXPECT_EQ(left, copy.stock().volume());
  EXPECT_EQ(copy.surface().cuts.size(), copy.surface().mesh.vertices.size());
  EXPECT_EQ(simulate(setup(), write("part.nc", program(2))).playback(), nullptr);
}

// Tool 1 has flutes of 4 mm and a shank of equal width: at a depth of 7 mm both have made the wall.
TEST_F(SimulationFiles, TellsWhichPartOfTheToolHasCut) {
  SimulationSetup wide = setup();
  wide.tools[1].shank = 4;
  const SimulationResult result =
      simulate(wide, write("deep.nc", {"G21 G90", "T1 M6", "S1000 M3", "G0 X-5 Y10 Z5", "Z-7", "G1 X30 F600", "M2"}));
  std::map<CutBy, double> highest, lowest;
  for (std::size_t v = 0; v < result.surface().cuts.size(); ++v) {
    const Cut cut = result.cuts()[result.surface().cuts[v]];
    const double z = result.surface().mesh.vertices[v][2];
    highest.try_emplace(cut.by, z).first->second = std::max(highest[cut.by], z);
    lowest.try_emplace(cut.by, z).first->second = std::min(lowest[cut.by], z);
    EXPECT_EQ(cut.move.line, cut.by == CutBy::nothing ? 0 : 6);
    EXPECT_EQ(cut.move.tool, cut.by == CutBy::nothing ? 0 : 1);
  }
  EXPECT_EQ(lowest.size(), 3u);
  EXPECT_NEAR(lowest[CutBy::tip], -7, 1e-3);
  EXPECT_NEAR(lowest[CutBy::shank], -3, 1e-3);
  EXPECT_NEAR(highest[CutBy::shank], 0, 1e-3);
}

TEST(Cuts, AreNumberedByMoveAndPartOfTheTool) {
  Cuts cuts;
  EXPECT_EQ(cuts.size(), 1u);
  const std::uint32_t first = cuts.add({12, 3}), second = cuts.add({13, 4, 1, 7});
  EXPECT_EQ(cuts[0].by, CutBy::nothing);
  EXPECT_EQ(cuts[first].by, CutBy::tip);
  EXPECT_EQ(cuts[first].move.line, 12);
  EXPECT_EQ(cuts[first].move.tool, 3);
  EXPECT_EQ(cuts[cut_number(second, ToolRole::shank)].by, CutBy::shank);
  EXPECT_EQ(cuts[cut_number(second, ToolRole::holder)].by, CutBy::holder);
  EXPECT_EQ(cuts[cut_number(second, ToolRole::holder)].move.line, 13);
  EXPECT_EQ(cuts[cut_number(second, ToolRole::holder)].move.program, 1);
  EXPECT_EQ(cuts[second].move.pass, 7u);
  EXPECT_EQ(cuts[static_cast<std::uint32_t>(cuts.size())].by, CutBy::nothing);
}

}  // namespace
}  // namespace fieldfab::cam
