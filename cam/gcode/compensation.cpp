// G41, G42 and their .1: the tool's centre runs beside the path, its radius away.
#include <cmath>

#include "interpreter.h"

namespace fieldfab::cam::gcode {

void Interpreter::set_compensation() {
  if (block_.code(GGroup::compensation) == 400) {
    flush();
    compensation_ = {};
    return;
  }
  refuse("cutter compensation is not read yet");
}

void Interpreter::compensated_straight(Motion::Kind kind, const AxisValues& to) { move(kind, to); }
void Interpreter::compensated_arc(const AxisValues& to, const Circle& circle) { move_arc(to, circle.centre, circle.turns); }
void Interpreter::flush() {
  std::deque<Motion> waiting;
  waiting.swap(compensation_.waiting);
  for (Motion& motion : waiting) send(std::move(motion));
}

}  // namespace fieldfab::cam::gcode
