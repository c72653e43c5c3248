#include "fieldfab/field/bounds.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <utility>

#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

constexpr double far_away = 1e6;  // mm; a solid that reaches this far counts as unbounded

// Operations that a search for one end along one axis may take.
constexpr std::size_t work_for_bounds = 40'000'000, work_for_tight_bounds = 4'000'000;

/// A box that may contain some of the solid. A search examines next what reaches farthest.
struct Suspect {
  double reach;  // coordinate of the box's end in the direction searched
  int depth;     // among equal reaches the most divided box comes first: it soon shows how far the solid reaches
  Box box;
  FieldPtr field;  // the solid in the box
  bool operator<(const Suspect& other) const {
    return reach != other.reach ? reach < other.reach : depth < other.depth;
  }
};

/// When a search for a face of the bounds ends.
struct Effort {
  Vec3 least;        ///< mm; sides of boxes that are divided no further
  std::size_t work;  ///< operations; boxes that are undecided after so many stay inside the bounds
};

/// NaN is outside, as 0 is.
bool holds_nothing(const Interval& range) { return range.lower >= 0; }

/// Returns the side of `box` to halve next, or nullopt if all are as short as `least`. Sides along which the values
/// change less may be longer: along an edge, the box stays as long as that. Sides are counted in those of the whole
/// box, and a little by themselves: the slope may be another one elsewhere.
std::optional<int> side_to_halve(const Field& field, const Box& box, const Vec3& whole, const Vec3& least) {
  const Vec3 size = box.size(), slope = field.gradient(box.centre()).cwiseAbs().cwiseProduct(whole);
  const Vec3 weight =
      slope.allFinite() ? Vec3(slope / std::max(slope.maxCoeff(), 1e-30) + Vec3::Constant(0.05)) : Vec3(Vec3::Ones());
  const Vec3 length = (size.array() > least.array()).select(size.cwiseQuotient(whole).cwiseProduct(weight), 0);
  int side = 0;
  if (length.maxCoeff(&side) == 0) return std::nullopt;
  return side;
}

/// Finds how far the solid reaches in `within` along sign * axis: no less than it does, and as little more as intervals
/// show. Returns nullopt if the solid is empty in `within`.
///
/// The suspect that reaches farthest is examined next. Its outer half is cut off if it is empty, so that a flat face
/// takes a few boxes, however large it is. Where the outer half holds some of the solid, only what reaches farther
/// counts from then on. Otherwise the suspect is halved across the side along which the values change most.
std::optional<double> find_reach(const FieldPtr& field, const Box& within, int axis, double sign, const Effort& effort,
                                 Progress& progress) {
  const auto reach_of = [&](const Box& box) { return sign > 0 ? box.upper[axis] : -box.lower[axis]; };
  const Vec3& least = effort.least;
  std::optional<double> known;  // how far the solid reaches at least
  std::priority_queue<Suspect> suspects;
  const auto push = [&](int depth, std::span<const Box> boxes, const Field& around) {
    std::array<Restriction, 2> inside;
    around.restrict_all(boxes, Purpose::occupancy, inside);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (!holds_nothing(inside[i].range))
        suspects.push({reach_of(boxes[i]), depth, boxes[i], std::move(inside[i].field)});
  };
  push(0, {&within, 1}, *field);
  constexpr std::size_t seldom = 64;  // a check asks for the time, which takes as long as a small Field's interval
  std::size_t work = 0;
  for (std::size_t popped = 0; !suspects.empty(); ++popped) {
    if (popped % seldom == 0) progress.check();
    const Suspect next = suspects.top();
    suspects.pop();
    work += 10 * next.field->cost() + 1000;
    if ((known && next.reach - *known <= least[axis]) || work >= effort.work) return next.reach;

    const Vec3 size = next.box.size();
    const double middle = next.reach - 0.5 * size[axis];
    const bool farther = !known || middle > *known;
    const double cut = farther ? middle : *known;
    Box outer = next.box, inner = next.box;
    (sign > 0 ? outer.lower : outer.upper)[axis] = (sign > 0 ? inner.upper : inner.lower)[axis] = sign * cut;
    if (size[axis] > least[axis]) {
      const Interval beyond = next.field->interval(outer);
      if (holds_nothing(beyond)) {
        if (farther) push(next.depth + 1, {&inner, 1}, *next.field);
        continue;
      }
      Vec3 foot = outer.centre();
      foot[axis] = sign * cut;
      if (farther && (beyond.inside() || next.field->value(foot) < 0)) {
        known = cut;
        push(next.depth + 1, {&outer, 1}, *next.field);
        continue;
      }
    }
    const auto side = side_to_halve(*next.field, next.box, within.size(), least);
    if (!side) return next.reach;  // nothing shows that it is empty
    std::array halves{outer, inner};
    if (*side != axis) {
      halves = {next.box, next.box};
      halves[0].upper[*side] = halves[1].lower[*side] = next.box.centre()[*side];
    }
    push(next.depth + 1, halves, *next.field);
  }
  return known;
}

