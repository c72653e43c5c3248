// Slots as wide as the tool: cuts along the medial axis.
#include <algorithm>
#include <cmath>

#include "fieldfab/cam/plan/operations.h"
#include "medial_axis.h"

namespace fieldfab::cam {
namespace {

/// The stretches of a branch where the tool fits and the area is no wider than a slot.
std::vector<Branch> fitting(const Branch& branch, double least, double most) {
  std::vector<Branch> runs;
  Branch run;
  const auto finish = [&] {
    if (run.size() > 1) runs.push_back(run);
    run.clear();
  };
  // The point of a stretch at which its radius is `radius`.
  const auto between = [](const AxisPoint& a, const AxisPoint& b, double radius) {
    const double t = (radius - a.radius) / (b.radius - a.radius);
    return AxisPoint{a.at + t * (b.at - a.at), radius};
  };
  const auto fits = [&](const AxisPoint& p) { return p.radius >= least && p.radius <= most; };
  for (std::size_t i = 0; i < branch.size(); ++i) {
    const AxisPoint& here = branch[i];
    if (i > 0 && fits(branch[i - 1]) != fits(here)) {
      const AxisPoint& beyond = fits(here) ? branch[i - 1] : here;
      run.push_back(between(branch[i - 1], here, beyond.radius < least ? least : most));
    }
    if (fits(here))
      run.push_back(here);
    else
      finish();
  }
  finish();
  return runs;
}

}  // namespace

Slots slots(const Loops& area, double widest, const CutSettings& cut, Progress& progress) {
  Slots found;
  if (area.empty()) return found;
  progress.report(0, "medial axis");
  const double own = cut.radius + cut.allowance;
  const std::vector<double> passes = cut.depths.passes();
  for (const Branch& branch : medial_axis(area, cut.tolerance)) {
    progress.check();
    for (const Branch& run : fitting(branch, own - 2 * cut.tolerance, std::max(own, 0.5 * widest))) {
      std::vector<Vec2> points;
      for (const AxisPoint& p : run) points.push_back(p.at);
      Path path = fit_arcs(points, false, 0, cut.tolerance);
      if (path.length() < 0.1 * cut.radius) continue;  // the end of a tapering corner
      const auto most = std::ranges::max_element(run, {}, &AxisPoint::radius);
      if (most->radius > own + 2 * cut.tolerance) found.wide.push_back(most->at);
      for (std::size_t pass = 0; pass < passes.size(); ++pass) {
        for (PathPoint& p : path.points) p.at.z() = passes[pass];
        path.level = static_cast<int>(pass);
        found.paths.push_back(path);
        reverse(path);
      }
    }
  }
  return found;
}

}  // namespace fieldfab::cam
