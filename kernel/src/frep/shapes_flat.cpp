// Flat shapes: to be cut, engraved, extruded or rotated.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "fieldfab/core/error.h"
#include "shapes_common.h"

namespace fieldfab::frep::shapes {
namespace {

using std::numbers::pi;

struct Point {
  double x, y;
};

/// Twice the signed area of a triangle, positive if it is counterclockwise.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// Half plane to the left of the line from a to b.
E left_of(const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, long_ = std::hypot(dx, dy);
  return (x() - a.x) * (dy / long_) - (y() - a.y) * (dx / long_);
}

/// Indices of the corners of the convex hull, counterclockwise (Andrew's monotone chain).
std::vector<std::size_t> hull_of(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(points[a].x, points[a].y) < std::pair(points[b].x, points[b].y);
  });
  std::vector<std::size_t> hull;
  const auto chain = [&](auto first, auto last) {
    const std::size_t base = hull.size();
    for (auto i = first; i != last; ++i) {
      while (hull.size() > base + 1 && turn(points[hull[hull.size() - 2]], points[hull.back()], points[*i]) <= 0)
        hull.pop_back();
      hull.push_back(*i);
    }
    hull.pop_back();
  };
  chain(order.begin(), order.end());
  chain(order.rbegin(), order.rend());
  return hull;
}

/// A counterclockwise polygon: its convex hull minus its pockets, which are polygons in turn.
E simple_polygon(const std::vector<Point>& points, int depth) {
  if (depth > 100) throw Error(ErrorKind::bad_input, "outline", "the polygon is too ragged, or crosses itself");
  const std::vector<std::size_t> hull = hull_of(points);
  if (hull.size() < 3) throw Error(ErrorKind::bad_input, "outline", "the points lie on a line");
  E solid = left_of(points[hull.back()], points[hull[0]]);
  for (std::size_t i = 0; i + 1 < hull.size(); ++i) solid = max(solid, left_of(points[hull[i]], points[hull[i + 1]]));
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const std::size_t from = hull[i], to = hull[(i + 1) % hull.size()];
    std::vector<Point> pocket;  // clockwise along the polygon; the hull's edge closes it
    for (std::size_t k = from; k != to; k = (k + 1) % points.size()) pocket.push_back(points[k]);
    pocket.push_back(points[to]);
    if (pocket.size() < 3) continue;
    std::reverse(pocket.begin(), pocket.end());
    if (std::all_of(pocket.begin(), pocket.end(),
                    [&](const Point& p) { return turn(pocket.front(), pocket.back(), p) == 0; }))
      continue;
    solid = max(solid, -simple_polygon(pocket, depth + 1));
  }
  return solid;
}

}  // namespace

E segment_distance(const E& px, const E& py, const E& ax, const E& ay, const E& bx, const E& by) {
  const E dx = bx - ax, dy = by - ay;
  const E along = clamp(((px - ax) * dx + (py - ay) * dy) / (square(dx) + square(dy)), 0.0, 1.0);
  return length(px - ax - along * dx, py - ay - along * dy);
}

E circle(const E& radius) { return length(x(), y()) - radius; }

E rectangle(const E& dx, const E& dy) { return max(abs(x()) - dx / 2.0, abs(y()) - dy / 2.0); }

E exact_rectangle(const E& dx, const E& dy) { return rounded_rectangle(dx, dy, 0.0); }

E rounded_rectangle(const E& dx, const E& dy, const E& radius) {
  const E a = abs(x()) - (dx / 2.0 - radius), b = abs(y()) - (dy / 2.0 - radius);
  return length(positive(a), positive(b)) + min(max(a, b), 0.0) - radius;
}

E triangle(const E& x0, const E& y0, const E& x1, const E& y1, const E& x2, const E& y2) {
  const auto right_of = [](const E& ax, const E& ay, const E& bx, const E& by) {
    return ((y() - ay) * (bx - ax) - (x() - ax) * (by - ay)) / length(bx - ax, by - ay);
  };
  const E a = right_of(x0, y0, x1, y1), b = right_of(x1, y1, x2, y2), c = right_of(x2, y2, x0, y0);
  return min(max(max(a, b), c), max(max(-a, -b), -c));  // one orientation gives the triangle, the other is empty
}

E polygon(int sides, double radius) {
  if (sides < 3 || sides > 10000)
    throw Error(ErrorKind::bad_input, "polygon", "the number of sides must be from 3 to 10000");
  const double reach = radius * std::cos(pi / sides);
  E solid = x() - reach;
  for (int i = 1; i < sides; ++i) {
    const double angle = 2 * pi * i / sides;
    solid = max(solid, x() * std::cos(angle) + y() * std::sin(angle) - reach);
  }
  return solid;
}

