#include "sweep.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/chords.h"
#include "zone_rows.h"

namespace fieldfab::cam {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Bounding box of a zone in a pose.
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

/// Number of chords of a circle such that each lies within `tolerance` of it.
int parts_of_circle(double radius, double tolerance) {
  if (radius <= tolerance) return 6;
  return std::clamp(static_cast<int>(std::ceil(2 * std::numbers::pi / chord_angle(radius, tolerance))), 12, 720);
}

/// Two unit vectors that form a right-handed basis with `axis`. They change little if the axis
/// changes little.
std::pair<Vec3, Vec3> across(const Vec3& axis, const Vec3& like) {
  const Vec3 one = (like - like.dot(axis) * axis).normalized();
  return {one, axis.cross(one)};
}

Vec3 any_across(const Vec3& axis) {
  int least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return axis.cross(Vec3::Unit(least)).normalized();
}

/// The surface that the grazing curves of a piece's section sweep between two poses, as strips of triangles.
class GrazingSurface {
 public:
  /// A point of the half section with its normal: distance from the axis, height, radial part, axial part.
  using SectionPoint = std::array<double, 4>;
  using Section = std::function<SectionPoint(double)>;
  using AddStrip = std::function<void(const std::vector<Vec3>&, const std::vector<Vec3>&)>;

  /// `parts`: number of pieces of the section's curve, at least; `sharpest`: its minimum radius of curvature, mm.
  GrazingSurface(const ToolPose& from, const ToolPose& to, Section section, int parts, double sharpest,
                 double tolerance, AddStrip add_strip)
      : from_(from),
        to_(to),
        section_(std::move(section)),
        parts_(parts),
        sharpest_(sharpest),
        tolerance_(tolerance),
        add_strip_(std::move(add_strip)) {}

  void add() { add_between(0, 1, 0); }

 private:
  /// The grazing points of one circle in one pose, on both sides, with their angles about the axis and their normals.
  struct Pair {
    std::array<double, 2> angles{};
    std::array<Vec3, 2> places, normals;
    bool closed = false;  ///< the circle has no grazing points
  };
  /// Those of one circle at two times.
  struct Grazing {
    double t = 0;
    std::array<Pair, 2> ends;
  };

  [[nodiscard]] ToolPose pose_at(double time) const {
    if (time <= 0 || time >= 1) return time <= 0 ? from_ : to_;
    return {from_.tip + time * motion_, (from_.axis + time * turning_).normalized()};
  }

  [[nodiscard]] Pair pair(const SectionPoint& point, const ToolPose& pose) const {
    const auto [distance, height, out, up] = point;
    const auto [one, other] = across(pose.axis, like_);
    const Vec3 swing = turning_ - turning_.dot(pose.axis) * pose.axis;
    // normal . velocity = p . (cos, sin) + q at the angle about the axis.
    const Vec3 p = out * motion_ + (height * out - distance * up) * swing;
    const double q = up * motion_.dot(pose.axis), x = p.dot(one), y = p.dot(other), length = std::hypot(x, y);
    const double middle = std::atan2(y, x), half = length > 0 ? std::acos(std::clamp(-q / length, -1.0, 1.0)) : 0;
    Pair result;
    result.closed = std::abs(q) > length;
    for (std::size_t side = 0; side < 2; ++side) {
      result.angles[side] = middle + (side ? half : -half);
      const Vec3 outwards = std::cos(result.angles[side]) * one + std::sin(result.angles[side]) * other;
      result.places[side] = pose.tip + height * pose.axis + distance * outwards;
      result.normals[side] = out * outwards + up * pose.axis;
    }
    return result;
  }

  [[nodiscard]] Grazing grazing(double t, const std::array<ToolPose, 2>& poses) const {
    const SectionPoint point = section_(t);
    return {t, {pair(point, poses[0]), pair(point, poses[1])}};
  }

