/// Simulating a program on a stock: what it leaves, and what goes wrong on the way (docs/simulation.md).
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/cam/simulate/playback.h"
#include "fieldfab/cam/stock/deviation.h"
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
  std::string file;   ///< where it was read from, for messages
  Machine machine;    ///< its kinematics, speeds, units of files and dialect
  bool inch = false;  ///< what programs count in before G20 and G21
  std::map<int, Tool> tools;
  int first_tool = 0;  ///< what a program starts with that names no tool; 0: the lowest number
  Box stock_box;       ///< of the material, in the part's coordinates, mm
  FieldPtr stock;      ///< its shape; null: all of the box
  FieldPtr fixture;    ///< null: none
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

/// Something that should not happen.
struct SimulationEvent {
  enum class Kind : std::uint8_t {
    rapid_contact,    ///< a rapid goes through material
    shank_contact,    ///< the shank meets material
    holder_contact,   ///< the holder meets material
    fixture_contact,  ///< any part of the tool meets a fixture
    over_travel,      ///< an axis leaves its limits
    spindle_stopped,  ///< material is cut while the spindle stands
    gouge,            ///< less is left than the target
    excess,           ///< more is left than allowed
  };
  Kind kind = Kind::rapid_contact;
  int line = 0;  ///< of the program
  int tool = 0;
  Vec3 place = Vec3::Zero();  ///< part coordinates
  double amount = 0;          ///< mm of depth, mm^3 of material, or mm (degrees) beyond a limit, by its kind
  std::string message;
};
/// "rapid contact" and so on.
std::string to_string(SimulationEvent::Kind kind);

/// What one line of a program did with one tool.
struct LineRecord {
  int line = 0, tool = 0;
  double removed = 0;  ///< mm^3
  double seconds = 0;
  double cut = 0, air = 0;  ///< mm of feed with and without material
};

struct SimulationReport {
  std::vector<SimulationEvent> events;
  std::vector<ReadingNote> notes;
  std::vector<LineRecord> lines;  ///< in the order in which they were first carried out
  std::optional<Deviation> deviation;
  std::uint64_t moves = 0, poses = 0;
  double seconds = 0, rapid_seconds = 0;
  double removed = 0, left = 0;        ///< mm^3
  double cut = 0, air = 0, rapid = 0;  ///< mm
  StockStatistics stock;
  [[nodiscard]] bool good() const { return events.empty(); }
  /// Share of the feed that meets no material, from 0 to 1.
  [[nodiscard]] double air_share() const { return cut + air > 0 ? air / (cut + air) : 0; }
};

/// The report as JSON; `with_lines`: and what each line did.
std::string to_json(const SimulationReport& report, bool with_lines);

/// A program being carried out on a stock.
class Simulation {
 public:
  explicit Simulation(SimulationSetup setup, Progress& progress = Progress::none());

  /// From now on remembers what it does, so that any moment of it can be shown again. Called before run().
  Playback& remember() { return playback_.emplace(stock_); }
  /// Null where nothing is remembered.
  [[nodiscard]] Playback* playback() { return playback_ ? &*playback_ : nullptr; }
  /// Carries out a program file: G-code, .sbp, .rml or .hpgl, by the set-up's machine or its extension. Throws bad_input with
  /// FILE:LINE, io, cancelled.
  void run(const std::filesystem::path& program, Progress& progress = Progress::none());
  /// Compares with the target, where there is one; adds gouges and excess to the events. Gives the surface with deviations.
  void finish(Progress& progress = Progress::none());

  [[nodiscard]] const Stock& stock() const { return stock_; }
  /// How many cuts samples can remember, the stock's first surface among them.
  [[nodiscard]] std::size_t cuts() const { return line_of_cut_.size(); }
  /// The program's line and the tool of a cut that samples remember; 0 for the stock's first surface.
  [[nodiscard]] int line_of(std::uint32_t cut) const { return cut < line_of_cut_.size() ? std::abs(line_of_cut_[cut]) : 0; }
  [[nodiscard]] int tool_of(std::uint32_t cut) const { return cut < tool_of_cut_.size() ? tool_of_cut_[cut] : 0; }
  [[nodiscard]] const SimulationSetup& setup() const { return setup_; }
  [[nodiscard]] const SimulationReport& report() const { return report_; }
  /// The file that was carried out last.
  [[nodiscard]] const std::filesystem::path& program() const { return program_; }
  /// Of the finished stock, as Stock::mesh() is; after finish(). Where there is a target, a flat's vertices are merged only where
  /// their deviations are alike: within a hundredth of a cell, or, where material is left over, within half of what is.
  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
  /// The program's line that made each vertex; 0 where it is the stock's first surface.
  [[nodiscard]] const std::vector<int>& lines_of_vertices() const { return vertex_lines_; }
  /// And the tool that did; 0 where it is the stock's first surface.
  [[nodiscard]] const std::vector<int>& tools_of_vertices() const { return vertex_tools_; }

 private:
  friend class SimulationRun;
  /// Tells where the target may have parts that the stock's cells are too large for.
  void note_thin_parts(Progress& progress);
  SimulationSetup setup_;
  Stock stock_;
  std::optional<Stock> fixture_;
  std::optional<Playback> playback_;
  SimulationReport report_;
  std::filesystem::path program_;
  std::vector<int> line_of_cut_{0}, tool_of_cut_{0};
  TriangleMesh mesh_;
  std::vector<int> vertex_lines_, vertex_tools_;
};

}  // namespace fieldfab::cam
