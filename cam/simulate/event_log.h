/// Events and notes of a simulation.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/cam/simulate/report.h"

namespace fieldfab::cam {

/// Keeps one event per kind and pass: the worst, with the line range of all of them.
class EventLog {
 public:
  void add(SimulationEvent event);
  /// Removes a program's events of a kind. Returns the line of the first one, 0 if there was none.
  int forget(SimulationEvent::Kind kind, int program);
  void note(SimulationNote note) { notes_.push_back(std::move(note)); }
  /// Inserts the notes of a program's reader before all others of that program.
  void add_first(const std::vector<ReadingNote>& notes, int program);

  /// Moves all events and notes to the report.
  void move_to(SimulationReport& report);

 private:
  std::vector<SimulationEvent> events_;
  std::vector<SimulationNote> notes_;
  std::map<std::pair<SimulationEvent::Kind, std::uint32_t>, std::size_t> of_pass_;
};

}  // namespace fieldfab::cam
