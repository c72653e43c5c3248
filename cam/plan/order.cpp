// Ordering: nearest neighbour with a grid, then Or-opt and 2-opt, with inner paths before outer
// ones as a constraint.
#include "fieldfab/cam/plan/order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fieldfab::cam {
namespace {

Vec2 flat(const PathPoint& p) { return p.at.head<2>(); }

/// Index of the enclosing path of each path: closed paths by nesting, open paths by their first
/// vertex.
std::vector<int> enclosing(const std::vector<Path>& paths) {
  Loops loops;
  for (const Path& path : paths) {
    Loop loop;
    if (path.closed)
      for (const PathPoint& p : points_along(path, 1.0)) loop.points.push_back(flat(p));
    if (loop.points.size() < 4) {
      // An open path is represented by a tiny loop at its start, which encloses no other path.
      const Vec2 at = path.points.empty() ? Vec2(0, 0) : flat(path.points.front());
      const double speck = 1e-7 * (1 + at.norm());
      loop.points = {at, at + Vec2(speck, 0), at + Vec2(0, speck)};
    }
    loops.push_back(std::move(loop));
  }
  return nesting(loops);
}

/// Possible starts of paths, in squares of a grid; paths can be removed.
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
        // a long path offers only some of its vertices; choose_starts() refines the choice
        constexpr std::size_t most = 64;
        for (std::size_t k = 0; k < points.size(); k += 1 + points.size() / most) add(k);
      } else {
        add(0);
        if (settings.may_reverse && !paths[i].closed && points.size() > 1) add(points.size() - 1);
      }
    }
    if (all.empty()) return;
    const Vec2 size = box.size();
    cell_ = std::max(
        1e-6,
        std::sqrt(std::max(size.x() * size.y(), 1e-3 * size.squaredNorm()) / static_cast<double>(all.size())) * 1.5);
    origin_ = box.lower;
    wide_ = static_cast<int>(size.x() / cell_) + 1, high_ = static_cast<int>(size.y() / cell_) + 1;
    squares_.resize(static_cast<std::size_t>(wide_) * static_cast<std::size_t>(high_));
    for (const Start& s : all) squares_[square_of(s.at)].push_back(s);
  }

  /// Nearest start of a path for which `open` returns true; nullptr if there is none.
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
          auto& square =
              squares_[static_cast<std::size_t>(j) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(i)];
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
    const int i = std::min(wide_ - 1, static_cast<int>((p.x() - origin_.x()) / cell_)),
              j = std::min(high_ - 1, static_cast<int>((p.y() - origin_.y()) / cell_));
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
    std::vector<int> waiting(paths_.size(), 0);  // number of uncut paths directly inside of each path
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
    const auto nearer = [&](const PathPoint& a, const PathPoint& b) {
      return (flat(a) - at).squaredNorm() < (flat(b) - at).squaredNorm();
    };
    begin_at(path, static_cast<std::size_t>(std::min_element(path.points.begin(), path.points.end(), nearer) -
                                            path.points.begin()));
  }

  /// Containment by preorder numbers of the tree: an inner path is numbered between the first and
  /// last number of an outer one.
  [[nodiscard]] bool encloses(std::size_t outer, std::size_t inner) const {
    return first_[outer] < first_[inner] && first_[inner] <= last_[outer];
  }
  void number_tree() {
    const std::size_t n = paths_.size();
    first_.assign(n, 0), last_.assign(n, 0);
    std::vector<std::vector<std::size_t>> children(n);
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < n; ++i)
      (parent_[i] < 0 ? waiting : children[static_cast<std::size_t>(parent_[i])]).push_back(i);
    std::size_t next = 0;
    std::vector<bool> entered(n, false);
    while (!waiting.empty()) {
      const std::size_t i = waiting.back();
      if (entered[i]) {
        last_[i] = next;
        waiting.pop_back();
        continue;
      }
      entered[i] = true;
      first_[i] = ++next;
      waiting.insert(waiting.end(), children[i].begin(), children[i].end());
    }
  }
  /// Whether one of two paths must precede the other.
  [[nodiscard]] bool related(std::size_t a, std::size_t b) const {
    return !alone_[a] && !alone_[b] && (encloses(a, b) || encloses(b, a));
  }

  [[nodiscard]] const Vec2& start_at(std::size_t place) const { return start_[sequence_[place]]; }
  [[nodiscard]] const Vec2& end_at(std::size_t place) const { return end_[sequence_[place]]; }
  [[nodiscard]] const Vec2& end_before(std::size_t place) const { return place == 0 ? from_ : end_at(place - 1); }
  void look_again(std::size_t place) {
    if (place < sequence_.size()) look_[sequence_[place]] = true;
  }

  /// Moves single paths and reverses runs until there is no improvement. `reach`: greatest distance
  /// in the sequence.
  void improve() {
    const std::size_t n = paths_.size();
    start_.resize(n), end_.resize(n);
    alone_.assign(n, true);
    for (std::size_t i = 0; i < n; ++i) {
      start_[i] = start_of(paths_[i]), end_[i] = end_of(paths_[i]);
      if (parent_[i] >= 0) alone_[i] = alone_[static_cast<std::size_t>(parent_[i])] = false;
    }
    look_.assign(n, true);
    number_tree();
    constexpr std::size_t reach = 50;
    constexpr int most_rounds = 8;
    for (int round = 0; round < most_rounds; ++round) {
      bool changed = false;
      for (std::size_t i = 0; i < sequence_.size(); ++i) {
        if (i % 64 == 0) progress_.check();
        if (!look_[sequence_[i]]) continue;
        look_[sequence_[i]] = false;
        changed |= move_one(i, reach);
        changed |= turn_run(i, reach);
      }
      changed |= choose_starts();
      if (!changed) break;
    }
  }

  /// Or-opt: moves the path at `i` to the position with the shortest travel.
  bool move_one(std::size_t i, std::size_t reach) {
    const std::size_t n = sequence_.size(), moved = sequence_[i];
    const Vec2 &before = end_before(i), start = start_[moved], end = end_[moved];
    double gain_out = (start - before).norm();
    if (i + 1 < n) gain_out += (start_at(i + 1) - end).norm() - (start_at(i + 1) - before).norm();
    if (gain_out < 1e-6) return false;
    double best = 1e-6;
    std::ptrdiff_t target = -1;
    // Gain of a position between the end point `from` and the next path.
    const auto gain_between = [&](const Vec2& from, std::size_t next) {
      const double in = (start - from).norm();
      return next >= n ? gain_out - in : gain_out - in - (start_at(next) - end).norm() + (start_at(next) - from).norm();
    };
    for (std::size_t j = i + 1; j < std::min(n, i + reach) && !related(sequence_[j], moved); ++j)  // after j
      if (const double gain = gain_between(end_at(j), j + 1); gain > best)
        best = gain, target = static_cast<std::ptrdiff_t>(j);
    for (std::size_t j = i; j-- > (i > reach ? i - reach : 0) && !related(sequence_[j], moved);)  // before j
      if (const double gain = gain_between(end_before(j), j); gain > best)
        best = gain, target = static_cast<std::ptrdiff_t>(j);
    if (target < 0) return false;
    const auto first = sequence_.begin();
    const auto t = static_cast<std::size_t>(target);
    if (t > i)
      std::rotate(first + static_cast<std::ptrdiff_t>(i), first + static_cast<std::ptrdiff_t>(i) + 1,
                  first + target + 1);
    else
      std::rotate(first + target, first + static_cast<std::ptrdiff_t>(i), first + static_cast<std::ptrdiff_t>(i) + 1);
    for (const std::size_t place : {i, i + 1, t, t + 1}) look_again(place);
    if (i > 0) look_again(i - 1);
    if (t > 0) look_again(t - 1);
    return true;
  }

  /// 2-opt: reverses the sequence from path `i` to a later one.
  bool turn_run(std::size_t i, std::size_t reach) {
    const std::size_t n = sequence_.size();
    const Vec2& before = end_before(i);
    const double in = (start_at(i) - before).norm();
    double kept = 0, turned = 0;  // travel within the run in both orders
    bool all_alone = alone_[sequence_[i]];
    for (std::size_t j = i + 1; j < std::min(n, i + reach); ++j) {
      if (!settings_.may_reverse && !(paths_[sequence_[j - 1]].closed && paths_[sequence_[j]].closed)) return false;
      all_alone &= alone_[sequence_[j]];
      if (!all_alone)
        for (std::size_t k = i; k < j; ++k)
          if (related(sequence_[k], sequence_[j])) return false;
      kept += (start_at(j) - end_at(j - 1)).norm();
      turned += (end_at(j - 1) - start_at(j)).norm();
      double now = in + kept, then = (end_at(j) - before).norm() + turned;
      if (j + 1 < n) now += (start_at(j + 1) - end_at(j)).norm(), then += (start_at(j + 1) - start_at(i)).norm();
      if (then >= now - 1e-6) continue;
      std::reverse(sequence_.begin() + static_cast<std::ptrdiff_t>(i),
                   sequence_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      for (std::size_t k = i; k <= j; ++k) {
        look_again(k);
        if (paths_[sequence_[k]].closed) continue;
        reverse(paths_[sequence_[k]]);
        std::swap(start_[sequence_[k]], end_[sequence_[k]]);
      }
      look_again(j + 1);
      if (i > 0) look_again(i - 1);
      return true;
    }
    return false;
  }

  /// Chooses the start vertices of closed paths, given their predecessors and successors.
  bool choose_starts() {
    if (!settings_.free_starts) return false;
    bool changed = false;
    for (std::size_t i = 0; i < sequence_.size(); ++i) {
      Path& path = paths_[sequence_[i]];
      if (!path.closed) continue;
      const Vec2 before = end_before(i);
      const auto cost = [&](const PathPoint& p) {
        return (flat(p) - before).norm() + (i + 1 < sequence_.size() ? (start_at(i + 1) - flat(p)).norm() : 0.0);
      };
      std::size_t best = 0;
      double least = cost(path.points[0]) - 1e-6;
      for (std::size_t k = 1; k < path.points.size(); ++k)
        if (const double c = cost(path.points[k]); c < least) least = c, best = k;
      if (best == 0) continue;
      begin_at(path, best);
      start_[sequence_[i]] = end_[sequence_[i]] = flat(path.points.front());
      for (const std::size_t place : {i, i + 1}) look_again(place);
      changed = true;
    }
    return changed;
  }

  std::vector<Path> paths_;
  const OrderSettings& settings_;
  Vec2 from_;
  Progress& progress_;
  std::vector<int> parent_;
  std::vector<std::size_t> sequence_;
  std::vector<Vec2> start_, end_;  // of each path
  std::vector<std::size_t> first_, last_;
  std::vector<bool> alone_, look_;  // unrelated to all other paths; a move of it may be an improvement
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
