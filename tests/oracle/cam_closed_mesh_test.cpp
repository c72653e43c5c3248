// Closed mesh of a stock with simplified flats, compared with the full mesh; and deviations from a
// simulation, compared with those of all vertices of the full mesh.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "closed.h"
#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/cam/stock/surface.h"
#include "fieldfab/check/check.h"
#include "fieldfab/core/file.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"

namespace fieldfab::cam {
namespace {

using Place = std::array<float, 3>;

Vec3 vector(const Place& p) { return {p[0], p[1], p[2]}; }

/// The full mesh: the pieces joined at equal points.
struct Fine {
  TriangleMesh mesh;
  std::vector<std::uint32_t> cuts;

  explicit Fine(const Stock& stock) {
    StockSurface surface;
    surface.update(stock);
    std::map<Place, std::uint32_t> at;
    for (std::size_t i = 0; i < surface.pieces(); ++i) {
      std::vector<std::uint32_t> cuts_here;
      const TriangleMesh piece = surface.piece(i, &cuts_here);
      for (const auto& t : piece.triangles) {
        auto& corners = mesh.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
          const auto [found, fresh] =
              at.try_emplace(piece.vertices[t[k]], static_cast<std::uint32_t>(mesh.vertices.size()));
          if (fresh) mesh.vertices.push_back(piece.vertices[t[k]]), cuts.push_back(cuts_here[t[k]]);
          corners[k] = found->second;
        }
      }
    }
  }
};

Tool cutter(const std::string& shape) {
  Tool tool;
  tool.number = 1;
  tool.shape = tool_shape_named(shape, "test");
  tool.diameter = 3;
  tool.flute = 20;
  tool.length = 30;
  tool.corner_radius = 0.8;
  return tool;
}

/// A stock after random strokes with several cutters, most of them parallel to an axis.
Stock random_stock(std::mt19937& random, int brick, double height) {
  StockSettings settings;
  settings.cell = 0.2;
  settings.cell_height = height;
  settings.brick = brick;
  Stock stock({{0, 0, 0}, {15, 13, 8}}, settings);
  std::uniform_real_distribution<double> x(-1, 16), z(1, 7);
  std::uint32_t cut = 0;
  for (const char* shape : {"flat", "flat", "ball", "flat", "bull"}) {
    const ToolSolid solid = tool_solid(cutter(shape));
    const double level = z(random);
    ToolPose at{{x(random), x(random), level}, Vec3::UnitZ()};
    for (int i = 0; i < 3; ++i) {
      ToolPose to{{x(random), x(random), i == 2 ? z(random) : level}, Vec3::UnitZ()};
      if (i == 1) to.tip.y() = at.tip.y();
      std::vector<Stroke> strokes;
      add_strokes(solid, ToolRole::cutting, at, to, ++cut, true, strokes);
      stock.cut(strokes);
      at = to;
    }
  }
  return stock;
}

/// Whether a point lies on one of the axis-aligned triangles, in projection along the axis.
bool on_level_triangle(const TriangleMesh& mesh, const std::vector<std::uint32_t>& level, const Vec3& p, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (const std::uint32_t i : level) {
    const auto& t = mesh.triangles[i];
    int left = 0, right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = vector(mesh.vertices[t[k]]), b = vector(mesh.vertices[t[(k + 1) % 3]]);
      const double side = (b[u] - a[u]) * (p[v] - a[v]) - (b[v] - a[v]) * (p[u] - a[u]);
      left += side > -1e-5, right += side < 1e-5;
    }
    if (left == 3 || right == 3) return true;
  }
  return false;
}

struct Case {
  int brick;
  double height;
};

class ClosedMeshTwin : public ::testing::TestWithParam<Case> {};

