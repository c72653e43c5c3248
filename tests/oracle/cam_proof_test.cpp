// Proofs for finishing paths: no gouge, and no reachable material left. Oracles: the exact Field
// and brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "../cam_tools.h"
#include "../family.h"
#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/solid/open.h"

namespace fieldfab::cam {
namespace {

constexpr double pi = std::numbers::pi;

struct Part {
  std::string name;
  FieldPtr solid;
  Box bounds;
  double sharpest = 1e9;  // minimum radius of curvature, mm: it increases the scallop height
  std::size_t number = 0;
  friend std::ostream& operator<<(std::ostream& out, const Part& p) { return out << p.name; }
};

/// Some of the tools, others for the next part: so that each is tried with several parts.
std::vector<Tool> tools_for(const Part& part, const std::vector<Tool>& all, std::size_t some) {
  std::vector<Tool> chosen;
  for (std::size_t i = 0; i < sample_or_all(some, all.size()); ++i)
    chosen.push_back(all[(part.number * some + i) % all.size()]);
  return chosen;
}

std::vector<Part> corpus() {
  const auto scaled = [](const std::string& file, double by) {
    return scale(united(open_model(TEST_DATA + file)).field, Vec3::Constant(by));
  };
  std::vector<Part> parts{
      {"cube", box_field({{-5, -5, 0}, {5, 5, 6}}), {{-9, -9, 0}, {9, 9, 7}}},
      {"turned_cube", rotate(box_field({{-5, -5, 0}, {5, 5, 6}}), {0, 0, 1}, 0.4), {{-9, -9, 0}, {9, 9, 7}}},
      {"knife_edges",
       formula("min(max((z - 4 + 3*abs(x+2))/sqrt(10), abs(y)-6), max((z - 3 + 8*abs(x-3))/sqrt(65), abs(y-1)-5))"),
       {{-9, -9, 0}, {9, 9, 4.5}}},
      {"exact_levels",
       unite(box_field({{-6, -6, -1}, {6, 6, 1}}),
             unite(box_field({{-4, -4, -1}, {4, 4, 2}}), box_field({{-2, -2, -1}, {2, 2, 3}}))),
       {{-9, -9, 0}, {9, 9, 3}}},
      {"gyroid_block",
       formula("max(max(abs(x)-7, max(abs(y)-7, abs(z-3)-3)), (sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)-0.4)/1.8)"),
       {{-9, -9, 0}, {9, 9, 6.5}}},
      {"noise",
       formula("(z - 2 - 0.5*sin(3.1*x+sin(2*y)) - 0.4*cos(4.3*y+1.7*x) - 0.3*sin(7*x-5*y))/3"),
       {{-8, -8, 0}, {8, 8, 4}}},
      {"mtm_az_03", scaled("/frep/mtm_az/mtm_az_03.math", 3), {{-13, -12, -1}, {13, -7, 25}}},
      {"mtm_az_16", scaled("/frep/mtm_az/mtm_az_16.math", 6), {{-14, -16, -1}, {-9, 16, 14.5}}},
      {"cthead",
       scale(united(open_model(TEST_DATA "/ct/cthead")).field, Vec3::Constant(0.1)),
       {{6, 13, 8}, {sample_or_all(13.0, 18.0), sample_or_all(20.0, 22.0), 19.8}},
       0.1},
  };
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].number = i;
  return parts;
}

class Finishing : public testing::TestWithParam<Part> {};

std::vector<Path> all_finishes(const std::shared_ptr<const TipSurface>& tips, const Box& bounds, double stepover,
                               double tolerance, double waterlines) {
  FinishSettings settings;
  settings.area = Rectangle::of(bounds);
  settings.stepover = stepover;
  settings.tolerance = tolerance;
  std::vector<Path> paths = raster(*tips, settings);
  const auto add = [&](const std::vector<Path>& more) { paths.insert(paths.end(), more.begin(), more.end()); };
  settings.angle = pi / 2;
  add(raster(*tips, settings));
  add(spiral(*tips, settings));
  CutSettings cut;
  cut.tolerance = tolerance / 2;
  cut.depths = {bounds.upper.z() + 0.01, bounds.lower.z() + 0.01, waterlines};
  add(waterline(tips, settings.area.grown(tips->profile().radius()), 0.1, cut));
  return paths;
}

TEST_P(Finishing, NeverGouges) {
  const Part& part = GetParam();
  constexpr double tolerance = 0.01;
  const auto surface = Surface::of(*part.solid, part.bounds, {0.1, tolerance});
  constexpr std::size_t samples = 200'000;  // of each tool
  std::mt19937 random(7);
  std::uniform_real_distribution<> share(0, 1);
  for (const Tool& t : tools_for(part,
                                 {tool("flat", 3), tool("ball", 3), tool("bull", 4, 0.8), tool("v", 4, 0, pi / 3),
                                  tool("tapered", 3, 0.4, pi / 8)},
                                 2)) {
    const auto tips = std::make_shared<TipSurface>(surface, t.profile());
    const std::vector<Path> paths = all_finishes(tips, part.bounds, 0.7, tolerance, 1);
    // Straight segments, chosen with a probability proportional to their length.
    std::vector<std::pair<Vec3, Vec3>> pieces;
    std::vector<double> length{0};
    for (const Path& path : paths) {
      const auto points = points_along(path, 0.02);
      for (std::size_t i = 1; i < points.size(); ++i) {
        pieces.emplace_back(points[i - 1].at, points[i].at);
        length.push_back(length.back() + (points[i].at - points[i - 1].at).norm());
      }
    }
    ASSERT_FALSE(pieces.empty());
    std::vector<float> x, y, z;
    const Profile& profile = tips->profile();
    for (std::size_t i = 0; i < samples; ++i) {
      const double at = share(random) * length.back();
      const auto k = static_cast<std::size_t>(std::upper_bound(length.begin(), length.end(), at) - length.begin()) - 1;
      const auto& [from, to] = pieces[std::min(k, pieces.size() - 1)];
      const Vec3 tip = from + share(random) * (to - from);
      const double away = profile.radius() * std::sqrt(share(random)), angle = 2 * pi * share(random);
      const Vec3 p(tip.x() + away * std::cos(angle), tip.y() + away * std::sin(angle),
                   tip.z() + profile.height(away) + 1e-4);
      if (!part.bounds.contains(p) || !Rectangle::of(part.bounds).grown(-0.05).contains(Vec2(p.head<2>())))
        continue;  // outside of the bounds nothing is to be machined
      x.push_back(static_cast<float>(p.x())), y.push_back(static_cast<float>(p.y())),
          z.push_back(static_cast<float>(p.z()));
    }
    std::vector<float> value(x.size()), dx(x.size()), dy(x.size()), dz(x.size());
    part.solid->gradients({x.data(), y.data(), z.data(), x.size()}, value.data(), {dx.data(), dy.data(), dz.data()});
    double deepest = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double slope = std::sqrt(static_cast<double>(dx[i]) * dx[i] + static_cast<double>(dy[i]) * dy[i] +
                                     static_cast<double>(dz[i]) * dz[i]);
      if (const double depth = value[i] / std::max(slope, 1e-3); depth < deepest) deepest = depth, worst = i;
    }
    RecordProperty(std::string(name_of(t.shape)), std::to_string(deepest));
    // The tolerances of the surface and of the path.
    EXPECT_GT(deepest, -2 * tolerance) << part.name << " " << name_of(t.shape) << " at " << x[worst] << " " << y[worst]
                                       << " " << z[worst];
  }
}

