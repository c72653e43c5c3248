#include "sweep.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fieldfab::cam {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Lines of one row of a window against one zone. Along a line the place is origin + s; all lengths relative to the zone's pose.
struct Row {
  int count = 0;
  double first_u = 0, step_u = 0, v = 0;  ///< of the lines, relative to the tip
  double origin = 0;                      ///< of s: the tip's coordinate along the lines
  double au = 0, av = 0, ad = 1;          ///< the zone's axis
  float *entry = nullptr, *exit = nullptr;
};

/// How a line and the unbounded cone of a frustum lie to each other.
enum class Slant {
  chord,     ///< the line leaves the cone at both ends
  upwards,   ///< it stays inside of the cone along +s
  downwards  ///< along -s
};

/// A frustum: where the line is inside of the cone and between the two planes.
template <Slant slant, bool slab>
__attribute__((target_clones("avx2", "default"))) void frustum_row(const Row& row, const Zone& zone) {
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

/// A cylinder along the lines.
void parallel_row(const Row& row, const Zone& zone) {
  const double s0 = zone.z0 * row.ad, s1 = zone.z1 * row.ad, r2 = zone.r0 * zone.r0;
  const float from = static_cast<float>(row.origin + std::min(s0, s1)), to = static_cast<float>(row.origin + std::max(s0, s1));
  for (int i = 0; i < row.count; ++i) {
    const double u = row.first_u + row.step_u * i;
    if (u * u + row.v * row.v > r2) continue;
    row.entry[i] = std::min(row.entry[i], from), row.exit[i] = std::max(row.exit[i], to);
  }
}

__attribute__((target_clones("avx2", "default"))) void ball_row(const Row& row, double radius) {
  const double rest = radius * radius - row.v * row.v;
  float* const __restrict entry = row.entry;
  float* const __restrict exit = row.exit;
  for (int i = 0; i < row.count; ++i) {
    const double u = row.first_u + row.step_u * i, disc = rest - u * u, half = std::sqrt(std::max(disc, 0.0));
    const float from = disc >= 0 ? static_cast<float>(row.origin - half) : std::numeric_limits<float>::infinity();
    const float to = disc >= 0 ? static_cast<float>(row.origin + half) : -std::numeric_limits<float>::infinity();
    entry[i] = std::min(entry[i], from), exit[i] = std::max(exit[i], to);
  }
}

/// A ring and what is inside of it, by Newton's method from both sides: the distance to a convex solid is convex along a line, so
/// that the steps never pass the surface.
void ring_row(const Row& row, const Zone& zone) {
  const double reach = zone.r0 + zone.r1;
  for (int i = 0; i < row.count; ++i) {
    const double u = row.first_u + row.step_u * i, z = row.au * u + row.av * row.v, square = u * u + row.v * row.v;
    const double middle = -zone.z0 * -row.ad;  // of the ring's centre along the line
    const auto outside = [&](double s, double& slope) {
      const double height = z + s * row.ad, from_axis = std::sqrt(std::max(square + s * s - height * height, 0.0));
      const double beyond = std::max(from_axis - zone.r0, 0.0), level = height - zone.z0;
      const double distance = std::hypot(beyond, level);
      slope = distance > 0 ? ((beyond > 0 ? beyond * (s - height * row.ad) / from_axis : 0) + level * row.ad) / distance : 0;
      return distance - zone.r1;
    };
    // All of the ring is within `reach` + of its centre: start outside of that.
    const double start = std::sqrt(reach * reach + zone.z0 * zone.z0) + reach + 1;
    double ends[2];
    bool met = true;
    for (int side = 0; side < 2 && met; ++side) {
      double s = middle + (side ? start : -start), slope = 0;
      for (int step = 0; step < 40; ++step) {
        const double f = outside(s, slope);
        if (f < 1e-9) break;
        if (side ? slope <= 1e-12 : slope >= -1e-12) {
          met = false;
          break;
        }
        const double next = s - f / slope;
        if (std::abs(next - s) < 1e-12) break;
        s = next;
      }
      ends[side] = s;
    }
    if (!met || ends[0] > ends[1]) continue;
    row.entry[i] = std::min(row.entry[i], static_cast<float>(row.origin + ends[0]));
    row.exit[i] = std::max(row.exit[i], static_cast<float>(row.origin + ends[1]));
  }
}

void frustum_row(const Row& row, const Zone& zone) {
  const double k = (zone.r1 - zone.r0) / (zone.z1 - zone.z0), ad = row.ad;
  const bool slab = std::abs(ad) > 1e-9;
  if (k == 0 && 1 - ad * ad < 1e-18) return parallel_row(row, zone);
  const double a = 1 - ad * ad - k * k * ad * ad;
  if (a > 0)
    slab ? frustum_row<Slant::chord, true>(row, zone) : frustum_row<Slant::chord, false>(row, zone);
  else if (k * ad > 0)
    frustum_row<Slant::upwards, true>(row, zone);
  else
    frustum_row<Slant::downwards, true>(row, zone);
}

/// The greatest distance of a zone from its axis, or of a ball from its centre.
double widest(const Zone& zone) {
  if (zone.shape == Zone::Shape::frustum) return std::max(zone.r0, zone.r1);
  return zone.shape == Zone::Shape::ball ? zone.r0 : zone.r0 + zone.r1;
}

/// The box of a zone in a pose.
Box box_of(const Zone& zone, const ToolPose& pose) {
  if (zone.shape == Zone::Shape::ball) {
    const Vec3 centre = pose.tip + zone.z0 * pose.axis;
    return Box{centre, centre}.grown(zone.r0);
  }
  const Vec3 flat = (Vec3::Ones() - pose.axis.cwiseProduct(pose.axis)).cwiseMax(0).cwiseSqrt();
  const auto disc = [&](double height, double radius) {
    const Vec3 centre = pose.tip + height * pose.axis;
    return Box{centre - radius * flat, centre + radius * flat};
  };
  if (zone.shape == Zone::Shape::ring) return disc(zone.z0, zone.r0).grown(zone.r1);
  return hull(disc(zone.z0, zone.r0), disc(zone.z1, zone.r1));
}

/// How many straight parts a circle needs so that they lie within `tolerance` of it.
int parts_of_circle(double radius, double tolerance) {
  if (radius <= tolerance) return 6;
  return std::clamp(static_cast<int>(std::ceil(std::numbers::pi / std::acos(1 - tolerance / radius))), 12, 720);
}

/// Two directions that make a right-handed frame with an axis, changing little where the axis changes little.
std::pair<Vec3, Vec3> across(const Vec3& axis, const Vec3& like) {
  const Vec3 one = (like - like.dot(axis) * axis).normalized();
  return {one, axis.cross(one)};
}

Vec3 any_across(const Vec3& axis) {
  int least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return axis.cross(Vec3::Unit(least)).normalized();
}

}  // namespace

