// Cutter compensation, G41, G42 and their .1: a stage over the stream of motions.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <utility>

#include "fieldfab/cam/gcode/motion.h"

namespace fieldfab::cam::gcode {

/// A line or a circle that the tool's centre follows, in the plane.
struct Track {
  bool circle = false;
  Vec2 point = Vec2::Zero();      ///< on the line, or the circle's centre
  Vec2 direction = Vec2::Zero();  ///< of the line, length 1
  double radius = 0;              ///< of the circle
};

/// Both intersections of two tracks, at least one of them a circle. std::nullopt if there is none.
std::optional<std::array<Vec2, 2>> intersections(const Track& a, const Track& b);

/// Converts the programmed path to that of the tool's centre, at the distance of its radius. A move in the plane is
/// kept until the next one is known, because in an inner corner it ends before the programmed end. Positions are in
/// program coordinates: mm, degrees.
class Compensation {
 public:
  /// `next` receives the motions of the tool's centre.
  explicit Compensation(MotionSink next) : next_(std::move(next)) {}

  /// `side`: 1 left of the path (G41), -1 right (G42). The next move in the plane is the entry move.
  void start(int side, double radius, const AxisValues& position);
  /// Sets the position from which the entry move begins.
  void begin_at(const AxisValues& position) { programmed_ = centre_ = position; }
  /// Passes on the motions that wait, and ends compensation.
  void stop();
  [[nodiscard]] bool on() const { return side_ != 0; }
  [[nodiscard]] int side() const { return side_; }
  /// Position of the tool's centre, after the motions that wait. Only while compensation is on.
  [[nodiscard]] const AxisValues& centre() const { return centre_; }

  /// Takes the next motion of the program. While compensation is on, rapids, feeds and arcs are offset, and other
  /// kinds occur at the tool's centre. Throws Refusal for a corner or an arc that the tool cannot reach.
  void give(const Motion& motion);

 private:
  void straight(Motion motion);
  void arc(Motion motion);
  void corner(const Vec2& at, const Vec2& heading, const Track& next, const Motion& motion);
  void outer_corner(const Vec2& at, const Vec2& heading, const Motion& motion);
  void inner_corner(const Vec2& at, double turn, const Track& next);
  [[nodiscard]] Vec2 beside(const Vec2& at, const Vec2& heading) const;
  void pass_on_or_wait(Motion motion);
  void wait(Motion motion, const Vec2& heading);
  void pass_on_waiting();

  MotionSink next_;
  int side_ = 0;  // 0: off
  double radius_ = 0;
  AxisValues programmed_, centre_;
  Vec2 heading_ = Vec2::Zero();  // direction of the path at its programmed position
  // The last move in the plane, whose end depends on the next one, and the motions after it. Empty before the entry.
  std::deque<Motion> waiting_;
  Vec2 start_ = Vec2::Zero();  // start of that move
};

}  // namespace fieldfab::cam::gcode
