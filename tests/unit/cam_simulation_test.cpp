// Simulation: what it remembers, against programs that end early.
#include "fieldfab/cam/simulate/simulation.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "fieldfab/cam/simulate/playback.h"
#include "fieldfab/core/file.h"

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
    std::filesystem::path at = std::filesystem::temp_directory_path() / fmt::format("fieldfab_simulation_{}", ::getpid());
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
  Simulation simulation(setup());
  Playback& playback = simulation.remember();
  simulation.run(write("whole.nc", lines));
  EXPECT_GT(playback.moves(), 120u);
  EXPECT_EQ(playback.stock_after(playback.moves()).mesh().triangles, simulation.stock().mesh().triangles);
  for (const int line : {50, 4, 131, 62, 64, 130, 90, 7}) {
    Simulation shorter(setup());
    shorter.run(write("shorter.nc", {lines.begin(), lines.begin() + line}));
    const std::size_t done = playback.done_after_line(line);
    const TriangleMesh then = playback.stock_after(done).mesh(), ended = shorter.stock().mesh();
    // Where strokes are put together otherwise, samples may be rounded otherwise.
    ASSERT_EQ(then.vertices.size(), ended.vertices.size()) << line;
    EXPECT_EQ(then.triangles, ended.triangles) << line;
    for (std::size_t v = 0; v < then.vertices.size(); ++v)
      for (std::size_t a = 0; a < 3; ++a) ASSERT_NEAR(then.vertices[v][a], ended.vertices[v][a], 1e-5) << line;
    ASSERT_GT(done, 0u);
    EXPECT_EQ(playback.move(done - 1).line, shorter.report().lines.back().line);
    EXPECT_NEAR(playback.move(done - 1).seconds, shorter.report().seconds, 1e-6);
    EXPECT_EQ(playback.done_after_seconds(playback.move(done - 1).seconds + 1e-9), done);
  }
  EXPECT_EQ(playback.stock_after(0).volume(), Stock(setup().stock_box, setup().sampling).volume());
}

// Many copies, and room for few: any moment is still the right one.
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
  Playback plenty(blank), scarce(blank, 100'000);
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
    for (Playback* p : {&plenty, &scarce}) {
      p->add({i + 1, 1, false, i + 1.0}, tool, cut, std::array{at, to});
      p->keep(stock);
    }
    volumes.push_back(stock.volume());
    at = to;
  }
  for (int k = 0; k < 60; ++k) {
    const auto moment = static_cast<std::size_t>(std::uniform_int_distribution<int>(0, 300)(random));
    EXPECT_NEAR(plenty.stock_after(moment).volume(), volumes[moment], 1e-3) << moment;  // of 2000 mm3
    EXPECT_NEAR(scarce.stock_after(moment).volume(), volumes[moment], 1e-3) << moment;
  }
}

TEST_F(SimulationFiles, CancelledMomentsDoNoHarm) {
  Simulation simulation(setup());
  Playback& playback = simulation.remember();
  simulation.run(write("whole.nc", program(60)));
  Progress stopped;
  stopped.cancel();
  const double before = playback.stock_after(20).volume();
  EXPECT_ANY_THROW(playback.stock_after(50, stopped));
  EXPECT_EQ(playback.stock_after(20).volume(), before);
}

TEST_F(SimulationFiles, TheFirstMoveIsHeldAgainstLimitsAsWell) {
  SimulationSetup limited = setup();
  limited.limits[0] = {0, 20};
  Simulation simulation(limited);
  simulation.run(write("far.nc", {"G21 G90", "T1 M6", "G0 X-5 Y3 Z5", "G1 X5 F100", "M2"}));
  ASSERT_EQ(simulation.report().events.size(), 1u);
  EXPECT_EQ(simulation.report().events[0].line, 3);
  EXPECT_EQ(to_string(simulation.report().events[0].kind), "over-travel");
}

}  // namespace
}  // namespace fieldfab::cam