Sweep::Sweep(const ToolPiece& piece, const ToolPose& from, const ToolPose& to, double tolerance) : from_(from), to_(to) {
  const bool turns = (to.axis - from.axis).squaredNorm() > 1e-24;
  const bool moves = turns || (to.tip - from.tip).squaredNorm() > 1e-24;
  bool first = true;
  double low = infinity, high = -infinity;
  for (const Zone& zone : piece.zones) {
    const bool frustum = zone.shape == Zone::Shape::frustum;
    low = std::min(low, zone.z0), high = std::max(high, frustum ? zone.z1 : zone.z0);
    radius_ = std::max(radius_, widest(zone));
  }
  core_ = {from.tip + low * from.axis, from.tip + high * from.axis, to.tip + low * to.axis, to.tip + high * to.axis};
  for (const Zone& zone : piece.zones) {
    for (const bool last : {false, true}) {
      if (last && !moves) break;
      stamps_.push_back({zone, last ? to : from});
      const Box box = box_of(zone, stamps_.back().pose);
      bounds_ = first ? box : hull(bounds_, box);
      first = false;
    }
    if (!moves) continue;
    if (zone.shape == Zone::Shape::ball) {
      // The capsule's cylinder, from the first centre to the last.
      const Vec3 start = from.tip + zone.z0 * from.axis, way = to.tip + zone.z0 * to.axis - start;
      if (way.norm() > 1e-12)
        stamps_.push_back({{Zone::Shape::frustum, 0, way.norm(), zone.r0, zone.r0, false, false}, {start, way.normalized()}});
      continue;
    }
    std::vector<std::array<double, 4>> section;  // distance, height, and the normal's two parts
    if (zone.shape == Zone::Shape::frustum) {
      if (zone.lower_edge) add_edge(zone.z0, zone.r0, tolerance);
      if (zone.upper_edge) add_edge(zone.z1, zone.r1, tolerance);
      const double length = std::hypot(zone.z1 - zone.z0, zone.r1 - zone.r0);
      const int parts = turns ? 4 : 1;
      for (int i = 0; i <= parts; ++i) {
        const double t = static_cast<double>(i) / parts;
        section.push_back({zone.r0 + t * (zone.r1 - zone.r0), zone.z0 + t * (zone.z1 - zone.z0), (zone.z1 - zone.z0) / length,
                           (zone.r0 - zone.r1) / length});
      }
    } else {
      const int parts = std::max(3, parts_of_circle(zone.r1, tolerance) / 4);
      for (int i = 0; i <= parts; ++i) {
        const double angle = std::numbers::pi / 2 * i / parts, c = std::sin(angle), s = -std::cos(angle);
        section.push_back({zone.r0 + zone.r1 * c, zone.z0 + zone.r1 * s, c, s});
      }
    }
    add_grazing(section);
  }
}

