/// What a simulation starts from: material, machine, tools, target (docs/simulation.md).
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

/// How rapids go from place to place.
enum class RapidWay : std::uint8_t {
  straight,  ///< all axes arrive together
  dog_leg,   ///< each axis at its own speed until it is there
};

/// How the part lies in the machine: a program's coordinates p are the part's rotation * p + origin.
struct Placement {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 origin = Vec3::Zero();
};

/// What the operator does when a program stops (M0).
struct StopAction {
  int tool = 0;                        ///< puts this one in; 0: none
  std::optional<Placement> placement;  ///< turns the part
};

/// Everything about a simulation but the program.
struct SimulationSetup {
  std::string name;
  std::string file;                             ///< where it was read from, for messages
  std::vector<std::filesystem::path> programs;  ///< that it is the set-up of, in their order; may be empty
  Machine machine;                              ///< its kinematics, speeds, units of files and dialect
  bool inch = false;                            ///< what programs count in before G20 and G21
  std::map<int, Tool> tools;
  int first_tool = 0;  ///< what a program starts with that names no tool; 0: the lowest number
  Box stock_box;       ///< of the material, in the part's coordinates, mm
  FieldPtr stock;      ///< its shape; null: all of the box
  std::shared_ptr<const Stock> saved;  ///< what is cut instead, and its sampling; null: box and shape
  FieldPtr fixture;                    ///< null: none
  Box fixture_box;
  FieldPtr target;                   ///< what should come out; null: not known
  double gouge = 0.05;               ///< how deep a cut into the target is one, mm
  double excess = 0;                 ///< how much may be left over it, mm; 0: any amount
  double touch = 0.02;               ///< contacts of less than this depth are none, mm
  double floor = -1e300;             ///< deviations below this height do not count, mm: what the next set-up will cut
  Vec3 zero = Vec3::Zero();          ///< machine coordinates of the part's zero
  double pen_up = 1, pen_down = -1;  ///< heights of pens, blades and beams in programs that do not say them (HPGL), mm
  std::array<AxisValues, 9> work_offsets{};
  std::array<AxisValues, 2> home{};  ///< where G28 and G30 go, machine coordinates
  AxisValues start;
  std::array<std::array<double, 2>, 9> limits;  ///< of each axis, mm or radians
  RapidWay rapid_way = RapidWay::straight;
  Placement placement;            ///< how the part lies at first
  std::vector<StopAction> stops;  ///< what is done at each of the program's stops, in their order
  StockSettings sampling;
  SimulationSetup();
};

/// Reads a set-up (docs/simulation.md), the job (docs/cam.md) that a program was planned by, or a project of CAMotics
/// (.camotics: its stock, tools, units and resolution). Throws bad_input with FILE:LINE,
/// io.
SimulationSetup read_simulation_setup(const std::filesystem::path& path, Progress& progress = Progress::none(),
                                      const Formats& formats = kernel_formats());
/// The same for a job that names no model, since its part was given as a Field (Job::parse()): all is then told in that Field's
/// coordinates, wherever the program's zero is.
SimulationSetup read_simulation_setup(const std::filesystem::path& path, FieldPtr part, Progress& progress = Progress::none(),
                                      const Formats& formats = kernel_formats());

/// From the part's coordinates to where the machine's table has turned it, while the axes stand there; nothing but tables turns
/// it.
Eigen::Isometry3d turn_of_work(const Machine& machine, const AxisValues& axes);

}  // namespace fieldfab::cam
