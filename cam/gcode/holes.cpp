#include "holes.h"

#include "block.h"
#include "frame.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {
namespace {

// mm; clearance of G83 and G73 above the previous depth, as in LinuxCNC
constexpr double peck_clearance = 0.254;
constexpr int most_pecks = 1'000'000;

/// The steps of one hole.
class Maker {
 public:
  Maker(const Hole& hole, const std::function<void(const HoleStep&)>& give, const std::function<void()>& count)
      : hole_(hole), axes_(axes_of(hole.plane)), give_(give), count_(count) {}

  void make() {
    switch (hole_.code) {
      case 810: feed(hole_.bottom); return rapid(hole_.clear);
      case 820:
        feed(hole_.bottom);
        dwell();
        return rapid(hole_.clear);
      case 730:
      case 830: return peck();
      case 740:
      case 840: return tap();
      case 850:
        feed(hole_.bottom);
        feed(hole_.r);
        return rapid(hole_.clear);
      case 860: return bore();
      case 870: return back_bore();
      case 880: return bore_by_hand();
      default:  // 890
        feed(hole_.bottom);
        dwell();
        return feed(hole_.clear);
    }
  }

 private:
  [[nodiscard]] AxisValues at(double height) const {
    AxisValues to = hole_.place;
    to.at[axes_.third] = height;
    return to;
  }
  void rapid(double height) { give_({HoleStep::Kind::rapid, at(height), 0}); }
  void feed(double height) { give_({HoleStep::Kind::feed, at(height), 0}); }
  void rapid_aside(double height) {
    AxisValues to = at(height);
    set_in_plane(to, axes_, in_plane(to, axes_) + hole_.aside);
    give_({HoleStep::Kind::rapid, to, 0});
  }
  void dwell() { give_({HoleStep::Kind::dwell, {}, 0}); }
  void turn(int turning) { give_({HoleStep::Kind::spindle, {}, turning}); }
  void need_spindle() const {
    if (hole_.turning == 0) refuse("{} while the spindle stands still", g_name(hole_.code));
  }

  void peck() {
    if ((hole_.r - hole_.bottom) / hole_.peck > most_pecks) refuse("more than {} pecks", most_pecks);
    for (double depth = hole_.r - hole_.peck; depth > hole_.bottom; depth -= hole_.peck) {
      count_();
      feed(depth);
      if (hole_.code == 830) rapid(hole_.r);
      rapid(depth + peck_clearance);
    }
    feed(hole_.bottom);
    rapid(hole_.clear);
  }

  void tap() {
    const bool clockwise = hole_.code == 840;
    if (hole_.turning != (clockwise ? 1 : -1))
      refuse("{} needs a spindle that turns {}", g_name(hole_.code), clockwise ? "clockwise" : "anticlockwise");
    feed(hole_.bottom);
    turn(-hole_.turning);
    dwell();
    feed(hole_.clear);
    turn(hole_.turning);
  }

  void bore() {
    need_spindle();
    feed(hole_.bottom);
    dwell();
    turn(0);
    rapid(hole_.clear);
    turn(hole_.turning);
  }

  void back_bore() {
    need_spindle();
    rapid_aside(hole_.r);
    turn(0);
    rapid_aside(hole_.bottom);
    rapid(hole_.bottom);
    turn(hole_.turning);
    feed(hole_.end);
    feed(hole_.bottom);
    turn(0);
    rapid_aside(hole_.bottom);
    rapid_aside(hole_.clear);
    rapid(hole_.clear);
    turn(hole_.turning);
  }

  void bore_by_hand() {
    need_spindle();
    feed(hole_.bottom);
    dwell();
    turn(0);
    give_({HoleStep::Kind::stop, {}, 0});
    rapid(hole_.clear);
    turn(hole_.turning);
  }

  const Hole& hole_;
  PlaneAxes axes_;
  const std::function<void(const HoleStep&)>& give_;
  const std::function<void()>& count_;
};

}  // namespace

void make_hole(const Hole& hole, const std::function<void(const HoleStep&)>& give, const std::function<void()>& count) {
  Maker(hole, give, count).make();
}

}  // namespace fieldfab::cam::gcode
