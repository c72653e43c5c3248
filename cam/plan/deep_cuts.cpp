#include "deep_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "strokes.h"

namespace fieldfab::cam {
namespace {

constexpr double touch = 0.01;  // mm; half of the depth that a simulation reports as contact

double shank_radius(const Tool& tool) { return 0.5 * (tool.shank > 0 ? tool.shank : tool.diameter); }

/// A tool with infinitely long shank and holder, as used in planning. It is thinner than the tool by `thin` mm, so that
/// its cutting part leaves as much at walls, and its shank keeps clear of that.
struct ShortTool {
  std::vector<ToolPiece> tip;
  std::optional<ToolPiece> shank, holder;
  double flute = 0;

  ShortTool(const Tool& tool, double cell, double thin, double endless) {
    if (tool.flute > 0) flute = std::max(tool.flute - cell, 0.5 * tool.flute);
    tip = thinned(tool, thin, flute > 0 ? flute : tool.length > 0 ? tool.length : endless);
    const auto cylinder = [&](ToolRole role, double from, double radius) -> std::optional<ToolPiece> {
      if (!(from > 0) || !(radius > 0)) return std::nullopt;
      return ToolPiece{role, {{Zone::Shape::frustum, from, from + endless, radius, radius, true, true}}};
    };
    // A shank no wider than the flutes stays within their path along walls. A wider shank keeps a
    // cell away from lattice points, so that it meets no material between them.
    const double radius = shank_radius(tool), half = tool.radius();
    shank = cylinder(ToolRole::shank, flute, radius > half + touch ? radius + cell : radius - touch - thin);
    holder = cylinder(ToolRole::holder, tool.length, std::max(radius, 0.5 * tool.holder_diameter) - touch - thin);
  }
};

/// Executes moves of one tool on one plane.
class DeepCutter {
 public:
  DeepCutter(Stock& stock, std::uint32_t cut, const Tool& tool, const Plane& plane)
      : stock_(stock),
        cut_(cut),
        plane_(plane),
        cell_(stock.lattice().spacing().maxCoeff()),
        tool_(tool, cell_, half_diagonal(stock.lattice(), plane.axes.col(2)),
              2 * stock.lattice().box().diagonal() + 2 * tool.length + tool.flute),
        step_(std::max(0.5 * tool.diameter, cell_)),
        clear_(plane.into(stock.lattice().box()).upper.z() + cell_ - tool_.flute),
        holder_clear_(clear_ + tool_.flute - tool.length) {}

  std::vector<Move> back_out(const std::vector<Move>& moves, double plunge, BackedOut& report, Progress& progress) {
    plunge_ = plunge;
    if (moves.empty()) return {};
    double highest = moves.front().to.z();
    for (const Move& move : moves) highest = std::max(highest, move.to.z());
    safe_ = highest - touch;
    done_.push_back(moves.front());
    constexpr std::size_t most = 512;
    std::size_t at_once = most;
    for (std::size_t next = 1; next < moves.size();) {
      progress.report(static_cast<double>(next) / static_cast<double>(moves.size()), "deep cuts");
      if (before_ && !moves[next].rapid()) {
        lift(moves[next++], report, progress);
        if (report.holder) return {};
        continue;
      }
      before_.reset();
      const std::size_t end = std::min(moves.size(), next + at_once);
      const std::vector<double> removed = before_contact(moves, next, end, progress);
      for (const double volume : removed) append(moves[next++], volume);
      at_once = std::min(most, 2 * at_once);
      if (next == end) continue;
      lift(moves[next++], report, progress);
      if (report.holder) return {};
      at_once = 8;
    }
    finish_pass();
    if (report.length > 0) report.left = volume_left(progress);
    return std::move(done_);
  }

 private:
  [[nodiscard]] ToolPose pose(const Vec3& tip, const Vec3& axis = Vec3::UnitZ()) const {
    return {plane_.out_of(tip), plane_.axes * axis};
  }
  void add(const ToolPiece& piece, const ToolPose& from, const ToolPose& to, bool removes) {
    strokes_.push_back({&piece, from, to, cut_, removes});
  }
  void add_tip(const ToolPose& from, const ToolPose& to) {
    for (const ToolPiece& piece : tool_.tip) add(piece, from, to, true);
  }
  /// Adds the strokes of a move: the cutter's, and those of shank and holder, which must not meet
  /// the remaining material.
  void add(const Move& from, const Move& to) {
    Move start = from;
    for (const Vec3& end : segments(from.to, to, std::numeric_limits<double>::infinity())) {
      const ToolPose a = pose(start.to, start.axis), b = pose(end, to.axis);
      add_tip(a, b);
      if (tool_.shank && std::min(start.to.z(), end.z()) < clear_) add(*tool_.shank, a, b, false);
      if (tool_.holder && std::min(start.to.z(), end.z()) < holder_clear_) add(*tool_.holder, a, b, false);
      start.to = end, start.axis = to.axis;
    }
  }