  /// Extends a curve to a place, by smaller steps where it bends or the strip is twisted.
  void extend(std::vector<Grazing>& curve, const Grazing& to, const std::array<ToolPose, 2>& poses, int depth) const {
    const Grazing& back = curve.back();
    double turn = 0, twist = 0;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t end = 0; end < 2; ++end)
        turn = std::max(turn, std::abs(std::remainder(to.ends[end].angles[side] - back.ends[end].angles[side],
                                                      2 * std::numbers::pi)));
      const Vec3 ways =
          to.ends[1].places[side] - to.ends[0].places[side] - back.ends[1].places[side] + back.ends[0].places[side];
      twist = std::max(twist, std::abs(ways.dot(to.ends[0].normals[side])));
    }
    // Two triangles deviate from a twisted quadrilateral by a quarter of the twist.
    if ((turn > 0.1 || twist > 4 * tolerance_) && depth < 10) {
      const Grazing middle = grazing(0.5 * (curve.back().t + to.t), poses);
      extend(curve, middle, poses, depth + 1);
      extend(curve, to, poses, depth + 1);
      return;
    }
    curve.push_back(to);
  }

  /// Adds the strips between the grazing curves at two times, one on each side.
  void add_strips(const std::array<ToolPose, 2>& poses) const {
    std::vector<Grazing> curve{grazing(0, poses)};
    for (int i = 1; i <= parts_; ++i) extend(curve, grazing(static_cast<double>(i) / parts_, poses), poses, 0);
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<Vec3> start, end;
      for (const Grazing& g : curve) start.push_back(g.ends[0].places[side]), end.push_back(g.ends[1].places[side]);
      add_strip_(start, end);
    }
  }

  /// Height of the curve at mid-time above the strip between its ends. Points this near to the piece in its first or
  /// last pose are not above that pose either: a step along a surface of radius r leaves it by step^2 / 2 r.
  [[nodiscard]] double height_above_strip(double begin, double end) const {
    const double time = 0.5 * (begin + end), to_stamp = std::min(time, 1 - time);
    const std::array<ToolPose, 3> poses{pose_at(begin), pose_at(time), pose_at(end)};
    // A corner's curve may cover only a small part of its parameter range.
    const int samples = parts_ * (std::isfinite(sharpest_) ? 16 : 2);
    double most = 0;
    for (int i = 0; i <= samples; ++i) {
      const SectionPoint point = section_(static_cast<double>(i) / samples);
      const double step = to_stamp * (motion_.norm() + std::hypot(point[0], point[1]) * turning_.norm());
      if (step * step <= 2 * tolerance_ * std::min(point[0], sharpest_)) continue;
      const Pair middle = pair(point, poses[1]);
      if (middle.closed) continue;
      const Pair first = pair(point, poses[0]), last = pair(point, poses[2]);
      for (std::size_t side = 0; side < 2; ++side)
        most = std::max(most,
                        middle.normals[side].dot(middle.places[side] - 0.5 * (first.places[side] + last.places[side])));
    }
    return most;
  }

  void add_between(double begin, double end, int depth) const {
    const bool turns = turning_.squaredNorm() > 1e-24;
    if (turns && depth < 5 && height_above_strip(begin, end) > tolerance_) {
      const double middle = 0.5 * (begin + end);
      add_between(begin, middle, depth + 1);
      add_between(middle, end, depth + 1);
      return;
    }
    add_strips({pose_at(begin), pose_at(end)});
  }

  ToolPose from_, to_;
  Vec3 like_ = any_across(from_.axis), motion_ = to_.tip - from_.tip, turning_ = to_.axis - from_.axis;
  Section section_;
  int parts_;
  double sharpest_, tolerance_;
  AddStrip add_strip_;
};

}  // namespace

Sweep::Sweep(const ToolPiece& piece, const ToolPose& from, const ToolPose& to) : piece_(&piece), from_(from), to_(to) {
  double low = infinity, high = -infinity;
  bounds_ = box_of(piece.zones.front(), from);
  for (const Zone& zone : piece.zones) {
    low = std::min(low, zone.z0), high = std::max(high, zone.shape == Zone::Shape::frustum ? zone.z1 : zone.z0);
    radius_ = std::max(radius_, widest(zone));
    for (const ToolPose* pose : {&from_, &to_}) bounds_ = hull(bounds_, box_of(zone, *pose));
  }
  core_ = {from.tip + low * from.axis, from.tip + high * from.axis, to.tip + low * to.axis, to.tip + high * to.axis};
}

