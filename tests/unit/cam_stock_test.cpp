// Stock against slow, obvious twins: membership of points in a tool at hundreds of poses, and
// closed forms of swept balls.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <random>
#include <set>

#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/cam/stock/surface.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"

namespace fieldfab::cam {
namespace {

Tool cutter(const std::string& shape) {
  Tool tool;
  tool.shape = tool_shape_named(shape, "test");
  tool.diameter = 3;
  tool.flute = 9;
  tool.corner_radius = shape == "tapered" ? 0.6 : 0.8;
  tool.angle = shape == "tapered" ? 0.3 : 1.2;
  tool.tip_diameter = shape == "v" ? 0.5 : 0;
  // a dovetail with a neck
  if (shape == "form") tool.points = {{0, 0}, {1.5, 0}, {1.5, 1}, {0.7, 1.6}, {0.7, 3}, {1.2, 4}};
  return tool;
}

/// Whether a point is in a tool, by its profile alone.
bool in_tool(const Tool& tool, const ToolPose& pose, const Vec3& p) {
  const Vec3 d = p - pose.tip;
  const double z = d.dot(pose.axis), r = (d - z * pose.axis).norm();
  if (z < 0 || z > tool.flute) return false;
  if (tool.shape == ToolShape::form) {
    // The greatest of the outline's radii at that height.
    double widest = -1;
    for (std::size_t i = 1; i < tool.points.size(); ++i) {
      const Vec2 &a = tool.points[i - 1], &b = tool.points[i];
      if (z < a.y() || z > b.y()) continue;
      widest = std::max(
          widest, b.y() > a.y() ? a.x() + (z - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) : std::max(a.x(), b.x()));
    }
    if (z >= tool.points.back().y()) widest = std::max(widest, tool.points.back().x());
    return r <= widest;
  }
  return r <= tool.radius() && tool.profile().height(r) <= z;
}

/// Points near a point, in all directions.
std::array<Vec3, 15> about(const Vec3& p, double by) {
  std::array<Vec3, 15> places;
  std::size_t i = 0;
  places[i++] = p;
  for (int axis = 0; axis < 3; ++axis)
    for (const double s : {-1.0, 1.0}) places[i++] = p + s * by * Vec3::Unit(axis);
  for (int corner = 0; corner < 8; ++corner)
    places[i++] = p + by / std::sqrt(3.0) * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  return places;
}

ToolPose between(const ToolPose& a, const ToolPose& b, double t) {
  return {a.tip + t * (b.tip - a.tip), (a.axis + t * (b.axis - a.axis)).normalized()};
}

std::vector<Stroke> strokes_of(const ToolSolid& solid, const std::vector<ToolPose>& way) {
  std::vector<Stroke> strokes;
  for (std::size_t i = 1; i < way.size(); ++i)
    for (const ToolPiece& piece : solid.pieces)
      if (piece.role == ToolRole::cutting)
        strokes.push_back({&piece, way[i - 1], way[i], static_cast<std::uint32_t>(i), true});
  return strokes;
}

/// A random walk through a box, with turns of at most `turn` radians per step.
std::vector<ToolPose> random_way(std::mt19937& random, int count, double turn) {
  std::uniform_real_distribution<double> unit(-1, 1);
  ToolPose pose{{2 * unit(random) + 5, 2 * unit(random) + 5, 4 + 2 * unit(random)}, Vec3::UnitZ()};
  if (turn > 0) pose.axis = Vec3(unit(random), unit(random), unit(random)).normalized();
  std::vector<ToolPose> way{pose};
  Vec3 direction(unit(random), unit(random), 0.3 * unit(random));
  for (int i = 0; i < count; ++i) {
    direction = (direction + 0.6 * Vec3(unit(random), unit(random), 0.4 * unit(random))).normalized();
    pose.tip += 0.7 * direction;
    for (int a = 0; a < 3; ++a)
      if (pose.tip[a] < 1 || pose.tip[a] > (a == 2 ? 7 : 9))
        direction[a] = -direction[a], pose.tip[a] = std::clamp(pose.tip[a], 1.0, a == 2 ? 7.0 : 9.0);
    if (turn > 0)
      pose.axis = (pose.axis + turn * Vec3(unit(random), unit(random), unit(random)) / std::sqrt(3.0)).normalized();
    way.push_back(pose);
  }
  return way;
}

/// Each edge of a closed mesh belongs to two triangles, once in each direction.
void expect_closed(const TriangleMesh& mesh, const std::string& what) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << what;
    ASSERT_TRUE(edges.contains({edge.second, edge.first})) << what;
  }
}

