// Solids, and solids made of flat shapes.
#include <cmath>
#include <numbers>

#include "shapes_common.h"

namespace fieldfab::frep::shapes {

using std::numbers::pi;

E sphere(const E& radius) { return length(x(), y(), z()) - radius; }

E ellipsoid(const E& rx, const E& ry, const E& rz) {
  return (length(x() / rx, y() / ry, z() / rz) - 1.0) * min(min(rx, ry), rz);
}

E box(const E& dx, const E& dy, const E& dz) {
  return max(max(abs(x()) - dx / 2.0, abs(y()) - dy / 2.0), abs(z()) - dz / 2.0);
}

E exact_box(const E& dx, const E& dy, const E& dz) { return rounded_box(dx, dy, dz, 0.0); }

E rounded_box(const E& dx, const E& dy, const E& dz, const E& radius) {
  const E a = abs(x()) - (dx / 2.0 - radius), b = abs(y()) - (dy / 2.0 - radius), c = abs(z()) - (dz / 2.0 - radius);
  return length(positive(a), positive(b), positive(c)) + min(max(max(a, b), c), 0.0) - radius;
}

E cylinder(const E& radius, const E& height) { return extrude(circle(radius), height, -height / 2.0); }

E exact_cylinder(const E& radius, const E& height) {
  const E a = length(x(), y()) - radius, b = abs(z()) - height / 2.0;
  return length(positive(a), positive(b)) + min(max(a, b), 0.0);
}

E cone(const E& radius, const E& height) {
  const E side = (length(x(), y()) * height + (z() - height / 2.0) * radius) / length(radius, height);
  return max(side, -(z() + height / 2.0));
}

E exact_cone(const E& radius, const E& height) {
  const E r = length(x(), y()), half = height / 2.0;
  const E side = segment_distance(r, z(), 0.0, half, radius, -half),
          base = segment_distance(r, z(), 0.0, -half, radius, -half);
  return with_sign_of(cone(radius, height), min(side, base));
}

E pyramid(const E& dx, const E& dy, const E& height) {
  const auto side = [&](const E& across, const E& half) {
    return (abs(across) * height + (z() - height / 2.0) * half) / length(half, height);
  };
  return max(max(side(x(), dx / 2.0), side(y(), dy / 2.0)), -(z() + height / 2.0));
}

E torus(const E& ring, const E& tube) { return length(length(x(), y()) - ring, z()) - tube; }

E capsule(const E& radius, const E& distance) {
  return length(x(), y(), z() - clamp(z(), -distance / 2.0, distance / 2.0)) - radius;
}

E half_space(const E& nx, const E& ny, const E& nz, const E& distance) {
  return (x() * nx + y() * ny + z() * nz) / length(nx, ny, nz) - distance;
}

E extrude(const E& shape, const E& height, const E& base) { return max(shape, max(base - z(), z() - (base + height))); }

E revolve(const E& shape) { return remap(shape, length(x(), y()), z(), 0.0); }

E loft(const E& a, const E& b, const E& height) { return extrude(morph(a, b, z() / height), height, 0.0); }

E gyroid(const E& period) {
  const E k = 2 * pi / period, a = x() * k, b = y() * k, c = z() * k;
  return (sin(a) * cos(b) + sin(b) * cos(c) + sin(c) * cos(a)) / (k * 1.5);
}

E schwarz_p(const E& period) {
  const E k = 2 * pi / period;
  return (cos(x() * k) + cos(y() * k) + cos(z() * k)) / (k * std::sqrt(3.0));
}

E diamond(const E& period) {
  const E k = 2 * pi / period, a = x() * k, b = y() * k, c = z() * k;
  return (sin(a) * sin(b) * sin(c) + sin(a) * cos(b) * cos(c) + cos(a) * sin(b) * cos(c) + cos(a) * cos(b) * sin(c)) /
         (k * 1.5);
}

namespace {

/// Distance from the middle of a cube of a lattice along an axis, from 0 to period / 2: its faces are mirrors.
E folded(const E& along, const E& period) { return abs(mod(along + period / 2.0, period) - period / 2.0); }

/// Distance to the line that is parallel to the direction (0, 1, 1) of three axes, at `away` along the first.
E to_diagonal(const E& away, const E& b, const E& c) { return sqrt(square(b - c) / 2.0 + square(away)); }

}  // namespace

E cubic_struts(const E& period) {
  const E h = period / 2.0, a = h - folded(x(), period), b = h - folded(y(), period), c = h - folded(z(), period);
  return min(min(length(a, b), length(b, c)), length(c, a));
}

E bcc_struts(const E& period) {
  const E a = folded(x(), period), b = folded(y(), period), c = folded(z(), period);
  return sqrt((square(a - b) + square(b - c) + square(c - a)) / 3.0);
}

E fcc_struts(const E& period) {
  const E h = period / 2.0, a = folded(x(), period), b = folded(y(), period), c = folded(z(), period);
  return min(min(to_diagonal(a - h, b, c), to_diagonal(b - h, c, a)), to_diagonal(c - h, a, b));
}

E octet_struts(const E& period) {
  const E h = period / 2.0, a = folded(x(), period), b = folded(y(), period), c = folded(z(), period);
  const E octahedron = min(min(to_diagonal(a, b, h - c), to_diagonal(b, c, h - a)), to_diagonal(c, a, h - b));
  return min(fcc_struts(period), octahedron);
}

E honeycomb_walls(const E& period) {
  // The middles of the hexagons are two rectangular lattices; walls are at x = +-period / 2 of each middle.
  const double sqrt3 = std::sqrt(3.0);
  const auto from_middle = [&](const E& u, const E& v) {
    const E a = folded(u, period), b = folded(v, period * sqrt3);
    return max(a, a / 2.0 + b * (sqrt3 / 2));
  };
  const E h = period / 2.0;
  return h - min(from_middle(x(), y()), from_middle(x() + h, y() + h * sqrt3));
}

E spinodal(const E& period) {
  constexpr int waves = 12;
  const double golden = (1 + std::sqrt(5.0)) / 2;
  E sum = 0.0;
  for (int i = 0; i < waves; ++i) {
    // Directions of a Fibonacci lattice on half of the sphere; phases by the golden section.
    const double height = (i + 0.5) / waves, turn = 2 * pi * i / golden, phase = 2 * pi * (i * i) / golden;
    const double across = std::sqrt(1 - height * height);
    const E along = x() * (across * std::cos(turn)) + y() * (across * std::sin(turn)) + z() * height;
    sum = sum + cos(along * (2 * pi / period) + phase);
  }
  // The mean slope of such a sum where it is 0, so that walls have about the thickness given.
  const double slope = std::sqrt(waves / 2.0) * std::sqrt(8 / (3 * pi));
  return sum * period / (2 * pi * slope);
}

E thread(const E& radius, const E& pitch, const E& height) {
  // ISO 68-1: flanks at 30 degrees, crests an eighth of the pitch wide, roots a quarter; so the
  // depth is 5/8 of the full triangle.
  const double tan30 = std::tan(pi / 6), cos30 = std::cos(pi / 6);
  const E r = length(x(), y());
  const E along = mod(z() - pitch * atan2(y(), x()) / (2 * pi), pitch) - pitch / 2.0;  // from the middle of the crest
  const E flank = (abs(along) - pitch / 16.0 - (radius - r) * tan30) * cos30;
  const E root = r - (radius - pitch * (0.625 * std::sqrt(3.0) / 2));
  return extrude(max(min(flank, root), r - radius), height, -height / 2.0);
}

}  // namespace fieldfab::frep::shapes
