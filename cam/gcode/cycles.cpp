// Canned cycles G73, G74 and G81 to G89, in all three planes.
#include <cmath>

#include "interpreter.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr std::string_view letters = "xyzabcuvw";
// mm; clearance of G83 and G73 above the previous depth, as in LinuxCNC
constexpr double peck_clearance = 0.254;
constexpr int most_pecks = 1'000'000;

}  // namespace

/// One hole of a canned cycle, from the plane R on. Heights are of the plane's third axis, mm.
class Interpreter::Hole {
 public:
  Hole(Interpreter& interpreter, int code, const AxisValues& place, double r, double bottom, double clear)
      : in_(interpreter),
        code_(code),
        place_(place),
        axes_(axes_of(interpreter.modes_.plane)),
        r_(r),
        bottom_(bottom),
        clear_(clear),
        turning_(interpreter.modes_.spindle) {}

  void make() {
    switch (code_) {
      case 810: feed(bottom_); return rapid(clear_);
      case 820:
        feed(bottom_);
        in_.dwell(in_.cycle_.p);
        return rapid(clear_);
      case 730:
      case 830: return peck();
      case 740:
      case 840: return tap();
      case 850:
        feed(bottom_);
        feed(r_);
        return rapid(clear_);
      case 860: return bore();
      case 870: return back_bore();
      case 880: return bore_by_hand();
      default:  // 890
        feed(bottom_);
        in_.dwell(in_.cycle_.p);
        return feed(clear_);
    }
  }

 private:
  void go(Motion::Kind kind, double height, double i = 0, double j = 0) {
    AxisValues to = place_;
    to.at[axes_.third] = height;
    to.at[axes_.first] += i, to.at[axes_.second] += j;
    in_.move(kind, to);
  }
  void rapid(double height) { go(Motion::Kind::rapid, height); }
  void feed(double height) { go(Motion::Kind::feed, height); }
  void set_spindle(int turning) { in_.modes_.spindle = turning; }
  void need_spindle() const {
    if (turning_ == 0) refuse("{} while the spindle stands still", g_name(code_));
  }

  void peck() {
    const double peck = in_.length(in_.cycle_.q);
    if ((r_ - bottom_) / peck > most_pecks) refuse("more than {} pecks", most_pecks);
    for (double depth = r_ - peck; depth > bottom_; depth -= peck) {
      in_.flow_.count();
      feed(depth);
      if (code_ == 830) rapid(r_);
      rapid(depth + peck_clearance);
    }
    feed(bottom_);
    rapid(clear_);
  }

  void tap() {
    if (turning_ != (code_ == 840 ? 1 : -1))
      refuse("{} needs a spindle that turns {}", g_name(code_), code_ == 840 ? "clockwise" : "anticlockwise");
    feed(bottom_);
    set_spindle(-turning_);
    in_.dwell(in_.cycle_.p);
    feed(clear_);
    set_spindle(turning_);
  }

  void bore() {
    need_spindle();
    feed(bottom_);
    in_.dwell(in_.cycle_.p);
    set_spindle(0);
    rapid(clear_);
    set_spindle(turning_);
  }

  void back_bore() {
    need_spindle();
    // I, J and K belong to X, Y and Z: two of them move aside, the third is where the boring ends.
    const CycleWords& given = in_.cycle_;
    const std::array<double, 3> words{in_.length(given.i), in_.length(given.j), in_.length(given.k)};
    const double i = words[axes_.first], j = words[axes_.second];
    const double end = in_.modes_.absolute ? words[axes_.third] : bottom_ + words[axes_.third];
    go(Motion::Kind::rapid, r_, i, j);
    set_spindle(0);
    go(Motion::Kind::rapid, bottom_, i, j);
    rapid(bottom_);
    set_spindle(turning_);
    feed(end);
    feed(bottom_);
    set_spindle(0);
    go(Motion::Kind::rapid, bottom_, i, j);
    go(Motion::Kind::rapid, clear_, i, j);
    rapid(clear_);
    set_spindle(turning_);
  }

  void bore_by_hand() {
    need_spindle();
    feed(bottom_);
    in_.dwell(in_.cycle_.p);
    set_spindle(0);
    Motion stop = in_.stamped(Motion::Kind::stop);
    stop.end = in_.at_;
    in_.give(stop);
    in_.notes_.add(in_.flow_.line(), "G88: the operator is taken to draw the tool out straight");
    rapid(clear_);
    set_spindle(turning_);
  }