/// Finds both ends of the solid in `box` along an axis, in parallel; nullopt if it is empty.
std::optional<std::array<double, 2>> find_extent(const Field& field, const Box& box, int axis, const Effort& effort,
                                                 Progress& progress) {
  const FieldPtr here = field.restricted(box, Purpose::occupancy).field;
  std::array<std::optional<double>, 2> reach;
  parallel_for(2,
               [&](std::size_t end) { reach[end] = find_reach(here, box, axis, end == 0 ? -1 : 1, effort, progress); });
  if (!reach[0] || !reach[1] || *reach[1] < -*reach[0]) return std::nullopt;
  return std::array{0.0 - *reach[0], *reach[1]};  // not -0
}

/// The search of solid_bounds(), in rounds.
class BoundsSearch {
  using Axes = Eigen::Array<bool, 3, 1>;

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
  /// Cuts empty slabs off the box along the axes that count as bounded, until it shrinks little along each. Axes that
  /// prove to be unbounded stay whole: usually the Field does not depend on them.
  void shave() {
    for (bool shrinks = true; shrinks && !found_.empty;) {
      const Vec3 before = found_.box.size();
      shrinks = false;
      for (int axis = 0; axis < 3 && !found_.empty; ++axis) {
        const Axes whole = flat_ || !Eigen::Map<const Axes>(found_.bounded);
        if (whole[axis]) continue;
        search(axis, whole);
        shrinks = shrinks || (found_.bounded[axis] && found_.box.size()[axis] < 0.75 * before[axis]);
      }
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

  /// Searches for both ends along an axis, to 1/512 of the box's size; axes that are `whole` are not divided.
  void search(int axis, const Axes& whole) {
    progress_.report(0, "finding the bounds");
    const Effort effort{whole.select(std::numeric_limits<double>::infinity(), found_.box.size().array() / 512),
                        work_for_bounds};
    const auto extent = find_extent(field_, found_.box, axis, effort, progress_);
    found_.empty = !extent;
    if (!extent) return;
    const auto [lower, upper] = *extent;
    found_.bounded[axis] = std::max(-lower, upper) < far_away * 0.99;
    if (found_.bounded[axis]) found_.box.lower[axis] = lower, found_.box.upper[axis] = upper;
  }

  const Field& field_;
  Progress& progress_;
  Axes flat_{};
  SolidBounds found_;
};

SolidBounds search_bounds(const Field& field, Progress& progress) {
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

}  // namespace

SolidBounds solid_bounds(const Field& field, Progress& progress) {
  std::shared_ptr<const SolidBounds> kept = field.bounds_.load();
  if (kept == nullptr) field.bounds_.store(kept = std::make_shared<const SolidBounds>(search_bounds(field, progress)));
  return *kept;
}

Box tight_bounds(const Field& field, const Box& bounds, Progress& progress) {
  constexpr double finest = 0x1p-23;  // of the box's size
  Box box = bounds;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.size()[axis] > 0)) continue;
    const Effort effort{Vec3::Constant(finest * box.size().maxCoeff()), work_for_tight_bounds};
    if (const auto extent = find_extent(field, box, axis, effort, progress))
      box.lower[axis] = (*extent)[0], box.upper[axis] = (*extent)[1];
  }
  return box;
}

}  // namespace fieldfab
