// V-carving along the medial axis of the outline.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "medial_axis.h"

namespace fieldfab::cam {

std::vector<Path> v_carve(const Loops& part, double half_angle, double stepover, const CutSettings& cut,
                          Progress& progress) {
  if (!(half_angle > 0) || !(half_angle < std::numbers::pi / 2))
    throw Error(ErrorKind::bad_input, "v_carve", "needs a V with an angle between 0 and 180 degrees");
  if (part.empty()) return {};
  const double slope = 1 / std::tan(half_angle), widest = (cut.depths.top - cut.depths.bottom) / slope;
  progress.report(0, "medial axis");
  std::vector<Path> paths;
  bool floor = false;
  for (const Branch& branch : medial_axis(part, cut.tolerance)) {
    progress.check();
    std::vector<Vec3> run;
    const auto finish = [&] {
      if (run.size() > 1) {
        Path path;
        for (const Vec3& p : simplified(run, cut.tolerance)) path.points.push_back({p});
        paths.push_back(std::move(path));
      }
      run.clear();
    };
    const auto add = [&](const Vec2& p, double radius) {
      run.emplace_back(p.x(), p.y(), cut.depths.top - slope * radius);
    };
    for (std::size_t i = 0; i < branch.size(); ++i) {
      const AxisPoint& here = branch[i];
      const bool deep = here.radius > widest;
      floor |= deep;
      if (i > 0 && (branch[i - 1].radius > widest) != deep) {
        const AxisPoint& before = branch[i - 1];
        const double t = (widest - before.radius) / (here.radius - before.radius);
        add(before.at + t * (here.at - before.at), widest);
        if (deep) finish();
      }
      if (!deep) add(here.at, here.radius);
    }
    finish();
  }
  if (floor) {
    // A flat floor in the area where the V would exceed the depth.
    Rectangle bounds = Rectangle::nothing();
    for (const Loop& loop : part)
      for (const Vec2& p : loop.points) bounds.add(p);
    const FieldPtr inner = offset(outline_field(part), -widest);
    const double cell = std::min(bounds.size().maxCoeff() / 200, widest / 4);
    for (Path& path : rings(*inner, bounds.grown(cell), cell, stepover, cut.depths.bottom, cut, progress))
      paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace fieldfab::cam