  Interpreter& in_;
  int code_;  ///< G code times ten
  AxisValues place_;
  PlaneAxes axes_;
  double r_, bottom_, clear_;
  int turning_;  ///< of the spindle, before the hole
};

void Interpreter::cycle_words(int code, const std::string& name) {
  const bool same = modes_.motion == code;
  const auto sticky = [&](char letter, double& kept, const char* what, bool needed) {
    if (block_.has(letter))
      kept = block_[letter];
    else if (!same && needed)
      refuse("{} needs {}, {}", name, static_cast<char>(letter - 32), what);
    else if (!same)
      kept = 0;
  };
  sticky('r', cycle_.r, "where the feed begins", true);
  const char depth = letters[axes_of(modes_.plane).third];
  if (block_.has(depth))
    cycle_.z = block_[depth];
  else if (!same)
    refuse("{} needs {}, the hole's bottom", name, static_cast<char>(depth - 32));
  sticky('p', cycle_.p, "the dwell in seconds", code == 820 || code == 860 || code == 880 || code == 890);
  sticky('q', cycle_.q, "the depth of a peck", code == 830 || code == 730);
  sticky('i', cycle_.i, "how far the tool moves aside or where it ends", code == 870);
  sticky('j', cycle_.j, "how far the tool moves aside or where it ends", code == 870);
  sticky('k', cycle_.k, "how far the tool moves aside or where it ends", code == 870);
}

void Interpreter::cycle() {
  const int code = block_.code(GGroup::motion) == Block::none ? modes_.motion : block_.code(GGroup::motion);
  const std::string name = g_name(code);
  no_compensation("a canned cycle");
  if (modes_.feed_mode == 930) refuse("{} cannot be used under G93", name);
  if (block_.has_any("abcuvw")) refuse("{} moves X, Y and Z only", name);
  if (block_.machine_coordinates) refuse("G53 goes with G0 and G1 only");
  require_feed();

  cycle_words(code, name);
  const int repeats = block_.has('l') ? whole(block_['l'], 1'000'000'000) : 1;
  if (repeats < 1) refuse("{} with L{}: repeats are 1 or more", name, repeats);
  if (cycle_.p < 0) refuse("{} with a dwell of {} seconds", name, cycle_.p);
  if ((code == 830 || code == 730) && cycle_.q <= 0) refuse("{} with Q{}: pecks are above 0", name, cycle_.q);

  const PlaneAxes axes = axes_of(modes_.plane);
  const bool in_cycles = modes_.motion >= 730 && modes_.motion <= 890 && modes_.motion != 760 && modes_.motion != 800;
  if (!in_cycles) cycle_.start = at_.at[axes.third];

  const double half = modes_.diameter && axes.third == 0 ? 0.5 : 1;
  double r = length(cycle_.r), bottom = length(cycle_.z) * half;
  AxisValues place = at_;
  std::array<double, 2> step{};
  const std::array<std::size_t, 2> span{axes.first, axes.second};
  if (modes_.absolute) {
    const AxisValues to = target();
    for (const std::size_t k : span) place.at[k] = to.at[k];
  } else {
    r += cycle_.start;
    bottom += r;
    for (std::size_t i = 0; i < 2; ++i)
      if (block_.has(letters[span[i]])) step[i] = word(letters[span[i]]);
  }
  if (r < bottom) refuse("{} with R below the hole's bottom", name);

  if (cycle_.start < r) {
    AxisValues up = at_;
    up.at[axes.third] = r;
    move(Motion::Kind::rapid, up);
  }
  const double clear = modes_.retract_to_start ? std::max(cycle_.start, r) : r;
  double height = at_.at[axes.third] >= r ? at_.at[axes.third] : clear;
  const bool polar = !modes_.absolute && (block_.has_radius || block_.has_angle);
  for (int i = 0; i < repeats; ++i) {
    if (polar) {  // each repetition is relative to the one before it
      const AxisValues to = target();
      step = {to.at[axes.first] - at_.at[axes.first], to.at[axes.second] - at_.at[axes.second]};
    }
    place.at[axes.first] += step[0], place.at[axes.second] += step[1];
    place.at[axes.third] = height;
    move(Motion::Kind::rapid, place);
    if (height != r) {
      place.at[axes.third] = r;
      move(Motion::Kind::rapid, place);
    }
    Hole(*this, code, place, r, bottom, clear).make();
    height = clear;
    flow_.count();
    if (i % 1024 == 0) progress_.check();
  }
}

}  // namespace fieldfab::cam::gcode
