// Simulated stock against two oracles that share only the tools' definitions with it: dense dexels
// along all three axes and OpenVDB's level sets, both cut by static tools at many closely spaced
// poses.
//
// Error of the oracles: between two poses no point of a tool moves farther than `step`, so that all
// swept points lie within step / 2 of a pose. A stroke that turns is executed within the Stock's
// own tolerance. Tools larger and smaller by the sum of both bounds enclose the removed volume: the
// Stock must lie between the two results everywhere.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/LevelSetMeasure.h>

#include <cmath>
#include <map>
#include <optional>
#include <random>

#include "closed.h"
#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/cam/stock/surface.h"
#include "fieldfab/field/field.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"
#include "volume/openvdb/float_grid.h"

namespace fieldfab::cam {
namespace {

// Tools.

/// A convex solid of revolution: all points within `rounding` of the revolved half section. Its
/// outline, as (distance from the axis, height), starts at the lowest point of the axis and ends at
/// the highest.
struct Part {
  std::vector<Vec2> outline;
  double rounding = 0;

  /// Signed distance at a distance from the axis and a height: exact, and convex along any line.
  [[nodiscard]] double distance(double r, double z) const {
    const Vec2 p(r, z);
    double least = (p - outline[0]).squaredNorm();
    bool inside = outline.size() > 2;
    for (std::size_t i = 1; i < outline.size(); ++i) {
      const Vec2 way = outline[i] - outline[i - 1], to = p - outline[i - 1];
      inside &= way.x() * to.y() - way.y() * to.x() >= 0;
      if (outline.size() > 2 && outline[i].x() == 0 && outline[i - 1].x() == 0) continue;
      const double t = std::clamp(to.dot(way) / way.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (to - t * way).squaredNorm());
    }
    return (inside ? -std::sqrt(least) : std::sqrt(least)) - rounding;
  }
  [[nodiscard]] double distance(const ToolPose& pose, const Vec3& place) const {
    const Vec3 d = place - pose.tip;
    const double z = d.dot(pose.axis);
    return distance(std::sqrt(std::max(0.0, d.squaredNorm() - z * z)), z);
  }
  [[nodiscard]] Box bounds(const ToolPose& pose, double more) const {
    double r = 0;
    for (const Vec2& p : outline) r = std::max(r, p.x());
    const Vec3 low = pose.tip + outline.front().y() * pose.axis, high = pose.tip + outline.back().y() * pose.axis;
    return Box{low.cwiseMin(high), low.cwiseMax(high)}.grown(r + rounding + more);
  }
};

constexpr double flute = 6;

Tool cutter(const std::string& shape) {
  Tool tool;
  tool.shape = tool_shape_named(shape, "test");
  tool.diameter = 3;
  tool.flute = flute;
  tool.corner_radius = shape == "tapered" ? 0.6 : 0.5;
  tool.angle = shape == "tapered" ? 0.3 : 1.2;
  tool.tip_diameter = 0.8;
  if (shape == "form") tool.points = {{0, 0}, {1.5, 0}, {1.5, 1.2}, {0.8, 1.2}, {0.8, flute}};  // a T-slot cutter
  return tool;
}

/// A second, independent definition of the same tools.
std::vector<Part> parts_of(const std::string& shape) {
  constexpr double r = 1.5;
  const auto rod = [&](double from) { return Part{{{0, from}, {r, from}, {r, flute}, {0, flute}}, 0}; };
  if (shape == "flat") return {rod(0)};
  if (shape == "ball") return {{{{0, r}}, r}, rod(r)};
  if (shape == "bull") return {{{{0, 0.5}, {r - 0.5, 0.5}}, 0.5}, rod(0.5)};
  if (shape == "v") return {{{{0, 0}, {0.4, 0}, {r, (r - 0.4) / std::tan(0.6)}, {r, flute}, {0, flute}}, 0}};
  if (shape == "tapered") {
    const double from = 0.6 * (1 - std::sin(0.15)), wide = 0.6 * std::cos(0.15);
    return {{{{0, 0.6}}, 0.6},
            {{{0, from}, {wide, from}, {wide + (flute - from) * std::tan(0.15), flute}, {0, flute}}, 0}};
  }
  return {{{{0, 0}, {r, 0}, {r, 1.2}, {0, 1.2}}, 0}, {{{0, 0}, {0.8, 0}, {0.8, flute}, {0, flute}}, 0}};
}

// Programs.

ToolPose between(const ToolPose& a, const ToolPose& b, double t) {
  return {a.tip + t * (b.tip - a.tip), (a.axis + t * (b.axis - a.axis)).normalized()};
}

/// Upper bound of the displacement of a tool's points between two poses.
double farthest(const ToolPose& a, const ToolPose& b) {
  return std::max((b.tip - a.tip).norm(), (b.tip + flute * b.axis - a.tip - flute * a.axis).norm()) +
         1.5 * (b.axis - a.axis).norm();
}

struct Case {
  unsigned seed;
  const char* shape;
  bool jagged;
  const char* start;  ///< block, ball, bored
  int brick;
  bool both_ends;
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << "seed " << c.seed << ", " << c.shape; }

struct Job {
  explicit Job(const Case& c) : solid(tool_solid(cutter(c.shape))), parts(parts_of(c.shape)) {
    settings.cell = 0.37;
    settings.brick = c.brick;
    settings.both_ends = c.both_ends;
    std::mt19937 random(c.seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto direction = [&] {
      Vec3 d;
      do d = Vec3(unit(random), unit(random), unit(random));
      while (d.norm() > 1 || d.norm() < 0.1);
      return Vec3(d.normalized());
    };
    const auto inside = [&] {
      return Vec3(box.centre() + 0.42 * box.size().cwiseProduct(Vec3(unit(random), unit(random), unit(random))));
    };
    ToolPose pose{inside(), direction()};
    way.push_back(pose);
    Vec3 going = direction(), turning = direction();
    for (int i = 0; i < (c.jagged ? 5 : 16); ++i) {
      ToolPose next;
      if (c.jagged) {
        next = {inside(), (pose.axis + 0.7 * direction()).normalized()};
      } else {
        going = (going + 0.5 * direction()).normalized(), turning = (turning + 0.4 * direction()).normalized();
        next = {pose.tip + 0.6 * going, (pose.axis + 0.12 * turning).normalized()};
        if (!box.contains(next.tip)) going = (box.centre() - pose.tip).normalized(), next.tip = pose.tip + 0.6 * going;
      }
      // Divided as for programs, until the sagitta of rotations is within the tolerance.
      const int steps =
          std::max(1, static_cast<int>(std::ceil(std::acos(std::clamp(pose.axis.dot(next.axis), -1.0, 1.0)) *
                                                 std::sqrt(flute / (8 * settings.cell / 50)))));
      for (int k = 1; k <= steps; ++k) way.push_back(between(pose, next, static_cast<double>(k) / steps));
      pose = next;
    }
    if (std::string(c.start) == "ball") {
      stock.emplace(*frep::make_field(frep::parse_infix("sqrt(square(x-4)+square(y-4)+square(z-3)) - 2.9")), box,
                    settings);
      start = {{{4, 4, 3}, Vec3::UnitZ()}, Part{{{0, 0}}, 2.9}, false};
    } else if (std::string(c.start) == "bored") {
      stock.emplace(*frep::make_field(frep::parse_infix("1.3 - sqrt(square(x-4.1)+square(z-2.9))")), box, settings);
      start = {{{4.1, -1, 2.9}, Vec3::UnitY()}, Part{{{0, 0}, {1.3, 0}, {1.3, 11}, {0, 11}}, 0}, true};
    } else {
      stock.emplace(box, settings);
    }
    for (std::size_t i = 1; i < way.size(); ++i)
      for (const ToolPiece& piece : solid.pieces)
        if (piece.role == ToolRole::cutting)
          strokes.push_back({&piece, way[i - 1], way[i], static_cast<std::uint32_t>(i), true});
    stock->cut(strokes);
  }

  /// Poses of a stroke such that no point of the tool moves farther than `step` between two of
  /// them.
  [[nodiscard]] std::vector<ToolPose> poses(std::size_t stroke, double step) const {
    const int count = std::max(1, static_cast<int>(std::ceil(farthest(way[stroke - 1], way[stroke]) / step)));
    std::vector<ToolPose> result;
    for (int k = 0; k <= count; ++k)
      result.push_back(between(way[stroke - 1], way[stroke], static_cast<double>(k) / count));
    return result;
  }

  /// Error bound of the oracles: half a step, the sagitta of strokes that turn, and the tolerance
  /// of the swept surface.
  [[nodiscard]] double off(double step) const { return step / 2 + 2 * stock->tolerance(); }

  /// The initial stock: a part, or its complement, within the box.
  struct Start {
    ToolPose pose;
    Part part;
    bool hollow = false;
  };

  Box box{{0, 0, 0}, {8, 8, 6}};
  StockSettings settings;
  ToolSolid solid;
  std::vector<Part> parts;
  std::vector<ToolPose> way;
  std::vector<Stroke> strokes;
  std::optional<Start> start;
  std::optional<Stock> stock;
};

// Dexels.

struct Interval {
  double from, to;
};
/// Sorted and disjoint.
using Intervals = std::vector<Interval>;

void add(Intervals& to, Interval more) {
  Intervals result;
  for (const Interval& i : to)
    if (i.to < more.from || i.from > more.to)
      result.push_back(i);
    else
      more = {std::min(i.from, more.from), std::max(i.to, more.to)};
  result.push_back(more);
  std::sort(result.begin(), result.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
  to = std::move(result);
}

void subtract(Intervals& from, const Interval& less) {
  Intervals result;
  for (const Interval& i : from) {
    if (i.to <= less.from || i.from >= less.to) {
      result.push_back(i);
      continue;
    }
    if (i.from < less.from) result.push_back({i.from, less.from});
    if (i.to > less.to) result.push_back({less.to, i.to});
  }
  from = std::move(result);
}

bool contains(const Intervals& all, double at, double margin = 0) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Interval& i) { return at > i.from + margin && at < i.to - margin; });
}

double length(const Intervals& all) {
  double sum = 0;
  for (const Interval& i : all) sum += i.to - i.from;
  return sum;
}

/// Intervals of a line, along an axis from `at`, with a distance to the part of at most -off and of
/// at most +off.
std::array<std::optional<Interval>, 2> met(const Part& part, const ToolPose& pose, Vec3 at, int axis, double off) {
  const Box bounds = part.bounds(pose, off);
  const auto distance = [&](double s) {
    at[axis] = s;
    return part.distance(pose, at);
  };
  // The distance to a convex solid is convex along a line: ternary search for the minimum, ended
  // early at a sufficiently deep point.
  double low = bounds.lower[axis], high = bounds.upper[axis], middle = 0.5 * (low + high), least = distance(middle);
  while (least > -off && high - low > 1e-7) {
    if (least - 0.5 * (high - low) > off) return {};  // the distance has the Lipschitz constant 1
    const double a = low + (high - low) / 3, b = high - (high - low) / 3, at_a = distance(a), at_b = distance(b);
    (at_a < at_b ? high : low) = at_a < at_b ? b : a;
    middle = at_a < at_b ? a : b, least = std::min(at_a, at_b);
  }
  std::array<std::optional<Interval>, 2> result;
  for (const bool larger : {false, true}) {
    const double level = larger ? off : -off;
    if (least > level) continue;
    const auto end = [&](double outer) {
      double inner = middle;
      for (int i = 0; i < 22; ++i) {
        const double half = 0.5 * (inner + outer);
        (distance(half) <= level ? inner : outer) = half;
      }
      return inner;
    };
    result[larger] = {end(bounds.lower[axis]), end(bounds.upper[axis])};
  }
  return result;
}

/// Material along all lattice lines of one direction: `most` is an upper bound of the remaining
/// material, `least` a lower bound.
struct Dexels {
  Dexels(const StockLattice& of, int along, const Job& job, double step, double off)
      : lattice(of), axis(along), u((along + 1) % 3), v((along + 2) % 3) {
    const std::size_t lines = static_cast<std::size_t>(points(u)) * static_cast<std::size_t>(points(v));
    most.assign(lines, {{0, lattice.box().size()[axis]}}), least = most;
    hidden.resize(lines);
    if (job.start)
      for_lines(lattice.box(), [&](std::size_t line, const Vec3& at) {
        for (const auto& [left, larger] : {std::pair{&most, true}, std::pair{&least, false}}) {
          const auto in = met(job.start->part, job.start->pose, at, axis, 1e-4)[larger != job.start->hollow];
          Intervals& here = (*left)[line];
          if (job.start->hollow && in) subtract(here, *in);
          if (!job.start->hollow) here = in ? Intervals{*in} : Intervals{};
        }
        // A chord of the bore between two points is not visible to the lattice.
        if (job.start->hollow)
          if (const auto in = met(job.start->part, job.start->pose, at, axis, 1e-4); in[1])
            hide(line, {*in[1]}, in[0] ? Intervals{*in[0]} : Intervals{});
      });
    for (std::size_t stroke = 1; stroke < job.way.size(); ++stroke) cut(job, job.poses(stroke, step), off);
  }

