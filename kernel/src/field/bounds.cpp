#include "fieldfab/field/bounds.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <queue>
#include <utility>
#include <vector>

#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

constexpr double far_away = 1e6;  // mm; a solid that reaches this far counts as unbounded
// Operations per face; boxes undecided after so many stay inside the bounds.
constexpr std::size_t most_work = 40'000'000;

/// Place of a box in a search that examines next what reaches farthest.
struct Place {
  double reach;  // coordinate of the box's end in the direction searched
  int depth;     // among equal reaches the smallest box comes first, since a box inside the solid ends the search
  bool operator<(const Place& other) const { return reach != other.reach ? reach < other.reach : depth < other.depth; }
};

/// A box that may contain some of the solid.
struct Suspect : Place {
  Box box;
};

/// Boxes that may contain some of the solid, with the Field in each. Thousands of boxes share a few hundred places.
class RestrictedSuspects {
 public:
  struct Suspect {
    Box box;
    Interval range;
    FieldPtr field;
    std::size_t cost;  // of the Field that was restricted
  };

  [[nodiscard]] bool empty() const { return suspects_.empty(); }
  void push(const Place& place, Suspect suspect) { suspects_[place].push_back(std::move(suspect)); }
  std::pair<Place, Suspect> pop() {
    const auto farthest = std::prev(suspects_.end());
    std::pair<Place, Suspect> found{farthest->first, std::move(farthest->second.back())};
    farthest->second.pop_back();
    if (farthest->second.empty()) suspects_.erase(farthest);
    return found;
  }

 private:
  std::map<Place, std::vector<Suspect>> suspects_;
};

/// NaN is outside, as 0 is.
bool holds_nothing(const Interval& range) { return range.lower >= 0; }

/// Axes that a search never divides.
using Whole = Eigen::Array<bool, 3, 1>;

/// Finds how far the solid reaches in `within` along sign * axis, to 1/512 of its size. The suspect
/// that reaches farthest is examined next: it is discarded, or halved along the axis that was
/// halved least. Returns false if the solid is empty in `within`.
bool find_reach(const FieldPtr& field, const Box& within, int axis, double sign, const Whole& whole, Progress& progress,
                double& reach) {
  const auto reach_of = [&](const Box& box) { return sign > 0 ? box.upper[axis] : -box.lower[axis]; };
  const Vec3 size = within.size();
  RestrictedSuspects suspects;
  Restriction whole_field = field->restricted(within, Purpose::occupancy);
  suspects.push({reach_of(within), 0}, {within, whole_field.range, std::move(whole_field.field), field->cost()});
  constexpr std::size_t seldom = 64;  // a check asks for the time, which takes as long as a small Field's interval
  std::size_t work = 0;
  for (std::size_t popped = 0; !suspects.empty(); ++popped) {
    if (popped % seldom == 0) progress.check();
    const auto [place, next] = suspects.pop();
    work += 10 * next.cost + 1000;
    if (holds_nothing(next.range)) continue;
    reach = place.reach;
    const Vec3 left = next.box.size();
    if (next.range.inside() || left[axis] <= size[axis] / 512 || work >= most_work) return true;
    int longest = axis;
    for (int other = 0; other < 3; ++other)
      if (!whole[other] && left[other] * size[longest] > left[longest] * size[other]) longest = other;
    // Both halves at once cost little more than one.
    std::array<Box, 2> halves{next.box, next.box};
    halves[0].upper[longest] = halves[1].lower[longest] = next.box.centre()[longest];
    std::array<Restriction, 2> inside;
    next.field->restrict_all(halves, Purpose::occupancy, inside);
    for (std::size_t half = 0; half < 2; ++half)
      suspects.push({reach_of(halves[half]), place.depth + 1},
                    {halves[half], inside[half].range, std::move(inside[half].field), next.field->cost()});
  }
  return false;
}

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
    std::array<double, 2> reach{};
    std::array<char, 2> found{};
    parallel_for(2, [&](std::size_t end) {
      found[end] = find_reach(here, found_.box, axis, end == 0 ? -1 : 1, whole, progress_, reach[end]) ? 1 : 0;
    });
    found_.empty = found[0] == 0 || found[1] == 0;
    found_.bounded[axis] = reach[0] < far_away * 0.99 && reach[1] < far_away * 0.99;
    if (found_.empty || !found_.bounded[axis]) return;
    found_.box.lower[axis] = -reach[0];
    found_.box.upper[axis] = reach[1];
  }

  const Field& field_;
  Progress& progress_;
  Whole flat_{};
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
  suspects.push({{reach_of(within), 0}, within});
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
      if (!holds_nothing(field->interval(inner))) suspects.push({{reach_of(inner), next.depth + 1}, inner});
      continue;
    }
    Vec3 foot = outer.centre();
    foot[axis] = middle;
    if (field->value(foot) < 0) {
      known = std::max(known, sign * middle);
      suspects.push({{reach_of(outer), next.depth + 1}, outer});
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
      if (!holds_nothing(field->interval(half))) suspects.push({{reach_of(half), next.depth + 1}, half});
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
