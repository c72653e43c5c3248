// Figures of docs/simulation.md: the thesis's examples (Hahn 6.1) rebuilt from their pictures, subdivisions by rules (Tables 6.2
// to 6.4), time and memory (6.5, 6.6), and the closest-point error (6.7). With an argument, only the part of that name: splits,
// time, error.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "fieldfab/cam/stock.h"

using namespace fieldfab;
using namespace fieldfab::cam;

namespace {

constexpr double pi = std::numbers::pi;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

ToolSolid ball(double radius) {
  Tool tool;
  tool.shape = "ball";
  tool.diameter = 2 * radius;
  tool.flute = 5;
  return tool_solid(tool);
}

struct Example {
  std::string name;
  Vec3 size;
  double radius;                            ///< of its ball
  std::vector<std::vector<ToolPose>> ways;  ///< several cuts, one after the other
};

/// The tool with the middle of its ball at a place.
ToolPose about(const Vec3& middle, const Vec3& axis, double radius) {
  return {middle - radius * axis.normalized(), axis.normalized()};
}

/// Straight into the material and out again.
std::vector<ToolPose> drill(const Vec3& end, const Vec3& axis, double depth, double radius) {
  std::vector<ToolPose> way;
  for (int i = 0; i <= 10; ++i) way.push_back(about(end + axis.normalized() * depth * (10 - i) / 10, axis, radius));
  return way;
}

/// Turns about z with the tool leaning outwards by an angle (inwards where it is below 0).
std::vector<ToolPose> donut(const Vec3& centre, double from, double to, double turns, double lean, double radius,
                            double rise = 0) {
  std::vector<ToolPose> way;
  const int steps = static_cast<int>(100 * turns);
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, angle = 2 * pi * turns * t, r = from + t * (to - from);
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    way.push_back(
        about(centre + r * out + rise * t * Vec3::UnitZ(), std::sin(lean) * out + std::cos(lean) * Vec3::UnitZ(), radius));
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

/// Bytes of a grid with a pointer for each point and, where one of the three edges upwards from it has a sample, a triplet of
/// them.
double pointer_grid(const Stock& stock) {
  double points = 1;
  for (const int cells : stock.lattice().cells()) points *= cells + 1;
  std::vector<std::uint32_t> cuts;
  const double samples = static_cast<double>(stock.mesh(&cuts).vertices.size());
  // A surface has about two samples for each triplet.
  return 8 * points + samples / 2 * 3 * 8;
}

void splits(double density) {
  const std::vector<std::string> rules{
      "RS", "CTD, RS", "SPT, RS", "FFS, RS", "FEFS, CTD, SPT, RS", "FEFS-FFS, CTD, SPT, RS", "FEFS-FFS, SPT, CTD, RS"};
  fmt::print("Subdivisions at density {}, one direction a cell and one cell at first, as in the thesis\n{:24}", density, "");
  const auto all = examples();
  for (const Example& e : all) fmt::print("{:>7}", e.name);
  fmt::print("\n");
  for (const std::string& rule : rules) {
    fmt::print("{:24}", rule);
    for (const Example& e : all) {
      StockSettings settings;
      settings.cell = 1 / density, settings.brick = 0, settings.both_ends = false, settings.rules = parse_split_rules(rule);
      double seconds = 0;
      fmt::print("{:>7}", machined(e, settings, seconds).statistics().splits);
      std::fflush(stdout);
    }
    fmt::print("\n");
  }
}

void time_and_memory(double density) {
  fmt::print("Time and memory at density {}, as they come (bricks of 64, both ends)\n{:5}{:>9}{:>9}{:>9}{:>12}{:>8}\n", density,
             "", "splits", "cut s", "mesh s", "bytes", "grid %");
  for (const Example& e : examples()) {
    StockSettings settings;
    settings.cell = 1 / density;
    double seconds = 0;
    const Stock stock = machined(e, settings, seconds);
    const double start = now();
    (void)stock.mesh();
    const double meshing = now() - start;
    const StockStatistics s = stock.statistics();
    fmt::print("{:5}{:>9}{:>9.3f}{:>9.3f}{:>12}{:>8.2f}\n", e.name, s.splits, seconds, meshing, s.bytes,
               100 * static_cast<double>(s.bytes) / pointer_grid(stock));
  }
}

/// Table 6.7: the distance of the triangles' centres from the surface that a leaning ball sweeps in a turn (equations 6.1
/// to 6.7).
void error() {
  const double lean = 25 * pi / 180, radius = 0.15, major = 1.69;
  const Vec3 centre(2, 2, 0.6748);
  const std::vector<double> theirs{0.1082255, 0.0278254, 0.0069804, 0.0020188, 0.0005377, 0.0001459};
  fmt::print("Closest-point error of Table 6.7\n{:>8}{:>12}{:>12}{:>8}\n", "density", "3-map", "ours", "ratio");
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
    fmt::print("{:>8}{:>12.7f}{:>12.7f}{:>8}\n", density, theirs[i], worst, last > 0 ? fmt::format("{:.2f}", last / worst) : "");
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
  if (part.empty() || part == "splits") splits(density);
}