TEST_P(ClosedMeshTwin, IsTheSameSurfaceWithFewerVertices) {
  std::mt19937 random(static_cast<unsigned>(GetParam().brick));
  std::size_t merged = 0, all = 0;
  for (int round = 0; round < 4; ++round) {
    const Stock stock = random_stock(random, GetParam().brick, GetParam().height);
    const Fine fine(stock);
    expect_closed(fine.mesh);
    std::vector<std::uint32_t> cuts;
    const TriangleMesh mesh = stock.mesh(&cuts, Progress::none(), StockEdges::sampled);
    ASSERT_EQ(cuts.size(), mesh.vertices.size());
    expect_closed(mesh);
    // The area is equal, too, so that the mesh does not overlap itself within a plane.
    EXPECT_NEAR(mesh.volume(), fine.mesh.volume(), 1e-6 * fine.mesh.volume());
    EXPECT_NEAR(mesh.area(), fine.mesh.area(), 1e-6 * fine.mesh.area());
    // Its vertices are those of the full mesh, or centres of several; all are used. Removed
    // vertices lie on axis-aligned triangles of the same cut.
    std::map<Place, std::uint32_t> left;
    for (std::uint32_t v = 0; v < cuts.size(); ++v) left.emplace(mesh.vertices[v], cuts[v]);
    ASSERT_EQ(left.size(), cuts.size());
    std::vector<char> used(cuts.size());
    std::map<std::pair<int, float>, std::vector<std::uint32_t>> level;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles[i];
      for (const std::uint32_t v : t) used[v] = 1;
      for (std::size_t a = 0; a < 3; ++a)
        if (mesh.vertices[t[0]][a] == mesh.vertices[t[1]][a] && mesh.vertices[t[0]][a] == mesh.vertices[t[2]][a])
          level[{static_cast<int>(a), mesh.vertices[t[0]][a]}].push_back(i);
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
    std::size_t found = 0, gone_wrong = 0;
    for (std::size_t v = 0; v < fine.cuts.size(); ++v) {
      const Place& place = fine.mesh.vertices[v];
      if (const auto at = left.find(place); at != left.end()) {
        EXPECT_EQ(at->second, fine.cuts[v]);
        ++found;
        continue;
      }
      bool lies = false;
      for (int a = 0; a < 3 && !lies; ++a)
        if (const auto at = level.find({a, place[static_cast<std::size_t>(a)]}); at != level.end())
          lies = on_level_triangle(mesh, at->second, vector(place), a);
      gone_wrong += !lies;
    }
    EXPECT_GT(found, cuts.size() / 2);
    EXPECT_EQ(gone_wrong, 0u);
    const MeshVerdict ours = inspect(mesh), theirs = inspect(fine.mesh);
    EXPECT_TRUE(ours.manifold && ours.closed && ours.outward);
    EXPECT_LE(ours.self_intersections, theirs.self_intersections);
    EXPECT_LE(ours.degenerate, theirs.degenerate);
    EXPECT_EQ(ours.components, theirs.components);
    merged += mesh.triangles.size(), all += fine.mesh.triangles.size();
  }
  EXPECT_LT(merged, GetParam().brick == 6 ? 4 * all / 5 : 7 * all / 10);
}

INSTANTIATE_TEST_SUITE_P(Bricks, ClosedMeshTwin,
                         ::testing::Values(Case{6, 0}, Case{11, 0}, Case{37, 0}, Case{64, 0}, Case{0, 0}, Case{16, 1},
                                           Case{64, 2}));

