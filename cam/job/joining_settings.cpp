// Settings of all operations: how paths are linked to moves.
#include "stages.h"

namespace fieldfab::cam {

Settings joining_settings() {
  return {
      above_zero(number("feed", "mm/min", 600, "feed rate of cuts")),
      above_zero(number("plunge", "mm/min", 200, "feed rate of plunges")),
      at_least(0, number("spindle", "1/min", 10000, "spindle speed")),
      choice("coolant", {"none", "mist", "flood"}, "coolant while cutting"),
      above_zero(number("clearance", "mm", 5, "height of rapids above the stock")),
      above_zero(
          number("link_feed", "mm/min", unset, "feed rate where the material is cut already; the default is the feed")),
      choice("entry", {"plunge", "ramp", "helix"}, "how closed paths are entered"),
      between(0.1, 45, number("ramp_angle", "degrees", 3, "angle of ramps and helices")),
      choice(
          "plane", {"top", "bottom", "front", "back", "left", "right", "five", "view", "stepped"},
          "cut from: one face, the five visible ones, as seen (alpha, beta), or in even steps; a machine that cannot "
          "tilt stops for turning the part by hand"),
      only_with("plane", number("alpha", "degrees", 0, "rotation of a view about z"), {"view"}),
      only_with("plane",
                between(0, 180, number("beta", "degrees", 0, "rotation of a view about x, after that about z")),
                {"view"}),
      only_with("plane", whole(between(2, 37, number("steps", "", 3, "number of stepped planes per half turn"))),
                {"stepped"})};
}

}  // namespace fieldfab::cam