void Sweep::build(double tolerance, const Box& domain) {
  const ToolPose &from = from_, &to = to_;
  const bool turns = (to.axis - from.axis).squaredNorm() > 1e-24;
  const bool moves = turns || (to.tip - from.tip).squaredNorm() > 1e-24;
  double high = -infinity;
  for (const Zone& zone : piece_->zones) high = std::max(high, zone.shape == Zone::Shape::frustum ? zone.z1 : zone.z0);
  for (Zone zone : piece_->zones) {
    // A cylinder that ends outside of the domain and leads away from it may be infinite.
    if (!turns && zone.shape == Zone::Shape::frustum && zone.z1 == high && zone.r0 == zone.r1) {
      const Zone end{Zone::Shape::frustum, zone.z1, zone.z1, zone.r1, zone.r1, false, false};
      const Box top = hull(box_of(end, from), box_of(end, to));
      for (int axis = 0; axis < 3; ++axis)
        endless_ |= (top.lower[axis] > domain.upper[axis] && from.axis[axis] >= 0) ||
                    (top.upper[axis] < domain.lower[axis] && from.axis[axis] <= 0);
      if (endless_) zone.z1 += 4 * (domain.diagonal() + (from.tip - domain.centre()).norm()), zone.upper_edge = false;
    }
    stamps_.push_back({zone, from, false, Vec3::Zero()});
    if (moves) stamps_.push_back({zone, to, false, Vec3::Zero()});
    if (!moves) continue;
    if (zone.shape == Zone::Shape::ball) {
      // Cylinder of the capsule, from the first centre to the last.
      const Vec3 start = from.tip + zone.z0 * from.axis, way = to.tip + zone.z0 * to.axis - start;
      if (way.norm() > 1e-12)
        stamps_.push_back({{Zone::Shape::frustum, 0, way.norm(), zone.r0, zone.r0, false, false},
                           {start, way.normalized()},
                           false,
                           Vec3::Zero()});
      continue;
    }
    if (zone.shape == Zone::Shape::frustum) {
      if (zone.lower_edge) add_disc(zone.z0, zone.r0, tolerance);
      if (zone.upper_edge) add_disc(zone.z1, zone.r1, tolerance);
      const double length = std::hypot(zone.z1 - zone.z0, zone.r1 - zone.r0);
      add_grazing(
          [&](double t) -> SectionPoint {
            return {zone.r0 + t * (zone.r1 - zone.r0), zone.z0 + t * (zone.z1 - zone.z0), (zone.z1 - zone.z0) / length,
                    (zone.r0 - zone.r1) / length};
          },
          turns ? 4 : 1, infinity, tolerance);
    } else {
      add_disc(zone.z0 - zone.r1, zone.r0, tolerance);
      if (zone.z0 == high) add_disc(zone.z0 + zone.r1, zone.r0, tolerance);
      add_grazing(
          [&](double t) -> SectionPoint {
            const double angle = std::numbers::pi / 2 * t, c = std::sin(angle), sine = -std::cos(angle);
            return {zone.r0 + zone.r1 * c, zone.z0 + zone.r1 * sine, c, sine};
          },
          std::max(3, parts_of_circle(zone.r1, tolerance) / 4), zone.r1, tolerance);
    }
  }
}

void Sweep::add_strip(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  // Short runs with a bounding box each, so that fill() can skip most of them.
  constexpr std::size_t run = 8;
  for (std::size_t begin = 1; begin < from.size(); begin += run) {
    const std::size_t end = std::min(begin + run, from.size());
    Strip strip{triangles_.size(), 0, {from[begin - 1], from[begin - 1]}};
    for (std::size_t i = begin - 1; i < end; ++i)
      strip.box = hull(strip.box, {from[i].cwiseMin(to[i]), from[i].cwiseMax(to[i])});
    for (std::size_t i = begin; i < end; ++i) {
      triangles_.push_back({from[i - 1], from[i], to[i]});
      triangles_.push_back({from[i - 1], to[i], to[i - 1]});
    }
    strip.last = triangles_.size();
    strips_.push_back(strip);
  }
}