struct Case {
  const char* shape;
  double turn;
  int brick;
  bool both_ends;
};

class StockTwin : public ::testing::TestWithParam<Case> {};

// Points well inside of the tool's poses are air, points well outside are solid, and the surface
// crosses an edge of the lattice where membership changes.
TEST_P(StockTwin, AgreesWithMembershipAtManyPoses) {
  const Case& c = GetParam();
  const Tool tool = cutter(c.shape);
  const ToolSolid solid = tool_solid(tool);
  std::mt19937 random(static_cast<unsigned>(c.turn * 1000) + 7);
  StockSettings settings;
  settings.cell = 0.43;
  settings.brick = c.brick;
  settings.both_ends = c.both_ends;
  settings.tolerance = 0.002;
  const Box box{{0, 0, 0}, {10, 10, 8}};
  Stock stock(box, settings);
  const std::vector<ToolPose> way = random_way(random, 8, c.turn);
  const auto results = stock.cut(strokes_of(solid, way));
  constexpr double near = 0.02;
  std::vector<ToolPose> poses;
  for (std::size_t i = 1; i < way.size(); ++i)
    for (int k = 0; k <= 24; ++k) poses.push_back(between(way[i - 1], way[i], k / 24.0));
  const StockLattice& lattice = stock.lattice();
  std::uint64_t removed = 0, wrong_solid = 0, wrong_air = 0;
  Index3 p;
  for (p[2] = 0; p[2] <= lattice.cells()[2]; ++p[2])
    for (p[1] = 0; p[1] <= lattice.cells()[1]; ++p[1])
      for (p[0] = 0; p[0] <= lattice.cells()[0]; ++p[0]) {
        const Vec3 place = lattice.spacing().cwiseProduct(Vec3(p[0], p[1], p[2]));
        bool surely_inside = false, surely_outside = true;
        for (const ToolPose& pose : poses) {
          if ((place - pose.tip - 4.5 * pose.axis).norm() > 5) continue;
          int count = 0;
          for (const Vec3& q : about(place, near)) count += in_tool(tool, pose, q);
          surely_inside |= count == 15, surely_outside &= count == 0;
          if (surely_inside) break;
        }
        const bool is_solid = stock.solid(p);
        removed += !is_solid;
        if (surely_inside && is_solid) ++wrong_solid;
        if (surely_outside && !is_solid) ++wrong_air;
      }
  EXPECT_EQ(wrong_solid, 0u);
  EXPECT_EQ(wrong_air, 0u);
  EXPECT_GT(removed, 200u);
  double volume = 0;
  for (const StrokeResult& r : results) volume += r.volume;
  const double left = stock.volume(), all = box.size().prod();
  EXPECT_NEAR(volume, all - left, 0.06 * volume);
  const TriangleMesh mesh = stock.mesh();
  expect_closed(mesh, c.shape);
  EXPECT_NEAR(mesh.volume(), left, 0.02 * all);
  // Vertices made by tools lie on their swept volumes.
  for (const StockEdges edges : {StockEdges::sampled, StockEdges::sharp}) {
    std::vector<std::uint32_t> cuts;
    const TriangleMesh again = stock.mesh(&cuts, Progress::none(), edges);
    std::size_t checked = 0, off = 0;
    for (std::size_t v = 0; v < cuts.size(); v += 2) {
      if (cuts[v] == 0) continue;
      const Vec3 place(again.vertices[v][0], again.vertices[v][1], again.vertices[v][2]);
      bool touches = false, inside = false;
      for (const ToolPose& pose : poses) {
        if ((place - pose.tip).norm() > 10) continue;
        int count = 0;
        for (const Vec3& q : about(place, 2 * near)) count += in_tool(tool, pose, q);
        touches |= count > 0, inside |= count == 15;
      }
      ++checked;
      off += !touches || inside;
    }
    EXPECT_GT(checked, 80u);
    // A lattice does not represent features thinner than its cells: nearby vertices may deviate.
    EXPECT_LE(off, checked / (edges == StockEdges::sampled ? 100 : 30));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Tools, StockTwin,
    ::testing::Values(Case{"flat", 0, 64, true}, Case{"ball", 0, 16, true}, Case{"bull", 0, 64, true},
                      Case{"v", 0, 64, true}, Case{"drill", 0, 16, true}, Case{"tapered", 0, 64, true},
                      Case{"form", 0, 64, true}, Case{"flat", 0.05, 16, true}, Case{"ball", 0.05, 64, true},
                      Case{"bull", 0.05, 64, true}, Case{"v", 0.05, 0, true}, Case{"tapered", 0.05, 64, true},
                      Case{"form", 0.05, 16, true}, Case{"flat", 0.05, 0, false}, Case{"ball", 0.05, 64, false},
                      Case{"bull", 0.05, 16, false}),
    [](const auto& test) {
      return fmt::format("{}_{}_{}_{}", test.param.shape, test.param.turn > 0 ? "turning" : "straight",
                         test.param.brick, test.param.both_ends ? "both" : "one");
    });

// A ball along an oblique straight line: every vertex of the groove lies on the capsule.
TEST(Stock, GrooveOfABallIsExact) {
  Tool tool = cutter("ball");
  tool.diameter = 6;
  const ToolSolid solid = tool_solid(tool);
  StockSettings settings;
  settings.cell = 0.1;
  Stock stock({{0, 0, 0}, {20, 20, 5}}, settings);
  const ToolPose a{{3.3, 2.1, 2.2}, Vec3::UnitZ()}, b{{16.4, 17.9, 3.1}, Vec3::UnitZ()};
  stock.cut(strokes_of(solid, {a, b}));
  std::vector<std::uint32_t> cuts;
  const TriangleMesh mesh = stock.mesh(&cuts);
  const Vec3 from = a.tip + 3 * Vec3::UnitZ(), way = b.tip - a.tip;
  double worst = 0, sum = 0;
  std::size_t count = 0;
  for (const auto& t : mesh.triangles) {
    Vec3 centre = Vec3::Zero();
    bool cut = true;
    for (const std::uint32_t v : t) {
      centre += Vec3(mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]) / 3;
      cut &= cuts[v] != 0;
    }
    const double t_at = (centre - from).dot(way) / way.squaredNorm();
    if (!cut || t_at < 0 || t_at > 1) continue;
    const double error = std::abs((centre - from - t_at * way).norm() - 3);
    worst = std::max(worst, error), sum += error, ++count;
  }
  ASSERT_GT(count, 10000u);
  EXPECT_LT(worst, 0.02);
  EXPECT_LT(sum / static_cast<double>(count), 0.005);
}

