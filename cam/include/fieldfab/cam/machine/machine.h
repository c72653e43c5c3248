/// Machines, each defined by one data file (cam/machine/*.toml, docs/machines.md), and writers of their program files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/base/chip_load.h"
#include "fieldfab/cam/base/setting.h"
#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/cam/plan/program.h"

namespace fieldfab::cam {

/// A rotary axis of a machine.
struct RotaryAxis {
  char letter = 'A';
  Vec3 direction = Vec3::UnitX();
  double lower = -1e300, upper = 1e300;  ///< limits, radians
  /// A point on the axis when both rotary axes are at 0, mm, if it does not pass through the common centre (table, in
  /// part coordinates) or the pivot (head, from the gauge line).
  std::optional<Vec3> centre = std::nullopt;
};

/// Rotary kinematics of a machine.
struct Kinematics {
  /// Of two head axes the first carries the second; the first table axis is the one nearest to the machine's bed.
  enum class Kind : std::uint8_t { none, head_head, table_table, head_table };
  Kind kind = Kind::none;
  std::vector<RotaryAxis> axes;
  Vec3 centre = Vec3::Zero();  ///< centre of a table's axes in part coordinates, mm
  double pivot = 0;            ///< distance from the pivot of a head to the gauge line, mm
  /// whether the control compensates the tool tip (G43.4, TCP): x, y, z are then those of the tip
  bool tip_mode = false;
};

/// Returns "none", "head-head", "table-table" or "head-table".
std::string_view name_of(Kinematics::Kind kind);

/// Input of a machine.
enum class MachineInput : std::uint8_t { paths, flat_paths, height_map, mesh };
/// Returns "paths", "flat paths", "height map" or "mesh".
std::string_view name_of(MachineInput takes);

/// File format of a machine's programs.
enum class FileFormat : std::uint8_t {
  text,  ///< text made from the machine's templates
  dxf,
  svg,
  png,  ///< a height map
  stl,  ///< a mesh
};

/// A machine, as described by its data file.
struct Machine {
  std::string id, name, extension, description;
  FileFormat format = FileFormat::text;
  MachineInput takes = MachineInput::paths;
  double unit = 1;  ///< length unit of its files, mm
  double tick = 0;  ///< step of files with whole numbers, mm; 0: decimal numbers
  int decimals = 4;
  bool arcs = false;
  double feed_unit = 1;  ///< feed unit of its files, mm/min
  double max_feed = 0;   ///< greatest feed, mm/min; 0: unknown
  double max_spindle = 0;
  std::array<double, 3> travel{0, 0, 0};  ///< travel along x, y, z, mm; 0: unknown
  bool negative = true;                   ///< whether x and y may be negative
  Dynamics dynamics;
  Kinematics kinematics;
  Dialect dialect = Dialect::linuxcnc;  ///< dialect of its G-code
  /// templates by name: header, footer, rapid, line and so on
  std::map<std::string, std::string> text;
  /// the machine's own settings, such as power or speed
  Settings settings;
  /// default values by material and setting; where a material has none, its chip load makes them (cutting_values_of)
  std::map<std::string, std::map<std::string, Value>> materials;
  std::string default_operation;  ///< operation for a job that names none
  std::string file;               ///< name of the data file, for messages
};

/// Returns starting values of feed, plunge and spindle by the chip load of a material, within the machine's limits;
/// none where the machine has values of its own or no chip load is known for the material, or the tool has no diameter.
std::optional<CuttingValues> cutting_values_of(const Machine& machine, const std::string& material, const Tool& tool);

/// Returns the contents of the built-in data files by machine id.
const std::map<std::string, std::string>& machine_files();
/// Loads a built-in machine by id, or a .toml file by name. Throws Error(bad_input) (with the most similar id),
/// Error(io).
Machine load_machine(const std::string& id_or_path);
/// Parses a data file. Throws Error(bad_input) with FILE:LINE.
Machine read_machine(std::string_view toml, const std::string& file);

/// Returns the program's text for a machine. Throws Error(bad_input) for moves beyond the machine's limits or
/// abilities.
std::string write_program(const Program& program, const Machine& machine, const Values& values);

}  // namespace fieldfab::cam