namespace {

/// Distance from a point to a triangle, which may be degenerate.
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
  const bool inside = (b - a).cross(q - a).dot(normal) >= 0 && (c - b).cross(q - b).dot(normal) >= 0 &&
                      (a - c).cross(q - c).dot(normal) >= 0;
  return inside ? (p - q).norm() : edges;
}

}  // namespace

bool Sweep::near(const Vec3& place, double distance) const {
  const double reach = distance + radius_;
  return distance_from_triangle(place, core_[0], core_[1], core_[2]) <= reach ||
         distance_from_triangle(place, core_[1], core_[2], core_[3]) <= reach;
}

/// Adds the swept surface of a flat end and of its edge.
void Sweep::add_disc(double height, double radius, double tolerance) {
  if (radius <= 0) return;
  if ((to_.axis - from_.axis).squaredNorm() <= 1e-24) {
    stamps_.push_back(
        {{Zone::Shape::frustum, height, height, radius, radius, false, false}, from_, true, to_.tip - from_.tip});
    return;
  }
  const int parts = parts_of_circle(radius, tolerance);
  const Vec3 like = any_across(from_.axis);
  const auto circle = [&](const ToolPose& pose) {
    const auto [one, other] = across(pose.axis, like);
    const Vec3 middle = pose.tip + height * pose.axis;
    // Each point is the previous one, rotated.
    const double angle = 2 * std::numbers::pi / parts, c = std::cos(angle), s = std::sin(angle);
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(parts) + 1);
    double x = radius, y = 0;
    for (int i = 0; i < parts; ++i) {
      points.emplace_back(middle + x * one + y * other);
      const double turned = c * x - s * y;
      y = s * x + c * y, x = turned;
    }
    points.push_back(points.front());
    return points;
  };
  add_strip(circle(from_), circle(to_));
}

/// Adds both grazing curves along a part of the half section, which is a function of a parameter
/// from 0 to 1: at each height, the points round the axis with a normal perpendicular to the
/// motion. A circle without such points contributes its point nearest to that condition: there the
/// curve closes. More than `parts` points are used near closed ends, where the curves turn quickly
/// round the axis, and where the swept strip is twisted.
void Sweep::add_grazing(const std::function<SectionPoint(double)>& section, int parts, double sharpest,
                        double tolerance) {
  GrazingSurface(from_, to_, section, parts, sharpest, tolerance, [&](const auto& start, const auto& end) {
    add_strip(start, end);
  }).add();
}

namespace {

/// Extends the intervals of the lines that intersect a triangle.
void fill_triangle(Window& window, const StockLattice& lattice, const std::array<Vec3, 3>& triangle) {
  const int d = window.axis, ua = (d + 1) % 3, va = (d + 2) % 3;
  const double inverse_u = 1 / lattice.spacing()[ua], inverse_v = 1 / lattice.spacing()[va];
  std::array<double, 3> u, v, w;
  for (std::size_t i = 0; i < 3; ++i)
    u[i] = triangle[i][ua] * inverse_u, v[i] = triangle[i][va] * inverse_v, w[i] = triangle[i][d];
  constexpr double slack = 1e-7;  // in cells, so that a line through an edge counts as an intersection
  const double v_low = std::min({v[0], v[1], v[2]}), v_high = std::max({v[0], v[1], v[2]});
  const int v0 = std::max(window.v0, static_cast<int>(std::ceil(v_low - slack)));
  const int v1 = std::min(window.v1, static_cast<int>(std::floor(v_high + slack)));
  if (v0 > v1 || std::max({u[0], u[1], u[2]}) < window.u0 - slack || std::min({u[0], u[1], u[2]}) > window.u1 + slack)
    return;
  const double area = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]);
  const double w_low = std::min({w[0], w[1], w[2]}), w_high = std::max({w[0], w[1], w[2]});
  double along_u = 0, along_v = 0;
  if (std::abs(area) > 1e-12) {
    along_u = ((w[1] - w[0]) * (v[2] - v[0]) - (w[2] - w[0]) * (v[1] - v[0])) / area;
    along_v = ((u[1] - u[0]) * (w[2] - w[0]) - (u[2] - u[0]) * (w[1] - w[0])) / area;
  } else if (w_high - w_low > 1e-9) {
    return;  // edge-on: its neighbours bound the same interval
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
    fill_row(&window.entry[first], &window.exit[first], u1 - u0 + 1,
             static_cast<float>(w[0] + along_u * (u0 - u[0]) + along_v * (j - v[0])), static_cast<float>(along_u),
             static_cast<float>(w_low), static_cast<float>(w_high));
  }
}

}  // namespace