  [[nodiscard]] int points(int a) const { return lattice.cells()[static_cast<std::size_t>(a)] + 1; }
  [[nodiscard]] std::size_t line(int at_u, int at_v) const {
    return static_cast<std::size_t>(at_v) * static_cast<std::size_t>(points(u)) + static_cast<std::size_t>(at_u);
  }

  template <class Body>
  void for_lines(const Box& box, const Body& body) {
    const auto first = [&](int a) {
      return std::max(0, static_cast<int>(std::ceil(box.lower[a] / lattice.spacing()[a])));
    };
    const auto last = [&](int a) {
      return std::min(points(a) - 1, static_cast<int>(std::floor(box.upper[a] / lattice.spacing()[a])));
    };
    for (int j = first(v); j <= last(v); ++j)
      for (int i = first(u); i <= last(u); ++i) {
        Vec3 at = Vec3::Zero();
        at[u] = i * lattice.spacing()[u], at[v] = j * lattice.spacing()[v];
        body(line(i, j), at);
      }
  }

  void cut(const Job& job, const std::vector<ToolPose>& poses, double off) {
    // All intervals that the stroke removes from each line are collected before they are
    // subtracted, so that the points among them are known.
    std::map<std::size_t, std::array<Intervals, 2>> removed;
    for (const ToolPose& pose : poses)
      for (const Part& part : job.parts)
        for_lines(part.bounds(pose, off), [&](std::size_t line, const Vec3& at) {
          const auto in = met(part, pose, at, axis, off);
          for (std::size_t larger = 0; larger < 2; ++larger)
            if (in[larger]) add(removed[line][larger], *in[larger]);
        });
    for (const auto& [line, both] : removed) {
      hide(line, both[1], both[0]);
      for (const Interval& i : both[0]) subtract(most[line], i);
      for (const Interval& i : both[1]) subtract(least[line], i);
    }
  }

