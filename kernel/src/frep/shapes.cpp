#include "fieldfab/frep/shapes.h"

#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"

namespace fieldfab::frep::shapes {
namespace {

const double pi = std::numbers::pi;
E x() { return Expression::x(); }
E y() { return Expression::y(); }
E z() { return Expression::z(); }

E length(const E& a, const E& b) { return sqrt(square(a) + square(b)); }
E length(const E& a, const E& b, const E& c) { return sqrt(square(a) + square(b) + square(c)); }
E positive(const E& a) { return max(a, 0.0); }

}  // namespace

E sphere(const E& radius) { return length(x(), y(), z()) - radius; }

E box(const E& dx, const E& dy, const E& dz) { return max(max(abs(x()) - dx / 2.0, abs(y()) - dy / 2.0), abs(z()) - dz / 2.0); }

E rounded_box(const E& dx, const E& dy, const E& dz, const E& radius) {
  const E a = abs(x()) - (dx / 2.0 - radius), b = abs(y()) - (dy / 2.0 - radius), c = abs(z()) - (dz / 2.0 - radius);
  return length(positive(a), positive(b), positive(c)) + min(max(max(a, b), c), 0.0) - radius;
}

E cylinder(const E& radius, const E& height) { return extrude(circle(radius), -height / 2.0, height / 2.0); }

E cone(const E& radius, const E& height) {
  const E slant = length(radius, height);
  const E side = (length(x(), y()) * height + (z() - height / 2.0) * radius) / slant;
  return max(side, -(z() + height / 2.0));
}

E torus(const E& ring, const E& tube) { return length(length(x(), y()) - ring, z()) - tube; }

E capsule(const E& radius, const E& distance) {
  return length(x(), y(), z() - max(-distance / 2.0, min(distance / 2.0, z()))) - radius;
}

E half_space(const E& nx, const E& ny, const E& nz, const E& distance) {
  return (x() * nx + y() * ny + z() * nz) / length(nx, ny, nz) - distance;
}

E circle(const E& radius) { return length(x(), y()) - radius; }

E rectangle(const E& dx, const E& dy) { return max(abs(x()) - dx / 2.0, abs(y()) - dy / 2.0); }

E rounded_rectangle(const E& dx, const E& dy, const E& radius) {
  const E a = abs(x()) - (dx / 2.0 - radius), b = abs(y()) - (dy / 2.0 - radius);
  return length(positive(a), positive(b)) + min(max(a, b), 0.0) - radius;
}

E polygon(int sides, double radius) {
  if (sides < 3 || sides > 10000) throw Error(ErrorKind::bad_input, "polygon", "the number of sides must be from 3 to 10000");
  const double reach = radius * std::cos(pi / sides);
  E solid = x() - reach;
  for (int i = 1; i < sides; ++i) {
    const double angle = 2 * pi * i / sides;
    solid = max(solid, x() * std::cos(angle) + y() * std::sin(angle) - reach);
  }
  return solid;
}

E extrude(const E& shape, const E& low, const E& high) { return max(shape, max(low - z(), z() - high)); }

E revolve(const E& shape) { return remap(shape, length(x(), y()), z(), 0.0); }

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
  return (sin(a) * sin(b) * sin(c) + sin(a) * cos(b) * cos(c) + cos(a) * sin(b) * cos(c) + cos(a) * cos(b) * sin(c)) / (k * 1.5);
}

E unite(const E& a, const E& b) { return min(a, b); }
E intersect(const E& a, const E& b) { return max(a, b); }
E subtract(const E& a, const E& b) { return max(a, -b); }
E offset(const E& a, const E& distance) { return a - distance; }
E shell(const E& a, const E& thickness) { return max(a - thickness / 2.0, -thickness / 2.0 - a); }
E blend(const E& a, const E& b, const E& radius) { return min(min(a, b), sqrt(abs(a)) + sqrt(abs(b)) - sqrt(radius)); }

E smooth_unite(const E& a, const E& b, const E& radius) {
  return max(radius, min(a, b)) - length(positive(radius - a), positive(radius - b));
}

E morph(const E& a, const E& b, const E& weight) { return (1.0 - weight) * a + weight * b; }

E move(const E& a, const E& dx, const E& dy, const E& dz) { return remap(a, x() - dx, y() - dy, z() - dz); }

E rotate_x(const E& a, const E& angle) {
  return remap(a, x(), cos(angle) * y() + sin(angle) * z(), cos(angle) * z() - sin(angle) * y());
}
E rotate_y(const E& a, const E& angle) {
  return remap(a, cos(angle) * x() - sin(angle) * z(), y(), sin(angle) * x() + cos(angle) * z());
}
E rotate_z(const E& a, const E& angle) {
  return remap(a, cos(angle) * x() + sin(angle) * y(), cos(angle) * y() - sin(angle) * x(), z());
}

E scale(const E& a, const E& factor) { return remap(a, x() / factor, y() / factor, z() / factor) * factor; }
E scale_xyz(const E& a, const E& sx, const E& sy, const E& sz) { return remap(a, x() / sx, y() / sy, z() / sz); }
E mirror_x(const E& a) { return remap(a, -x(), y(), z()); }
E mirror_y(const E& a) { return remap(a, x(), -y(), z()); }
E mirror_z(const E& a) { return remap(a, x(), y(), -z()); }

E twist(const E& a, const E& angle) { return rotate_z(a, angle * z()); }

E taper(const E& a, const E& height, const E& factor) {
  const E size = 1.0 + (factor - 1.0) * z() / height;
  return remap(a, x() / size, y() / size, z());
}

E repeat_x(const E& a, const E& period) { return remap(a, mod(x() + period / 2.0, period) - period / 2.0, y(), z()); }
E repeat_y(const E& a, const E& period) { return remap(a, x(), mod(y() + period / 2.0, period) - period / 2.0, z()); }
E repeat_z(const E& a, const E& period) { return remap(a, x(), y(), mod(z() + period / 2.0, period) - period / 2.0); }

}  // namespace fieldfab::frep::shapes
