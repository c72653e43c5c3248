/// Canonical motions: the output of all program readers in cam/gcode.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/base/units.h"
#include "fieldfab/core/geometry.h"
#include "fieldfab/core/progress.h"

namespace fieldfab::cam {

/// Axes of a machine, in the order of AxisValues.
enum class Axis : std::uint8_t { x, y, z, a, b, c, u, v, w };

/// Axis positions: x y z u v w in mm, a b c in radians.
struct AxisValues {
  std::array<double, 9> at{};

  double& operator[](Axis axis) { return at[static_cast<std::size_t>(axis)]; }
  double operator[](Axis axis) const { return at[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] Vec3 xyz() const { return {at[0], at[1], at[2]}; }
  bool operator==(const AxisValues&) const = default;
};

/// Plane of an arc: G17 (x, y; normal z), G18 (z, x; normal y), G19 (y, z; normal x).
enum class ArcPlane : std::uint8_t { xy, zx, yz };

/// Kinematics in force during a motion (M428 to M430 of LinuxCNC's five-axis machines, Fanuc's G43.4).
enum class ControlMode : std::uint8_t {
  machine,  ///< as in the machine's data file
  tip,      ///< x, y, z are those of the tool tip, whatever the rotary axes do (M428, G43.4)
  axes,     ///< x, y, z are the linear axes (M429, G49 after G43.4)
  user,     ///< the machine's own third kinematics (M430)
};

/// A canonical motion.
struct Motion {
  enum class Kind : std::uint8_t {
    rapid,  ///< rapid to `end`
    feed,   ///< linear feed to `end`; all axes move proportionally
    /// circular feed to `end` about `centre`; a helix if the third axis moves; other axes move proportionally
    arc,
    dwell,        ///< pause of `seconds`
    tool_change,  ///< change to `tool`
    stop,         ///< M0, M1, M60: stop until the operator continues
    end,          ///< M2, M30, %: end of the program
  };
  Kind kind = Kind::rapid;
  ArcPlane plane = ArcPlane::xy;
  ControlMode mode = ControlMode::machine;
  int line = 0;  ///< line of the program's file, from 1; within a subroutine, the line of the motion
  /// End position in machine coordinates. Work offsets, G92, rotation and cutter compensation are applied; the tool
  /// length is not (see `tool_offset`). It is the position of the tool tip if the control's tool length is correct. The
  /// linear axes are at `end` + `tool_offset`, and a motion starts from these axis positions: if `tool_offset` changes
  /// between two motions, the axes have not moved. For dwells, tool changes, stops and the end it is the current
  /// position.
  AxisValues end;
  Vec2 centre = Vec2::Zero();  ///< centre of an arc along the plane's first and second axis, machine coordinates, mm
  /// turns of an arc, seen from the plane's normal: 1 is up to one full turn counter-clockwise, -1 clockwise, 2 one
  /// turn more
  int turns = 0;
  double feed =
      /// feed, mm/min along x, y, z (along u, v, w if these are at rest; radians/min if only rotary axes move); 0 for
      /// rapids
      0;
  /// duration stated by the program, seconds: of a dwell, or of a move under G93; otherwise 0
  double seconds = 0;
  int tool = 0;                     ///< number of the tool in the spindle
  double spindle = 0;               ///< spindle speed, revolutions per minute; negative: counter-clockwise; 0: stopped
  Vec3 tool_offset = Vec3::Zero();  ///< tool length compensation in force (G43), mm
};

using MotionSink = std::function<void(const Motion&)>;

/// Entry of the control's tool table.
struct ToolEntry {
  Vec3 offset = Vec3::Zero();  ///< length compensation, usually (0, 0, length), mm
  double diameter = 0;         ///< cutter diameter for G41 and G42, mm
};

/// G-code dialect. LinuxCNC's is read strictly. In the others, a code without an effect on motion or meaning here gives
/// a note.
enum class Dialect : std::uint8_t {
  linuxcnc,
  fanuc,  ///< Fanuc and Haas: P of G4 is in milliseconds if it has no decimal point
  grbl,   ///< Grbl and its senders: lines that start with $ are skipped
  mach3,
};
/// Returns "linuxcnc", "fanuc", "grbl" or "mach3".
std::string_view name_of(Dialect dialect);
/// Returns the dialect of that name. Throws Error(bad_input) at `place`, with the most similar name.
Dialect dialect_named(std::string_view name, const std::string& place);

/// State of the control before the program starts, and limits.
struct ReadingOptions {
  Dialect dialect = Dialect::linuxcnc;
  bool inch = false;                         ///< unit before G20 or G21: inch or millimetre
  std::map<int, ToolEntry> tools;            ///< tool table by tool number
  std::array<AxisValues, 9> work_offsets{};  ///< G54 to G59, G59.1 to G59.3, machine coordinates
  AxisValues start;                          ///< axis positions at the start, machine coordinates
  std::array<AxisValues, 2> home{};          ///< positions of G28 and G30, machine coordinates
  bool block_delete = true;                  ///< whether lines that start with / are skipped
  /// further folders to search for subroutine files; the program's own folder is searched as well
  std::vector<std::filesystem::path> folders;
  std::uint64_t most_blocks = 100'000'000;  ///< limit of executed blocks; a program beyond it counts as an endless loop
};

/// A remark on a program that did not stop the reading, such as an M-code without a meaning here.
struct ReadingNote {
  int line = 0;
  std::string message;
};

/// Interprets a G-code program and passes each motion to `sink` in order. Returns notes, each message once. Memory does
/// not grow with the length of the program, except for subroutines and parameters.
///
/// The dialect is that of LinuxCNC 2.9, whose interpreter is the oracle of the tests, with the following additions and
/// differences. Other dialects (docs/simulation.md, Dialects) differ further: of several codes of one group in a block
/// the last applies, G80 may share a block with a motion, G0 and G98 are in force at the start, feeds need no rate, and
/// unknown codes without motion and unused words are ignored. Each such case gives a note.
///
/// - M428, M429, M430 and G43.4 ... G49 set the ControlMode.
/// - G68 X Y R and G69 rotate the program about a point of the plane, as Fanuc's controls do. The machine does not
///   move; subsequent words refer to the rotated system.
/// - The machine's unit is the millimetre: parameters with machine positions (#5161 to #5390) are mm and degrees.
/// - Splines (G5, G5.1, G5.2), and arcs that a rotation takes out of their plane, become short feeds with a deviation
///   of at most 0.001 mm.
/// - G38.x is a feed to its end point, without contact. G33, G33.1 and G76 are feeds of pitch times spindle speed.
/// - After the stop of G88 the tool is retracted. M-codes from 100 on, outputs (M62 to M68) and #<_hal[...]> give notes
///   and are skipped.
/// - Lathe cycles G70 to G72, G50, G51 and Python are refused.
///
/// `file` names the program in messages; its folder is searched first for subroutine files. Throws Error(bad_input)
/// with FILE:LINE for unknown input that might move an axis, Error(io) for an unreadable subroutine file,
/// Error(cancelled). Motions passed before an error stay passed. Speed: about 3 million simple blocks per second.
std::vector<ReadingNote> read_gcode(std::string_view text, const std::string& file, const ReadingOptions& options,
                                    const MotionSink& sink, Progress& progress = Progress::none());
/// Interprets a ShopBot part file (.sbp): moves (M2, MX and others), jogs, arcs (CG, CP), zeroing, speeds, variables,
/// labels. `unit` is the length of a program unit, mm. Conditions on the control's state (IF %(25) ...) count as false,
/// with a note; macros of the control (C6, C#,90) give a note and are skipped; anything else that might move an axis is
/// refused. Rotary axes are in degrees. The program's zero is the first work offset, as for the readers below. Throws
/// as read_gcode().
std::vector<ReadingNote> read_sbp(std::string_view text, const std::string& file, const ReadingOptions& options,
                                  double unit, const MotionSink& sink, Progress& progress = Progress::none());
/// Interprets RML of Roland's mills (Modela, SRM-20). `tick` is the length of a program unit, mm: 1/40 or 1/100. Z
/// moves use the lesser of the speeds VS and !VZ. Moves with a raised tool are feeds, too, because RML has no rapids.
/// Throws as read_gcode().
std::vector<ReadingNote> read_rml(std::string_view text, const std::string& file, const ReadingOptions& options,
                                  double tick, const MotionSink& sink, Progress& progress = Progress::none());
/// Interprets HPGL: PU, PD, PA, PR, arcs, circles, rectangles; escape sequences of printers are skipped. The raised pen
/// is at z = `up`, the lowered one at z = `down`, mm; the pen number is the tool number. Lettering, fills, scaling and
/// other drawing commands are refused. Throws as read_gcode().
std::vector<ReadingNote> read_hpgl(std::string_view text, const std::string& file, const ReadingOptions& options,
                                   double tick, double up, double down, const MotionSink& sink,
                                   Progress& progress = Progress::none());

}  // namespace fieldfab::cam
