/// What goes wrong while a program is carried out, and what the user should know besides.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fieldfab/cam/simulate/report.h"

namespace fieldfab::cam {

/// Keeps one event of a kind for each line: the worst.
class EventLog {
 public:
  void add(SimulationEvent event);
  /// Forgets the events of a kind; returns the line of the first one, 0 where there was none.
  int forget(SimulationEvent::Kind kind);
  void note(int line, std::string message) { notes_.push_back({line, std::move(message)}); }
  /// Notes of the program's reader, before all others.
  void add_first(const std::vector<ReadingNote>& notes) { notes_.insert(notes_.begin(), notes.begin(), notes.end()); }

  /// Hands all of it on.
  void move_to(SimulationReport& report);

 private:
  std::vector<SimulationEvent> events_;
  std::vector<ReadingNote> notes_;
  std::map<std::pair<SimulationEvent::Kind, int>, std::size_t> of_line_;
};

}  // namespace fieldfab::cam
