#include "fieldfab/field/bounds.h"

#include <algorithm>
#include <queue>

namespace fieldfab {
namespace {

constexpr double far_away = 1e6;               // mm; what reaches this far counts as unbounded
constexpr std::size_t most_work = 40'000'000;  // operations a face; what is undecided after so many stays inside

/// A part of space that may hold some of the solid.
struct Suspect {
  Box box;
  FieldPtr field;
  double reach;  // how far the box goes in the direction searched
  int depth;     // of those that reach as far, the smallest comes first: one that holds some of the solid ends the search
  bool operator<(const Suspect& other) const { return reach != other.reach ? reach < other.reach : depth < other.depth; }
};

bool holds_nothing(const Interval& range) { return range.lower >= 0 && !range.maybe_nan; }

/// How far the solid reaches within `within` along sign * axis, to `tolerance`: the suspect that reaches farthest is looked at
/// next, cleared or halved. Axes marked `whole` are never divided. Returns false where there is nothing.
bool find_reach(const FieldPtr& field, const Box& within, int axis, double sign, double tolerance, const bool (&whole)[3],
                Progress& progress, double& reach) {
  const auto reach_of = [&](const Box& box) { return sign > 0 ? box.upper[axis] : -box.lower[axis]; };
  std::priority_queue<Suspect> suspects;
  suspects.push({within, field, reach_of(within), 0});
  for (std::size_t work = 0; !suspects.empty();) {
    progress.check();
    const Suspect next = suspects.top();
    suspects.pop();
    work += 10 * next.field->cost() + 1000;
    const Restriction inside = next.field->restricted(next.box, Purpose::occupancy);
    if (holds_nothing(inside.range)) continue;
    reach = next.reach;
    if (inside.range.inside() || next.box.size()[axis] <= tolerance || work >= most_work) return true;
    int longest = axis;
    for (int other = 0; other < 3; ++other)
      if (!whole[other] && next.box.size()[other] > next.box.size()[longest]) longest = other;
    for (const bool upper : {false, true}) {
      Box half = next.box;
      (upper ? half.lower : half.upper)[longest] = next.box.centre()[longest];
      suspects.push({half, inside.field, reach_of(half), next.depth + 1});
    }
  }
  return false;
}

}  // namespace

SolidBounds solid_bounds(const Field& field, Progress& progress) {
  SolidBounds found;
  found.box = {Vec3::Constant(-far_away), Vec3::Constant(far_away)};
  const Box known = field.known_bounds();
  if (known.valid()) found.box = known;
  bool whole[3] = {};
  for (int axis = 0; axis < 3; ++axis) {
    found.bounded[axis] = true;
    whole[axis] = found.box.size()[axis] == 0;
  }

  // Each round searches the six faces to a share of the present size, until that stops shrinking.
  for (double before = std::numeric_limits<double>::infinity();;) {
    progress.report(0, "finding the bounds");
    const Restriction here = field.restricted(found.box, Purpose::occupancy);
    for (int axis = 0; axis < 3; ++axis) {
      if (whole[axis]) continue;
      const double tolerance = found.box.size()[axis] / 512;
      double upper = 0, lower = 0;
      if (!find_reach(here.field, found.box, axis, 1, tolerance, whole, progress, upper) ||
          !find_reach(here.field, found.box, axis, -1, tolerance, whole, progress, lower)) {
        found.empty = true;
        return found;
      }
      if (upper >= far_away * 0.99 || -lower <= -far_away * 0.99) {
        found.bounded[axis] = false;
        whole[axis] = true;
        continue;
      }
      found.box.upper[axis] = upper;
      found.box.lower[axis] = -lower;
    }
    if (whole[0] && whole[1] && whole[2]) return found;
    double size = 0;
    for (int axis = 0; axis < 3; ++axis)
      if (!whole[axis]) size = std::max(size, found.box.size()[axis]);
    if (size > 0.75 * before || size == 0) return found;
    before = size;
  }
}

}  // namespace fieldfab
