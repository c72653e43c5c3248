// Solids, and solids made of flat shapes.
#include <cmath>
#include <numbers>

#include "shapes_common.h"

namespace fieldfab::frep::shapes {

const double pi = std::numbers::pi;

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
