/// What a program makes a machine do: the stream of canonical motions that every reader in cam/gcode gives.
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

/// The axes of a machine, in the order in which AxisValues holds them.
enum class Axis : std::uint8_t { x, y, z, a, b, c, u, v, w };

/// Where a machine's axes stand: x y z u v w in mm, a b c in radians.
struct AxisValues {
  std::array<double, 9> at{};

  double& operator[](Axis axis) { return at[static_cast<std::size_t>(axis)]; }
  double operator[](Axis axis) const { return at[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] Vec3 xyz() const { return {at[0], at[1], at[2]}; }
  bool operator==(const AxisValues&) const = default;
};

/// The plane of an arc: G17 (x, y; its axis is z), G18 (z, x; y), G19 (y, z; x).
enum class ArcPlane : std::uint8_t { xy, zx, yz };

/// Which kinematics the control uses while it moves (M428 to M430 of LinuxCNC's five-axis machines, Fanuc's G43.4).
enum class ControlMode : std::uint8_t {
  machine,  ///< as the machine's data file says
  tip,      ///< x, y, z are the tool tip's, whatever the rotary axes do (M428, G43.4)
  axes,     ///< x, y, z are the linear axes themselves (M429, G49 after G43.4)
  user,     ///< the machine's own third kinematics (M430)
};

/// One thing the machine does.
struct Motion {
  enum class Kind : std::uint8_t {
    rapid,        ///< to `end` at full speed
    feed,         ///< to `end`, all axes evenly
    arc,          ///< to `end` about `centre`, a helix where the third axis moves; other axes evenly
    dwell,        ///< stands for `seconds`
    tool_change,  ///< takes `tool` into the spindle
    stop,         ///< M0, M1, M60: waits for the operator
    end,          ///< M2, M30, %: nothing comes after it
  };
  Kind kind = Kind::rapid;
  ArcPlane plane = ArcPlane::xy;
  ControlMode mode = ControlMode::machine;
  int line = 0;  ///< of the program's file, from 1; in a subroutine, the line that moves
  /// Machine coordinates: work offsets, G92 and rotation are in, the tool's length is not (it is `tool_offset`), cutter
  /// compensation is. The place the tool's tip goes to where the control's idea of its length is right; the linear axes stand at
  /// `end` + `tool_offset`, and it is they that a motion begins from: where `tool_offset` changes between two motions, the axes
  /// have not moved. Dwells, tool changes, stops and the end have the place where the machine stands.
  AxisValues end;
  Vec2 centre = Vec2::Zero();  ///< of an arc: along the plane's first and second axis, machine coordinates
  int turns = 0;  ///< of an arc: 1 is up to a full turn anticlockwise seen from the plane's axis, -1 clockwise, 2 one turn more
  double feed =
      0;  ///< mm/min along x, y, z (u, v, w where these stand still; radians/min where only rotary axes move); 0 for rapids
  double seconds = 0;               ///< what the program itself says that it takes: a dwell's, or a move's under G93; else 0
  int tool = 0;                     ///< in the spindle
  double spindle = 0;               ///< revolutions per minute; below 0 anticlockwise; 0: stands still
  Vec3 tool_offset = Vec3::Zero();  ///< the length compensation in force (G43), mm
};

using MotionSink = std::function<void(const Motion&)>;

/// What the control's tool table says.
struct ToolEntry {
  Vec3 offset = Vec3::Zero();  ///< length compensation: usually (0, 0, length), mm
  double diameter = 0;         ///< for G41 and G42, mm
};

/// Whose control a G-code program was written for. LinuxCNC's is read strictly. In the others, what moves nothing and has no
/// meaning here is a note.
enum class Dialect : std::uint8_t {
  linuxcnc,
  fanuc,  ///< and Haas: G4 P counts in milliseconds where it has no decimal point
  grbl,   ///< and its senders: lines that begin with $ are left out
  mach3,
};
/// "linuxcnc", "fanuc", "grbl", "mach3".
std::string_view name_of(Dialect dialect);
/// Throws bad_input at `place`, with the nearest name.
Dialect dialect_named(std::string_view name, const std::string& place);

/// What the control knows before the program starts, and how long it may take.
struct ReadingOptions {
  Dialect dialect = Dialect::linuxcnc;
  bool inch = false;                           ///< what it counts in before G20 and G21
  std::map<int, ToolEntry> tools;              ///< by number
  std::array<AxisValues, 9> work_offsets{};    ///< G54 to G59, G59.1 to G59.3, machine coordinates
  AxisValues start;                            ///< where the axes stand, machine coordinates
  std::array<AxisValues, 2> home{};            ///< G28's and G30's places, machine coordinates
  bool block_delete = true;                    ///< lines that begin with / are left out
  std::vector<std::filesystem::path> folders;  ///< where subroutine files are looked for, besides the program's own folder
  std::uint64_t most_blocks = 100'000'000;     ///< blocks carried out before a loop is called endless
};

/// Something about a program that its reader of it should know and that did not stop the reading: an M-code without a meaning
/// here, say.
struct ReadingNote {
  int line = 0;
  std::string message;
};

/// Carries out a program and hands on each motion in order. Returns what was passed over, each message once. Memory does not grow
/// with the program's length, but for its subroutines and parameters. The dialect is LinuxCNC 2.9's, whose interpreter is the
/// oracle of its tests, with the additions and differences below. In the other dialects (docs/simulation.md, Dialects) of codes
/// of one group in a block the last one holds, G80 takes no motion's place, G0 and G98 are in force at first, a feed needs no
/// rate, and unknown codes that move nothing and words that nothing uses are passed over, each with a note.
/// - M428, M429, M430 and G43.4 ... G49 set the ControlMode; G68 X Y R and G69 turn the program about a point of the plane, as
/// Fanuc's
///   controls do (the machine stays where it is; words then count in the turned system).
/// - The machine's unit is the millimetre: parameters that hold places of the machine (#5161 to #5390) are mm and degrees.
/// - Splines (G5, G5.1, G5.2) and arcs that a rotation takes out of their plane are short feeds, 0.001 mm from the curve at most.
/// - G38.x is a feed to its end, where nothing was touched; G33, G33.1 and G76 are feeds of the pitch times the spindle's speed.
/// - After the stop of G88 the tool is drawn out. M-codes from 100 on, outputs (M62 to M68) and #<_hal[...]> are noted and passed
/// over.
/// - Lathe cycles G70 to G72, G50 and G51 are refused, so is Python.
/// `file` names the program in messages; its folder is the first one where subroutine files are looked for.
/// Throws bad_input with FILE:LINE for whatever it does not understand and that might move an axis, io for a subroutine file that
/// cannot be read, cancelled. What was handed on before stays handed on. About 3 million plain blocks a second.
std::vector<ReadingNote> read_gcode(std::string_view text, const std::string& file, const ReadingOptions& options,
                                    const MotionSink& sink, Progress& progress = Progress::none());
/// ShopBot's part files (.sbp): moves (M2, MX, ...), jogs, arcs (CG, CP), zeroing, speeds, variables, labels. `unit`: mm in one
/// of its units. What asks the control (IF %(25) ...) counts as not so, with a note; its macros (C6, C#,90) are noted and passed
/// over; whatever else might move an axis is refused. Rotary axes are in degrees. The program's zero lies at the first work
/// offset (so for those below).
std::vector<ReadingNote> read_sbp(std::string_view text, const std::string& file, const ReadingOptions& options, double unit,
                                  const MotionSink& sink, Progress& progress = Progress::none());
/// RML of Roland's mills (Modela, SRM-20): ticks of 1/40 mm or 1/100 mm. `tick` in mm. Z moves feed with the lesser of VS and
/// !VZ; their rapids are feeds, too, since RML has no others.
std::vector<ReadingNote> read_rml(std::string_view text, const std::string& file, const ReadingOptions& options, double tick,
                                  const MotionSink& sink, Progress& progress = Progress::none());
/// HPGL: PU, PD, PA, PR, arcs, circles, rectangles; printers' escapes around it are stepped over. The pen is up at z = `up` and
/// down at z = `down`, mm; its number is the tool's. Lettering, fills, scaling and what else would draw are refused.
std::vector<ReadingNote> read_hpgl(std::string_view text, const std::string& file, const ReadingOptions& options, double tick,
                                   double up, double down, const MotionSink& sink, Progress& progress = Progress::none());

}  // namespace fieldfab::cam
