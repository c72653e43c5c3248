// Tools that are too short for a job: the depth that they reach, proved by simulation of the
// planned program.
#include "fieldfab/cam/plan/planned_stock.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../cam_tools.h"
#include "../family.h"
#include "fieldfab/cam/job/job.h"
#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

/// A block of 40 x 40 x 30 mm with a pocket of 20 x 16 mm, 25 mm deep.
const char* const block = "max(max(max(abs(x)-20, abs(y)-20), max(z, -30-z)), -max(max(abs(x)-10, abs(y)-8), -25-z))";

class DeepJobs : public ::testing::Test {
 protected:
  DeepJobs() { std::filesystem::create_directories(folder_); }
  ~DeepJobs() override { std::filesystem::remove_all(folder_); }

  /// Plans a job for the block and writes its program.
  Job plan(const std::string& tools, const std::string& operations, const std::string& machine = "linuxcnc") {
    const std::string text =
        fmt::format("machine = \"{}\"\n[input]\n[stock]\nmargin = 1\ntop = 1\n{}{}", machine, tools, operations);
    write_file(folder_ / "job.toml", text);
    Job job = Job::parse(text, folder_ / "job.toml", formula(block));
    job.run();
    job.write(folder_ / "program.ngc");
    return job;
  }
  /// Simulates the program, with the default cell or another one, and expects no events.
  SimulationResult proved(double cell = 0) {
    SimulationSetup setup = read_simulation_setup(folder_ / "job.toml", formula(block));
    if (cell > 0) setup.sampling.cell = cell;
    SimulationResult result = simulate(setup, folder_ / "program.ngc");
    for (const SimulationEvent& event : result.events()) ADD_FAILURE() << event.first_line << ": " << event.message;
    return result;
  }
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("fieldfab_deep_{}", ::getpid());
};

std::string tool_table(int number, const std::string& sizes) {
  return fmt::format("[[tool]]\nnumber = {}\ndiameter = 6\n{}\n", number, sizes);
}

/// Coarse, since depths do not depend on it.
const std::string surface = "cell = 0.4\nsurface_tolerance = 0.05\n";
const std::string rough = "[[operation]]\ntype = \"rough\"\nallowance = 0\nstepdown = 3\n" + surface;

// A shank no wider than the flutes follows them down, level by level.
TEST_F(DeepJobs, GoAsDeepAsAskedWhereUpperLevelsMadeRoom) {
  const auto moves = [&] {
    const std::string text = read_file(folder_ / "program.ngc", 1 << 20);
    return text.substr(text.find("(1 rough)"));  // the head lists the tool's sizes
  };
  plan(tool_table(1, ""), rough);
  const std::string endless = moves();
  for (const char* sizes : {"flute = 12\nlength = 40", "flute = 12\nshank = 5\nlength = 40"}) {
    const Job job = plan(tool_table(1, sizes), rough);
    EXPECT_TRUE(job.notes().empty()) << job.notes().front();
    EXPECT_EQ(moves(), endless);
  }
  proved();
}

TEST_F(DeepJobs, BackOutWhereTheShankIsTooWide) {
  const Job job = plan(tool_table(1, "flute = 12\nshank = 8\nlength = 40"), rough);
  ASSERT_EQ(job.notes().size(), 1u);
  EXPECT_NE(job.notes()[0].find("1 rough: tool 1 is too short with flutes of 12 mm"), std::string::npos)
      << job.notes()[0];
  const SimulationResult result = proved();
  EXPECT_GT(result.report().removed, 6000);  // a flute's length of the pocket, and more in its middle
  if (sample_or_all(false, true)) proved(0.11);
}

TEST_F(DeepJobs, BackOutInOneDeepPass) {
  const Job job = plan(tool_table(1, "flute = 12\nlength = 40"), "[[operation]]\ntype = \"profile\"\n");
  ASSERT_EQ(job.notes().size(), 1u);
  proved();
  if (sample_or_all(false, true)) proved(0.13);
  // At the flutes' length below the stock's top, at most a cell and a quarter higher.
  double lowest = 0;
  for (std::size_t k = 1; k < job.program().sections[0].moves.size(); ++k) {
    const Move &from = job.program().sections[0].moves[k - 1], &to = job.program().sections[0].moves[k];
    if ((from.to - to.to).head<2>().norm() > 1) lowest = std::min(lowest, to.to.z());
  }
  EXPECT_GE(lowest, -11.0);
  EXPECT_LE(lowest, -11.0 + 1.25 * StockSettings::usual_cell(job.stock()) + 0.01);
}