  /// Marks edges between possibly solid points from which an interval without a lattice point is
  /// removed: a lattice cannot represent that (docs/simulation.md, limits).
  void hide(std::size_t line, const Intervals& removed, const Intervals& surely) {
    const double h = lattice.spacing()[axis];
    for (const Interval& i : removed) {
      bool seen = false;
      for (int k = std::max(0, static_cast<int>(i.from / h)); k < points(axis) && k * h <= i.to; ++k)
        seen |= contains(surely, k * h);
      if (seen) continue;
      for (int k = std::max(0, static_cast<int>(i.from / h)); k < points(axis) && k * h <= i.to; ++k)
        hidden[line].push_back(k);
    }
  }

  [[nodiscard]] double volume(const std::vector<Intervals>& lines) const {
    double sum = 0;
    for (int j = 0; j < points(v); ++j)
      for (int i = 0; i < points(u); ++i)
        sum += (i == 0 || i == points(u) - 1 ? 0.5 : 1) * (j == 0 || j == points(v) - 1 ? 0.5 : 1) *
               length(lines[line(i, j)]);
    return sum * lattice.spacing()[u] * lattice.spacing()[v];
  }

  StockLattice lattice;
  int axis, u, v;
  std::vector<Intervals> most, least;
  std::vector<std::vector<int>> hidden;  ///< edges by their lower points
};

class StockOracle : public ::testing::TestWithParam<Case> {};

/// The axis along which a vertex lies between two lattice points, and the nearer one of them.
/// std::nullopt for vertices in the middle of a lattice cube, which some polygons need.
std::optional<int> axis_of(const StockLattice& lattice, const Vec3& place, Index3& near) {
  std::optional<int> axis;
  for (int a = 0; a < 3; ++a) {
    const double cells = place[a] / lattice.spacing()[a];
    near[static_cast<std::size_t>(a)] = static_cast<int>(std::lround(cells));
    if (std::abs(cells - std::round(cells)) < 5e-4) continue;
    if (axis) return {};
    axis = a;
  }
  return axis;
}

TEST_P(StockOracle, LiesBetweenDexelsOfLargerAndSmallerTools) {
  const Job job(GetParam());
  const Stock& stock = *job.stock;
  const StockLattice& lattice = stock.lattice();
  constexpr double step = 0.03;
  const double off = job.off(step);
  std::vector<Dexels> dexels;
  for (int axis = 0; axis < 3; ++axis) dexels.emplace_back(lattice, axis, job, step, off);

  // Points: surely solid, surely air, or undecided near the surface.
  std::size_t solid = 0, air = 0, open = 0, wrong = 0;
  Index3 p;
  for (p[2] = 0; p[2] <= lattice.cells()[2]; ++p[2])
    for (p[1] = 0; p[1] <= lattice.cells()[1]; ++p[1])
      for (p[0] = 0; p[0] <= lattice.cells()[0]; ++p[0])
        for (const Dexels& d : dexels) {
          const auto axis = static_cast<std::size_t>(d.axis);
          // a line's ends are inner points of other lines
          if (p[axis] == 0 || p[axis] == lattice.cells()[axis]) continue;
          const std::size_t line = d.line(p[static_cast<std::size_t>(d.u)], p[static_cast<std::size_t>(d.v)]);
          const double at = p[axis] * lattice.spacing()[d.axis];
          const bool surely = contains(d.least[line], at, 1e-5), perhaps = contains(d.most[line], at, -1e-5);
          ++(surely ? solid : perhaps ? open : air);
          wrong += stock.solid(p) ? !perhaps : surely;
        }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(solid, 2000u);
  EXPECT_GT(air, 2000u);
  EXPECT_LT(static_cast<double>(open), 0.03 * static_cast<double>(solid + air));

  // Intersections of the surface with the lattice's edges.
  const TriangleMesh mesh = stock.mesh();
  expect_closed(mesh);
  StockSurface surface;
  surface.update(stock);
  TriangleMesh samples;  // of the full mesh, because the other one has simplified flats
  std::vector<std::uint32_t> cuts;
  for (std::size_t i = 0; i < surface.pieces(); ++i) {
    std::vector<std::uint32_t> cuts_here;
    const TriangleMesh piece = surface.piece(i, &cuts_here);
    samples.vertices.insert(samples.vertices.end(), piece.vertices.begin(), piece.vertices.end());
    cuts.insert(cuts.end(), cuts_here.begin(), cuts_here.end());
  }
  std::size_t checked = 0, wrong_seen = 0, wrong_hidden = 0;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (cuts[i] == 0) continue;
    const Vec3 place(samples.vertices[i][0], samples.vertices[i][1], samples.vertices[i][2]);
    Index3 near;
    const std::optional<int> axis = axis_of(lattice, place, near);
    ASSERT_TRUE(axis);
    const Dexels& d = dexels[static_cast<std::size_t>(*axis)];
    const std::size_t line = d.line(near[static_cast<std::size_t>(d.u)], near[static_cast<std::size_t>(d.v)]);
    // vertices keep a distance of h / 1000 from points
    const double at = place[*axis], h = lattice.spacing()[*axis], slack = 1.1e-3 * h;
    ++checked;
    if (contains(d.most[line], at, -slack) && !contains(d.least[line], at, slack)) continue;
    const auto& hidden = d.hidden[line];
    ++(std::find(hidden.begin(), hidden.end(), static_cast<int>(at / h)) != hidden.end() ? wrong_hidden : wrong_seen);
  }
  EXPECT_GT(checked, 200u);
  EXPECT_EQ(wrong_seen, 0u);
  EXPECT_LE(wrong_hidden, checked / 200);

