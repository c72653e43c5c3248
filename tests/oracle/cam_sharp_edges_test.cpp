// Edges and corners where surfaces of cuts meet: positions and volumes by closed forms, and validity over random cuts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/cam/stock/surface.h"
#include "fieldfab/check/check.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"

namespace fieldfab::cam {
namespace {

constexpr double cell = 0.2;

StockSettings settings() {
  StockSettings made;
  made.cell = cell;
  return made;
}

Tool cutter(const std::string& shape, double diameter) {
  Tool tool;
  tool.number = 1;
  tool.shape = tool_shape_named(shape, "test");
  tool.diameter = diameter;
  tool.flute = 20;
  tool.length = 30;
  tool.corner_radius = diameter / 4;
  tool.angle = 2 * std::numbers::pi / 3;
  return tool;
}

/// Executes level or tilted strokes one after the other, each with a number of its own.
class Milling {
 public:
  explicit Milling(Stock& stock) : stock_(stock) {}
  void cut(const ToolSolid& solid, const ToolPose& from, const ToolPose& to) {
    ++number_;
    std::vector<Stroke> strokes;
    for (const ToolPiece& piece : solid.pieces)
      if (piece.role == ToolRole::cutting) strokes.push_back({&piece, from, to, number_, true});
    stock_.cut(strokes);
  }
  void cut(const ToolSolid& solid, const Vec3& from, const Vec3& to) {
    cut(solid, ToolPose{from, Vec3::UnitZ()}, ToolPose{to, Vec3::UnitZ()});
  }

 private:
  Stock& stock_;
  std::uint32_t number_ = 0;
};

Vec3 at(const TriangleMesh& mesh, std::uint32_t v) {
  return {mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]};
}

double distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto from_segment = [&](const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const double t = std::clamp((p - from).dot(way) / std::max(way.squaredNorm(), 1e-30), 0.0, 1.0);
    return (p - from - t * way).norm();
  };
  const Vec3 normal = (b - a).cross(c - a);
  const double edges = std::min({from_segment(a, b), from_segment(b, c), from_segment(c, a)});
  if (normal.squaredNorm() < 1e-24) return edges;
  const Vec3 q = p - normal * ((p - a).dot(normal) / normal.squaredNorm());
  const bool inside = (b - a).cross(q - a).dot(normal) >= 0 && (c - b).cross(q - b).dot(normal) >= 0 &&
                      (a - c).cross(q - c).dot(normal) >= 0;
  return inside ? (p - q).norm() : edges;
}

/// Distances of points of an exact edge from a mesh, in cells.
struct EdgeError {
  double mean = 0, most = 0;
};
EdgeError edge_error(const TriangleMesh& mesh, const std::vector<Vec3>& edge) {
  EdgeError error;
  for (const Vec3& p : edge) {
    double least = 1;
    for (const auto& t : mesh.triangles) {
      const Vec3 a = at(mesh, t[0]), b = at(mesh, t[1]), c = at(mesh, t[2]);
      if (((a.cwiseMin(b).cwiseMin(c) - p).array() > least).any() ||
          ((p - a.cwiseMax(b).cwiseMax(c)).array() > least).any())
        continue;
      least = std::min(least, distance(p, a, b, c));
    }
    error.mean += least / cell / static_cast<double>(edge.size()), error.most = std::max(error.most, least / cell);
  }
  return error;
}

struct Both {
  TriangleMesh sharp, sampled;
};
Both meshes_of(const Stock& stock) {
  return {stock.mesh(), stock.mesh(nullptr, Progress::none(), StockEdges::sampled)};
}

void report(const std::string& name, const EdgeError& before, const EdgeError& after) {
  fmt::print("{}: edge error in cells, mean {:.4f} -> {:.5f}, most {:.4f} -> {:.5f}\n", name, before.mean, after.mean,
             before.most, after.most);
}

void report_volume(const std::string& name, double before, double after, double exact) {
  fmt::print("{}: volume {:.4f}, errors {:.5f} -> {:.5f} mm3\n", name, exact, before - exact, after - exact);
}

/// A slot along a line, from a flat mill that moves level: floor and wall of one stroke.
TEST(SharpEdges, OfASlotAreItsClosedForm) {
  Stock stock({{0, 0, 0}, {20, 14, 5}}, settings());
  const ToolSolid solid = tool_solid(cutter("flat", 6));
  Milling milling(stock);
  const Vec3 from(5.03, 6.11, 2.07), to(14.3, 8.2, 2.07);
  milling.cut(solid, from, to);
  const Both mesh = meshes_of(stock);
  const double depth = 5 - 2.07, length = (to - from).norm();
  const double exact = 20 * 14 * 5 - depth * (6 * length + std::numbers::pi * 9);
  report_volume("slot", mesh.sampled.volume(), mesh.sharp.volume(), exact);
  std::vector<Vec3> edge;
  const Vec3 along = (to - from).normalized(), across(-along.y(), along.x(), 0);
  for (int i = 0; i <= 100; ++i) {
    edge.push_back(from + i / 100.0 * (to - from) + 3 * across);
    const double angle = std::numbers::pi * i / 100.0;
    edge.push_back(to + 3 * (std::cos(angle) * across + std::sin(angle) * along));
  }
  const EdgeError before = edge_error(mesh.sampled, edge), after = edge_error(mesh.sharp, edge);
  report("floor edge of a slot", before, after);
  EXPECT_TRUE(inspect(mesh.sharp).valid());
  EXPECT_LT(after.most, 0.015);
  EXPECT_LT(after.mean, 0.005);
  // What remains are the chords of the round walls.
  EXPECT_LT(std::abs(mesh.sharp.volume() - exact), 0.25 * std::abs(mesh.sampled.volume() - exact));
}

