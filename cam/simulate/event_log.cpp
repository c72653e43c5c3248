#include "event_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fieldfab::cam {

std::string_view name_of(SimulationEvent::Kind kind) {
  constexpr std::array<std::string_view, 8> names{"rapid contact",   "shank contact", "holder contact",
                                                  "fixture contact", "over-travel",   "spindle stopped",
                                                  "gouge",           "excess"};
  return names[static_cast<std::size_t>(kind)];
}

void EventLog::add(SimulationEvent event) {
  if (event.first_line == 0) event.first_line = event.last_line = event.move.line;
  const auto [at, fresh] = of_pass_.try_emplace({event.kind, event.move.pass}, events_.size());
  if (fresh) {
    events_.push_back(std::move(event));
    return;
  }
  SimulationEvent& known = events_[at->second];
  event.first_line = known.first_line = std::min(known.first_line, event.first_line);
  event.last_line = known.last_line = std::max(known.last_line, event.last_line);
  if (std::abs(event.amount) > std::abs(known.amount)) known = std::move(event);
}

int EventLog::forget(SimulationEvent::Kind kind, int program) {
  const auto meant = [&](const SimulationEvent& e) { return e.kind == kind && e.move.program == program; };
  const auto first = std::find_if(events_.begin(), events_.end(), meant);
  if (first == events_.end()) return 0;
  const int line = first->first_line;
  std::erase_if(events_, meant);
  of_pass_.clear();
  for (std::size_t i = 0; i < events_.size(); ++i) of_pass_[{events_[i].kind, events_[i].move.pass}] = i;
  return line;
}

void EventLog::add_first(const std::vector<ReadingNote>& notes, int program) {
  auto at =
      std::find_if(notes_.begin(), notes_.end(), [&](const SimulationNote& note) { return note.program == program; });
  for (const ReadingNote& note : notes) at = notes_.insert(at, {note.line, note.message, program}) + 1;
}

void EventLog::move_to(SimulationReport& report) {
  for (SimulationEvent& event : events_)
    if (event.first_line < event.last_line)
      event.message += fmt::format("; it is the worst of lines {} to {}", event.first_line, event.last_line);
  report.events = std::move(events_);
  report.notes = std::move(notes_);
}

}  // namespace fieldfab::cam
