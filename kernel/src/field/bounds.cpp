#include "fieldfab/field/bounds.h"

#include <algorithm>
#include <array>
#include <optional>
#include <queue>

#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

constexpr double far_away = 1e6;  // mm; a solid that reaches this far counts as unbounded
// Operations per face; boxes undecided after so many stay inside the bounds.
constexpr std::size_t most_work = 40'000'000;

/// A box that may contain some of the solid.
struct Suspect {
  Box box;
  FieldPtr field;
  double reach;  // coordinate of the box's end in the direction searched
  int depth;     // among equal reaches the smallest box comes first, since a box inside the solid ends the search
  bool inside = false;
  bool operator<(const Suspect& other) const {
    return reach != other.reach ? reach < other.reach : depth < other.depth;
  }
};

/// NaN is outside, as 0 is.
bool holds_nothing(const Interval& range) { return range.lower >= 0; }

/// Axes that a search never divides.
using Whole = Eigen::Array<bool, 3, 1>;

/// Finds how far the solid reaches in a box along sign * axis, to 1/512 of the box's size. The suspect that reaches
/// farthest is examined next. It is halved along that axis which raises its least values most: a flat face is found by
/// boxes as wide as the face, a dome by small ones. Boxes never become longer along the searched axis than across it,
/// nor much longer along one of the other two: halves that tell nothing new may have halves that do.
class ReachSearch {
 public:
  ReachSearch(const Box& within, int axis, double sign, const Whole& whole, Progress& progress)
      : within_(within), axis_(axis), sign_(sign), progress_(progress) {
    smallest_ = whole.select(std::numeric_limits<double>::infinity(), within.size().array() / 256);
    smallest_[axis] = within.size()[axis] / 512;
  }

  /// Returns nothing if the solid is empty in the box.
  std::optional<double> run(const FieldPtr& field) {
    const Restriction all = field->restricted(within_, Purpose::occupancy);
    for (add(within_, all, 0); !suspects_.empty();) {
      progress_.check();
      const Suspect next = suspects_.top();
      suspects_.pop();
      if (next.inside || work_ >= most_work || !examine(next)) return next.reach;
    }
    return {};
  }

 private:
  [[nodiscard]] double reach_of(const Box& box) const { return sign_ > 0 ? box.upper[axis_] : -box.lower[axis_]; }

  void add(const Box& box, const Restriction& inside, int depth) {
    if (holds_nothing(inside.range)) return;
    suspects_.push({box, inside.field, reach_of(box), depth, inside.range.inside()});
  }

  /// Adds the halves of a suspect. Returns false if it is as small as they get.
  bool examine(const Suspect& suspect) {
    std::array<Box, 6> halves;
    std::array<Restriction, 6> inside;
    std::size_t count = 0;
    const Eigen::Array3d left = suspect.box.size().array() / smallest_;
    for (int turn = 0; turn < 3; ++turn) {
      const int axis = (axis_ + turn) % 3;
      if (!(left[axis] > 1)) continue;
      if (turn > 0 && (left[axis] < 0.75 * left[axis_] || left[axis] < left.maxCoeff() / 8)) continue;
      halves[count] = halves[count + 1] = suspect.box;
      halves[count].upper[axis] = halves[count + 1].lower[axis] = suspect.box.centre()[axis];
      count += 2;
    }
    if (count == 0) return false;
    suspect.field->restrict_all(std::span(halves).first(count), Purpose::occupancy, std::span(inside).first(count));
    work_ += 10 * suspect.field->cost() + 1000;
    std::size_t best = 0;
    for (std::size_t first = 2; first < count; first += 2)
      if (least(inside[first]) + least(inside[first + 1]) > least(inside[best]) + least(inside[best + 1])) best = first;
    for (std::size_t half : {best, best + 1}) add(halves[half], inside[half], suspect.depth + 1);
    return true;
  }

  /// The least value, as far as it matters.
  static double least(const Restriction& inside) { return std::clamp<double>(inside.range.lower, -far_away, 0); }

  Box within_;
  int axis_;
  double sign_;
  Eigen::Array3d smallest_;  // sides that are not halved
  Progress& progress_;
  std::priority_queue<Suspect> suspects_;
  std::size_t work_ = 0;
};

/// The search of solid_bounds(), in rounds.
class BoundsSearch {
 public:
  BoundsSearch(const Field& field, const Box& known, Progress& progress) : field_(field), progress_(progress) {
    found_.box = known.valid() ? known : Box{Vec3::Constant(-far_away), Vec3::Constant(far_away)};
    flat_ = found_.box.size().array() == 0;
    std::fill_n(found_.bounded, 3, true);
  }

  SolidBounds run() {
    do shave();
    while (reconsider());
    return found_;
  }

 private:
  /// Cuts empty slabs off the box along the axes that count as bounded, until the box shrinks
  /// little. Axes that prove to be unbounded stay whole: usually the Field does not depend on them.
  void shave() {
    for (double before = std::numeric_limits<double>::infinity();;) {
      double size = 0;
      for (int axis = 0; axis < 3 && !found_.empty; ++axis) {
        const Whole whole = flat_ || !Eigen::Map<const Whole>(found_.bounded);
        if (whole[axis]) continue;
        search(axis, whole);
        if (found_.bounded[axis]) size = std::max(size, found_.box.size()[axis]);
      }
      if (found_.empty || size > 0.75 * before || size == 0) return;
      before = size;
    }
  }