TEST(ClosedMesh, OfAnUncutBoxHasFewTriangles) {
  StockSettings settings;
  settings.cell = 0.1;
  const Stock stock({{0, 0, 0}, {40, 30, 2}}, settings);
  const TriangleMesh mesh = stock.mesh();
  EXPECT_TRUE(inspect(mesh).valid());
  EXPECT_LT(mesh.triangles.size(), 30'000u);  // the rims keep their vertices; 548,000 in the full mesh
}

// Simulations: a program with some gouges, compared with solids of known distance.

struct Target {
  const char* text;
  double (*distance)(const Vec3&);
};

class DeviationTwin : public ::testing::TestWithParam<Target> {};

TEST_P(DeviationTwin, SaysWhatAllVerticesSay) {
  SimulationSetup setup;
  setup.stock_box = {{0, 0, -8}, {22, 20, 0}};
  setup.sampling.cell = 0.25;
  setup.sampling.brick = 20;
  setup.tools[1] = cutter("flat");
  setup.tools[1].shank = 3;
  setup.target = frep::make_field(frep::parse_infix(GetParam().text));
  setup.floor = -6.5;
  setup.excess = 0.4;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> across(-1, 23), deep(-3.6, -2.6);
  std::string program = "G21 G90\nT1 M6\nS1000 M3\nG0 X-5 Y-5 Z5\n";
  for (int i = 0; i < 20; ++i) {
    const double z = deep(random);
    program += fmt::format("G0 X{:.3f} Y{:.3f} Z5\nG1 Z{:.3f} F600\n", across(random), across(random), z);
    program += fmt::format("G1 X{:.3f} Y{:.3f}\nG0 Z5\n", across(random), across(random));
  }
  const auto path = std::filesystem::temp_directory_path() / fmt::format("fieldfab_closed_mesh_{}.nc", ::getpid());
  write_file(path, program + "M2\n");
  const SimulationResult result = simulate(setup, path);
  std::filesystem::remove(path);

  const Fine fine(result.stock());
  const auto deviation = [&](const Place& at) {
    return at[2] < setup.floor ? 0 : std::clamp(GetParam().distance(vector(at)), -10.0, 10.0);
  };
  struct Worst {
    double depth = 0;
  };
  // A pass lies between two rapids: two lines of four.
  const auto pass_of = [](int line) { return (line - 5) / 4; };
  std::map<int, double> gouges;
  std::vector<double> at_vertex;
  double highest = 0, deepest = 0;
  for (std::size_t v = 0; v < fine.cuts.size(); ++v) {
    const double d = deviation(fine.mesh.vertices[v]);
    at_vertex.push_back(d);
    highest = std::max(highest, d), deepest = std::max(deepest, -d);
    if (d < -setup.gouge)
      gouges[pass_of(result.cuts()[fine.cuts[v]].move.line)] =
          std::max(gouges[pass_of(result.cuts()[fine.cuts[v]].move.line)], -d);
  }
  const Deviation& said = *result.report().deviation;
  EXPECT_NEAR(said.highest, highest, 1e-4);
  EXPECT_NEAR(said.deepest, deepest, 1e-4);
  EXPECT_GT(gouges.size(), 5u);
  std::map<int, double> told;
  for (const SimulationEvent& e : result.report().events) {
    if (e.kind != SimulationEvent::Kind::gouge && e.kind != SimulationEvent::Kind::excess) continue;
    const Place place{static_cast<float>(e.place.x()), static_cast<float>(e.place.y()),
                      static_cast<float>(e.place.z())};
    EXPECT_TRUE(std::find(fine.mesh.vertices.begin(), fine.mesh.vertices.end(), place) != fine.mesh.vertices.end());
    EXPECT_NEAR(std::abs(deviation(place)), e.amount, 1e-4);
    if (e.kind == SimulationEvent::Kind::gouge) told[pass_of(e.move.line)] = e.amount;
    if (e.kind == SimulationEvent::Kind::excess) {
      EXPECT_NEAR(e.amount, highest, 1e-4);
    }
  }
  ASSERT_EQ(told.size(), gouges.size());
  for (const auto& [pass, depth] : gouges) {
    ASSERT_TRUE(told.contains(pass)) << pass;
    EXPECT_NEAR(told[pass], depth, 1e-4) << pass;
  }
  // Means over the area, and a histogram.
  double area = 0, sum = 0, squares = 0;
  constexpr std::size_t bins = 40;
  constexpr double from = -0.5, to = 0.5;
  std::vector<double> histogram(bins, 0);
  for (const auto& t : fine.mesh.triangles) {
    const Vec3 a = vector(fine.mesh.vertices[t[0]]);
    const double part = 0.5 * (vector(fine.mesh.vertices[t[1]]) - a).cross(vector(fine.mesh.vertices[t[2]]) - a).norm();
    const double mean = (at_vertex[t[0]] + at_vertex[t[1]] + at_vertex[t[2]]) / 3;
    area += part, sum += part * mean, squares += part * mean * mean;
    const double bin = std::clamp(std::floor((mean - from) / (to - from) * bins), 0.0, bins - 1.0);
    histogram[static_cast<std::size_t>(bin)] += part;
  }
  EXPECT_NEAR(said.mean, sum / area, 1e-5);
  EXPECT_NEAR(said.root_mean_square, std::sqrt(squares / area), 1e-5);
  const std::vector<double> steps = said.areas.steps(from, to, bins);
  // Values at the border of two bins may count in either, hence the comparison of cumulative sums.
  double ours = 0, theirs = 0;
  for (std::size_t i = 0; i < bins; ++i) {
    ours += steps[i], theirs += histogram[i];
    EXPECT_NEAR(ours, theirs, 2e-3 * area) << i;
  }
  EXPECT_NEAR(ours, theirs, 1e-6 * area);

  // The simplified mesh: each vertex has its own deviation, or a similar one of its square.
  const TriangleMesh& mesh = result.surface().mesh;
  ASSERT_EQ(said.at_vertex.size(), mesh.vertices.size());
  ASSERT_EQ(result.lines_of_vertices().size(), mesh.vertices.size());
  EXPECT_LT(mesh.vertices.size(), fine.mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    EXPECT_NEAR(said.at_vertex[v], deviation(mesh.vertices[v]), setup.sampling.cell / 100);
  const TriangleMesh sampled = result.stock().mesh(nullptr, Progress::none(), StockEdges::sampled);
  EXPECT_NEAR(sampled.volume(), fine.mesh.volume(), 1e-6 * mesh.volume());
  EXPECT_NEAR(mesh.volume(), fine.mesh.volume(), 2e-3 * mesh.volume());  // its edges are not cut off
}

INSTANTIATE_TEST_SUITE_P(Targets, DeviationTwin,
                         ::testing::Values(Target{"z + 3", [](const Vec3& p) { return p.z() + 3; }},
                                           Target{"sqrt(square(x - 11) + square(y - 9) + square(z + 103)) - 100",
                                                  [](const Vec3& p) { return (p - Vec3(11, 9, -103)).norm() - 100; }}));

}  // namespace
}  // namespace fieldfab::cam