// A tool that moves far along its axis and turns a little: its grazing curves move round it.
TEST(Stock, SlidingAlongTheAxisWhileTurningLeavesNothing) {
  Tool tool = cutter("bull");
  tool.corner_radius = 0.5;
  tool.flute = 6;
  const ToolPose a{{0.677, 1.012, 2.723}, Vec3(0.99666, 0.08167, -0.00201).normalized()};
  const ToolPose b{{3.869, 1.055, 3.142}, Vec3(0.98407, 0.17674, 0.01931).normalized()};
  const ToolSolid solid = tool_solid(tool);
  StockSettings settings;
  settings.cell = 0.2;
  settings.tolerance = 0.0074;  // the tolerance for which such a turn is divided
  Stock stock({{0, 0, 0}, {8, 8, 6}}, settings);
  stock.cut(strokes_of(solid, {a, b}));
  const StockLattice& lattice = stock.lattice();
  std::size_t inside = 0, left = 0;
  Index3 p;
  for (p[2] = 0; p[2] <= lattice.cells()[2]; ++p[2])
    for (p[1] = 0; p[1] <= lattice.cells()[1]; ++p[1])
      for (p[0] = 0; p[0] <= lattice.cells()[0]; ++p[0]) {
        const auto near = about(lattice.spacing().cwiseProduct(Vec3(p[0], p[1], p[2])), 2.5 * settings.tolerance);
        for (int k = 0; k <= 40; ++k)
          if (std::all_of(near.begin(), near.end(),
                          [&](const Vec3& q) { return in_tool(tool, between(a, b, k / 40.0), q); })) {
            ++inside, left += stock.solid(p);
            break;
          }
      }
  EXPECT_GT(inside, 4000u);
  EXPECT_EQ(left, 0u);
}