/// A rectangular pocket of four strokes, and two crossing grooves of different depths.
TEST(SharpEdges, OfGroovesThatCrossAreTheirClosedForm) {
  Stock stock({{0, 0, 0}, {20, 16, 5}}, settings());
  const ToolSolid solid = tool_solid(cutter("flat", 4));
  Milling milling(stock);
  milling.cut(solid, {-5, 8.07, 2.55}, {25, 8.07, 2.55});
  milling.cut(solid, {9.93, -5, 1.31}, {9.93, 21, 1.31});
  const Both mesh = meshes_of(stock);
  const double exact = 20 * 16 * 5 - 4 * 20 * (5 - 2.55) - 4 * 16 * (5 - 1.31) + 4 * 4 * (5 - 2.55);
  report_volume("crossing grooves", mesh.sampled.volume(), mesh.sharp.volume(), exact);
  std::vector<Vec3> edge;
  for (int i = 0; i <= 100; ++i) {
    const double t = i / 100.0;
    edge.emplace_back(7.93 * t, 6.07, 2.55);         // floor and wall of the first groove
    edge.emplace_back(7.93, 6.07 + 4 * t, 2.55);     // convex: its floor and the second's wall
    edge.emplace_back(7.93, 16 * t, 1.31);           // floor and wall of the second
    edge.emplace_back(7.93, 6.07, 2.55 + 2.45 * t);  // convex: both walls
  }
  const EdgeError before = edge_error(mesh.sampled, edge), after = edge_error(mesh.sharp, edge);
  report("crossing grooves", before, after);
  EXPECT_TRUE(inspect(mesh.sharp).valid());
  EXPECT_LT(after.most, 0.01);
  EXPECT_LT(std::abs(mesh.sharp.volume() - exact), 0.02 * std::abs(mesh.sampled.volume() - exact));
}

/// Parallel passes of a ball cutter, at an angle to the lattice: the height of the ridges.
TEST(SharpEdges, OfABallCuttersPassesAreAsHighAsTheClosedForm) {
  for (const double step : {0.7, 1.3, 2.0}) {
    Stock stock({{0, 0, 0}, {14, 12, 4}}, settings());
    const double r = 3;
    const ToolSolid solid = tool_solid(cutter("ball", 2 * r));
    Milling milling(stock);
    const Vec3 along(std::cos(0.3), std::sin(0.3), 0), across(-along.y(), along.x(), 0);
    const Vec3 middle(7, 6, 1);
    for (int i = -12; i <= 12; ++i)
      milling.cut(solid, middle + i * step * across - 20 * along, middle + i * step * across + 20 * along);
    const Both mesh = meshes_of(stock);
    const double height = r - std::sqrt(r * r - step * step / 4);
    std::vector<Vec3> ridge;
    for (int i = -2; i < 2; ++i)
      for (int k = -20; k <= 20; ++k)
        ridge.emplace_back(middle + (i + 0.5) * step * across + 0.1 * k * along + height * Vec3::UnitZ());
    const EdgeError before = edge_error(mesh.sampled, ridge), after = edge_error(mesh.sharp, ridge);
    report(fmt::format("ridges {:.4f} mm high, {} mm apart", height, step), before, after);
    EXPECT_TRUE(inspect(mesh.sharp).valid());
    EXPECT_LT(after.most, 0.01);
    EXPECT_LT(after.mean, 0.15 * before.mean);
  }
}

/// A groove of a V cutter: both sides, and the tip's line between them, are of one stroke.
TEST(SharpEdges, OfAVGrooveLieAtItsBottom) {
  Stock stock({{0, 0, 0}, {14, 12, 4}}, settings());
  const ToolSolid solid = tool_solid(cutter("v", 6));
  Milling milling(stock);
  const Vec3 from(2.3, 3.1, 1.13), to(11.2, 8.3, 1.13);
  milling.cut(solid, from, to);
  const Both mesh = meshes_of(stock);
  std::vector<Vec3> bottom;
  for (int i = 5; i <= 95; ++i) bottom.push_back(from + i / 100.0 * (to - from));
  const EdgeError before = edge_error(mesh.sampled, bottom), after = edge_error(mesh.sharp, bottom);
  report("bottom of a V groove", before, after);
  EXPECT_TRUE(inspect(mesh.sharp).valid());
  EXPECT_LT(after.mean, 0.2 * before.mean);
}

