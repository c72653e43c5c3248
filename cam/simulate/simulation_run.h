/// A program being carried out: its motions become strokes, and what these meet becomes events.
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
  /// Carries out a program from its beginning to its end, on what earlier ones have left. Tools stay in the spindle, and the part
  /// lies as the last one left it; how the axes come to where the program starts is not known.
  void carry_out(const ProgramFile& program);

  [[nodiscard]] const Stock& stock() const { return stock_; }
  [[nodiscard]] const Cuts& cuts() const { return cuts_; }
  [[nodiscard]] EventLog& log() { return log_; }
  /// What came of it, the set-up and the surface missing.
  SimulationResult::Parts take() &&;

 private:
  /// What is to be done with the result of a stroke.
  struct Purpose {
    enum class What : std::uint8_t { cut, rapid, shank, holder, fixture } what;
    std::size_t record;
    CutMove move;
    double length;  ///< of the way, mm
    bool stopped;
  };
  /// A tool with what is asked about it.
  struct Mounted {
    Tool tool;
    ToolSolid solid, inner;  ///< as it is, and what lies deeper in it than contacts count
  };

  void take_motion(const Motion& motion);
  void mount(const Tool& tool);
  void change_tool(int number, int line);
  void stop(const Motion& motion);
  void need_tool(const Motion& motion);

  void move(const Motion& motion);
  void add(const ToolPose& from, const ToolPose& to, const Motion& motion, std::uint32_t tip, double length);
  /// A motion as cuts remember it.
  [[nodiscard]] CutMove cut_move(const Motion& motion) const { return {motion.line, tool_number_, program_number_, pass_}; }
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
  Vec3 offset_ = Vec3::Zero();  ///< the length compensation that was in force there
  std::uint32_t pass_ = 0;
  bool pass_is_rapid_ = false;
  bool known_ = false;  ///< whether the way to the next place is known: not before the first motion
  Placement placement_;
  bool spindle_turns_ = false;  ///< at any place of the program
  bool by_hand_ = false;        ///< tools are changed at stops, whatever the program's numbers are
  std::size_t stops_ = 0, record_ = 0;
  std::vector<Stroke> strokes_, fixture_strokes_;
  std::vector<Purpose> purposes_, fixture_purposes_;
};

}  // namespace fieldfab::cam
