// Common part of the readers of the simpler languages (ShopBot, RML, HPGL): a machine that moves
// from point to point.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/core/error.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {

/// Converts positions in program coordinates (mm, radians) to motions. The first work offset is the
/// position of the program's zero.
class SimpleMachine {
 public:
  SimpleMachine(std::string file, const ReadingOptions& options, const MotionSink& sink, Progress& progress)
      : file_(std::move(file)),
        most_(options.most_blocks),
        origin_(options.work_offsets[0]),
        sink_(sink),
        progress_(progress) {
    for (std::size_t k = 0; k < 9; ++k) at_.at[k] = options.start.at[k] - origin_.at[k];
  }

  int line = 1;
  int tool = 0;
  double spindle = 0;  ///< revolutions per minute
  Notes notes;

  [[nodiscard]] const AxisValues& at() const { return at_; }
  /// Assigns the coordinates `place` to the machine's current position.
  void call_it(const AxisValues& place) {
    for (std::size_t k = 0; k < 9; ++k) origin_.at[k] += at_.at[k] - place.at[k];
    at_ = place;
  }

  void rapid(const AxisValues& to) { move(Motion::Kind::rapid, to, 0); }
  /// `feed` in mm/min; in radians/min if only rotary axes move.
  void feed(const AxisValues& to, double feed) {
    if (!(feed > 0)) refuse("a feed of {} mm/min", feed);
    move(Motion::Kind::feed, to, feed);
  }
  /// An arc in the plane x, y about `centre`.
  void arc(const AxisValues& to, const Vec2& centre, int turns, double feed) {
    if (!(feed > 0)) refuse("a feed of {} mm/min", feed);
    Motion motion = stamped(Motion::Kind::arc);
    motion.centre = centre + Vec2(origin_.at[0], origin_.at[1]);
    motion.turns = turns;
    motion.feed = feed;
    give(motion, to);
  }
  void dwell(double seconds) {
    if (!(seconds >= 0) || seconds > 1e9) refuse("a pause of {} seconds", seconds);
    Motion motion = stamped(Motion::Kind::dwell);
    motion.seconds = seconds;
    give(motion, at_);
  }
  void say(Motion::Kind kind) { give(stamped(kind), at_); }

  /// Counts one command. Throws Error(cancelled), and Refusal beyond the limit.
  void count(double share) {
    if (++counted_ > most_) refuse("more than {} blocks: this program seems to have no end", most_);
    if (counted_ % 1024 == 0) progress_.check();
    if (counted_ % 65536 == 0) progress_.report(share, "reading the program");
  }
  /// Executes a whole program: adds file and line to refusals, and returns the notes.
  template <class Run>
  std::vector<ReadingNote> run(const Run& all) {
    try {
      all();
    } catch (const Refusal& refusal) {
      throw Error(ErrorKind::bad_input, fmt::format("{}:{}", file_, line), refusal.message);
    }
    return notes.take();
  }

 private:
  [[nodiscard]] Motion stamped(Motion::Kind kind) const {
    Motion motion;
    motion.kind = kind;
    motion.line = line;
    motion.tool = tool;
    motion.spindle = spindle;
    return motion;
  }
  void move(Motion::Kind kind, const AxisValues& to, double feed) {
    Motion motion = stamped(kind);
    motion.feed = feed;
    give(motion, to);
  }
  void give(Motion motion, const AxisValues& to) {
    for (std::size_t k = 0; k < 9; ++k) {
      motion.end.at[k] = to.at[k] + origin_.at[k];
      if (!(std::abs(motion.end.at[k]) < 1e12)) refuse("a move to {}, which no machine can reach", to.at[k]);
    }
    at_ = to;
    sink_(motion);
  }

  std::string file_;
  std::uint64_t most_, counted_ = 0;
  AxisValues origin_, at_;
  const MotionSink& sink_;
  Progress& progress_;
};

}  // namespace fieldfab::cam::gcode
