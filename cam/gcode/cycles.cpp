#include "cycles.h"

#include <cmath>

namespace fieldfab::cam::gcode {

void Cycles::carry_out(const Block& block, int code) {
  const Modes& modes = control_.modes;
  const std::string name = g_name(code);
  stream_.no_compensation("a canned cycle");
  if (modes.feed_mode == 930) refuse("{} cannot be used under G93", name);
  if (block.has_any("abcuvw")) refuse("{} moves X, Y and Z only", name);
  if (block.machine_coordinates) refuse("G53 goes with G0 and G1 only");
  control_.require_feed(block);

  take_words(block, code);
  const int repeats = block.has('l') ? whole(block['l'], 1'000'000'000) : 1;
  if (repeats < 1) refuse("{} with L{}: repeats are 1 or more", name, repeats);
  if (p_ < 0) refuse("{} with a dwell of {} seconds", name, p_);
  if ((code == 830 || code == 730) && q_ <= 0) refuse("{} with Q{}: pecks are above 0", name, q_);

  const std::size_t third = axes_of(modes.plane).third;
  if (!is_cycle(modes.motion)) start_ = control_.at.at[third];
  const Hole hole = first_hole(block, code);
  if (hole.r < hole.bottom) refuse("{} with R below the hole's bottom", name);
  if (start_ < hole.r) {
    AxisValues up = control_.at;
    up.at[third] = hole.r;
    stream_.straight(Motion::Kind::rapid, up);
  }
  repeat(block, hole, repeats);
}

/// Takes the words of a block. Another cycle starts without those of the one before.
void Cycles::take_words(const Block& block, int code) {
  const std::string name = g_name(code);
  const bool same = control_.modes.motion == code;
  const auto sticky = [&](char letter, double& kept, const char* what, bool needed) {
    if (block.has(letter))
      kept = block[letter];
    else if (!same && needed)
      refuse("{} needs {}, {}", name, static_cast<char>(letter - 32), what);
    else if (!same)
      kept = 0;
  };
  sticky('r', r_, "where the feed begins", true);
  const char depth = axis_letters[axes_of(control_.modes.plane).third];
  if (block.has(depth))
    z_ = block[depth];
  else if (!same)
    refuse("{} needs {}, the hole's bottom", name, static_cast<char>(depth - 32));
  sticky('p', p_, "the dwell in seconds", code == 820 || code == 860 || code == 880 || code == 890);
  sticky('q', q_, "the depth of a peck", code == 830 || code == 730);
  sticky('i', i_, "how far the tool moves aside or where it ends", code == 870);
  sticky('j', j_, "how far the tool moves aside or where it ends", code == 870);
  sticky('k', k_, "how far the tool moves aside or where it ends", code == 870);
}

/// The block's hole from the words in force. Under G91 its place is the tool's position, without the first step.
Hole Cycles::first_hole(const Block& block, int code) const {
  const Modes& modes = control_.modes;
  const PlaneAxes axes = axes_of(modes.plane);
  Hole hole;
  hole.code = code;
  hole.plane = modes.plane;
  hole.place = control_.at;
  const double half = modes.diameter && axes.third == 0 ? 0.5 : 1;
  hole.r = modes.length(r_);
  hole.bottom = modes.length(z_) * half;
  if (modes.absolute) {
    set_in_plane(hole.place, axes, in_plane(control_.target(block), axes));
  } else {
    hole.r += start_;
    hole.bottom += hole.r;
  }
  hole.clear = modes.retract_to_start ? std::max(start_, hole.r) : hole.r;
  hole.dwell = p_;
  hole.peck = modes.length(q_);
  // I, J and K belong to X, Y and Z: two of them move aside, the third is where the boring of G87 ends.
  const std::array<double, 3> words{modes.length(i_), modes.length(j_), modes.length(k_)};
  hole.aside = {words[axes.first], words[axes.second]};
  hole.end = modes.absolute ? words[axes.third] : hole.bottom + words[axes.third];
  hole.turning = modes.spindle;
  return hole;
}

void Cycles::repeat(const Block& block, Hole hole, int repeats) {
  const PlaneAxes axes = axes_of(hole.plane);
  const bool relative = !control_.modes.absolute, polar = relative && (block.has_radius || block.has_angle);
  const auto step_of = [&](std::size_t axis) {
    const char letter = axis_letters[axis];
    return relative && block.has(letter) ? control_.word(block, letter) : 0;
  };
  Vec2 step{step_of(axes.first), step_of(axes.second)};
  const double now = control_.at.at[axes.third];
  double height = now >= hole.r ? now : hole.clear;
  for (int i = 0; i < repeats; ++i) {
    // each repetition is relative to the one before it
    if (polar) step = in_plane(control_.target(block), axes) - in_plane(control_.at, axes);
    set_in_plane(hole.place, axes, in_plane(hole.place, axes) + step);
    hole.place.at[axes.third] = height;
    stream_.straight(Motion::Kind::rapid, hole.place);
    if (height != hole.r) {
      hole.place.at[axes.third] = hole.r;
      stream_.straight(Motion::Kind::rapid, hole.place);
    }
    make(hole);
    height = hole.clear;
    count_.add();
    if (i % 1024 == 0) progress_.check();
  }
}

void Cycles::make(const Hole& hole) {
  const auto take = [&](const HoleStep& step) {
    switch (step.kind) {
      case HoleStep::Kind::rapid: stream_.straight(Motion::Kind::rapid, step.to); break;
      case HoleStep::Kind::feed: stream_.straight(Motion::Kind::feed, step.to); break;
      case HoleStep::Kind::dwell: stream_.dwell(hole.dwell); break;
      case HoleStep::Kind::spindle: control_.modes.spindle = step.turning; break;
      case HoleStep::Kind::stop:
        stream_.say(Motion::Kind::stop);
        control_.note("G88: the operator is taken to draw the tool out straight");
        break;
    }
  };
  make_hole(hole, take, [this] { count_.add(); });
}

}  // namespace fieldfab::cam::gcode
