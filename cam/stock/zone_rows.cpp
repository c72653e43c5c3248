#include "zone_rows.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fieldfab/core/clones.h"

namespace fieldfab::cam {
namespace {

/// Position of a line relative to the unbounded cone of a frustum.
enum class Slant {
  chord,     ///< the intersection with the cone is bounded at both ends
  upwards,   ///< the line stays inside of the cone along +s
  downwards  ///< the line stays inside of the cone along -s
};

/// Intervals in a frustum: intersection of the line's interval in the cone and that between the two
/// planes.
template <Slant slant, bool slab>
FIELDFAB_CLONES void cone_row(const Row& row, const Zone& zone) {
  const double k = (zone.r1 - zone.r0) / (zone.z1 - zone.z0);
  const double ad = row.ad, a = 1 - ad * ad - k * k * ad * ad;
  const double safe = slant == Slant::chord ? std::max(a, 1e-14) : std::min(a, -1e-14);
  const double inverse = 1 / safe, level = slab ? 1 / ad : 0;
  float* const __restrict entry = row.entry;
  float* const __restrict exit = row.exit;
  for (int i = 0; i < row.count; ++i) {
    const double u = row.first_u + row.step_u * i;
    const double z = row.au * u + row.av * row.v, w = zone.r0 + k * (z - zone.z0);
    const double b = -(z + k * w) * ad, c = u * u + row.v * row.v - z * z - w * w;
    const double disc = b * b - safe * c, root = std::sqrt(std::max(disc, 0.0));
    const double one = (-b - root) * inverse, other = (-b + root) * inverse;
    double low, high;
    if (slant == Slant::chord)
      low = one, high = other;
    else if (slant == Slant::upwards)
      low = disc < 0 ? -1e300 : one, high = 1e300;
    else
      low = -1e300, high = disc < 0 ? 1e300 : other;
    bool met = slant != Slant::chord || disc >= 0;
    if (slab) {
      const double s0 = (zone.z0 - z) * level, s1 = (zone.z1 - z) * level;
      low = std::max(low, std::min(s0, s1)), high = std::min(high, std::max(s0, s1));
    } else {
      met = met && z >= zone.z0 && z <= zone.z1;
    }
    met = met && low <= high;
    const float from = met ? static_cast<float>(row.origin + low) : std::numeric_limits<float>::infinity();
    const float to = met ? static_cast<float>(row.origin + high) : -std::numeric_limits<float>::infinity();
    entry[i] = std::min(entry[i], from), exit[i] = std::max(exit[i], to);
  }
}

/// Intervals in a cylinder parallel to the lines.
FIELDFAB_CLONES void parallel_row(const Row& row, const Zone& zone) {
  const double s0 = zone.z0 * row.ad, s1 = zone.z1 * row.ad;
  const auto low = static_cast<float>(row.origin + std::min(s0, s1)),
             high = static_cast<float>(row.origin + std::max(s0, s1));
  const auto rest = static_cast<float>(zone.r0 * zone.r0 - row.v * row.v), first = static_cast<float>(row.first_u),
             step = static_cast<float>(row.step_u);
  float* const __restrict entry = row.entry;
  float* const __restrict exit = row.exit;
  for (int i = 0; i < row.count; ++i) {
    const float u = first + step * static_cast<float>(i);
    const bool met = u * u <= rest;
    const float from = met ? low : std::numeric_limits<float>::infinity(),
                to = met ? high : -std::numeric_limits<float>::infinity();
    entry[i] = std::min(entry[i], from), exit[i] = std::max(exit[i], to);
  }
}

/// Intervals in a cylinder that is not parallel to the lines. Computed from the distance of each
/// line to the axis, because that stays accurate in single precision.
template <bool slab>
FIELDFAB_CLONES void cylinder_row(const Row& row, const Zone& zone) {
  const double sine2 = 1 - row.ad * row.ad, sine = std::sqrt(sine2);
  // All are linear along the row: height of the foot point, position of the line's closest point,
  // and distance.
  const auto z0 = static_cast<float>(row.au * row.first_u + row.av * row.v),
             z_step = static_cast<float>(row.au * row.step_u);
  const auto nearest = static_cast<float>(row.ad / sine2), inverse = static_cast<float>(1 / sine);
  const auto d0 = static_cast<float>((row.au * row.v - row.av * row.first_u) / sine),
             d_step = static_cast<float>(-row.av * row.step_u / sine);
  const auto square = static_cast<float>(zone.r0 * zone.r0), origin = static_cast<float>(row.origin);
  const float level = slab ? static_cast<float>(1 / row.ad) : 0.0f, bottom = static_cast<float>(zone.z0),
              top = static_cast<float>(zone.z1);
  float* const __restrict entry = row.entry;
  float* const __restrict exit = row.exit;
  for (int i = 0; i < row.count; ++i) {
    const float t = static_cast<float>(i), z = z0 + z_step * t, distance = d0 + d_step * t;
    const float disc = square - distance * distance, half = std::sqrt(std::max(disc, 0.0f)) * inverse;
    float low = z * nearest - half, high = z * nearest + half;
    bool met = disc >= 0;
    if (slab) {
      const float s0 = (bottom - z) * level, s1 = (top - z) * level;
      low = std::max(low, std::min(s0, s1)), high = std::min(high, std::max(s0, s1));
    } else {
      met = met & (z >= bottom) & (z <= top);
    }
    met = met & (low <= high);
    const float from = met ? origin + low : std::numeric_limits<float>::infinity();
    const float to = met ? origin + high : -std::numeric_limits<float>::infinity();
    entry[i] = std::min(entry[i], from), exit[i] = std::max(exit[i], to);
  }
}

/// Intervals in the convex hull of a ring whose axis is parallel to the lines: heights of its half
/// section.
FIELDFAB_CLONES void ring_along_row(const Row& row, const Zone& zone) {
  const double middle = row.origin + zone.z0 * row.ad;
  float* const __restrict entry = row.entry;
  float* const __restrict exit = row.exit;
  for (int i = 0; i < row.count; ++i) {
    const double u = row.first_u + row.step_u * i;
    const double beyond = std::max(std::sqrt(u * u + row.v * row.v) - zone.r0, 0.0),
                 square = zone.r1 * zone.r1 - beyond * beyond;
    const double half = std::sqrt(std::max(square, 0.0));
    const float from = square >= 0 ? static_cast<float>(middle - half) : std::numeric_limits<float>::infinity();
    const float to = square >= 0 ? static_cast<float>(middle + half) : -std::numeric_limits<float>::infinity();
    entry[i] = std::min(entry[i], from), exit[i] = std::max(exit[i], to);
  }
}

/// Intervals in the convex hull of a ring whose axis is perpendicular to the lines, and parallel or
/// perpendicular to the row: circles.
FIELDFAB_CLONES void ring_across_row(const Row& row, const Zone& zone) {
  float* const __restrict entry = row.entry;
  float* const __restrict exit = row.exit;
  for (int i = 0; i < row.count; ++i) {
    const double u = row.first_u + row.step_u * i;
    const double level = row.au * u + row.av * row.v - zone.z0, square = zone.r1 * zone.r1 - level * level;
    const double radius = zone.r0 + std::sqrt(std::max(square, 0.0)), side = row.av * u - row.au * row.v;
    const double chord = radius * radius - side * side, half = std::sqrt(std::max(chord, 0.0));
    const bool met = square >= 0 && chord >= 0;
    const float from = met ? static_cast<float>(row.origin - half) : std::numeric_limits<float>::infinity();
    const float to = met ? static_cast<float>(row.origin + half) : -std::numeric_limits<float>::infinity();
    entry[i] = std::min(entry[i], from), exit[i] = std::max(exit[i], to);
  }
}

/// Intervals in the convex hull of a ring in any direction, by Newton's method from outside. The
/// distance to a convex solid is convex along a line, so that the steps never pass its surface.
/// Convergence is linear, by halves, for lines that only touch, which is accurate enough there.
FIELDFAB_CLONES void ring_askew_row(const Row& row, const Zone& zone) {
  const double reach = zone.r0 + zone.r1, centre_u = zone.z0 * row.au, centre_v = zone.z0 * row.av,
               middle = zone.z0 * row.ad;
  float* const __restrict entry = row.entry;
  float* const __restrict exit = row.exit;
  const double dv = row.v - centre_v;
  for (int i = 0; i < row.count; ++i) {
    // Relative to the ring's centre, starting at its bounding ball.
    const double du = row.first_u + row.step_u * i - centre_u;
    const double across = du * du + dv * dv, level = row.au * du + row.av * dv, room = reach * reach - across;
    const double start = std::sqrt(std::max(room, 0.0));
    double ends[2], off = 0;
    for (int side = 0; side < 2; ++side) {
      double s = side ? start : -start, f = 0;
      for (int step = 0; step < 12; ++step) {
        const double height = level + s * row.ad,
                     from_axis = std::sqrt(std::max(across + s * s - height * height, 1e-18));
        const double beyond = std::max(from_axis - zone.r0, 0.0),
                     distance = std::sqrt(std::max(beyond * beyond + height * height, 1e-18));
        f = distance - zone.r1;
        const double slope = (beyond * (s - height * row.ad) / from_axis + height * row.ad) / distance;
        // Steps go inwards only. A line that misses the solid would turn round; it stays at its
        // closest point.
        const double inwards = side ? std::max(slope, 1e-3) : std::min(slope, -1e-3);
        s -= std::max(f, 0.0) / inwards;
        s = side ? std::max(s, -start) : std::min(s, start);
      }
      ends[side] = s;
      off = std::max(off, f);
    }
    const bool met = room >= 0 && off < 1e-5 && ends[0] <= ends[1];
    const float from = met ? static_cast<float>(row.origin + middle + ends[0]) : std::numeric_limits<float>::infinity();
    const float to = met ? static_cast<float>(row.origin + middle + ends[1]) : -std::numeric_limits<float>::infinity();
    entry[i] = std::min(entry[i], from), exit[i] = std::max(exit[i], to);
  }
}

/// Intervals in the oblique cylinder that a disc sweeps along a straight line. Its points are a
/// fraction of the path plus a point of the disc's plane. Computed from the line's closest point to
/// the disc's centre in that plane. That point, like its distance, is linear along the row.
FIELDFAB_CLONES void oblique_disc_row(const Row& row, double radius, double wu, double wv, double wd) {
  // component of the path along the disc's axis
  const double along = wu * row.au + wv * row.av + wd * row.ad;
  const double share = 1 / along, tilt = row.ad * share;
  // Projected direction in the disc's plane: along the line, and from line to line.
  const Vec3 line(-tilt * wu, -tilt * wv, 1 - tilt * wd);
  const double u_share = row.au * share, v_share = row.av * share;
  const Vec3 by_u(1 - u_share * wu, -u_share * wv, -u_share * wd), by_v(-v_share * wu, 1 - v_share * wv, -v_share * wd);
  const Vec3 first = row.first_u * by_u + row.v * by_v, step = row.step_u * by_u;
  const double square = line.squaredNorm();
  if (square < 1e-12) {
    // Lines parallel to the path have the same interval ends.
    const double one = -(row.au * row.first_u + row.av * row.v) / row.ad, per_line = -row.au * row.step_u / row.ad,
                 whole = along / row.ad;
    for (int i = 0; i < row.count; ++i) {
      if ((first + i * step).squaredNorm() > radius * radius) continue;
      const double low = one + i * per_line, high = low + whole;
      row.entry[i] = std::min(row.entry[i], static_cast<float>(row.origin + std::min(low, high)));
      row.exit[i] = std::max(row.exit[i], static_cast<float>(row.origin + std::max(low, high)));
    }
    return;
  }
  const double inverse = 1 / square;
  // At a distance from its centre the disc is a chord wide, half of it on each side.
  const Vec3 normal(row.au, row.av, row.ad), side = normal.cross(line) / std::sqrt(square);
  const auto d0 = static_cast<float>(first.dot(side)), d_step = static_cast<float>(step.dot(side));
  const auto s0 = static_cast<float>(-first.dot(line) * inverse),
             s_step = static_cast<float>(-step.dot(line) * inverse);
  const auto t0 = static_cast<float>((row.au * row.first_u + row.av * row.v) * share),
             t_step = static_cast<float>(row.au * row.step_u * share);
  const auto chord = static_cast<float>(1 / std::sqrt(square)), round = static_cast<float>(radius * radius);
  const bool slab = std::abs(row.ad) > 1e-9;
  const float per_share = slab ? static_cast<float>(along / row.ad) : 0.0f, origin = static_cast<float>(row.origin);
  float* const __restrict entry = row.entry;
  float* const __restrict exit = row.exit;
  for (int i = 0; i < row.count; ++i) {
    const float k = static_cast<float>(i), t = t0 + t_step * k, distance = d0 + d_step * k, nearest = s0 + s_step * k;
    const float room = round - distance * distance, half = std::sqrt(std::max(room, 0.0f)) * chord;
    float low = nearest - half, high = nearest + half;
    bool met = room >= 0;
    if (slab) {
      const float one = -t * per_share, other = (1 - t) * per_share;
      low = std::max(low, std::min(one, other)), high = std::min(high, std::max(one, other));
    } else {
      met = met & (t >= 0) & (t <= 1);
    }
    met = met & (low <= high);
    const float from = met ? origin + low : std::numeric_limits<float>::infinity();
    const float to = met ? origin + high : -std::numeric_limits<float>::infinity();
    entry[i] = std::min(entry[i], from), exit[i] = std::max(exit[i], to);
  }
}

/// Intervals in the volume that a disc sweeps in its own plane: a flat slot with round ends.
FIELDFAB_CLONES void level_disc_row(const Row& row, double radius, double wu, double wv, double wd) {
  if (std::abs(row.ad) < 1e-9) return;
  const double square = wu * wu + wv * wv + wd * wd;
  // Both are linear along the row: height of the line's point, and its position along the path.
  const auto s0 = static_cast<float>(-(row.au * row.first_u + row.av * row.v) / row.ad),
             s_step = static_cast<float>(-row.au * row.step_u / row.ad);
  const double share = square > 0 ? 1 / square : 0;
  const auto t0 = static_cast<float>((row.first_u * wu + row.v * wv + static_cast<double>(s0) * wd) * share),
             t_step = static_cast<float>((row.step_u * wu - row.au * row.step_u / row.ad * wd) * share);
  const auto u0 = static_cast<float>(row.first_u), u_step = static_cast<float>(row.step_u),
             v = static_cast<float>(row.v), du = static_cast<float>(wu), dv = static_cast<float>(wv),
             dd = static_cast<float>(wd), reach = static_cast<float>(radius * radius),
             origin = static_cast<float>(row.origin);
  float* const __restrict entry = row.entry;
  float* const __restrict exit = row.exit;
  for (int i = 0; i < row.count; ++i) {
    const float k = static_cast<float>(i), s = s0 + s_step * k, t = std::min(std::max(t0 + t_step * k, 0.0f), 1.0f);
    const float pu = u0 + u_step * k - t * du, pv = v - t * dv, pd = s - t * dd;
    const bool met = pu * pu + pv * pv + pd * pd <= reach;
    const float from = met ? origin + s : std::numeric_limits<float>::infinity(),
                to = met ? origin + s : -std::numeric_limits<float>::infinity();
    entry[i] = std::min(entry[i], from), exit[i] = std::max(exit[i], to);
  }
}

}  // namespace

FIELDFAB_CLONES void ball_row(const Row& row, double radius) {
  const auto rest = static_cast<float>(radius * radius - row.v * row.v), first = static_cast<float>(row.first_u),
             step = static_cast<float>(row.step_u), origin = static_cast<float>(row.origin);
  float* const __restrict entry = row.entry;
  float* const __restrict exit = row.exit;
  for (int i = 0; i < row.count; ++i) {
    const float u = first + step * static_cast<float>(i), disc = rest - u * u, half = std::sqrt(std::max(disc, 0.0f));
    const float from = disc >= 0 ? origin - half : std::numeric_limits<float>::infinity();
    const float to = disc >= 0 ? origin + half : -std::numeric_limits<float>::infinity();
    entry[i] = std::min(entry[i], from), exit[i] = std::max(exit[i], to);
  }
}

void frustum_row(const Row& row, const Zone& zone) {
  const double k = (zone.r1 - zone.r0) / (zone.z1 - zone.z0), ad = row.ad;
  const bool slab = std::abs(ad) > 1e-9;
  if (k == 0) {
    if (1 - ad * ad < 1e-12) return parallel_row(row, zone);
    return std::abs(ad) > 1e-3   ? cylinder_row<true>(row, zone)
           : std::abs(ad) < 1e-9 ? cylinder_row<false>(row, zone)
                                 : cone_row<Slant::chord, true>(row, zone);
  }
  const double a = 1 - ad * ad - k * k * ad * ad;
  if (a > 0)
    slab ? cone_row<Slant::chord, true>(row, zone) : cone_row<Slant::chord, false>(row, zone);
  else if (k * ad > 0)
    cone_row<Slant::upwards, true>(row, zone);
  else
    cone_row<Slant::downwards, true>(row, zone);
}

void ring_row(const Row& row, const Zone& zone) {
  const double ad = std::abs(row.ad);
  (ad > 1 - 1e-12 ? ring_along_row : ad < 1e-9 ? ring_across_row : ring_askew_row)(row, zone);
}

void disc_row(const Row& row, double radius, double wu, double wv, double wd) {
  const double along = wu * row.au + wv * row.av + wd * row.ad;
  const bool level = std::abs(along) < 1e-9 * (1 + std::sqrt(wu * wu + wv * wv + wd * wd));
  (level ? level_disc_row : oblique_disc_row)(row, radius, wu, wv, wd);
}

/// Extends intervals to linearly spaced values.
FIELDFAB_CLONES void fill_row(float* entry, float* exit, int count, float at, float step, float low, float high) {
  for (int i = 0; i < count; ++i) {
    const float place = std::min(std::max(at + step * static_cast<float>(i), low), high);
    entry[i] = std::min(entry[i], place), exit[i] = std::max(exit[i], place);
  }
}

}  // namespace fieldfab::cam
