/// What goes wrong while a program is carried out, and what the user should know besides.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/cam/simulate/report.h"

namespace fieldfab::cam {

/// Keeps one event of a kind for each pass: the worst, with the lines of all of them.
class EventLog {
 public:
  void add(SimulationEvent event);
  /// Forgets a program's events of a kind; returns the line of the first one, 0 where there was none.
  int forget(SimulationEvent::Kind kind, int program);
  void note(SimulationNote note) { notes_.push_back(std::move(note)); }
  /// Notes of a program's reader, before all others of that program.
  void add_first(const std::vector<ReadingNote>& notes, int program);

  /// Hands all of it on.
  void move_to(SimulationReport& report);

 private:
  std::vector<SimulationEvent> events_;
  std::vector<SimulationNote> notes_;
  std::map<std::pair<SimulationEvent::Kind, std::uint32_t>, std::size_t> of_pass_;
};

}  // namespace fieldfab::cam
