// Marching squares over a quadtree of a Field.
#include "fieldfab/cam/plan/contour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <tuple>

#include "contour_block.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab::cam {
namespace {

constexpr int task = 512;  // greatest number of squares along a side of one task

/// Traverses the quadtree and collects segments.
class Descent {
 public:
  /// `missed`: see trace_block().
  Descent(const Squares& squares, double level, MissedParts* missed, Progress& progress)
      : squares_(squares), level_(level), missed_(missed), progress_(progress) {}

  void run(const FieldPtr& field, const Part& part) {
    progress_.check();
    const int longer = std::max(part.right - part.left, part.high - part.low);
    if (longer <= task) {
      std::vector<Piece> found;
      MissedParts missed;
      descend(field, part, found, missed);
      const std::lock_guard lock(collecting_);
      if (missed_ != nullptr) add(missed);
      pieces_.insert(pieces_.end(), found.begin(), found.end());
      return;
    }
    const auto children = split(*field, part);
    parallel_for(children.size(), [&](std::size_t i) { run(children[i].field, children[i].part); });
  }

  /// Segments in an order that does not depend on the number of threads.
  std::vector<Piece> take() {
    std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) { return a.from < b.from; });
    return std::move(pieces_);
  }

 private:
  struct Child {
    FieldPtr field;
    Part part;
  };

  /// Quarters that the contour may cross.
  std::vector<Child> split(const Field& field, const Part& part) const {
    const auto halves = [](int from, int to) {
      // Multiples of the block size, so that blocks are full.
      const int middle = from + ((to - from) / 2 + block_side - 1) / block_side * block_side;
      return std::array<int, 3>{from, std::min(middle, to), to};
    };
    const auto x = halves(part.left, part.right), y = halves(part.low, part.high);
    std::array<Part, 4> parts;
    std::array<Box, 4> boxes;
    std::array<Restriction, 4> here;
    std::size_t count = 0;
    for (std::size_t v = 0; v < 2; ++v)
      for (std::size_t u = 0; u < 2; ++u) {
        const Part p{x[u], y[v], x[u + 1], y[v + 1]};
        if (p.left >= p.right || p.low >= p.high) continue;
        parts[count] = p;
        boxes[count++] = {{squares_.x(p.left), squares_.y(p.low), squares_.z},
                          {squares_.x(p.right), squares_.y(p.high), squares_.z}};
      }
    field.restrict_all({boxes.data(), count}, Purpose::value, {here.data(), count});
    std::vector<Child> children;
    for (std::size_t i = 0; i < count; ++i) {
      const Interval& range = here[i].range;
      const bool at_border = parts[i].left == 0 || parts[i].low == 0 || parts[i].right == squares_.columns ||
                             parts[i].high == squares_.rows;
      const bool inside = range.upper < level_ && !range.maybe_nan, outside = range.lower > level_ && !range.maybe_nan;
      if (!outside && (!inside || at_border)) children.push_back({here[i].field, parts[i]});
    }
    return children;
  }

  /// Keeps the lowest place, and the leftmost of equally low ones, independently of the order of
  /// threads.
  void add(const MissedParts& more) {
    const auto rank = [](const MissedParts& m) { return std::tuple(m.lost == 0, !m.any(), m.place.y(), m.place.x()); };
    if (rank(more) < rank(*missed_)) missed_->place = more.place;
    missed_->lost += more.lost;
    missed_->unproved += more.unproved;
  }

  void descend(const FieldPtr& field, const Part& part, std::vector<Piece>& found, MissedParts& missed) const {
    if (part.right - part.left <= block_side && part.high - part.low <= block_side)
      return trace_block(*field, squares_, level_, part, found, missed_ != nullptr ? &missed : nullptr);
    for (const Child& child : split(*field, part)) descend(child.field, child.part, found, missed);
  }

  const Squares& squares_;
  double level_;
  MissedParts* missed_;
  Progress& progress_;
  std::mutex collecting_;
  std::vector<Piece> pieces_;
};