/// A level cut through a cylinder of a Field, and three mutually perpendicular cuts that meet in a corner.
TEST(SharpEdges, OfACutAndTheFirstSurfaceAreACircle) {
  const auto field =
      frep::make_field(frep::parse_infix("max(sqrt(square(x - 7) + square(y - 6)) - 5, max(z - 4, -z))"));
  Stock stock(*field, {{0, 0, -1}, {14, 12, 5}}, settings());
  Milling milling(stock);
  milling.cut(tool_solid(cutter("flat", 20)), {-2, 6, 2.47}, {16, 6, 2.47});
  const Both mesh = meshes_of(stock);
  std::vector<Vec3> rim;
  for (int i = 0; i < 200; ++i)
    rim.emplace_back(7 + 5 * std::cos(std::numbers::pi * i / 100), 6 + 5 * std::sin(std::numbers::pi * i / 100), 2.47);
  const EdgeError before = edge_error(mesh.sampled, rim), after = edge_error(mesh.sharp, rim);
  report("rim of a cylinder", before, after);
  EXPECT_TRUE(inspect(mesh.sharp).valid());
  EXPECT_LT(after.most, 0.015);
}

TEST(SharpEdges, MeetInACorner) {
  Stock stock({{0, 0, 0}, {12, 12, 6}}, settings());
  Milling milling(stock);
  const ToolSolid solid = tool_solid(cutter("flat", 4));
  milling.cut(solid, {-5, 3.07, 2.55}, {20, 3.07, 2.55});
  milling.cut(solid, {3.11, -5, 2.55}, {3.11, 20, 2.55});
  // From the side, a tool along x: a floor above which material is left, with a wall.
  milling.cut(solid, ToolPose{{8.03, -5, 1.47}, -Vec3::UnitX()}, ToolPose{{8.03, 20, 1.47}, -Vec3::UnitX()});
  const TriangleMesh mesh = stock.mesh();
  EXPECT_TRUE(inspect(mesh).valid());
  // The convex corner of two walls on the upper face, and the corner at the floor.
  for (const Vec3& corner : {Vec3(5.11, 5.07, 6), Vec3(5.11, 5.07, 3.47)}) {
    double least = 1;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) least = std::min(least, (at(mesh, v) - corner).norm());
    EXPECT_LT(least, 0.005 * cell) << corner.transpose();
  }
}

/// Random cuts: the mesh stays closed and free of self-intersections.
class RandomCuts : public ::testing::TestWithParam<bool> {};

TEST_P(RandomCuts, LeaveAValidMesh) {
  std::mt19937 random(GetParam() ? 7 : 3);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::size_t worse = 0, sharp = 0, before = 0;
  constexpr int rounds = 100;
  for (int round = 0; round < rounds; ++round) {
    StockSettings coarse = settings();
    coarse.cell = 0.25;
    coarse.brick = round % 3 == 0 ? 13 : 64;
    Stock stock({{0, 0, 0}, {7, 6, 4}}, coarse);
    Milling milling(stock);
    for (int i = 0; i < 6; ++i) {
      const char* const shapes[] = {"flat", "ball", "bull", "v"};
      const ToolSolid solid = tool_solid(cutter(shapes[random() % 4], 2 + unit(random)));
      ToolPose from{{3.5 + 4 * unit(random), 3 + 3.5 * unit(random), 2.5 + 1.3 * unit(random)}, Vec3::UnitZ()};
      ToolPose to = from;
      to.tip += Vec3(3 * unit(random), 3 * unit(random), random() % 2 ? 0 : unit(random));
      if (GetParam()) {
        from.axis = Vec3(unit(random), unit(random), 0.7 + unit(random)).normalized();
        to.axis = random() % 2 ? from.axis : (from.axis + 0.1 * Vec3(unit(random), unit(random), 0)).normalized();
      }
      milling.cut(solid, from, to);
    }
    const Both mesh = meshes_of(stock);
    const MeshVerdict ours = inspect(mesh.sharp), theirs = inspect(mesh.sampled);
    EXPECT_TRUE(ours.manifold && ours.closed && ours.outward) << round;
    EXPECT_EQ(ours.components, theirs.components) << round;
    EXPECT_LE(ours.self_intersections, theirs.self_intersections) << round;
    EXPECT_LE(ours.degenerate, theirs.degenerate) << round;
    worse += ours.self_intersections > 0, before += theirs.self_intersections > 0;
    sharp += mesh.sharp.vertices.size() > mesh.sampled.vertices.size();
  }
  fmt::print("{} of {} stocks have edges; with self-intersections: {} sharp, {} sampled\n", sharp, rounds, worse,
             before);
  EXPECT_EQ(sharp, static_cast<std::size_t>(rounds));
}

INSTANTIATE_TEST_SUITE_P(Axes, RandomCuts, ::testing::Values(false, true),
                         [](const auto& five) { return five.param ? "Five" : "Three"; });

}  // namespace
}  // namespace fieldfab::cam