/// Lower envelope over a lattice of a cutter at these tip positions.
HeightMap left_by(const std::vector<Vec3>& tips, const Profile& profile, HeightMap map) {
  const int reach = static_cast<int>(profile.radius() / map.cell);
  for (const Vec3& tip : tips) {
    const int column = static_cast<int>(std::lround((tip.x() - map.origin.x()) / map.cell)),
              row = static_cast<int>(std::lround((tip.y() - map.origin.y()) / map.cell));
    for (int v = std::max(0, row - reach); v <= std::min(map.height - 1, row + reach); ++v)
      for (int u = std::max(0, column - reach); u <= std::min(map.width - 1, column + reach); ++u) {
        float& left = map.at(u, v);
        if (left <= tip.z()) continue;  // no part of a tool is below its tip
        if (const double away = (map.place(u, v) - tip.head<2>()).norm(); away <= profile.radius())
          left = std::min(left, static_cast<float>(tip.z() + profile.height(away)));
      }
  }
  return map;
}

TEST_P(Finishing, LeavesNoMoreThanTheScallop) {
  const Part& part = GetParam();
  const auto surface = Surface::of(*part.solid, part.bounds, {0.1, 0.01});
  for (const Tool& t : tools_for(part, {tool("ball", 3), tool("flat", 3)}, 1)) {
    const auto tips = std::make_shared<TipSurface>(surface, t.profile());
    constexpr double stepover = 0.3;
    const double scallop = stepover * stepover / 8 * ((t.shape == ToolShape::ball ? 1 / 1.5 : 0) + 1 / part.sharpest);
    std::vector<Vec3> cut, everywhere;
    for (const Path& path : all_finishes(tips, part.bounds, stepover, 0.01, stepover)) {
      const auto points = points_along(path, 0.05);
      for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 way = points[i].at - points[i - 1].at;
        const int steps = 1 + static_cast<int>(way.norm() / 0.03);
        for (int s = 0; s <= steps; ++s) cut.push_back(points[i - 1].at + way * s / steps);
      }
    }
    // Brute force: the lowest tip at every point of a lattice.
    const Rectangle area = Rectangle::of(part.bounds);
    constexpr double cell = 0.1;
    for (double y = area.lower.y(); y <= area.upper.y(); y += cell)
      for (double x = area.lower.x(); x <= area.upper.x(); x += cell) everywhere.emplace_back(x, y, tips->tip({x, y}));
    const Vec2 size = area.size();
    const HeightMap block(static_cast<int>(size.x() / cell), static_cast<int>(size.y() / cell), cell, area.lower,
                          static_cast<float>(part.bounds.upper.z()));
    const HeightMap left = left_by(cut, t.profile(), block), possible = left_by(everywhere, t.profile(), block);
    double most = 0;
    for (int row = 2; row < block.height - 2; ++row)
      for (int column = 2; column < block.width - 2; ++column) {
        // Measured along the normal on slopes. A column of the lattice may lie on either side of a
        // wall, hence the maximum of its neighbours.
        double target = possible.at(column, row), slope = 0;
        for (int v = row - 2; v <= row + 2; ++v)
          for (int u = column - 2; u <= column + 2; ++u) {
            target = std::max<double>(target, possible.at(u, v));
            slope = std::max(slope, std::abs(possible.at(u, v) - possible.at(column, row)) / cell);
          }
        most = std::max(most, (left.at(column, row) - target) / std::sqrt(1 + slope * slope));
      }
    RecordProperty(std::string(name_of(t.shape)), std::to_string(most));
    EXPECT_LT(most, scallop + 0.03) << part.name << " " << name_of(t.shape);
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, Finishing, testing::ValuesIn(corpus()), [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace fieldfab::cam