TEST(Stock, StrokesThatOnlyAskLeaveItAsItIs) {
  const ToolSolid solid = tool_solid(cutter("flat"));
  Stock stock({{0, 0, 0}, {10, 10, 5}}, {});
  const std::vector<ToolPose> way{{{2, 5, 3}, Vec3::UnitZ()}, {{8, 5, 3}, Vec3::UnitZ()}};
  std::vector<Stroke> strokes = strokes_of(solid, way);
  strokes[0].removes = false;
  const auto asked = stock.cut(strokes);
  EXPECT_NEAR(stock.volume(), 500, 1e-6);
  strokes[0].removes = true;
  const auto removed = stock.cut(strokes);
  EXPECT_EQ(asked[0].points, removed[0].points);
  EXPECT_NEAR(asked[0].volume, removed[0].volume, 1e-9);
  // columns on the border count fully
  EXPECT_NEAR(removed[0].volume, 2 * (6 * 3 + std::numbers::pi * 2.25), 1.5);
  EXPECT_EQ(stock.cut(strokes)[0].points, 0u);
}

TEST(Stock, CopiesAreCheckpoints) {
  const ToolSolid solid = tool_solid(cutter("ball"));
  std::mt19937 random(3);
  const std::vector<Stroke> strokes = strokes_of(solid, random_way(random, 20, 0.04));
  StockSettings settings;
  settings.cell = 0.25;
  settings.brick = 16;
  Stock stock({{0, 0, 0}, {10, 10, 8}}, settings);
  const std::span<const Stroke> all(strokes);
  stock.cut(all.first(10));
  const Stock checkpoint = stock;
  const TriangleMesh before = checkpoint.mesh();
  stock.cut(all.subspan(10));
  const TriangleMesh after = stock.mesh();
  EXPECT_EQ(checkpoint.mesh().vertices, before.vertices);
  Stock again = checkpoint;
  again.cut(all.subspan(10));
  EXPECT_EQ(again.mesh().vertices, after.vertices);
  EXPECT_EQ(again.mesh().triangles, after.triangles);
}