  /// Executes moves up to the first contact of shank or holder with material. Returns the volume
  /// that each move removes, mm^3.
  std::vector<double> before_contact(const std::vector<Move>& moves, std::size_t begin, std::size_t end,
                                     Progress& progress) {
    std::vector<std::size_t> first;  // index of each move's first stroke
    Move at = done_.back();
    for (std::size_t k = begin; k < end; ++k) {
      first.push_back(strokes_.size());
      add(at, moves[k]);
      at = moves[k];
    }
    first.push_back(strokes_.size());
    Stock after = stock_;
    const std::vector<StrokeResult> met = after.cut(strokes_, progress);
    std::vector<double> removed;
    for (std::size_t k = 0; k + 1 < first.size(); ++k) {
      double volume = 0;
      bool contact = false;
      for (std::size_t i = first[k]; i < first[k + 1]; ++i)
        if (strokes_[i].removes)
          volume += met[i].volume;
        else
          contact = contact || met[i].points > 0;
      if (contact) break;
      removed.push_back(volume);
    }
    if (removed.size() == end - begin) {
      stock_ = std::move(after);
    } else {
      after = stock_;  // discards the bricks of the trial
      strokes_.resize(first[removed.size()]);
      std::erase_if(strokes_, [](const Stroke& s) { return !s.removes; });
      stock_.cut(strokes_, progress);
    }
    strokes_.clear();
    return removed;
  }

  /// Whether a piece of the tool meets material on a straight line.
  bool meets(Stock& stock, const ToolPiece& piece, const Vec3& from, const Vec3& to, Progress& progress) const {
    const Stroke stroke{&piece, pose(from), pose(to), 1, false};
    return stock.cut({&stroke, 1}, progress).front().points > 0;
  }

  /// Lowest height, in quarters of a cell, at which the shank is clear on the whole line.
  double lowest_clear(Stock& stock, const Vec3& from, const Vec3& to, Progress& progress) const {
    const double quarter = 0.25 * cell_;
    const auto height = [&](std::int64_t k) { return clear_ - static_cast<double>(k) * quarter; };
    // Bisection: clear at `high` quarters below, not clear at `low`.
    std::int64_t high = 0, low = std::max<std::int64_t>(
                               1, std::llround(std::ceil((clear_ - std::min(from.z(), to.z())) / quarter)));
    while (low - high > 1) {
      std::vector<std::int64_t> tried;
      for (std::int64_t k = 1; k < 16; ++k)
        if (const std::int64_t at = high + (low - high) * k / 16; at > high && (tried.empty() || at > tried.back()))
          tried.push_back(at);
      std::vector<Stroke> strokes;
      for (const std::int64_t k : tried)
        strokes.push_back(
            {&*tool_.shank, pose({from.x(), from.y(), height(k)}), pose({to.x(), to.y(), height(k)}), 1, false});
      const std::vector<StrokeResult> met = stock.cut(strokes, progress);
      for (std::size_t i = 0; i < tried.size(); ++i) {
        if (met[i].points) {
          low = tried[i];
          break;
        }
        high = tried[i];
      }
    }
    return height(high);
  }

