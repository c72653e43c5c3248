// Ordering: greedy with a grid, then Or-opt and 2-opt, all under "inside before outside".
#include "fieldfab/cam/order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fieldfab::cam {
namespace {

Vec2 flat(const PathPoint& p) { return p.at.head<2>(); }

/// Which paths enclose which: of closed ones by nesting, of open ones by their first vertex.
std::vector<int> enclosing(const std::vector<Path>& paths) {
  Loops loops;
  for (const Path& path : paths) {
    Loop loop;
    if (path.closed)
      for (const PathPoint& p : points_along(path, 1.0)) loop.points.push_back(flat(p));
    if (loop.points.size() < 4) {
      // An open path: a speck at its start, which encloses nothing.
      const Vec2 at = path.points.empty() ? Vec2(0, 0) : flat(path.points.front());
      const double speck = 1e-7 * (1 + at.norm());
      loop.points = {at, at + Vec2(speck, 0), at + Vec2(0, speck)};
    }
    loops.push_back(std::move(loop));
  }
  return nesting(loops);
}

/// Places to begin a path at, in squares of a grid; paths can be taken out.
class Starts {
 public:
  struct Start {
    Vec2 at;
    std::size_t path, vertex;
  };

  Starts(const std::vector<Path>& paths, const OrderSettings& settings) {
    std::vector<Start> all;
    Rectangle box = Rectangle::nothing();
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const auto& points = paths[i].points;
      const auto add = [&](std::size_t vertex) {
        all.push_back({flat(points[vertex]), i, vertex});
        box.add(all.back().at);
      };
      if (points.empty()) continue;
      if (paths[i].closed && settings.free_starts) {
        constexpr std::size_t most = 64;  // a long path offers some of its vertices; the best of all is looked for afterwards
        for (std::size_t k = 0; k < points.size(); k += 1 + points.size() / most) add(k);
      } else {
        add(0);
        if (settings.may_reverse && !paths[i].closed && points.size() > 1) add(points.size() - 1);
      }
    }
    if (all.empty()) return;
    const Vec2 size = box.size();
    cell_ = std::max(1e-6, std::sqrt(std::max(size.x() * size.y(), 1e-3 * size.squaredNorm()) / static_cast<double>(all.size())) * 1.5);
    origin_ = box.lower;
    wide_ = static_cast<int>(size.x() / cell_) + 1, high_ = static_cast<int>(size.y() / cell_) + 1;
    squares_.resize(static_cast<std::size_t>(wide_) * static_cast<std::size_t>(high_));
    for (const Start& s : all) squares_[square_of(s.at)].push_back(s);
  }

  /// The nearest start of a path that `open` allows; nullptr where there is none.
  template <class Open>
  const Start* nearest(const Vec2& p, const std::vector<bool>& gone, const Open& open) {
    const Start* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    const int ci = std::clamp(static_cast<int>((p.x() - origin_.x()) / cell_), 0, wide_ - 1);
    const int cj = std::clamp(static_cast<int>((p.y() - origin_.y()) / cell_), 0, high_ - 1);
    for (int ring = 0; ring < std::max(wide_, high_); ++ring) {
      if (best != nullptr && (ring - 1) * cell_ > least) break;
      for (int j = cj - ring; j <= cj + ring; ++j) {
        if (j < 0 || j >= high_) continue;
        const bool edge = j == cj - ring || j == cj + ring;
        for (int i = ci - ring; i <= ci + ring; i += edge || ring == 0 ? 1 : 2 * ring) {
          if (i < 0 || i >= wide_) continue;
          auto& square = squares_[static_cast<std::size_t>(j) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(i)];
          std::erase_if(square, [&](const Start& s) { return gone[s.path]; });
          for (const Start& s : square)
            if (const double away = (s.at - p).norm(); away < least && open(s.path)) least = away, best = &s;
        }
      }
    }
    return best;
  }

 private:
  [[nodiscard]] std::size_t square_of(const Vec2& p) const {
    const int i = std::min(wide_ - 1, static_cast<int>((p.x() - origin_.x()) / cell_)), j = std::min(high_ - 1, static_cast<int>((p.y() - origin_.y()) / cell_));
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(i);
  }
  double cell_ = 1;
  Vec2 origin_ = Vec2::Zero();
  int wide_ = 0, high_ = 0;
  std::vector<std::vector<Start>> squares_;
};

Vec2 start_of(const Path& path) { return flat(path.points.front()); }
Vec2 end_of(const Path& path) { return path.closed ? flat(path.points.front()) : flat(path.points.back()); }

