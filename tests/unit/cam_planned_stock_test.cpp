// The one model of what is left: heights of planned stock from any plane against points that no tool has cut, jobs that
// start from saved stock, and second planes.
#include "fieldfab/cam/plan/planned_stock.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "../cam_tools.h"
#include "fieldfab/cam/job/job.h"
#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

const Box block{{0, 0, 0}, {20, 16, 12}};

/// Whether a vertical tool on its way along level or inclined straight moves cuts a point: poses close to one another.
bool cuts(const std::vector<Move>& moves, const Tool& cutter, const Vec3& p) {
  const Profile profile = cutter.profile();
  for (std::size_t k = 1; k < moves.size(); ++k) {
    if (moves[k].rapid()) continue;
    const Vec3 from = moves[k - 1].to, way = moves[k].to - from;
    const int steps = 1 + static_cast<int>(way.norm() / 0.01);
    for (int i = 0; i <= steps; ++i) {
      const Vec3 tip = from + way * i / steps;
      const double away = (p - tip).head<2>().norm();
      if (away < profile.radius() && p.z() > tip.z() + profile.height(away)) return true;
    }
  }
  return false;
}

std::vector<Move> random_moves(const Box& box, std::mt19937& random, int count) {
  std::uniform_real_distribution<double> share(0, 1);
  const auto place = [&] {
    return Vec3(box.lower + box.size().cwiseProduct(Vec3(share(random), share(random), 0.4 + 0.6 * share(random))));
  };
  std::vector<Move> moves{{place()}};
  for (int i = 0; i < count; ++i) moves.push_back({place(), 100});
  return moves;
}

Vec3 random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  return block.lower + block.size().cwiseProduct(Vec3(share(random), share(random), share(random)));
}

// The slow twin: points of the block that no pose of the tool covers are material. Heights are never below them, not
// even over walls that are thinner than a cell.
TEST(PlannedStock, HeightsAreNeverTooLow) {
  std::mt19937 random(7);
  for (const char* shape : {"flat", "ball", "bull", "v"})
    for (const Plane& plane : {plane_named("top"), plane_named("front"), plane_along({0.3, -0.8, 0.5}, "tilted")}) {
      SCOPED_TRACE(shape + (" " + plane.name));
      const Tool cutter = tool(shape, 4, std::string(shape) == "bull" ? 0.8 : 0, 1.2);
      const std::vector<Move> moves = random_moves(plane.into(block), random, 12);
      PlannedStock stock(block, 0.5);
      stock.cut(moves, cutter, plane);
      const Material seen = stock.seen_from(plane);
      int left = 0;
      double lowered = 0;
      for (int trial = 0; trial < 1500; ++trial) {
        const Vec3 p = plane.into(random_point(random));
        const double height = seen.highest(p.head<2>(), 0);
        lowered += plane.into(block).upper.z() - height;
        if (height >= p.z() || cuts(moves, cutter, p)) continue;
        ADD_FAILURE() << p.transpose() << " is above " << height;
        ++left;
      }
      EXPECT_EQ(left, 0);
      EXPECT_GT(lowered / 1500, 0.3);
    }
}

// Of a stock that was cut from above, other planes see all material, too, if it is as thick as a cell.
TEST(PlannedStock, OtherPlanesSeeWhatIsLeft) {
  std::mt19937 random(8);
  const Tool cutter = tool("flat", 5);
  const Plane top = plane_named("top");
  const std::vector<Move> moves = random_moves(block, random, 10);
  PlannedStock stock(block, 0.4);
  stock.cut(moves, cutter, top);
  for (const Plane& plane : {plane_named("front"), plane_named("bottom"), plane_along({-0.5, 0.4, 0.6}, "tilted")}) {
    SCOPED_TRACE(plane.name);
    const Material seen = stock.seen_from(plane);
    double lowered = 0;
    for (int trial = 0; trial < 2000; ++trial) {
      const Vec3 p = random_point(random), q = plane.into(p);
      const double height = seen.highest(q.head<2>(), 0.4);
      lowered += plane.into(block).upper.z() - height;
      if (height < q.z()) EXPECT_TRUE(cuts(moves, cutter, p)) << p.transpose();
    }
    if (plane.name == "tilted") EXPECT_GT(lowered / 2000, 0.1);
  }
}