void Sweep::fill(Window& window, const StockLattice& lattice) const {
  const int d = window.axis, ua = (d + 1) % 3, va = (d + 2) % 3;
  const double hu = lattice.spacing()[ua], hv = lattice.spacing()[va];
  for (const Stamp& stamp : stamps_) {
    const Zone& zone = stamp.zone;
    Box box = box_of(zone, stamp.pose);
    if (stamp.disc) box = hull(box, {box.lower + stamp.way, box.upper + stamp.way});
    const int low_u = std::max(window.u0, static_cast<int>(std::ceil(box.lower[ua] / hu)));
    const int high_u = std::min(window.u1, static_cast<int>(std::floor(box.upper[ua] / hu)));
    const int low_v = std::max(window.v0, static_cast<int>(std::ceil(box.lower[va] / hv)));
    const int high_v = std::min(window.v1, static_cast<int>(std::floor(box.upper[va] / hv)));
    if (low_u > high_u) continue;
    const bool ball = zone.shape == Zone::Shape::ball;
    const Vec3 centre = ball || stamp.disc ? Vec3(stamp.pose.tip + zone.z0 * stamp.pose.axis) : stamp.pose.tip;
    const double au = stamp.pose.axis[ua], av = stamp.pose.axis[va], ad = stamp.pose.axis[d];
    const bool level_way = stamp.disc && std::abs(stamp.way.dot(stamp.pose.axis)) < 1e-9 * (1 + stamp.way.norm());
    if (level_way && std::abs(ad) < 1e-9) continue;
    // Seen along the lines, a zone lies in a strip about its axis, and the volume swept by a disc
    // in a strip about its path.
    const double strip_u = stamp.disc ? stamp.way[ua] : au, strip_v = stamp.disc ? stamp.way[va] : av;
    const double strip = std::hypot(strip_u, strip_v);
    const bool askew = !ball && strip > 0 && std::abs(strip_v) > 0.05 * strip;
    const double half = askew ? widest(zone) * strip / std::abs(strip_v) : 0;
    for (int v = low_v; v <= high_v; ++v) {
      int u0 = low_u, u1 = high_u;
      if (askew) {
        const double middle = centre[ua] + strip_u / strip_v * (v * hv - centre[va]);
        u0 = std::max(u0, static_cast<int>(std::ceil(std::max((middle - half) / hu, -1e6))));
        u1 = std::min(u1, static_cast<int>(std::floor(std::min((middle + half) / hu, 1e8))));
        if (u0 > u1) continue;
      }
      const std::size_t index = window.index(u0, v);
      const Row row{u1 - u0 + 1,          u0 * hu - centre[ua], hu, v * hv - centre[va], centre[d], au, av, ad,
                    &window.entry[index], &window.exit[index]};
      if (stamp.disc) {
        disc_row(row, zone.r0, stamp.way[ua], stamp.way[va], stamp.way[d]);
      } else if (ball) {
        ball_row(row, zone.r0);
      } else {
        (zone.shape == Zone::Shape::frustum ? frustum_row : ring_row)(row, zone);
      }
    }
  }
  for (const Strip& strip : strips_) {
    if (strip.box.upper[ua] < (window.u0 - 0.01) * hu || strip.box.lower[ua] > (window.u1 + 0.01) * hu) continue;
    if (strip.box.upper[va] < (window.v0 - 0.01) * hv || strip.box.lower[va] > (window.v1 + 0.01) * hv) continue;
    for (std::size_t i = strip.first; i < strip.last; ++i) fill_triangle(window, lattice, triangles_[i]);
  }
  // Lines parallel to an infinite piece never leave it.
  if (endless_ && from_.axis[d] > 1 - 1e-12 && to_.axis[d] > 1 - 1e-12)
    for (std::size_t i = 0; i < window.entry.size(); ++i)
      if (window.entry[i] <= window.exit[i]) window.exit[i] = std::numeric_limits<float>::infinity();
}

}  // namespace fieldfab::cam