E outline(std::span<const double> coordinates) {
  if (coordinates.size() % 2 != 0 || coordinates.size() < 6)
    throw Error(ErrorKind::bad_input, "outline", "takes at least three points, each with its x and y");
  std::vector<Point> points;
  for (std::size_t i = 0; i < coordinates.size(); i += 2)
    if (const Point p{coordinates[i], coordinates[i + 1]};
        points.empty() || p.x != points.back().x || p.y != points.back().y)
      points.push_back(p);
  if (points.front().x == points.back().x && points.front().y == points.back().y) points.pop_back();
  double area = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) area += turn(points[0], points[i], points[i + 1]);
  if (area < 0) std::reverse(points.begin(), points.end());
  return simple_polygon(points, 0);
}

E stroke(const E& x0, const E& y0, const E& x1, const E& y1, const E& width) {
  return segment_distance(x(), y(), x0, y0, x1, y1) - width / 2.0;
}

E tab(const E& width, const E& height) { return max(abs(x()) - width / 2.0, max(-y(), y() - height)); }

E slot(const E& width, const E& depth, const E& chamfer) {
  const E mouth = (abs(x()) - y() - width / 2.0 - chamfer) / std::sqrt(2.0);
  return max(min(max(abs(x()) - width / 2.0, -y() - depth), max(mouth, -y() - chamfer)), y());
}

E gear(int teeth, double module, double pressure_angle, double backlash) {
  if (teeth < 3 || teeth > 10000)
    throw Error(ErrorKind::bad_input, "gear", "the number of teeth must be from 3 to 10000");
  if (!(module > 0)) throw Error(ErrorKind::bad_input, "gear", "the module must be above 0 mm");
  if (!(pressure_angle > 0 && pressure_angle < 1.2))
    throw Error(ErrorKind::bad_input, "gear", "the pressure angle must be above 0 and below 68 degrees");
  const double pitch = module * teeth / 2, base = pitch * std::cos(pressure_angle);
  const double involute = std::tan(pressure_angle) - pressure_angle;
  const double half_tooth = (pi * module / 2 - backlash) / (2 * pitch) + involute;  // at the base circle, as an angle
  const E r = length(x(), y());
  const E angle = mod(atan2(y(), x()) + pi / teeth, 2 * pi / teeth) - pi / teeth;
  // The string of the involute: its length over the base radius minus the angle of its winding.
  // Distances between involutes of one circle are angles times its radius; inside the circle flanks
  // are straight. The last factor makes the value a bound on both sides.
  const E wound = sqrt(positive(square(r / base) - 1.0));
  const E flank = (abs(angle) - half_tooth + wound - atan(wound)) * min(r, base) / std::hypot(1, pi / teeth);
  return min(max(flank, r - (pitch + module)), r - (pitch - 1.25 * module));
}

E trace(std::span<const double> c, double width) {
  if (c.size() % 2 != 0 || c.size() < 4)
    throw Error(ErrorKind::bad_input, "trace", "takes at least two points, each with its x and y");
  E copper = stroke(c[0], c[1], c[2], c[3], width);
  for (std::size_t i = 2; i + 3 < c.size(); i += 2)
    copper = min(copper, stroke(c[i], c[i + 1], c[i + 2], c[i + 3], width));
  return copper;
}

E footprint_chip(double pad_dx, double pad_dy, double span) {
  return symmetric_x(move(rectangle(pad_dx, pad_dy), span / 2, 0.0, 0.0));
}

E footprint_soic(int pins, double pitch, double span, double pad_dx, double pad_dy) {
  if (pins < 2 || pins > 1000 || pins % 2 != 0)
    throw Error(ErrorKind::bad_input, "footprint_soic", "the number of pins must be even, from 2 to 1000");
  const int rows = pins / 2;
  return symmetric_x(
      array_xy(move(rectangle(pad_dx, pad_dy), span / 2, -pitch * (rows - 1) / 2, 0.0), 1, rows, 0.0, pitch));
}

E footprint_header(int columns, int rows, double pitch, double pad) {
  return array_xy(move(circle(pad / 2), -pitch * (columns - 1) / 2, -pitch * (rows - 1) / 2, 0.0), columns, rows, pitch,
                  pitch);
}

}  // namespace fieldfab::frep::shapes
