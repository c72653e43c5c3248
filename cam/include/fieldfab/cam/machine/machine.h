/// Machines: one data file each (cam/machine/*.toml, docs/machines.md), and the writers that turn programs into their files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/base/setting.h"
#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/cam/plan/program.h"

namespace fieldfab::cam {

/// A rotary axis of a machine.
struct RotaryAxis {
  char letter = 'A';
  Vec3 direction = Vec3::UnitX();
  double lower = -1e300, upper = 1e300;  ///< radians
  /// Where it does not run through the common centre (a table's, in the part's coordinates) or pivot (a head's, from the gauge
  /// line): a point on it while both axes stand at 0, mm.
  std::optional<Vec3> centre = std::nullopt;
};

/// How tool and work turn against each other.
struct Kinematics {
  /// Of two axes of a head the first one carries the second one; a table's first axis is the one nearest to the machine's bed.
  enum class Kind : std::uint8_t { none, head_head, table_table, head_table };
  Kind kind = Kind::none;
  std::vector<RotaryAxis> axes;
  Vec3 centre = Vec3::Zero();  ///< of a table's axes in the part's coordinates, mm
  double pivot = 0;            ///< of a head: from its pivot to the gauge line, mm
  bool tip_mode = false;       ///< the control follows the tool's tip itself (G43.4, TCP): then x, y, z are the tip's
};

/// "none", "head-head", "table-table" or "head-table".
std::string_view name_of(Kinematics::Kind kind);

/// What a machine is fed with.
enum class MachineInput : std::uint8_t { paths, flat_paths, height_map, mesh };
/// "paths", "flat paths", "height map" or "mesh".
std::string_view name_of(MachineInput takes);

/// What a machine's file is.
enum class FileFormat : std::uint8_t {
  text,  ///< its templates, filled in
  dxf,
  svg,
  png,  ///< of a height map
  stl,  ///< of a mesh
};

/// A machine as its data file describes it.
struct Machine {
  std::string id, name, extension, description;
  FileFormat format = FileFormat::text;
  MachineInput takes = MachineInput::paths;
  double unit = 1;  ///< mm in one unit of its files
  double tick = 0;  ///< mm of its smallest step where files hold whole ticks
  int decimals = 4;
  bool arcs = false;
  double feed_unit = 1;  ///< mm/min in one unit of its feeds
  double max_feed = 0;   ///< mm/min; 0: no limit known
  double max_spindle = 0;
  std::array<double, 3> travel{0, 0, 0};  ///< mm; 0: no limit known
  bool negative = true;                   ///< whether its x and y may be below 0
  Dynamics dynamics;
  Kinematics kinematics;
  Dialect dialect = Dialect::linuxcnc;                            ///< of its G-code
  std::map<std::string, std::string> text;                        ///< header, footer, rapid, line, ... : templates
  Settings settings;                                              ///< of its own: power, speed, ...
  std::map<std::string, std::map<std::string, Value>> materials;  ///< defaults by material
  std::string default_operation;                                  ///< what is done where a job names nothing
  std::string file;                                               ///< the data file, for messages
};

/// The machines that come with Fieldfab, by id.
const std::map<std::string, std::string>& machine_files();
/// The machine of that id, or the one in a .toml file of that name. Throws bad_input (with the nearest id), io.
Machine load_machine(const std::string& id_or_path);
/// Reads a data file. Throws bad_input with FILE:LINE.
Machine read_machine(std::string_view toml, const std::string& file);

/// The text of a program for a machine. Throws bad_input for moves outside of the machine's limits, or that it cannot make.
std::string write_program(const Program& program, const Machine& machine, const Values& values);

}  // namespace fieldfab::cam