TEST_F(DeepJobs, LeaveTheRestToALongerTool) {
  const std::string finish = fmt::format("[[operation]]\ntype = \"finish\"\nstepover = {}\n", sample_or_all(0.3, 0.1));
  const std::string tools = tool_table(1, "shape = \"ball\"\nflute = 12\nshank = 9\nlength = 40") +
                            tool_table(2, "shape = \"ball\"\nflute = 40\nlength = 60");
  const Job job = plan(tools, finish + "tool = 1\n" + finish + "tool = 2\nplane = \"top\"\n");
  ASSERT_EQ(job.notes().size(), 1u);
  const SimulationResult result = proved();
  // The pocket has the full depth of the part.
  EXPECT_FALSE(result.stock().solid({result.stock().lattice().cells()[0] / 2, result.stock().lattice().cells()[1] / 2,
                                     static_cast<int>((30 - 24.5) / result.stock().lattice().spacing().z())}));
}

TEST_F(DeepJobs, BackOutFromOtherSides) {
  for (const char* machine : {"five_axis_ac", "linuxcnc"}) {
    const Job job = plan(tool_table(1, "flute = 8\nshank = 8\nlength = 60"),
                         "[[operation]]\ntype = \"rough\"\nstepdown = 4\nplane = \"front\"\n" + surface, machine);
    EXPECT_EQ(job.notes().size(), 1u) << machine;
    proved();
  }
}

TEST_F(DeepJobs, HoldersThatMeetMaterialAreErrors) {
  try {
    plan(tool_table(1, "flute = 12\nlength = 20\nholder_diameter = 30"), rough);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("the holder of tool 1 meets material"), std::string::npos) << error.what();
    EXPECT_NE(error.place().find("job.toml:"), std::string::npos) << error.place();
  }
}

// Passes that only repeat a higher level in the air are removed.
TEST_F(DeepJobs, LeaveOutPassesThatCutNothing) {
  const Box box{{-20, -20, -30}, {20, 20, 0}};
  PlannedStock stock(box, StockSettings::usual_cell(box));
  Tool cutter = tool("flat", 6);
  cutter.flute = 10, cutter.shank = 8;
  std::vector<Move> moves{{{-30, 0, 5}}};
  for (const double z : {-8.0, -16.0, -24.0}) {
    moves.push_back({{-30, 0, 5}});
    moves.push_back({{-30, 0, z}, 200});
    moves.push_back({{30, 0, z}, 600});
    moves.push_back({{30, 0, 5}});
  }
  BackedOut report;
  const std::vector<Move> done = stock.back_out(moves, cutter, Plane{}, 200, report);
  EXPECT_NEAR(report.most, 14, 0.3);
  EXPECT_NEAR(report.length, 2 * 48, 8);
  int passes = 0;
  for (std::size_t k = 1; k < done.size(); ++k)
    if (!done[k].rapid() && done[k - 1].rapid()) ++passes;
  EXPECT_EQ(passes, 2) << "the third pass goes no deeper than the second one";
  // Rapids keep their height if nothing is in the way.
  for (std::size_t k = 1; k < done.size(); ++k)
    if (done[k].rapid() && done[k].to.head<2>() != done[k - 1].to.head<2>())
      EXPECT_TRUE(done[k].to.z() == 5 && done[k - 1].to.z() == 5);
}

TEST(DeepCuts, AreLookedForWhereTheShankMayComeIntoTheStock) {
  const Box stock{{0, 0, -20}, {10, 10, 0}};
  Tool cutter = tool("flat", 6);
  const std::vector<Move> moves{{{0, 0, 5}}, {{0, 0, -12}, 200}};
  EXPECT_FALSE(may_be_too_deep(moves, cutter, Plane{}, stock));
  cutter.flute = 12;
  EXPECT_FALSE(may_be_too_deep(moves, cutter, Plane{}, stock));
  cutter.flute = 11.5;
  EXPECT_TRUE(may_be_too_deep(moves, cutter, Plane{}, stock));
  cutter.flute = 0, cutter.length = 11;
  EXPECT_TRUE(may_be_too_deep(moves, cutter, Plane{}, stock));
}

}  // namespace
}  // namespace fieldfab::cam