/// Repairs open ends. Rounding of a Field near 0 may give neighbouring blocks different signs for a
/// crossing, so that a segment ends where none starts. Such an end is joined to the nearest
/// unmatched start.
template <class Find>
void mend(std::vector<Piece>& pieces, const Find& next_of, double cell) {
  std::vector<bool> met(pieces.size(), false);
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto next = next_of(pieces[i].to);
    if (next != pieces.end() && next->from == pieces[i].to)
      met[static_cast<std::size_t>(next - pieces.begin())] = true;
    else
      ends.push_back(i);
  }
  if (ends.empty()) return;
  const auto place = [&](std::size_t i) { return Vec2(pieces[i].start[0], pieces[i].start[1]); };
  for (const std::size_t end : ends) {
    std::size_t nearest = pieces.size();
    double least = 4 * cell;  // the end of a segment is at most a cell's diagonal from its start
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (!met[i] && (place(i) - place(end)).norm() < least) nearest = i, least = (place(i) - place(end)).norm();
    if (nearest == pieces.size()) throw Error(ErrorKind::internal, "contour", "is not closed");
    met[nearest] = true;
    pieces[end].to = pieces[nearest].from;
  }
}

/// Joins segments into closed loops by their crossings.
Loops link(std::vector<Piece> pieces, double cell) {
  const auto next_of = [&](Crossing key) {
    return std::lower_bound(pieces.begin(), pieces.end(), key,
                            [](const Piece& piece, Crossing k) { return piece.from < k; });
  };
  mend(pieces, next_of, cell);
  std::vector<bool> used(pieces.size(), false);
  Loops loops;
  const double same = 1e-6 * cell;
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    if (used[first]) continue;
    Loop loop;
    const auto add = [&](const std::array<float, 2>& p) {
      const Vec2 point(p[0], p[1]);
      if (loop.points.empty() || (point - loop.points.back()).norm() > same) loop.points.push_back(point);
    };
    for (std::size_t i = first; !used[i];) {
      used[i] = true;
      add(pieces[i].start);
      if (pieces[i].corner[0] == pieces[i].corner[0]) add(pieces[i].corner);
      i = static_cast<std::size_t>(next_of(pieces[i].to) - pieces.begin());
    }
    while (loop.points.size() > 1 && (loop.points.front() - loop.points.back()).norm() <= same) loop.points.pop_back();
    if (loop.points.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

Loops traced(const Field& field, const Rectangle& region, const ContourSettings& settings, MissedParts* missed,
             Progress& progress) {
  const Vec2 size = region.size();
  if (!(settings.cell > 0) || !size.allFinite() || !(size.minCoeff() > 0))
    throw Error(ErrorKind::bad_input, "contour", "needs a region and a cell that are finite and have a size");
  const Vec2 count = (size / settings.cell).array().ceil() + 2;
  if (count.maxCoeff() > 1e8)
    throw Error(ErrorKind::too_large, "contour", fmt::format("{:.3g} cells along a side", count.maxCoeff()));
  const Squares squares{region.lower - 0.5 * (count * settings.cell - size),
                        settings.cell,
                        settings.z,
                        static_cast<int>(count.x()),
                        static_cast<int>(count.y()),
                        region};
  Descent descent(squares, settings.level, missed, progress);
  descent.run(field.shared_from_this(), {0, 0, squares.columns, squares.rows});
  return link(descent.take(), settings.cell);
}

}  // namespace

Loops contours(const Field& field, const Rectangle& region, const ContourSettings& settings, Progress& progress) {
  return traced(field, region, settings, nullptr, progress);
}

Loops contours(const Field& field, const Rectangle& region, const ContourSettings& settings, MissedParts& missed,
               Progress& progress) {
  missed = {};
  return traced(field, region, settings, &missed, progress);
}

}  // namespace fieldfab::cam