/// Triangles by the positions of their corners, each starting with its smallest corner.
std::multiset<std::array<std::array<float, 3>, 3>> by_places(const TriangleMesh& mesh) {
  std::multiset<std::array<std::array<float, 3>, 3>> set;
  for (const auto& t : mesh.triangles) {
    std::array<std::array<float, 3>, 3> places{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
    set.insert(places);
  }
  return set;
}

// After each of many cuts the updated surface equals a new one, piece by piece, and pieces reported
// as unchanged are unchanged.
TEST(Stock, SurfaceIsKeptUpToDate) {
  for (const int brick : {6, 11, 64}) {
    StockSettings settings;
    settings.cell = 0.2;
    settings.brick = brick;
    Stock stock({{0, 0, 0}, {10, 10, 8}}, settings);
    StockSurface surface;
    std::mt19937 random(static_cast<unsigned>(brick));
    std::vector<std::multiset<std::array<std::array<float, 3>, 3>>> pieces;
    std::size_t stayed = 0;
    for (const char* shape : {"ball", "flat", "form", "ball", "ball", "bull"}) {
      const ToolSolid solid = tool_solid(cutter(shape));
      std::vector<ToolPose> way = random_way(random, 2, 0.04);
      way[1].tip = way[0].tip + 0.1 * (way[1].tip - way[0].tip);
      stock.cut(strokes_of(solid, way));
      const std::vector<std::size_t> changed = surface.update(stock);
      std::vector<std::uint32_t> cuts, cuts_at_once;
      const TriangleMesh mesh = surface.mesh(&cuts),
                         at_once = stock.mesh(&cuts_at_once, Progress::none(), StockEdges::sampled);
      ASSERT_EQ(mesh.vertices, at_once.vertices);
      ASSERT_EQ(mesh.triangles, at_once.triangles);
      ASSERT_EQ(cuts, cuts_at_once);
      expect_closed(mesh, shape);
      std::vector<char> used(mesh.vertices.size());
      for (const auto& t : mesh.triangles)
        for (const std::uint32_t v : t) used[v] = 1;
      EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
      pieces.resize(surface.pieces());
      StockSurface anew;
      anew.update(stock);
      for (std::size_t i = 0; i < surface.pieces(); ++i) {
        const auto piece = by_places(surface.piece(i));
        const bool said = std::find(changed.begin(), changed.end(), i) != changed.end();
        if (!said) {
          EXPECT_EQ(piece, pieces[i]);
        }
        stayed += !said;
        EXPECT_EQ(piece, by_places(anew.piece(i)));
        pieces[i] = piece;
      }
      EXPECT_TRUE(surface.update(stock).empty());
    }
    if (brick < 64) {
      EXPECT_GT(stayed, 100u);
    }
  }
}

TEST(Stock, BeginsAsAField) {
  const FieldPtr field = frep::make_field(frep::parse_infix("max(sqrt(square(x) + square(y)) - 4, abs(z) - 3)"));
  StockSettings settings;
  settings.cell = 0.2;
  settings.brick = 16;
  const Stock stock(*field, {{-4.5, -4.5, -3.5}, {4.5, 4.5, 3.5}}, settings);
  const TriangleMesh mesh = stock.mesh();
  expect_closed(mesh, "cylinder");
  EXPECT_NEAR(mesh.volume(), std::numbers::pi * 16 * 6, 2.0);
  for (const auto& v : mesh.vertices) EXPECT_NEAR(field->value({v[0], v[1], v[2]}), 0, 2e-3);
}

/// The square root of a negative number is NaN, which counts as outside: an interval that contains
/// it proves nothing.
TEST(Stock, IsOutsideWhereItsFieldIsNoNumber) {
  const FieldPtr field = frep::make_field(frep::parse_infix("sqrt(x) - 100"));
  StockSettings settings;
  settings.cell = 0.5;
  settings.brick = 16;
  const Stock stock(*field, {{-4, -4, -4}, {4, 4, 4}}, settings);
  EXPECT_NEAR(stock.mesh().volume(), 4 * 8 * 8, 2.0);
}

TEST(Stock, RefusesWhatIsNone) {
  EXPECT_THROW(Stock(Box{{0, 0, 0}, {1, 1, 0}}), Error);
  StockSettings settings;
  settings.cell = 0;
  EXPECT_THROW(Stock(Box{{0, 0, 0}, {1, 1, 1}}, settings), Error);
  settings.cell = 1e-9;
  EXPECT_THROW(Stock(Box{{0, 0, 0}, {1, 1, 1}}, settings), Error);
  EXPECT_THROW(parse_split_rules("CTD, ABC"), Error);
  EXPECT_EQ(parse_split_rules("fefs-ffs, ctd, SPT, rs").size(), 4u);
}

}  // namespace
}  // namespace fieldfab::cam