void Sweep::add_strip(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  // In runs of a few, so that most can be passed over together.
  constexpr std::size_t run = 8;
  for (std::size_t begin = 1; begin < from.size(); begin += run) {
    const std::size_t end = std::min(begin + run, from.size());
    Strip strip{triangles_.size(), 0, {from[begin - 1], from[begin - 1]}};
    for (std::size_t i = begin - 1; i < end; ++i) strip.box = hull(strip.box, {from[i].cwiseMin(to[i]), from[i].cwiseMax(to[i])});
    for (std::size_t i = begin; i < end; ++i) {
      triangles_.push_back({from[i - 1], from[i], to[i]});
      triangles_.push_back({from[i - 1], to[i], to[i - 1]});
    }
    strip.last = triangles_.size();
    strips_.push_back(strip);
  }
}

namespace {

/// Distance of a place from a triangle, which may be degenerate.
double distance_from_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto from_segment = [&](const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const double square = way.squaredNorm(), t = square > 0 ? std::clamp((p - from).dot(way) / square, 0.0, 1.0) : 0;
    return (p - from - t * way).norm();
  };
  const double edges = std::min({from_segment(a, b), from_segment(b, c), from_segment(c, a)});
  const Vec3 normal = (b - a).cross(c - a);
  const double square = normal.squaredNorm();
  if (square < 1e-24) return edges;
  const Vec3 q = p - normal * ((p - a).dot(normal) / square);
  const bool inside = (b - a).cross(q - a).dot(normal) >= 0 && (c - b).cross(q - b).dot(normal) >= 0 && (a - c).cross(q - c).dot(normal) >= 0;
  return inside ? (p - q).norm() : edges;
}

}  // namespace

bool Sweep::near(const Vec3& place, double distance) const {
  const double reach = distance + radius_;
  return distance_from_triangle(place, core_[0], core_[1], core_[2]) <= reach || distance_from_triangle(place, core_[1], core_[2], core_[3]) <= reach;
}

