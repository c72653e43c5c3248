// Figures of docs/simulation.md, beside the thesis's own numbers: its examples (Hahn 6.1), rebuilt
// from their pictures; subdivisions by rules (Tables 6.2 to 6.4); time and memory (6.5, 6.6); and
// the closest-point error (6.7). Also cutsim's job, and growth of time and memory with density. An
// argument selects one part: splits, time, error, tilted, growth.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/cam/stock/surface.h"

using namespace fieldfab;
using namespace fieldfab::cam;

namespace {

constexpr double pi = std::numbers::pi;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

ToolSolid ball(double radius) {
  Tool tool;
  tool.shape = ToolShape::ball;
  tool.diameter = 2 * radius;
  tool.flute = 5;
  return tool_solid(tool);
}

struct Example {
  std::string name;
  Vec3 size;
  double radius;                            ///< of its ball
  std::vector<std::vector<ToolPose>> ways;  ///< several cuts in sequence
};

/// Pose of a tool with its ball's centre at a point.
ToolPose about(const Vec3& middle, const Vec3& axis, double radius) {
  return {middle - radius * axis.normalized(), axis.normalized()};
}

/// Straight into the material and out again.
std::vector<ToolPose> drill(const Vec3& end, const Vec3& axis, double depth, double radius) {
  std::vector<ToolPose> way;
  for (int i = 0; i <= 10; ++i) way.push_back(about(end + axis.normalized() * depth * (10 - i) / 10, axis, radius));
  return way;
}

/// Rotation about z with the tool tilted outwards by an angle (inwards if negative).
std::vector<ToolPose> donut(const Vec3& centre, double from, double to, double turns, double lean, double radius,
                            double rise = 0) {
  std::vector<ToolPose> way;
  const int steps = static_cast<int>(100 * turns);
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, angle = 2 * pi * turns * t, r = from + t * (to - from);
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    way.push_back(about(centre + r * out + rise * t * Vec3::UnitZ(),
                        std::sin(lean) * out + std::cos(lean) * Vec3::UnitZ(), radius));
  }
  return way;
}