  /// Searches again along the axes that seemed unbounded. The other axes are shorter now, and these
  /// may be divided: the bounds of a twisted bar across its length follow only if the length is
  /// known. Returns false if nothing changes.
  bool reconsider() {
    bool changed = false;
    if (std::count(found_.bounded, found_.bounded + 3, true) > 0)
      for (int axis = 0; axis < 3 && !found_.empty; ++axis) {
        if (found_.bounded[axis] || is_constant_along(axis)) continue;
        search(axis, flat_);
        changed = changed || found_.bounded[axis];
      }
    return changed && !found_.empty;
  }

  /// Whether slopes prove that the Field does not change along an axis.
  [[nodiscard]] bool is_constant_along(int axis) const {
    const Vec3 direction = Vec3::Unit(axis);
    Interval slope;
    field_.slopes(found_.box, {&direction, 1}, {&slope, 1});
    return slope == Interval::of(0);
  }

  void search(int axis, const Whole& whole) {
    progress_.report(0, "finding the bounds");
    const FieldPtr here = field_.restricted(found_.box, Purpose::occupancy).field;
    std::array<std::optional<double>, 2> reach;
    parallel_for(2, [&](std::size_t end) {
      reach[end] = ReachSearch(found_.box, axis, end == 0 ? -1 : 1, whole, progress_).run(here);
    });
    found_.empty = !reach[0] || !reach[1];
    found_.bounded[axis] = reach[0] < far_away * 0.99 && reach[1] < far_away * 0.99;
    if (found_.empty || !found_.bounded[axis]) return;
    found_.box.lower[axis] = -*reach[0];
    found_.box.upper[axis] = *reach[1];
  }

  const Field& field_;
  Progress& progress_;
  Whole flat_{};
  SolidBounds found_;
};

}  // namespace

SolidBounds solid_bounds(const Field& field, Progress& progress) {
  SolidBounds found = BoundsSearch(field, field.known_bounds(), progress).run();
  if (found.empty || found.is_bounded()) return found;
  const Framed framed = field.framed();
  if (framed.field.get() == &field) return found;
  const SolidBounds inner = BoundsSearch(*framed.field, framed.field->known_bounds(), progress).run();
  if (inner.empty || !inner.is_bounded()) return found;
  const Box box = image_of(inner.box, framed.axes, framed.origin);
  const double rounding = 1e-6 * std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
  return BoundsSearch(field, box.grown(rounding), progress).run();
}

namespace {

constexpr double finest = 0x1p-23;            // of a box's size: the distance at which a face is near enough
constexpr std::size_t most_suspects = 4'000;  // for each face

/// Finds how far the solid reaches in `within` along sign * axis: no less than it does, and as little more as intervals
/// show. The suspect that reaches farthest is examined next. Its outer half is cut off if it is empty, and its inner
/// half if the outer one holds some of the solid; otherwise it is halved along the side along which the values change
/// most.
double nearest_reach(const FieldPtr& field, const Box& within, int axis, double sign, Progress& progress) {
  const auto reach_of = [&](const Box& box) { return sign > 0 ? box.upper[axis] : -box.lower[axis]; };
  const double near_enough = finest * within.size().maxCoeff();
  double known = -std::numeric_limits<double>::infinity();  // how far the solid reaches at least
  std::priority_queue<Suspect> suspects;
  suspects.push({within, field, reach_of(within), 0});
  const std::size_t most = std::min(most_suspects, most_work / (field->cost() + 1));
  for (std::size_t tried = 0; tried < most && !suspects.empty(); ++tried) {
    progress.check();
    Suspect next = suspects.top();
    if (next.reach - known <= near_enough) break;
    suspects.pop();
    Box inner = next.box, outer = next.box;
    const double middle = next.box.centre()[axis];
    (sign > 0 ? inner.upper : inner.lower)[axis] = middle;
    (sign > 0 ? outer.lower : outer.upper)[axis] = middle;
    if (holds_nothing(field->interval(outer))) {
      if (!holds_nothing(field->interval(inner))) suspects.push({inner, field, reach_of(inner), next.depth + 1});
      continue;
    }
    Vec3 foot = outer.centre();
    foot[axis] = middle;
    if (field->value(foot) < 0) {
      known = std::max(known, sign * middle);
      suspects.push({outer, field, reach_of(outer), next.depth + 1});
      continue;
    }
    const Vec3 size = next.box.size();
    if (size.maxCoeff() <= near_enough) return next.reach;  // nothing shows that it is empty
    // Sides along which the values change less may be longer: along an edge, the box stays as long as that.
    const Vec3 slope = field->gradient(next.box.centre()).cwiseAbs();
    const Vec3 weight =
        slope.allFinite() ? Vec3(slope / std::max(slope.maxCoeff(), 1e-30) + Vec3::Constant(0.05)) : Vec3(Vec3::Ones());
    int longest = 0;
    size.cwiseProduct(weight).maxCoeff(&longest);
    for (const bool upper : {false, true}) {
      Box half = next.box;
      (upper ? half.lower : half.upper)[longest] = next.box.centre()[longest];
      if (!holds_nothing(field->interval(half))) suspects.push({half, field, reach_of(half), next.depth + 1});
    }
  }
  return suspects.empty() ? reach_of(within) : suspects.top().reach;
}

}  // namespace

Box tight_bounds(const Field& field, const Box& bounds, Progress& progress) {
  Box box = bounds;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.size()[axis] > 0)) continue;
    const FieldPtr here = field.restricted(box, Purpose::occupancy).field;
    std::array<double, 2> reach{};
    parallel_for(2, [&](std::size_t end) { reach[end] = nearest_reach(here, box, axis, end == 0 ? -1 : 1, progress); });
    if (-reach[0] < reach[1]) box.lower[axis] = -reach[0], box.upper[axis] = reach[1];
  }
  return box;
}

}  // namespace fieldfab
