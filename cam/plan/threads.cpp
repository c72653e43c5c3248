// Thread milling.
#include <fmt/format.h>

#include <cmath>

#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {
namespace {

/// One helical way along a thread: from the hole's axis to the wall by a half circle, along the helix, and back.
Path helix(const Hole& hole, double radius, const ThreadSettings& thread, const CutSettings& cut) {
  // A clockwise tool climbs inside a hole where it goes anticlockwise; upwards that makes a right-hand thread.
  const bool anticlockwise = cut.climb, up = anticlockwise == thread.right_hand;
  const double half = thread.pitch / 2, bulge = anticlockwise ? 1 : -1;
  const double low = cut.depths.bottom, high = cut.depths.top;
  const int turns = 1 + static_cast<int>(std::ceil((high - low) / half - 1e-9));  // half ones; to above the top
  const double rise = up ? half : -half;
  double z = up ? low : low + turns * half;
  Path path;
  const auto add = [&](double x, double at, double arc, Pace pace) {
    path.points.push_back({{hole.centre.x() + x, hole.centre.y(), at}, arc, Vec3::UnitZ(), pace});
  };
  add(0, std::max(high, z), 0, Pace::enter);
  add(0, z, bulge, Pace::cut);
  double side = radius;
  for (int i = 0; i < turns; ++i, z += rise, side = -side) add(side, z, bulge, Pace::cut);
  add(side, z, bulge, Pace::cut);
  add(0, z, 0, Pace::link);
  add(0, std::max(high, z), 0, Pace::link);
  return path;
}

}  // namespace

std::vector<Path> mill_threads(const std::vector<Hole>& where, const ThreadSettings& thread, const CutSettings& cut) {
  if (!(thread.pitch > 0)) throw Error(ErrorKind::bad_input, "pitch", "must be above 0");
  if (!(cut.depths.bottom < cut.depths.top))
    throw Error(ErrorKind::bad_input, "depth", "the bottom of a thread must be below its top");
  std::vector<Path> paths;
  for (const Hole& hole : where) {
    const double deepest = thread.diameter > 0 ? thread.diameter / 2 : hole.radius + thread_depth(thread.pitch);
    if (deepest <= hole.radius)
      throw Error(ErrorKind::bad_input, "diameter",
                  fmt::format("a thread of {:.4g} mm needs a smaller hole than that of {:.4g} mm", 2 * deepest,
                              2 * hole.radius));
    if (cut.radius >= hole.radius)
      throw Error(ErrorKind::bad_input, "tool",
                  fmt::format("the tool of {:.4g} mm does not fit into the hole of {:.4g} mm", 2 * cut.radius,
                              2 * hole.radius));
    for (int pass = 1; pass <= thread.passes; ++pass) {
      const double reach = hole.radius + (deepest - hole.radius) * pass / thread.passes;
      paths.push_back(helix(hole, reach - cut.radius, thread, cut));
    }
  }
  return paths;
}

double thread_depth(double pitch) { return 5.0 / 16 * std::sqrt(3) * pitch; }

}  // namespace fieldfab::cam