void begin_at(Path& path, std::size_t vertex) {
  if (path.closed)
    std::rotate(path.points.begin(), path.points.begin() + static_cast<std::ptrdiff_t>(vertex), path.points.end());
  else if (vertex != 0)
    reverse(path);
}

double travel(const std::vector<Path>& paths, Vec2 from) {
  double sum = 0;
  for (const Path& path : paths) {
    if (path.points.empty()) continue;
    sum += (start_of(path) - from).norm();
    from = end_of(path);
  }
  return sum;
}

/// Orders the paths of one level.
class Level {
 public:
  Level(std::vector<Path> paths, const OrderSettings& settings, Vec2 from, Progress& progress)
      : paths_(std::move(paths)), settings_(settings), from_(from), progress_(progress) {}

  std::vector<Path> ordered() {
    parent_ = settings_.inside_first ? enclosing(paths_) : std::vector<int>(paths_.size(), -1);
    choose_greedily();
    improve();
    std::vector<Path> out;
    for (const std::size_t i : sequence_) out.push_back(std::move(paths_[i]));
    return out;
  }

 private:
  void choose_greedily() {
    std::vector<int> waiting(paths_.size(), 0);  // how many of the paths directly inside are still to be cut
    for (const int p : parent_)
      if (p >= 0) ++waiting[static_cast<std::size_t>(p)];
    std::vector<bool> gone(paths_.size(), false);
    Starts starts(paths_, settings_);
    Vec2 at = from_;
    for (std::size_t n = 0; n < paths_.size(); ++n) {
      if (n % 256 == 0) progress_.check();
      const auto* const next = starts.nearest(at, gone, [&](std::size_t i) { return waiting[i] == 0; });
      if (next == nullptr) break;
      const std::size_t i = next->path;
      begin_at(paths_[i], next->vertex);
      if (paths_[i].closed && settings_.free_starts) begin_nearest(paths_[i], at);
      gone[i] = true;
      if (parent_[i] >= 0) --waiting[static_cast<std::size_t>(parent_[i])];
      at = end_of(paths_[i]);
      sequence_.push_back(i);
    }
  }

  static void begin_nearest(Path& path, const Vec2& at) {
    const auto nearer = [&](const PathPoint& a, const PathPoint& b) { return (flat(a) - at).squaredNorm() < (flat(b) - at).squaredNorm(); };
    begin_at(path, static_cast<std::size_t>(std::min_element(path.points.begin(), path.points.end(), nearer) - path.points.begin()));
  }

  [[nodiscard]] bool encloses(std::size_t outer, std::size_t inner) const {
    for (int p = parent_[inner]; p >= 0; p = parent_[static_cast<std::size_t>(p)])
      if (static_cast<std::size_t>(p) == outer) return true;
    return false;
  }
  [[nodiscard]] bool related(std::size_t a, std::size_t b) const { return encloses(a, b) || encloses(b, a); }
  [[nodiscard]] Vec2 end_before(std::size_t place) const { return place == 0 ? from_ : end_of(paths_[sequence_[place - 1]]); }
  [[nodiscard]] const Path& at(std::size_t place) const { return paths_[sequence_[place]]; }

  /// Moves single paths to better places and turns runs round, until nothing helps; looks `reach` places far.
  void improve() {
    constexpr std::size_t reach = 60;
    constexpr int most_rounds = 8;
    for (int round = 0; round < most_rounds; ++round) {
      bool changed = false;
      for (std::size_t i = 0; i < sequence_.size(); ++i) {
        if (i % 64 == 0) progress_.check();
        changed |= move_one(i, reach);
        changed |= turn_run(i, reach);
      }
      changed |= choose_starts();
      if (!changed) break;
    }
  }