  /// Executes a move, raised as far as the shank requires.
  void lift(const Move& move, BackedOut& report, Progress& progress) {
    Vec3 planned = done_.back().to;
    std::vector<Vec3> ends{planned};
    double removed = 0;
    bool backs_out = false;
    const auto go = [&](const Vec3& to) {
      if ((to - ends.back()).norm() < 1e-9) return true;
      add_tip(pose(ends.back()), pose(to));
      for (const StrokeResult& result : stock_.cut(strokes_, progress)) removed += result.volume;
      strokes_.clear();
      const bool clear = !tool_.holder || !meets(stock_, *tool_.holder, ends.back(), to, progress);
      ends.push_back(to);
      if (!clear) report.holder = to;
      return clear;
    };
    const Vec3 start = planned;
    for (const Vec3& end : segments(start, move, step_)) {
      // The tool may have been raised before this segment started.
      const Vec3 at = ends.back();
      Vec3 to = end;
      if (tool_.shank && meets(before_ ? *before_ : stock_, *tool_.shank, at, end, progress)) {
        if (!before_) before_ = stock_;
        const double floor = lowest_clear(*before_, at, end, progress);
        if (at.z() < floor && !go({at.x(), at.y(), floor})) return;
        to.z() = std::max(to.z(), floor);
      } else {
        before_.reset();
      }
      if (!go(to)) return;
      const double rise = to.z() - end.z();
      if (rise > touch) {
        report.length += (end - planned).norm();
        report.most = std::max(report.most, rise);
        report.places = hull(report.places, {end, end});
        left_.push_back({planned, end});
        backs_out = true;
      }
      planned = end;
    }
    for (const Vec3& p : simplified(ends, 1e-3))
      if ((p - done_.back().to).norm() > 1e-9) append({p, feed_to(p, move), 0, move.axis}, std::exchange(removed, 0));
    pass_backs_out_ = pass_backs_out_ || backs_out;
    removed_ += removed;
  }

  /// Feed rate at a point: a lowered tool enters the material.
  [[nodiscard]] double feed_to(const Vec3& p, const Move& move) const {
    const Vec3 way = p - done_.back().to;
    return !move.rapid() && -way.z() > 0.5 * way.head<2>().norm() ? std::min(move.feed, plunge_) : move.feed;
  }

  /// Appends a move. A pass is a sequence of moves between rapids.
  void append(const Move& move, double removed) {
    if (move.rapid()) finish_pass();
    removed_ += removed;
    done_.push_back(move);
  }
  void finish_pass() {
    constexpr double nothing = 1e-3;  // mm^3
    // Back to its last point in the air, so that the rapids before and after it join there.
    if (pass_backs_out_ && removed_ < nothing)
      while (done_.size() > 1 && done_.back().to.z() < safe_) done_.pop_back();
    pass_backs_out_ = false, removed_ = 0;
  }

  /// Volume that the remaining planned moves would remove, mm^3.
  double volume_left(Progress& progress) {
    Stock planned = stock_;
    for (const auto& [from, to] : left_) add_tip(pose(from), pose(to));
    double volume = 0;
    for (const StrokeResult& result : planned.cut(strokes_, progress)) volume += result.volume;
    strokes_.clear();
    return volume;
  }

  Stock& stock_;
  std::uint32_t cut_;
  const Plane& plane_;
  double cell_;
  ShortTool tool_;
  double step_;          // length of the segments that are tested individually, mm
  double clear_;         // least height of the tip with the shank above the stock
  double holder_clear_;  // least height of the tip with the holder above the stock
  double plunge_ = 0;    // mm/min
  double safe_ = 0;      // height of rapids
  double removed_ = 0;   // since the last rapid, mm^3
  bool pass_backs_out_ = false;
  /// The stock at the time when the tool was raised, until it may be lowered again. It still
  /// contains what the raised tool cuts beside the shank; otherwise the tool would be lowered for
  /// every small step of a path.
  std::optional<Stock> before_;
  std::vector<Move> done_;
  std::vector<Stroke> strokes_;
  struct Piece {
    Vec3 from, to;
  };
  std::vector<Piece> left_;  // planned segments that were executed at a greater height
};

}  // namespace

std::vector<Move> back_out(Stock& stock, std::uint32_t cut, const std::vector<Move>& moves, const Tool& tool,
                           const Plane& plane, double plunge, BackedOut& report, Progress& progress) {
  return DeepCutter(stock, cut, tool, plane).back_out(moves, plunge, report, progress);
}

bool may_be_too_deep(const std::vector<Move>& moves, const Tool& tool, const Plane& plane, const Box& stock) {
  if (!(tool.diameter > 0) || !(stock.size().minCoeff() > 0)) return false;
  const double top = plane.into(stock).upper.z();
  const double above = tool.flute > 0 ? tool.flute : tool.length;
  return above > 0 &&
         std::any_of(moves.begin(), moves.end(), [&](const Move& m) { return m.to.z() + above < top - 1e-6; });
}

}  // namespace fieldfab::cam
