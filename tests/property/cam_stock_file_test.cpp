// A stock that is saved and read again is equal bit for bit, and further cuts have equal results.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <random>

#include "../cam_tools.h"
#include "fieldfab/cam/base/tool_solid.h"
#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

const std::filesystem::path path =
    std::filesystem::temp_directory_path() / fmt::format("stock_file_{}.fieldstock", ::getpid());

struct Remove {
  ~Remove() { std::filesystem::remove(path); }
} at_the_end;

std::string bytes_of(const Stock& stock) {
  write_stock(stock, path);
  return read_file(path);
}

/// Random cuts by a tool from any side.
void cut(Stock& stock, const ToolSolid& tool, std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 13), lean(-1, 1);
  std::vector<Stroke> strokes;
  Vec3 at(place(random), place(random), place(random));
  for (int i = 0; i < count; ++i) {
    const Vec3 to(place(random), place(random), place(random)),
        axis = Vec3(lean(random), lean(random), 1.2).normalized();
    for (const ToolPiece& piece : tool.pieces)
      strokes.push_back({&piece, {at, axis}, {to, axis}, static_cast<std::uint32_t>(i + 1), true});
    at = to;
  }
  stock.cut(strokes);
}

RC_GTEST_PROP(SavedStock, IsTheSameAndIsCutOnAlike, (std::uint32_t seed)) {
  StockSettings settings;
  settings.cell = *rc::gen::element(0.2, 0.35, 0.5);
  settings.brick = *rc::gen::element(0, 8, 64);
  settings.both_ends = *rc::gen::arbitrary<bool>();
  settings.tolerance = *rc::gen::element(0.0, 0.01);
  if (*rc::gen::arbitrary<bool>()) settings.rules = {SplitRule::random_selection};
  if (*rc::gen::arbitrary<bool>()) settings.cell_height = 3;
  const Box box{{0, 0, 0}, {12, 12, 6}};
  Tool cutter = tool(*rc::gen::element<std::string>("flat", "ball"), 3);
  cutter.flute = 8;
  const ToolSolid solid = tool_solid(cutter);
  Stock stock =
      *rc::gen::arbitrary<bool>() ? Stock(box, settings) : Stock(*formula("sqrt(x*x+y*y+z*z) - 11"), box, settings);
  cut(stock, solid, seed, *rc::gen::inRange(0, 20));
  const std::string saved = bytes_of(stock);
  Stock again = read_stock(path);
  RC_ASSERT(bytes_of(again) == saved);
  RC_ASSERT(again.volume() == stock.volume());
  cut(stock, solid, seed + 1, 12);
  cut(again, solid, seed + 1, 12);
  RC_ASSERT(bytes_of(again) == bytes_of(stock));
  std::vector<std::uint32_t> cuts, cuts_again;
  // A file has no strokes, which sharp edges need.
  const TriangleMesh mesh = stock.mesh(&cuts, Progress::none(), StockEdges::sampled),
                     mesh_again = again.mesh(&cuts_again, Progress::none(), StockEdges::sampled);
  RC_ASSERT(mesh.vertices == mesh_again.vertices);
  RC_ASSERT(mesh.triangles == mesh_again.triangles);
  RC_ASSERT(cuts == cuts_again);
}

RC_GTEST_PROP(SavedStock, IsRefusedWhereDamaged, (std::uint32_t seed)) {
  Stock stock({{0, 0, 0}, {12, 12, 6}}, {.cell = 0.5});
  Tool cutter = tool("ball", 3);
  cut(stock, tool_solid(cutter), seed, 5);
  std::string bytes = bytes_of(stock);
  const auto at = *rc::gen::inRange<std::size_t>(0, bytes.size());
  if (*rc::gen::arbitrary<bool>())
    bytes.resize(at);
  else
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << *rc::gen::inRange(0, 8)));
  write_file(path, bytes);
  try {
    (void)read_stock(path);
    RC_FAIL("it was read");
  } catch (const Error& error) {
    RC_ASSERT(error.kind() == ErrorKind::bad_input);
    RC_ASSERT(error.place() == path.string());
    RC_ASSERT(std::string(error.what()).find('\n') == std::string::npos);
  }
}

// Two set-ups, the second with the stock of the first, give the same result as one set-up with both
// programs.
TEST(SavedStock, IsWhatASecondSetUpBeginsWith) {
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("stock_setups_{}", ::getpid());
  std::filesystem::create_directories(folder);
  const std::string tools = "[[tool]]\nnumber = 1\ndiameter = 3\nflute = 10\n";
  write_file(folder / "first.toml",
             "machine = \"linuxcnc\"\ncell = 0.3\n[stock]\nlower = [0, 0, -8]\nupper = [20, 20, 0]\n" + tools);
  write_file(folder / "second.toml", "machine = \"linuxcnc\"\n[stock]\nfile = \"first.fieldstock\"\n" + tools);
  write_file(folder / "a.ngc", "T1 M6\nS1000 M3\nG0 X-3 Y5 Z5\nG0 Z-3\nG1 X23 Y9 F500\nG0 Z5\nM2\n");
  write_file(folder / "b.ngc", "T1 M6\nS1000 M3\nG0 X5 Y-3 Z5\nG0 Z-4.2\nG1 X9 Y23 F500\nG0 Z5\nM2\n");
  const SimulationResult first = simulate(read_simulation_setup(folder / "first.toml"), folder / "a.ngc");
  write_stock(first.stock(), folder / "first.fieldstock");
  SimulationSetup setup = read_simulation_setup(folder / "second.toml");
  EXPECT_EQ(setup.sampling.cell, 0.3);
  const SimulationResult second = simulate(setup, folder / "b.ngc");
  const SimulationResult both =
      simulate(read_simulation_setup(folder / "first.toml"), std::vector{folder / "a.ngc", folder / "b.ngc"});
  Stock one = second.stock(), other = both.stock();
  one.forget_cuts(), other.forget_cuts();
  EXPECT_EQ(bytes_of(one), bytes_of(other));
  EXPECT_EQ(second.report().removed + first.report().removed, both.report().removed);
  // Cuts of the first program have no line numbers of the second.
  for (const int line : second.lines_of_vertices()) EXPECT_TRUE(line == 0 || line == 4 || line == 5) << line;
  setup.sampling.cell = 0.1;
  EXPECT_THROW(simulate(setup, folder / "b.ngc"), Error);
  write_file(folder / "third.toml",
             "machine = \"linuxcnc\"\ncell = 0.1\n[stock]\nfile = \"first.fieldstock\"\n" + tools);
  EXPECT_THROW((void)read_simulation_setup(folder / "third.toml"), Error);
  // A job may start with it, too.
  write_file(folder / "part.frep", "max(max(abs(x-10)-8, abs(y-10)-8), max(z+2, -8-z))");
  write_file(folder / "job.toml",
             "machine = \"linuxcnc\"\n[input]\nmodel = \"part.frep\"\n[stock]\nfile = \"first.fieldstock\"\n" + tools +
                 "[[operation]]\ntype = \"rough\"\n");
  const SimulationSetup job = read_simulation_setup(folder / "job.toml");
  ASSERT_TRUE(job.saved);
  EXPECT_EQ(job.saved->volume(), first.stock().volume());
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace fieldfab::cam