  /// Or-opt: takes the path at `i` out and puts it in where the way gets shortest.
  bool move_one(std::size_t i, std::size_t reach) {
    const std::size_t n = sequence_.size(), moved = sequence_[i];
    const Path& path = paths_[moved];
    const Vec2 before = end_before(i);
    double gain_out = (start_of(path) - before).norm();
    if (i + 1 < n) gain_out += (start_of(at(i + 1)) - end_of(path)).norm() - (start_of(at(i + 1)) - before).norm();
    if (gain_out < 1e-6) return false;
    double best = 1e-6;
    std::ptrdiff_t target = -1;
    const auto cost_between = [&](const Vec2& from, const Path* to) {
      const double in = (start_of(path) - from).norm();
      return to == nullptr ? in : in + (start_of(*to) - end_of(path)).norm() - (start_of(*to) - from).norm();
    };
    for (std::size_t j = i + 1; j < std::min(n, i + reach) && !related(sequence_[j], moved); ++j)  // after j
      if (const double gain = gain_out - cost_between(end_of(at(j)), j + 1 < n ? &at(j + 1) : nullptr); gain > best) best = gain, target = static_cast<std::ptrdiff_t>(j);
    for (std::size_t j = i; j-- > (i > reach ? i - reach : 0) && !related(sequence_[j], moved);)  // before j
      if (const double gain = gain_out - cost_between(end_before(j), &at(j)); gain > best) best = gain, target = static_cast<std::ptrdiff_t>(j);
    if (target < 0) return false;
    const auto first = sequence_.begin();
    if (const auto t = static_cast<std::size_t>(target); t > i)
      std::rotate(first + static_cast<std::ptrdiff_t>(i), first + static_cast<std::ptrdiff_t>(i) + 1, first + target + 1);
    else
      std::rotate(first + target, first + static_cast<std::ptrdiff_t>(i), first + static_cast<std::ptrdiff_t>(i) + 1);
    return true;
  }

  /// 2-opt: cuts the paths from `i` to some later one in the other order.
  bool turn_run(std::size_t i, std::size_t reach) {
    const std::size_t n = sequence_.size();
    double kept = 0, turned = 0;  // the way within the run, one way and the other
    for (std::size_t j = i + 1; j < std::min(n, i + reach); ++j) {
      const Path &a = at(j - 1), &b = at(j);
      for (std::size_t k = i; k < j; ++k)
        if (related(sequence_[k], sequence_[j])) return false;
      const bool can_turn = settings_.may_reverse || (a.closed && b.closed);
      if (!can_turn) return false;
      kept += (start_of(b) - end_of(a)).norm();
      turned += (end_of(a) - start_of(b)).norm();
      const Vec2 before = end_before(i);
      double now = (start_of(at(i)) - before).norm() + kept, then = (end_of(b) - before).norm() + turned;
      if (j + 1 < n) now += (start_of(at(j + 1)) - end_of(b)).norm(), then += (start_of(at(j + 1)) - start_of(at(i))).norm();
      if (then < now - 1e-6) {
        std::reverse(sequence_.begin() + static_cast<std::ptrdiff_t>(i), sequence_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        for (std::size_t k = i; k <= j; ++k)
          if (!at(k).closed) reverse(paths_[sequence_[k]]);
        return true;
      }
    }
    return false;
  }

  /// Where closed paths best begin, given what comes before and after.
  bool choose_starts() {
    if (!settings_.free_starts) return false;
    bool changed = false;
    for (std::size_t i = 0; i < sequence_.size(); ++i) {
      Path& path = paths_[sequence_[i]];
      if (!path.closed) continue;
      const Vec2 before = end_before(i);
      const auto cost = [&](const PathPoint& p) {
        return (flat(p) - before).norm() + (i + 1 < sequence_.size() ? (start_of(at(i + 1)) - flat(p)).norm() : 0.0);
      };
      std::size_t best = 0;
      double least = cost(path.points[0]) - 1e-6;
      for (std::size_t k = 1; k < path.points.size(); ++k)
        if (const double c = cost(path.points[k]); c < least) least = c, best = k;
      if (best != 0) begin_at(path, best), changed = true;
    }
    return changed;
  }

  std::vector<Path> paths_;
  const OrderSettings& settings_;
  Vec2 from_;
  Progress& progress_;
  std::vector<int> parent_;
  std::vector<std::size_t> sequence_;
};

}  // namespace

AirTravel order(std::vector<Path>& paths, const OrderSettings& settings, Progress& progress) {
  std::erase_if(paths, [](const Path& path) { return path.points.empty(); });
  AirTravel air{travel(paths, settings.start), 0};
  std::stable_sort(paths.begin(), paths.end(), [](const Path& a, const Path& b) { return a.level < b.level; });
  std::vector<Path> done;
  for (auto first = paths.begin(); first != paths.end();) {
    const auto last = std::find_if(first, paths.end(), [&](const Path& p) { return p.level != first->level; });
    const Vec2 from = done.empty() ? settings.start : end_of(done.back());
    Level level({std::make_move_iterator(first), std::make_move_iterator(last)}, settings, from, progress);
    for (Path& path : level.ordered()) done.push_back(std::move(path));
    first = last;
  }
  paths = std::move(done);
  air.after = travel(paths, settings.start);
  return air;
}

}  // namespace fieldfab::cam