TEST(PlannedStock, HeightsAreWhatTheToolLeaves) {
  PlannedStock stock({{0, 0, -5}, {20, 20, 5}}, 0.25);
  stock.cut({{{10, 0, 10}}, {{10, 0, 2}, 100}, {{10, 20, 2}, 100}, {{0, 0, 10}}}, tool("flat", 10), Plane{});
  const Material material = stock.seen_from(Plane{});
  EXPECT_NEAR(material.highest({10, 10}, 1), 2, 1e-5);
  EXPECT_NEAR(material.certain({10, 10}, 4), 2, 1e-5);
  EXPECT_EQ(material.highest({10, 10}, 5.5), 5);
  EXPECT_EQ(material.highest({2, 10}, 1), 5);
  EXPECT_TRUE(std::isinf(material.highest({40, 40}, 1)));
  Path along;
  along.points = {{{10, 2, 2}}, {{10, 18, 2}}};
  Path across;
  across.points = {{{2, 10, 2}}, {{18, 10, 2}}};
  EXPECT_TRUE(where_material({along}, material, 2).empty());
  EXPECT_EQ(where_material({across}, material, 2).size(), 2U);
  // From the front the slot's floor is at its height, and walls are not farther out than they are.
  stock.cut({{{10, 0, 10}}, {{10, 0, 2}, 100}, {{10, 8, 2}, 100}}, tool("flat", 10), Plane{});
  const Plane front = plane_named("front");
  const Material from_front = stock.seen_from(front);
  const Vec3 open = front.into(Vec3(10, 0, 3)), closed = front.into(Vec3(10, 0, 1.5));
  EXPECT_TRUE(std::isinf(from_front.highest(open.head<2>(), 0.1)));
  EXPECT_NEAR(from_front.highest(closed.head<2>(), 0.1), front.into(block).upper.z(), 1e-5);
}

/// Distance of a point from the nearest of some paths of straight lines, mm.
double distance_from(const std::vector<Path>& paths, const Vec3& p) {
  double nearest = 1e9;
  for (const Path& path : paths)
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
      const Vec3 a = path.points[i].at, way = path.points[i + 1].at - a;
      const double t = way.norm() > 0 ? std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
      nearest = std::min(nearest, (a + t * way - p).norm());
    }
  return nearest;
}

// The slow twin: where a path is left out, each point above the cutter is one that an earlier tool cut, or is outside
// the block.
TEST(PlannedStock, OnlyAirIsLeftOutOfFinishing) {
  std::mt19937 random(11);
  const double tolerance = 0.02;
  std::uniform_real_distribution<double> share(0, 1);
  for (const char* shape : {"flat", "ball", "v"}) {
    SCOPED_TRACE(shape);
    const Plane top = plane_named("top");
    const Tool cutter = tool(shape, 3, 0, 1.2), wide = tool("flat", 6);
    const Profile profile = cutter.profile();
    const std::vector<Move> moves = random_moves(block, random, 25);
    PlannedStock stock(block, 0.25);
    stock.cut(moves, wide, top);
    Path path;
    for (int i = 0; i < 30; ++i)
      path.points.push_back({{24 * share(random) - 2, 20 * share(random) - 2, 6 + 7 * share(random)}});
    const std::vector<Path> kept = without_air({path}, stock.seen_from(top), profile, tolerance);
    int left_out = 0, poses = 0;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
      for (double t = 0; t < 1; t += 0.03) {
        const Vec3 tip = path.points[i].at + t * (path.points[i + 1].at - path.points[i].at);
        ++poses;
        if (distance_from(kept, tip) < 0.01) continue;
        ++left_out;
        for (int trial = 0; trial < 30; ++trial) {
          const double turn = 6.3 * share(random), away = profile.radius() * std::sqrt(share(random));
          const double low = tip.z() + profile.height(away) + 1.1 * tolerance;
          const Vec3 p(tip.x() + away * std::cos(turn), tip.y() + away * std::sin(turn),
                       low + std::abs(block.upper.z() - low) * share(random));
          if (block.contains(p)) EXPECT_TRUE(cuts(moves, wide, p)) << p.transpose() << " under " << tip.transpose();
        }
      }
    EXPECT_GT(left_out, poses / 20);
    EXPECT_LT(left_out, poses);
  }
}