  // Volumes as sums over lines, along several axes. Chords of the mesh cut into convex surfaces,
  // and chamfer edges, on average by less than a twentieth of a cell.
  for (const Dexels& d : dexels) {
    EXPECT_GT(stock.volume(), d.volume(d.least));
    EXPECT_LT(stock.volume(), d.volume(d.most));
  }
  EXPECT_NEAR(mesh.volume(), stock.volume(), mesh.area() * stock.settings().cell / 20);
}

// OpenVDB.

constexpr double voxel = 0.15;

/// Level set of a function that is a distance near its surface; not defined outside of the box.
template <class Distance>
openvdb::FloatGrid::Ptr level_set(const Box& box, const Distance& distance) {
  auto grid = openvdb::createLevelSet<openvdb::FloatGrid>(voxel);
  const float background = grid->background();
  auto accessor = grid->getAccessor();
  const auto index = [](double x) { return static_cast<int>(std::floor(x / voxel)); };
  for (int i = index(box.lower.x()); i <= index(box.upper.x()) + 1; ++i)
    for (int j = index(box.lower.y()); j <= index(box.upper.y()) + 1; ++j)
      for (int k = index(box.lower.z()); k <= index(box.upper.z()) + 1; ++k) {
        const auto d = static_cast<float>(distance(Vec3(voxel * Vec3(i, j, k))));
        if (std::abs(d) < background)
          accessor.setValue({i, j, k}, d);
        else if (d < 0)
          accessor.setValueOff({i, j, k}, -background);
      }
  return grid;
}

