/// Execution of programs: motions become strokes, and their results become events.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "event_log.h"
#include "fieldfab/cam/simulate/simulate.h"
#include "poses.h"
#include "program_file.h"

namespace fieldfab::cam {

class SimulationRun {
 public:
  SimulationRun(const SimulationSetup& setup, const SimulationOptions& options, Progress& progress);
  /// Executes a whole program on the material that earlier programs left. The tool stays in the
  /// spindle, and the part keeps its placement. The motion of the axes to the program's start is
  /// unknown.
  void carry_out(const ProgramFile& program);

  [[nodiscard]] const Stock& stock() const { return stock_; }
  [[nodiscard]] const Cuts& cuts() const { return cuts_; }
  [[nodiscard]] EventLog& log() { return log_; }
  /// Returns the result, without set-up and surface.
  SimulationResult::Parts take() &&;

 private:
  /// Use of a stroke's result.
  struct Purpose {
    enum class What : std::uint8_t { cut, rapid, shank, holder, fixture } what;
    std::size_t record;
    CutMove move;
    double length;  ///< of the motion, mm
    bool stopped;
  };
  /// A tool with the solids for its tests.
  struct Mounted {
    Tool tool;
    ToolSolid solid, inner;  ///< the tool's solid, and the solid offset inwards by the tolerance of
                             ///< contacts
  };

  void take_motion(const Motion& motion);
  void mount(const Tool& tool);
  void change_tool(int number, int line);
  void stop(const Motion& motion);
  void need_tool(const Motion& motion);

  void move(const Motion& motion);
  void add(const ToolPose& from, const ToolPose& to, const Motion& motion, std::uint32_t tip, double length);
  /// A motion as stored with cuts.
  [[nodiscard]] CutMove cut_move(const Motion& motion) const {
    return {motion.line, tool_number_, program_number_, pass_};
  }
  void check_limits(const Motion& motion, const std::vector<AxisValues>& stations);
  [[nodiscard]] double duration_of(const Motion& motion, double length) const;

  void flush();
  void judge(const Stroke& stroke, const Purpose& purpose, const StrokeResult& result);
  LineRecord& record(int line);

  const SimulationSetup& setup_;
  Progress& progress_;
  Stock stock_;
  std::optional<Stock> fixture_;
  std::shared_ptr<Playback> playback_;
  Cuts cuts_;
  SimulationReport report_;
  EventLog log_;
  std::map<std::array<int, 3>, std::size_t> record_of_line_;  ///< by program, line and tool

  const ProgramFile* program_ = nullptr;
  int program_number_ = -1;
  std::optional<PoseMaker> poses_;
  std::shared_ptr<const Mounted> mounted_;
  int tool_number_ = 0;
  AxisValues at_;
  Vec3 offset_ = Vec3::Zero();  ///< length compensation in force at that position
  std::uint32_t pass_ = 0;
  bool pass_is_rapid_ = false;
  bool known_ = false;  ///< whether the motion to the next position is known: not before the first motion
  /// Whether the height of the axes is known. A set-up may not give it: then from the first motion along Z or feed on.
  bool height_known_ = false;
  Placement placement_;
  bool spindle_turns_ = false;  ///< at any position of the program
  bool by_hand_ = false;        ///< tools are changed at stops, independently of the program's tool
                                ///< numbers
  std::size_t stops_ = 0, record_ = 0;
  std::vector<Stroke> strokes_, fixture_strokes_;
  std::vector<Purpose> purposes_, fixture_purposes_;
};

}  // namespace fieldfab::cam