/// The way of an edge: of a circle about the axis.
void Sweep::add_edge(double height, double radius, double tolerance) {
  if (radius <= 0) return;
  const int parts = parts_of_circle(radius, tolerance);
  const Vec3 like = any_across(from_.axis);
  const auto circle = [&](const ToolPose& pose) {
    const auto [one, other] = across(pose.axis, like);
    std::vector<Vec3> points;
    for (int i = 0; i <= parts; ++i) {
      const double angle = 2 * std::numbers::pi * i / parts;
      points.emplace_back(pose.tip + height * pose.axis + radius * (std::cos(angle) * one + std::sin(angle) * other));
    }
    return points;
  };
  add_strip(circle(from_), circle(to_));
}

/// Both grazing curves along a part of the half section: at each height, the places round the axis where the normal is across the
/// motion. Where a circle has none, its place nearest to that: there the curve closes.
void Sweep::add_grazing(const std::vector<std::array<double, 4>>& section) {
  const Vec3 like = any_across(from_.axis), motion = to_.tip - from_.tip, turning = to_.axis - from_.axis;
  std::array<std::vector<Vec3>, 2> start, end;
  for (const bool last : {false, true}) {
    const ToolPose& pose = last ? to_ : from_;
    const auto [one, other] = across(pose.axis, like);
    const Vec3 swing = turning - turning.dot(pose.axis) * pose.axis;
    for (const auto& [distance, height, out, up] : section) {
      // normal . velocity = p . (cos, sin) + q  at the angle about the axis.
      const Vec3 p = out * motion + (height * out - distance * up) * swing;
      const double q = up * motion.dot(pose.axis), x = p.dot(one), y = p.dot(other), length = std::hypot(x, y);
      const double middle = std::atan2(y, x), half = length > 0 ? std::acos(std::clamp(-q / length, -1.0, 1.0)) : 0;
      for (std::size_t side = 0; side < 2; ++side) {
        const double angle = middle + (side ? half : -half);
        (last ? end : start)[side].emplace_back(pose.tip + height * pose.axis +
                                                distance * (std::cos(angle) * one + std::sin(angle) * other));
      }
    }
  }
  for (std::size_t side = 0; side < 2; ++side) add_strip(start[side], end[side]);
}

namespace {

/// Lowers and raises the intervals of the lines that a triangle meets.
void fill_triangle(Window& window, const StockLattice& lattice, const std::array<Vec3, 3>& triangle) {
  const int d = window.axis, ua = (d + 1) % 3, va = (d + 2) % 3;
  const double inverse_u = 1 / lattice.spacing()[ua], inverse_v = 1 / lattice.spacing()[va];
  std::array<double, 3> u, v, w;
  for (std::size_t i = 0; i < 3; ++i)
    u[i] = triangle[i][ua] * inverse_u, v[i] = triangle[i][va] * inverse_v, w[i] = triangle[i][d];
  constexpr double slack = 1e-7;  // of a cell: a line on an edge is met
  const double v_low = std::min({v[0], v[1], v[2]}), v_high = std::max({v[0], v[1], v[2]});
  const int v0 = std::max(window.v0, static_cast<int>(std::ceil(v_low - slack)));
  const int v1 = std::min(window.v1, static_cast<int>(std::floor(v_high + slack)));
  if (v0 > v1 || std::max({u[0], u[1], u[2]}) < window.u0 - slack || std::min({u[0], u[1], u[2]}) > window.u1 + slack) return;
  const double area = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]);
  const double w_low = std::min({w[0], w[1], w[2]}), w_high = std::max({w[0], w[1], w[2]});
  double along_u = 0, along_v = 0;
  if (std::abs(area) > 1e-12) {
    along_u = ((w[1] - w[0]) * (v[2] - v[0]) - (w[2] - w[0]) * (v[1] - v[0])) / area;
    along_v = ((u[1] - u[0]) * (w[2] - w[0]) - (u[2] - u[0]) * (w[1] - w[0])) / area;
  } else if (w_high - w_low > 1e-9) {
    return;  // on edge: what it bounds is bounded by its neighbours
  }
  for (int j = v0; j <= v1; ++j) {
    double low = infinity, high = -infinity;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = i == 2 ? 0 : i + 1;
      const double lower = std::min(v[i], v[k]), upper = std::max(v[i], v[k]);
      if (j < lower - slack || j > upper + slack) continue;
      const double t = upper - lower > 1e-12 ? std::clamp((j - v[i]) / (v[k] - v[i]), 0.0, 1.0) : 0;
      const double at = u[i] + t * (u[k] - u[i]);
      low = std::min(low, at), high = std::max(high, at);
      if (upper - lower <= 1e-12) low = std::min(low, u[k]), high = std::max(high, u[k]);
    }
    const int u0 = std::max(window.u0, static_cast<int>(std::ceil(low - slack)));
    const int u1 = std::min(window.u1, static_cast<int>(std::floor(high + slack)));
    if (u0 > u1) continue;
    const std::size_t first = window.index(u0, j);
    for (int i = u0; i <= u1; ++i) {
      const double at = std::clamp(w[0] + along_u * (i - u[0]) + along_v * (j - v[0]), w_low, w_high);
      const std::size_t index = first + static_cast<std::size_t>(i - u0);
      window.entry[index] = std::min(window.entry[index], static_cast<float>(at));
      window.exit[index] = std::max(window.exit[index], static_cast<float>(at));
    }
  }
}

}  // namespace