openvdb::FloatGrid::Ptr cut_level_set(const Job& job, double step) {
  const Box around = job.box.grown(4 * voxel);
  auto stock = level_set(around, [&](const Vec3& p) {
    const Vec3 q = (p - job.box.centre()).cwiseAbs() - 0.5 * job.box.size();
    return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
  });
  if (job.start) {
    const auto shape = level_set(around, [&](const Vec3& p) { return job.start->part.distance(job.start->pose, p); });
    (job.start->hollow ? openvdb::tools::csgDifference<openvdb::FloatGrid>
                       : openvdb::tools::csgIntersection<openvdb::FloatGrid>)(*stock, *shape, true, true);
  }
  for (std::size_t stroke = 1; stroke < job.way.size(); ++stroke) {
    const std::vector<ToolPose> poses = job.poses(stroke, step);
    std::optional<Box> swept;
    for (const ToolPose& pose : poses)
      for (const Part& part : job.parts) {
        const Box here = part.bounds(pose, 4 * voxel);
        swept = swept ? hull(*swept, here) : here;
      }
    const auto tool =
        level_set({swept->lower.cwiseMax(around.lower), swept->upper.cwiseMin(around.upper)}, [&](const Vec3& p) {
          double least = 1e9;
          for (const ToolPose& pose : poses)
            for (const Part& part : job.parts) least = std::min(least, part.distance(pose, p));
          return least;
        });
    openvdb::tools::csgDifference(*stock, *tool, true, true);
  }
  return stock;
}

