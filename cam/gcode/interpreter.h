// Execution of blocks: modal state, offsets, motions.
#pragma once

#include <deque>
#include <functional>
#include <optional>

#include "decoder.h"
#include "flow.h"
#include "frame.h"

namespace fieldfab::cam::gcode {

/// Modal state, which M70 saves.
struct Modes {
  int motion = 800;  ///< G code times ten; 800: none
  ArcPlane plane = ArcPlane::xy;
  bool absolute = true, arcs_absolute = false, inch = false, diameter = false;
  bool retract_to_start = false;  ///< G98; LinuxCNC's default is G99
  int feed_mode = 940;
  int system = 1;  ///< coordinate system: 1 is G54
  int path = 640;
  double feed = 0;       ///< the F word: units of length (or degrees) per minute, per revolution, or 1/minutes
  double feed_unit = 1;  ///< mm per unit of length at the time of F
  double speed = 0;      ///< the S word: revolutions per minute, or m/min under G96
  int spindle = 0;       ///< 1 clockwise, -1 anticlockwise
  bool constant_surface = false;
  double most_speed = 0;  ///< G96 D
  bool mist = false, flood = false, feed_override = true, speed_override = true;
  AxisValues tool_offset;
  bool axis_offset = false;  ///< whether G92 or G52 was in force at M70
};

/// Modal words of canned cycles. Lengths in the program's units.
struct CycleWords {
  double r = 0, z = 0, p = 0, q = 0, i = 0, j = 0, k = 0;
  double start = 0;  ///< coordinate along the third axis before the first of consecutive cycles, mm
};

class Interpreter final : public PredefinedParameters {
 public:
  Interpreter(std::string_view text, const std::string& file, const ReadingOptions& options, const MotionSink& sink,
              Progress& progress);
  std::vector<ReadingNote> run();

  [[nodiscard]] double numbered(int number) const override;
  [[nodiscard]] std::optional<double> named(std::string_view name) const override;

 private:
  /// Cutter compensation.
  struct Compensation {
    int side = 0;  ///< 1: left of the path (G41), -1: right, 0: off
    double radius = 0;
    bool entered = false;         ///< whether the entry move is complete
    AxisValues programmed;        ///< position on the programmed path
    Vec2 heading = Vec2::Zero();  ///< direction of the path at that position
    /// The last move in the plane, whose end depends on the next one, and the motions after it.
    std::deque<Motion> waiting;
    Vec2 start = Vec2::Zero();  ///< start of that move
  };
  /// A line or a circle that the tool's centre follows.
  struct Track {
    bool circle = false;
    Vec2 point = Vec2::Zero();      ///< on the line, or the circle's centre
    Vec2 direction = Vec2::Zero();  ///< of the line
    double radius = 0;              ///< of the circle
  };

  // interpreter.cpp: the loop over blocks and the order within a block
  bool step();
  void execute();
  void set_feed_mode(int code);
  void set_feed();
  void set_speed();
  void select_tool();
  void change_tool();
  void set_plane(ArcPlane plane);
  void do_modal_m();
  void do_stop();
  void dwell(double seconds);
  void end_program();
  [[nodiscard]] const ToolEntry& tool_entry(int tool) const;
  void set_control(ControlMode mode);
  void save_state(bool restore_on_return);
  void restore_state(const Modes& saved);

  // offsets.cpp: coordinate systems, length compensation, home positions
  void set_system(int system);
  void read_system();
  void set_length_compensation();
  void action();
  void set_data();
  void go_home(int first);
  void keep_home(int first);
  void set_axis_offset();
  void turn_program();
  void change_frame(const std::function<void()>& change);
  void no_compensation(const char* what) const;

  // motions.cpp: straight moves and the processing that all motions share
  void motion();
  [[nodiscard]] AxisValues target() const;
  [[nodiscard]] AxisValues machine_target() const;
  [[nodiscard]] double word(char letter) const;  ///< a word's value in the unit of its axis: mm or
                                                 ///< degrees
  [[nodiscard]] double length(double value) const { return value * unit(); }
  [[nodiscard]] double unit() const { return modes_.inch ? 25.4 : 1; }
  void straight(const AxisValues& to);
  void spindle_synchronous();
  void probe(const AxisValues& to);
  void require_feed();
  /// Makes a motion with the modal state and hands it on (program coordinates: mm, degrees).
  void move(Motion::Kind kind, const AxisValues& to, double length_along = -1);
  void move_arc(const AxisValues& to, const Vec2& centre, int turns);
  void give(Motion motion);
  void send(Motion motion);
  [[nodiscard]] Motion stamped(Motion::Kind kind) const;
  void feed_of(Motion& motion, const AxisValues& from, double length_along) const;
  [[nodiscard]] double spindle_at(const AxisValues& to) const;
  void send_chords(const Motion& arc);

  // arcs.cpp
  void arc();
  struct Circle {
    Vec2 centre = Vec2::Zero();
    int turns = 1;
  };
  [[nodiscard]] Circle circle(const Vec2& from, const Vec2& to) const;
  static double arc_length(const Vec2& from, const Vec2& to, const Vec2& centre, int turns);

  // splines.cpp
  void spline();
  void nurbs_point();
  void nurbs_end();

  // cycles.cpp, threads.cpp
  void cycle();
  /// Takes the words of a canned cycle. They are modal; another cycle starts without those of the one before.
  void cycle_words(int code, const std::string& name);
  class Hole;
  void thread();

  // compensation.cpp
  void set_compensation();
  void compensated_straight(Motion::Kind kind, const AxisValues& to);
  void compensated_arc(const AxisValues& to, const Circle& circle);
  void corner(const Vec2& at, const Vec2& heading, const Track& next, const Motion& pattern);
  void give_waiting(Motion motion, const Vec2& heading);
  [[nodiscard]] Vec2 beside(const Vec2& at, const Vec2& heading) const;
  void flush();

  ReadingOptions options_;
  MotionSink sink_;
  Progress& progress_;
  mutable Notes notes_;  // mutable, because a query of a parameter may add a note
  Parameters parameters_;
  Flow flow_;
  Decoder decoder_;
  Line line_;
  Command command_;
  const Block& block_ = command_.block;

  Modes modes_;
  Frame frame_;
  AxisValues at_;    // position in the program: mm, degrees
  AxisValues sent_;  // end of the last motion that was handed on
  Compensation compensation_;
  CycleWords cycle_;
  int tool_ = 0, selected_tool_ = 0;
  ControlMode mode_ = ControlMode::machine;
  bool tip_by_length_ = false;  // G43.4 is in force
  // % was first; the end was reached; something was read
  bool delimited_ = false, finished_ = false, begun_ = false;
  std::optional<Modes> saved_;
  struct SavedInCall {
    std::size_t depth;
    Modes modes;
  };
  std::vector<SavedInCall> saved_in_calls_;
  std::vector<std::array<double, 3>> control_points_;  // G5.2: x, y, weight
  int nurbs_order_ = 0;
  std::optional<Vec2> last_control_;  // G5: last control point of the previous cubic
};

}  // namespace fieldfab::cam::gcode
