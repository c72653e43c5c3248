// Facing: level passes over the whole stock.
#include <algorithm>
#include <cmath>

#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {
namespace {

/// Way of the tool's edge beyond the stock, at the ends of a pass and at the last one, mm.
constexpr double beyond = 0.5;

/// A level pass in the direction of the axes u and v.
struct Pass {
  Vec2 from, to;
};

/// Passes that advance along v, each of the same width, of at most `stepover` mm.
std::vector<Pass> passes_over(const Rectangle& stock, double radius, double stepover, const Vec2& u, const Vec2& v) {
  const Vec2 middle = 0.5 * (stock.lower + stock.upper), half = 0.5 * stock.size();
  const double along = std::abs(half.x() * u.x()) + std::abs(half.y() * u.y());
  const double across = std::abs(half.x() * v.x()) + std::abs(half.y() * v.y());
  const int count = std::max(1, static_cast<int>(std::ceil((2 * across + beyond) / stepover - 1e-9)));
  const double width = (2 * across + beyond) / count, end = along + radius + beyond;
  std::vector<Pass> passes;
  for (int i = 1; i <= count; ++i) {
    // The tool's leading edge has reached i widths; where one pass is enough, the tool is in the middle.
    const double at = count == 1 ? 0 : i * width - across - radius;
    passes.push_back({middle + at * v - end * u, middle + at * v + end * u});
  }
  return passes;
}

}  // namespace

std::vector<Path> face(const Rectangle& stock, const FaceSettings& settings, const CutSettings& cut) {
  if (!(settings.stepover > 0 && cut.radius > 0))
    throw Error(ErrorKind::bad_input, "stepover", "facing needs a tool with a diameter, and a stepover above 0");
  const Vec2 u(std::cos(settings.angle), std::sin(settings.angle)), v(-u.y(), u.x());
  const double stepover = std::min(settings.stepover, 2 * cut.radius);
  // The stock that is left is on the side of v: on the right of a tool that moves against u.
  const bool against = cut.climb;
  const std::vector<Pass> passes = passes_over(stock, cut.radius, stepover, u, v);
  std::vector<Path> paths;
  int level = 0;
  for (const double z : cut.depths.passes()) {
    Path zigzag;
    zigzag.level = level++;
    bool turned = against;
    for (const Pass& pass : passes) {
      const Vec2 &from = turned ? pass.to : pass.from, &to = turned ? pass.from : pass.to;
      zigzag.points.push_back({{from.x(), from.y(), z}});
      zigzag.points.push_back({{to.x(), to.y(), z}, 0, Vec3::UnitZ(), Pace::link});
      if (settings.both_ways) {
        turned = !turned;
      } else {
        paths.push_back(zigzag);
        zigzag.points.clear();
      }
    }
    if (settings.both_ways) paths.push_back(std::move(zigzag));
  }
  return paths;
}

}  // namespace fieldfab::cam
