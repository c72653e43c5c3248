#include "event_log.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fieldfab::cam {

using Kind = SimulationEvent::Kind;

std::string_view name_of(Kind kind) {
  constexpr std::array<std::string_view, 8> names{"rapid contact", "shank contact",   "holder contact", "fixture contact",
                                                  "over-travel",   "spindle stopped", "gouge",          "excess"};
  return names[static_cast<std::size_t>(kind)];
}

void EventLog::add(SimulationEvent event) {
  const auto [at, fresh] = of_line_.try_emplace({event.kind, event.line}, events_.size());
  if (fresh)
    events_.push_back(std::move(event));
  else if (std::abs(event.amount) > std::abs(events_[at->second].amount))
    events_[at->second] = std::move(event);
}

int EventLog::forget(Kind kind) {
  const auto first = std::find_if(events_.begin(), events_.end(), [&](const SimulationEvent& e) { return e.kind == kind; });
  if (first == events_.end()) return 0;
  const int line = first->line;
  std::erase_if(events_, [&](const SimulationEvent& e) { return e.kind == kind; });
  of_line_.clear();
  for (std::size_t i = 0; i < events_.size(); ++i) of_line_[{events_[i].kind, events_[i].line}] = i;
  return line;
}

void EventLog::move_to(SimulationReport& report) {
  report.events = std::move(events_);
  report.notes = std::move(notes_);
}

}  // namespace fieldfab::cam