// Between cuts from different directions a thin part may be missed: then all passes stay.
TEST(PlannedStock, FinishingStaysWholeAfterCutsFromOtherDirections) {
  std::mt19937 random(12);
  const Plane top = plane_named("top"), front = plane_named("front");
  PlannedStock stock(block, 0.4);
  Path high;
  high.points = {{{2, 2, 13}}, {{18, 14, 13}}};
  const Profile ball = tool("ball", 3).profile();
  EXPECT_TRUE(without_air({high}, stock.seen_from(top), ball, 0.01).empty());
  stock.cut(random_moves(front.into(block), random, 5), tool("flat", 4), front);
  EXPECT_EQ(without_air({high}, stock.seen_from(top), ball, 0.01).size(), 1U);
  EXPECT_FALSE(stock.seen_from(front).whole() && stock.seen_from(top).whole());
}

// All crossings are edges from a solid point to air, and none is missing.
TEST(Stock, CrossingsAreThoseOfItsPoints) {
  std::mt19937 random(9);
  for (const int brick : {8, 64}) {
    Stock stock(block, {.cell = 0.8, .brick = brick});
    const ToolSolid solid = tool_solid(tool("ball", 4));
    Vec3 at = random_point(random);
    for (std::uint32_t i = 1; i < 9; ++i) {
      const Vec3 to = random_point(random), axis = Vec3(0.2, -0.1, 1).normalized();
      const Stroke stroke{&solid.pieces[0], {at, axis}, {to, axis}, i};
      stock.cut({&stroke, 1});
      at = to;
    }
    std::size_t expected = 0;
    const Index3 cells = stock.lattice().cells();
    for (int z = 0; z <= cells[2]; ++z)
      for (int y = 0; y <= cells[1]; ++y)
        for (int x = 0; x <= cells[0]; ++x)
          for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
              Index3 next{x, y, z};
              next[axis] += step;
              expected += stock.solid({x, y, z}) && !stock.solid(next);
            }
    std::vector<StockCrossing> crossings;
    for (const auto& of_brick : stock.crossings()) crossings.insert(crossings.end(), of_brick.begin(), of_brick.end());
    EXPECT_EQ(crossings.size(), expected);
    for (const StockCrossing& c : crossings) {
      const Vec3 k = (c.solid - block.lower).cwiseQuotient(stock.lattice().spacing());
      Index3 p{static_cast<int>(std::lround(k.x())), static_cast<int>(std::lround(k.y())),
               static_cast<int>(std::lround(k.z()))};
      EXPECT_TRUE(stock.solid(p));
      p[static_cast<std::size_t>(c.axis)] += c.upwards ? 1 : -1;
      EXPECT_FALSE(stock.solid(p));
      EXPECT_LE((c.place - c.solid).norm(), stock.lattice().spacing()[c.axis] * 1.0001);
    }
  }
}

class StockJobs : public ::testing::Test {
 protected:
  StockJobs() { std::filesystem::create_directories(folder_); }
  ~StockJobs() override { std::filesystem::remove_all(folder_); }