std::vector<Example> examples() {
  std::vector<Example> list;
  const double degree = pi / 180;
  list.push_back({"CS", {2, 2, 1.5}, 0.12, {donut({1, 1, 0.25}, 0.85, 0.85, 6, 90 * degree, 0.12, 1.0)}});
  list.push_back({"D1", {4, 4, 2}, 0.2, {donut({2, 2, 1.3}, 1.3, 1.3, 1, 25 * degree, 0.2)}});
  list.push_back({"D2", {4, 4, 2}, 0.15, {donut({2, 2, 1.5}, 1.0, 1.0, 1, 45 * degree, 0.15)}});
  list.push_back({"DS1", {4, 4, 2}, 0.15, {donut({2, 2, 1.4}, 0.4, 1.6, 3, 30 * degree, 0.15)}});
  list.push_back({"DS2", {4, 4, 2}, 0.15, {donut({2, 2, 1.4}, 0.5, 1.5, 2, -30 * degree, 0.15)}});
  Example connected{"MA1", {1, 1, 1}, 0.08, {}}, apart{"MA2", {1, 1, 1}, 0.08, {}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (Example* e : {&connected, &apart})
        e->ways.push_back(drill({0.25 + 0.25 * i, 0.3 + 0.25 * j, 0.55}, Vec3::UnitZ(), 0.6, 0.08));
  const auto edge = [](double depth) {
    std::vector<ToolPose> way;
    for (int i = 0; i <= 10; ++i) way.push_back(about({0.05 + 0.09 * i, depth, 0.5}, Vec3(0, -1, 1), 0.08));
    return way;
  };
  connected.ways.push_back(edge(0.28)), apart.ways.push_back(edge(0.08));
  list.push_back(connected), list.push_back(apart);
  list.push_back({"NA", {1, 1, 1}, 0.12, {drill({0.45, 0.45, 0.45}, {1, 1, std::sqrt(2.0)}, 1, 0.12)}});
  list.push_back({"A1", {1, 1, 1}, 0.12, {drill({0.45, 0.5, 0.45}, {1, 0, 1}, 1, 0.12)}});
  Example cube{"A2", {2, 2, 2}, 0.2, {}};
  for (int axis = 0; axis < 3; ++axis) cube.ways.push_back(drill({1, 1, 1}, Vec3::Unit(axis), 1.2, 0.2));
  list.push_back(cube);
  list.push_back({"A3",
                  {1, 1, 1},
                  0.12,
                  {{about({-0.2, 0.5, 1.0}, Vec3::UnitZ(), 0.12), about({1.2, 0.5, 1.0}, Vec3::UnitZ(), 0.12)},
                   {about({1.0, -0.2, 0.4}, Vec3::UnitX(), 0.12), about({1.0, 1.2, 0.4}, Vec3::UnitX(), 0.12)}}});
  return list;
}

Stock machined(const Example& example, const StockSettings& settings, double& seconds) {
  const ToolSolid solid = ball(example.radius);
  std::vector<Stroke> strokes;
  for (const auto& way : example.ways)
    for (std::size_t i = 1; i < way.size(); ++i)
      strokes.push_back({&solid.pieces[0], way[i - 1], way[i], static_cast<std::uint32_t>(strokes.size() + 1), true});
  Stock stock(Box{Vec3::Zero(), example.size}, settings);
  const double start = now();
  stock.cut(strokes);
  seconds = now() - start;
  return stock;
}

/// Memory of a grid with a pointer per point, and a triplet of samples for each point with a sample
/// on one of its three upward edges; bytes.
double pointer_grid(const Stock& stock) {
  double points = 1;
  for (const int cells : stock.lattice().cells()) points *= cells + 1;
  StockSurface surface;
  surface.update(stock);
  double samples = 0;  // one per vertex; a closed mesh has about half as many vertices as triangles
  for (std::size_t i = 0; i < surface.pieces(); ++i)
    samples += static_cast<double>(surface.piece(i).triangles.size()) / 2;
  // A surface has about two samples per triplet.
  return 8 * points + samples / 2 * 3 * 8;
}

/// Rules, and the thesis's numbers of subdivisions for them (Table 6.2).
struct Rules {
  std::string names;
  std::vector<double> theirs;
};

void splits(double density) {
  const std::vector<Rules> table{{"RS", {2893, 528, 508, 2448, 911, 707, 321, 31, 4, 16, 1}},
                                 {"CTD, RS", {4143, 4928, 4642, 16816, 10946, 683, 150, 43, 3, 14, 1}},
                                 {"SPT, RS", {1390, 276, 269, 1547, 843, 584, 147, 22, 1, 11, 1}},
                                 {"FFS, RS", {282, 159, 132, 1246, 286, 562, 224, 12, 10, 5, 2}},
                                 {"FEFS, CTD, SPT, RS", {358, 120, 96, 1163, 307, 560, 128, 12, 1, 12, 1}},
                                 {"FEFS-FFS, CTD, SPT, RS", {314, 103, 81, 1109, 293, 550, 163, 12, 1, 12, 1}},
                                 {"FEFS-FFS, SPT, CTD, RS", {379, 131, 125, 1059, 289, 547, 158, 10, 1, 15, 1}}};
  fmt::print("Subdivisions at density {}, one direction a cell and one cell at first, as in the thesis\n{:24}", density,
             "");
  const auto all = examples();
  for (const Example& e : all) fmt::print("{:>7}", e.name);
  fmt::print("\n");
  std::vector<double> chance;
  for (const Rules& rules : table) {
    fmt::print("{:24}", rules.names);
    std::vector<double> ours;
    for (const Example& e : all) {
      StockSettings settings;
      settings.cell = 1 / density, settings.brick = 0, settings.both_ends = false,
      settings.rules = parse_split_rules(rules.names);
      double seconds = 0;
      ours.push_back(static_cast<double>(machined(e, settings, seconds).statistics().splits));
      fmt::print("{:>7}", ours.back());
      std::fflush(stdout);
    }
    if (chance.empty()) chance = ours;
    const auto line = [&](const std::string& name, const auto& value) {
      fmt::print("\n  {:22}", name);
      for (std::size_t i = 0; i < ours.size(); ++i) fmt::print("{:>7}", value(i));
    };
    line("thesis", [&](std::size_t i) { return fmt::format("{}", rules.theirs[i]); });
    line("ours / thesis", [&](std::size_t i) { return fmt::format("{:.2f}", ours[i] / rules.theirs[i]); });
    // Table 6.3: subdivisions by a rule, relative to random choice.
    const auto share = [](double part, double whole) {
      return whole > 0 ? fmt::format("{:.0f}", 100 * part / whole) : "-";
    };
    line("% of RS, ours", [&](std::size_t i) { return share(ours[i], chance[i]); });
    line("% of RS, thesis", [&](std::size_t i) { return share(rules.theirs[i], table[0].theirs[i]); });
    fmt::print("\n");
  }
}

void time_and_memory(double density) {
  // Rules FEFS-FFS, CTD, SPT, RS: total seconds without rendering (Table 6.5), percentage of a 3D
  // pointer grid (Table 6.6).
  const std::vector<double> seconds_of_thesis{197.83, 24.02, 12.88, 40.38, 27.77, 20.39,
                                              17.06,  1.42,  3.23,  19.63, 7.45};
  const std::vector<double> share_of_thesis{31.82, 5.92, 2.13, 5.38, 4.22, 24.62, 22.90, 6.92, 6.24, 4.66, 6.35};
  fmt::print("Time and memory at density {}, as they come (bricks of 64, both ends)\n", density);
  fmt::print("{:5}{:>8}{:>9}{:>9}{:>10}{:>16}{:>11}{:>8}{:>10}{:>15}\n", "", "splits", "cut s", "mesh s", "thesis s",
             "thesis / ours", "bytes", "grid %", "thesis %", "ours / thesis");
  const auto all = examples();
  for (std::size_t i = 0; i < all.size(); ++i) {
    StockSettings settings;
    settings.cell = 1 / density;
    double seconds = 0;
    const Stock stock = machined(all[i], settings, seconds);
    const double start = now();
    (void)stock.mesh();
    const double meshing = now() - start;
    const StockStatistics s = stock.statistics();
    const double share = 100 * static_cast<double>(s.bytes) / pointer_grid(stock);
    fmt::print("{:5}{:>8}{:>9.3f}{:>9.3f}{:>10.2f}{:>16.0f}{:>11}{:>8.2f}{:>10.2f}{:>15.2f}\n", all[i].name, s.splits,
               seconds, meshing, seconds_of_thesis[i], seconds_of_thesis[i] / (seconds + meshing), s.bytes, share,
               share_of_thesis[i], share / share_of_thesis[i]);
  }
}

/// cutsim's job: 7381 poses of a tilted 6 mm cutter, in rows 1 mm apart over a block of 60 x 60 x
/// 20 mm.
Stock milled(ToolShape shape, double cell, double& cutting, double& meshing) {
  Tool tool;
  tool.shape = shape;
  tool.diameter = 6;
  tool.flute = 30;
  const ToolSolid solid = tool_solid(tool);
  const double a = 25 * pi / 180, c = 20 * pi / 180;
  const Vec3 axis(std::sin(a) * std::sin(c), -std::sin(a) * std::cos(c), std::cos(a));
  std::vector<Stroke> strokes;
  ToolPose last;
  for (int row = 0; row <= 60; ++row)
    for (int step = 0; step <= 120; ++step) {
      const double x = row % 2 ? 60 - 0.5 * step : 0.5 * step;
      const ToolPose pose{{x, static_cast<double>(row), -4 + 2 * std::sin(x / 8) * std::cos(row / 9.0)}, axis};
      if (row || step)
        strokes.push_back({&solid.pieces[0], last, pose, static_cast<std::uint32_t>(strokes.size() + 1), true});
      last = pose;
    }
  StockSettings settings;
  settings.cell = cell;
  Stock stock(Box{{0, 0, -20}, {60, 60, 0}}, settings);
  const double start = now();
  stock.cut(strokes);
  cutting = now() - start;
  (void)stock.mesh();
  meshing = now() - start - cutting;
  return stock;
}

void tilted() {
  struct Rival {
    ToolShape shape;
    double cell, seconds, bytes;
  };
  fmt::print("7381 poses of a leaning 6 mm cutter, cutsim's job\n{:6}{:>8}{:>8}{:>8}{:>10}{:>9}{:>15}{:>10}{:>15}\n",
             "", "cell", "cut s", "mesh s", "cutsim s", "ratio", "bytes", "cutsim", "cutsim / ours");
  for (const Rival& rival : {Rival{ToolShape::flat, 0.156, 31, 2.9e9}, Rival{ToolShape::ball, 0.313, 9.2, 0.74e9}}) {
    double cutting = 0, meshing = 0;
    const auto bytes = static_cast<double>(milled(rival.shape, rival.cell, cutting, meshing).statistics().bytes);
    fmt::print("{:6}{:>8}{:>8.2f}{:>8.2f}{:>10}{:>9.1f}{:>15}{:>10.3g}{:>15.0f}\n", name_of(rival.shape), rival.cell,
               cutting, meshing, rival.seconds, rival.seconds / (cutting + meshing), bytes, rival.bytes,
               rival.bytes / bytes);
  }
}

/// The same job with doubling density: a surface grows with the square, a grid of points with the
/// cube.
void growth() {
  fmt::print("The same job with a flat cutter as density doubles\n{:>8}{:>9}{:>9}{:>12}{:>9}{:>12}\n", "cell", "cut s",
             "mesh s", "bytes", "time x", "bytes x");
  double last_time = 0, last_bytes = 0;
  for (const double cell : {0.8, 0.4, 0.2, 0.1, 0.05}) {
    double cutting = 0, meshing = 0;
    const auto bytes = static_cast<double>(milled(ToolShape::flat, cell, cutting, meshing).statistics().bytes);
    const auto times = [](double now, double before) { return before > 0 ? fmt::format("{:.2f}", now / before) : ""; };
    fmt::print("{:>8}{:>9.3f}{:>9.3f}{:>12}{:>9}{:>12}\n", cell, cutting, meshing, bytes,
               times(cutting + meshing, last_time), times(bytes, last_bytes));
    std::fflush(stdout);
    last_time = cutting + meshing, last_bytes = bytes;
  }
}

/// Table 6.7: distance of the triangles' centres from the surface that a tilted ball sweeps in a
/// rotation (equations 6.1 to 6.7).
void error() {
  const double lean = 25 * pi / 180, radius = 0.15, major = 1.69;
  const Vec3 centre(2, 2, 0.6748);
  const std::vector<double> theirs{0.1082255, 0.0278254, 0.0069804, 0.0020188, 0.0005377, 0.0001459};
  fmt::print("Closest-point error of Table 6.7\n{:>8}{:>12}{:>12}{:>15}{:>12}\n", "density", "3-map", "ours",
             "ours / thesis", "a doubling");
  double last = 0;
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    const double density = 4 << i;
    Example e{"", {4, 4, 1}, radius, {{}}};
    constexpr int steps = 3600;
    for (int k = 0; k <= steps; ++k) {
      const double angle = 2 * pi * k / steps;
      const Vec3 out(std::cos(angle), std::sin(angle), 0);
      e.ways[0].push_back(about(centre + major * out, -std::sin(lean) * out + std::cos(lean) * Vec3::UnitZ(), radius));
    }
    StockSettings settings;
    settings.cell = 1 / density;
    double seconds = 0;
    std::vector<std::uint32_t> cuts;
    const TriangleMesh mesh = machined(e, settings, seconds).mesh(&cuts);
    double worst = 0;
    for (const auto& t : mesh.triangles) {
      Vec3 p = Vec3::Zero();
      bool cut = true;
      for (const std::uint32_t v : t)
        p += Vec3(mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]) / 3, cut &= cuts[v] != 0;
      if (!cut) continue;
      const Vec3 out = Vec3(p.x() - 2, p.y() - 2, 0).normalized(), a = centre + major * out,
                 way = centre + major / std::tan(lean) * Vec3::UnitZ() - a;
      const double along = std::max((p - a).dot(way) / way.squaredNorm(), 0.0);
      worst = std::max(worst, std::abs((p - a - along * way).norm() - radius));
    }
    fmt::print("{:>8}{:>12.7f}{:>12.7f}{:>15.2f}{:>12}\n", density, theirs[i], worst, worst / theirs[i],
               last > 0 ? fmt::format("{:.2f}", last / worst) : "");
    std::fflush(stdout);
    last = worst;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string part = argc > 1 ? argv[1] : "";
  const double density = argc > 2 ? std::stod(argv[2]) : 100;
  if (part.empty() || part == "error") error();
  if (part.empty() || part == "time") time_and_memory(density);
  if (part.empty() || part == "tilted") tilted();
  if (part.empty() || part == "growth") growth();
  if (part.empty() || part == "splits") splits(argc > 2 ? density : 50);
}
