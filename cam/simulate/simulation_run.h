/// A program being carried out: its motions become strokes, and what these meet becomes events.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fieldfab/cam/simulate/simulation.h"
#include "poses.h"

namespace fieldfab::cam {

class SimulationRun {
 public:
  /// `lines` of the program, for progress.
  SimulationRun(Simulation& simulation, std::string program, int lines, Progress& progress);
  void operator()(const Motion& motion);
  /// Ends the program.
  void finish();

 private:
  /// What is to be done with the result of a stroke.
  struct Purpose {
    enum class What : std::uint8_t { cut, rapid, shank, holder, fixture } what;
    std::size_t record;
    int line, tool;
    double length;  ///< of the way, mm
    bool stopped;
  };
  /// A tool with what is asked about it.
  struct Mounted {
    Tool tool;
    ToolSolid solid, inner;  ///< as it is, and what lies deeper in it than contacts count
  };

  void take(const Tool& tool);
  void change_tool(int number, int line);
  [[nodiscard]] std::string tool_list() const;
  void stop(const Motion& motion);
  void need_tool(const Motion& motion);

  void move(const Motion& motion);
  void add(const ToolPose& from, const ToolPose& to, const Motion& motion, std::uint32_t cut, double length);
  void check_limits(const Motion& motion, const std::vector<AxisValues>& stations);
  [[nodiscard]] double duration_of(const Motion& motion, double length) const;

  void flush();
  void judge(const Stroke& stroke, const Purpose& purpose, const StrokeResult& result);
  LineRecord& record(int line);
  void event(SimulationEvent::Kind kind, int line, int tool, const Vec3& place, double amount, std::string message);

  Simulation& s_;
  const SimulationSetup& setup_;
  PoseMaker poses_;
  std::string program_;
  int lines_;
  Progress& progress_;
  std::shared_ptr<const Mounted> mounted_;
  int tool_number_ = 0;
  AxisValues at_;
  Vec3 offset_ = Vec3::Zero();  ///< the length compensation that was in force there
  bool known_ = false;          ///< whether the way to the next place is known: not before the first motion
  Placement placement_;
  bool spindle_turns_ = false;  ///< at any place of the program
  bool by_hand_ = false;        ///< tools are changed at stops, whatever the program's numbers are
  std::size_t stops_ = 0, record_ = 0;
  std::vector<Stroke> strokes_, fixture_strokes_;
  std::vector<Purpose> purposes_, fixture_purposes_;
  std::map<std::pair<int, int>, std::size_t> record_of_line_;  ///< and tool
  std::map<std::pair<int, int>, std::size_t> event_of_;
};

}  // namespace fieldfab::cam