void Sweep::fill(Window& window, const StockLattice& lattice) const {
  const int d = window.axis, ua = (d + 1) % 3, va = (d + 2) % 3;
  const double hu = lattice.spacing()[ua], hv = lattice.spacing()[va];
  for (const Stamp& stamp : stamps_) {
    const Zone& zone = stamp.zone;
    const Box box = box_of(zone, stamp.pose);
    const int low_u = std::max(window.u0, static_cast<int>(std::ceil(box.lower[ua] / hu)));
    const int high_u = std::min(window.u1, static_cast<int>(std::floor(box.upper[ua] / hu)));
    const int low_v = std::max(window.v0, static_cast<int>(std::ceil(box.lower[va] / hv)));
    const int high_v = std::min(window.v1, static_cast<int>(std::floor(box.upper[va] / hv)));
    if (low_u > high_u) continue;
    const bool ball = zone.shape == Zone::Shape::ball;
    const Vec3 centre = ball ? Vec3(stamp.pose.tip + zone.z0 * stamp.pose.axis) : stamp.pose.tip;
    // Seen along the lines, the zone lies in a strip about its axis.
    const double au = stamp.pose.axis[ua], av = stamp.pose.axis[va];
    const bool askew = !ball && std::abs(av) > 0.05;
    const double half = askew ? widest(zone) * std::hypot(au, av) / std::abs(av) : 0;
    for (int v = low_v; v <= high_v; ++v) {
      int u0 = low_u, u1 = high_u;
      if (askew) {
        const double middle = centre[ua] + au / av * (v * hv - centre[va]);
        u0 = std::max(u0, static_cast<int>(std::ceil(std::max((middle - half) / hu, -1e6))));
        u1 = std::min(u1, static_cast<int>(std::floor(std::min((middle + half) / hu, 1e8))));
        if (u0 > u1) continue;
      }
      const std::size_t index = window.index(u0, v);
      const Row row{u1 - u0 + 1, u0 * hu - centre[ua], hu, v * hv - centre[va], centre[d], au, av, stamp.pose.axis[d],
                    &window.entry[index], &window.exit[index]};
      switch (zone.shape) {
        case Zone::Shape::ball: ball_row(row, zone.r0); break;
        case Zone::Shape::ring: ring_row(row, zone); break;
        case Zone::Shape::frustum: frustum_row(row, zone); break;
      }
    }
  }
  for (const Strip& strip : strips_) {
    if (strip.box.upper[ua] < (window.u0 - 0.01) * hu || strip.box.lower[ua] > (window.u1 + 0.01) * hu) continue;
    if (strip.box.upper[va] < (window.v0 - 0.01) * hv || strip.box.lower[va] > (window.v1 + 0.01) * hv) continue;
    for (std::size_t i = strip.first; i < strip.last; ++i) fill_triangle(window, lattice, triangles_[i]);
  }
}

}  // namespace fieldfab::cam
