/// Intervals of lines in simple solids, a row of a window at a time.
#pragma once

#include "fieldfab/cam/base/tool_solid.h"

namespace fieldfab::cam {

/// Lines of one row of a window against one zone. Along a line the place is origin + s; all lengths relative to the zone's pose.
struct Row {
  int count = 0;
  double first_u = 0, step_u = 0, v = 0;  ///< of the lines, relative to the tip
  double origin = 0;                      ///< of s: the tip's coordinate along the lines
  double au = 0, av = 0, ad = 1;          ///< the zone's axis
  float *entry = nullptr, *exit = nullptr;
};

/// A ball about the row's origin.
void ball_row(const Row& row, double radius);
/// A cylinder or cone, in any direction.
void frustum_row(const Row& row, const Zone& zone);
/// A ring and what is inside of it, in any direction.
void ring_row(const Row& row, const Zone& zone);
/// A disc about the row's origin that goes along (wu, wv, wd).
void disc_row(const Row& row, double radius, double wu, double wv, double wd);
/// Lowers and raises intervals to places that lie evenly, none below `low` or above `high`.
void fill_row(float* entry, float* exit, int count, float at, float step, float low, float high);

}  // namespace fieldfab::cam