  Job plan(const std::string& name, const std::string& stock, const std::string& operations) {
    const std::string text = fmt::format(
        "machine = \"linuxcnc\"\n[input]\n[stock]\n{}\n[[tool]]\nnumber = 1\ndiameter = 6\nflute = 20\nlength = 40\n{}",
        stock, operations);
    write_file(folder_ / (name + ".toml"), text);
    Job job = Job::parse(text, folder_ / (name + ".toml"), part());
    job.run();
    if (!job.program().sections.empty()) job.write(folder_ / (name + ".ngc"));
    return job;
  }
  /// Simulates a program that was planned. Expects no events.
  SimulationResult proved(const std::string& name) {
    SimulationResult result =
        simulate(read_simulation_setup(folder_ / (name + ".toml"), part()), folder_ / (name + ".ngc"));
    for (const SimulationEvent& event : result.events()) ADD_FAILURE() << event.first_line << ": " << event.message;
    return result;
  }
  /// A block of 40 x 30 x 12 mm with a step: its front half is 6 mm lower.
  static FieldPtr part() { return formula("max(max(abs(x)-20, abs(y)-15), max(max(z, -12-z), min(z+6, -y)))"); }
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("fieldfab_planned_{}", ::getpid());
};

const std::string surface = "cell = 0.4\nsurface_tolerance = 0.05\n";  // coarse, which is quick
const std::string rough = "[[operation]]\ntype = \"rough\"\nstepdown = 3\nbottom = -6\n" + surface;

// A second roughing of the same stock, with its saved remainder, has little left to do: cells along walls.
TEST_F(StockJobs, LeaveOutWhatAnEarlierJobDid) {
  const Job first = plan("first", "margin = 0", rough);
  write_stock(proved("first").stock(), folder_ / "first.fieldstock");
  const Job again = plan("again", "file = \"first.fieldstock\"", rough);
  double length = 0;
  for (const OperationReport& report : again.reports()) length += report.length.cut;
  EXPECT_LT(length, 0.15 * first.reports()[0].length.cut);
  // One level deeper starts in the open step, not at the box's top.
  const Job deeper = plan("deeper", "file = \"first.fieldstock\"",
                          "[[operation]]\ntype = \"rough\"\nstepdown = 3\nallowance = 0\nbottom = -6\n" + surface);
  double highest = -100;
  const std::vector<Move>& moves = deeper.program().sections.at(0).moves;
  for (std::size_t k = 1; k < moves.size(); ++k)
    if (!moves[k].rapid()) highest = std::max(highest, moves[k - 1].to.z());
  EXPECT_LT(highest, 4.9);
  proved("deeper");
}

// Finishing goes only where stock is left: the same solid in a fraction of the way.
TEST_F(StockJobs, FinishingLeavesOutAir) {
  const std::string clear = "[[operation]]\ntype = \"rough\"\nstepdown = 3\nallowance = 0\nbottom = -6\n" + surface;
  const std::string finish = "[[operation]]\ntype = \"finish\"\n" + surface;
  const Job all = plan("all", "margin = 0", clear + finish + "skip_air = false\n");
  const Job needed = plan("needed", "margin = 0", clear + finish);
  const double longer = all.reports().at(1).length.cut;
  EXPECT_GT(longer, 1500);
  EXPECT_LT(needed.reports().size() > 1 ? needed.reports()[1].length.cut : 0, 0.3 * longer);
  EXPECT_NEAR(proved("needed").stock().volume(), proved("all").stock().volume(), 0.5);
}

// What was cut from above is air for the front.
TEST_F(StockJobs, SecondPlanesCutNoAir) {
  const std::string front = "[[operation]]\ntype = \"rough\"\nstepdown = 3\nplane = \"front\"\n" + surface;
  const Job alone = plan("alone", "margin = 0\ntop = 2", front);
  const Job both = plan("both", "margin = 0\ntop = 2", rough + front);
  double length = 0;
  for (const OperationReport& report : both.reports())
    if (report.name.find("rough") != std::string::npos && &report != &both.reports()[0]) length += report.length.cut;
  EXPECT_LT(length, 0.5 * alone.reports().at(0).length.cut);
  proved("both");
}

}  // namespace
}  // namespace fieldfab::cam
