/// Simulation set-ups: material, machine, tools, target (docs/simulation.md).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/solid/formats.h"

namespace fieldfab::cam {

/// Path of rapids.
enum class RapidWay : std::uint8_t {
  straight,  ///< linear: all axes arrive at the same time
  dog_leg,   ///< dog-leg: each axis moves at its own speed until it arrives
};

/// Placement of the part in the machine: program coordinates p are rotation * p + origin in the part.
struct Placement {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 origin = Vec3::Zero();
};

/// Action of the operator at a program stop (M0).
struct StopAction {
  int tool = 0;                        ///< number of the tool to insert; 0: none
  std::optional<Placement> placement;  ///< new placement of the part
};

/// The inputs of a simulation, except the program.
struct SimulationSetup {
  std::string name;
  std::string file;                             ///< name of its file, for messages
  std::vector<std::filesystem::path> programs;  ///< programs of this set-up in order; may be empty
  Machine machine;                              ///< kinematics, speeds, file units and dialect
  bool inch = false;                            ///< unit before G20 or G21: inch or millimetre
  std::map<int, Tool> tools;
  int first_tool = 0;  ///< tool of a program that names none; 0: the lowest number
  Box stock_box;       ///< box of the material, part coordinates, mm
  FieldPtr stock;      ///< shape of the material; null: the box
  /// saved stock to start from, with its own sampling; null: box and shape
  std::shared_ptr<const Stock> saved;
  FieldPtr fixture;  ///< fixture; null: none
  Box fixture_box;
  FieldPtr target;           ///< target solid; null: unknown
  double gouge = 0.05;       ///< least depth that counts as a gouge, mm
  double excess = 0;         ///< permitted excess over the target, mm; 0: any
  double touch = 0.02;       ///< least depth that counts as a contact, mm
  double floor = -1e300;     ///< height below which deviations are ignored, mm: the next set-up machines that region
  Vec3 zero = Vec3::Zero();  ///< the part's zero in machine coordinates, mm
  /// heights of pens, blades and beams for programs that do not state them (HPGL), mm
  double pen_up = 1, pen_down = -1;
  std::array<AxisValues, 9> work_offsets{};
  std::array<AxisValues, 2> home{};  ///< positions of G28 and G30, machine coordinates
  AxisValues start;
  bool start_given = true;                      ///< false: nobody said how high the axes stand at first
  std::array<std::array<double, 2>, 9> limits;  ///< lower and upper limit per axis, mm or radians
  RapidWay rapid_way = RapidWay::straight;
  Placement placement;            ///< initial placement of the part
  std::vector<StopAction> stops;  ///< actions at the program's stops, in order
  StockSettings sampling;
  SimulationSetup();
};

/// Reads a set-up file (docs/simulation.md), a job file (docs/cam.md), or a CAMotics project (.camotics: stock, tools,
/// units and resolution). Throws Error(bad_input) with FILE:LINE, Error(io), Error(cancelled).
SimulationSetup read_simulation_setup(const std::filesystem::path& path, Progress& progress = Progress::none(),
                                      const Formats& formats = kernel_formats());
/// Reads a job file that names no model; the part is given as a Field (see Job::parse()). All results are in that
/// Field's coordinates, wherever the program's zero is. Throws as the function above.
SimulationSetup read_simulation_setup(const std::filesystem::path& path, FieldPtr part,
                                      Progress& progress = Progress::none(), const Formats& formats = kernel_formats());

/// Returns the map from part coordinates to the position at which the machine's table holds the part, for given axis
/// positions. The identity for machines without a rotary table.
Eigen::Isometry3d turn_of_work(const Machine& machine, const AxisValues& axes);

}  // namespace fieldfab::cam