// The values of the level sets have an error of at most `off` and Lipschitz constant 1. Trilinear
// interpolation averages eight corners with a mean distance of at most sqrt(3) / 2 voxels. These
// two are all terms of the bound, also at sharp edges.
TEST_P(StockOracle, AgreesWithLevelSetsOfOpenVDB) {
  openvdb::initialize();
  const Job job(GetParam());
  const Stock& stock = *job.stock;
  const StockLattice& lattice = stock.lattice();
  constexpr double step = 0.05;
  const double bound = std::sqrt(3.0) / 2 * voxel + job.off(step);
  const auto grid = cut_level_set(job, step);
  openvdb::tools::GridSampler<openvdb::FloatGrid, openvdb::tools::BoxSampler> sampler(*grid);
  const auto distance = [&](const Vec3& p) {
    return static_cast<double>(sampler.wsSample(openvdb::Vec3d(p.x(), p.y(), p.z())));
  };

  std::size_t wrong = 0, told = 0;
  Index3 p;
  for (p[2] = 0; p[2] <= lattice.cells()[2]; ++p[2])
    for (p[1] = 0; p[1] <= lattice.cells()[1]; ++p[1])
      for (p[0] = 0; p[0] <= lattice.cells()[0]; ++p[0]) {
        const double d = distance(lattice.spacing().cwiseProduct(Vec3(p[0], p[1], p[2])));
        if (std::abs(d) <= bound) continue;
        ++told;
        wrong += stock.solid(p) != (d < 0);
      }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(told, 5000u);

  // Vertices at samples; level sets have no sharp edges to compare the others with.
  const TriangleMesh mesh = stock.mesh(nullptr, Progress::none(), StockEdges::sampled);
  std::size_t checked = 0;
  double worst = 0, sum = 0;
  for (const auto& v : mesh.vertices) {
    const Vec3 place(v[0], v[1], v[2]);
    Index3 near;
    const bool face = (place.array() <= 0).any() || (place.array() >= job.box.upper.array()).any();
    if (!face && !axis_of(lattice, place, near)) continue;
    const double d = std::abs(distance(place));
    worst = std::max(worst, d), sum += d, ++checked;
  }
  EXPECT_GT(checked, mesh.vertices.size() * 9 / 10);
  EXPECT_LT(worst, bound);
  EXPECT_LT(sum / static_cast<double>(checked),
            0.05 * voxel);  // on flat surfaces interpolation is exact
  // Level sets round edges by less than a voxel, and their volume is an integral over a band of
  // that width: a sixth of a voxel on average.
  for (const TriangleMesh& either : {mesh, stock.mesh()})
    EXPECT_NEAR(openvdb::tools::levelSetVolume(*grid), either.volume(), either.area() * voxel / 6);
}

INSTANTIATE_TEST_SUITE_P(
    Programs, StockOracle,
    ::testing::Values(Case{1, "flat", false, "block", 64, true}, Case{2, "ball", true, "block", 16, true},
                      Case{3, "bull", false, "ball", 16, true}, Case{4, "v", true, "bored", 64, true},
                      Case{5, "form", false, "block", 16, true}, Case{6, "tapered", true, "block", 0, true},
                      Case{7, "flat", true, "ball", 16, true}, Case{8, "ball", false, "bored", 64, false},
                      Case{9, "bull", true, "block", 0, false}, Case{10, "v", false, "block", 16, true},
                      Case{11, "form", true, "bored", 64, true}, Case{12, "tapered", false, "ball", 64, false},
                      Case{409, "bull", true, "block", 0, false}),
    [](const auto& of) {
      return fmt::format("{}_{}_{}_{}", of.param.seed, of.param.shape, of.param.jagged ? "jagged" : "smooth",
                         of.param.start);
    });

}  // namespace
}  // namespace fieldfab::cam
