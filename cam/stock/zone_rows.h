/// Intervals of lines in simple solids, computed for one row of a window at a time.
#pragma once

#include "fieldfab/cam/base/tool_solid.h"

namespace fieldfab::cam {

/// The lines of one row of a window, relative to one zone. A point of a line is origin + s. All
/// lengths are relative to the zone's pose.
struct Row {
  int count = 0;
  double first_u = 0, step_u = 0, v = 0;  ///< coordinates of the lines relative to the tip
  double origin = 0;                      ///< origin of s: the tip's coordinate along the lines
  double au = 0, av = 0, ad = 1;          ///< unit vector of the zone's axis
  float *entry = nullptr, *exit = nullptr;
};

/// Intervals in a ball about the row's origin.
void ball_row(const Row& row, double radius);
/// Intervals in a cylinder or a frustum of a cone in any direction.
void frustum_row(const Row& row, const Zone& zone);
/// Intervals in the convex hull of a ring in any direction.
void ring_row(const Row& row, const Zone& zone);
/// Intervals in the volume of a disc about the row's origin that moves along (wu, wv, wd).
void disc_row(const Row& row, double radius, double wu, double wv, double wd);
/// Extends intervals to linearly spaced values, clamped to [low, high].
void fill_row(float* entry, float* exit, int count, float at, float step, float low, float high);

}  // namespace fieldfab::cam
