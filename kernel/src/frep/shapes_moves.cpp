// Set operations, and shapes that are moved, bent and repeated.
#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"
#include "shapes_common.h"

namespace fieldfab::frep::shapes {
namespace {

const double root_half = std::sqrt(0.5);

/// Scales the surroundings of a point by `factor` around it.
E about_point(const E& a, const E& px, const E& py, const E& pz, const E& factor) {
  return remap(a, px + (x() - px) * factor, py + (y() - py) * factor, pz + (z() - pz) * factor);
}

E fading(const E& px, const E& py, const E& pz, const E& reach) {
  return exp(-length(x() - px, y() - py, z() - pz) / reach);
}

void require_count(int count, const char* where) {
  if (count < 1 || count > 10000)
    throw Error(ErrorKind::bad_input, where, "the number of copies must be from 1 to 10000");
}

/// Union of copies first ... first + count - 1, as a balanced tree, so that pruning removes halves.
template <class Copy>
E united(int first, int count, const Copy& copy) {
  if (count == 1) return copy(first);
  return min(united(first, count / 2, copy), united(first + count / 2, count - count / 2, copy));
}

}  // namespace

E unite(const E& a, const E& b) { return min(a, b); }
E intersect(const E& a, const E& b) { return max(a, b); }
E subtract(const E& a, const E& b) { return max(a, -b); }
E offset(const E& a, const E& distance) { return a - distance; }
E shell(const E& a, const E& thickness) { return max(a - thickness / 2.0, -thickness / 2.0 - a); }
E clearance(const E& a, const E& b, const E& gap) { return max(a, gap - b); }
E blend(const E& a, const E& b, const E& radius) { return min(min(a, b), sqrt(abs(a)) + sqrt(abs(b)) - sqrt(radius)); }

E smooth_unite(const E& a, const E& b, const E& radius) {
  return max(radius, min(a, b)) - length(positive(radius - a), positive(radius - b));
}
E smooth_intersect(const E& a, const E& b, const E& radius) { return -smooth_unite(-a, -b, radius); }
E smooth_subtract(const E& a, const E& b, const E& radius) { return -smooth_unite(-a, b, radius); }

E chamfer_unite(const E& a, const E& b, const E& size) { return min(min(a, b), (a + b - size) * root_half); }
E chamfer_intersect(const E& a, const E& b, const E& size) { return max(max(a, b), (a + b + size) * root_half); }
E chamfer_subtract(const E& a, const E& b, const E& size) { return chamfer_intersect(a, -b, size); }

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
E symmetric_x(const E& a) { return remap(a, abs(x()), y(), z()); }
E symmetric_y(const E& a) { return remap(a, x(), abs(y()), z()); }
E symmetric_z(const E& a) { return remap(a, x(), y(), abs(z())); }
E shear_x_y(const E& a, const E& slope) { return remap(a, x() - slope * y(), y(), z()); }
E shear_x_z(const E& a, const E& slope) { return remap(a, x() - slope * z(), y(), z()); }

E twist(const E& a, const E& angle) { return rotate_z(a, angle * z()); }

E taper(const E& a, const E& height, const E& factor) {
  const E size = 1.0 + (factor - 1.0) * z() / height;
  return remap(a, x() / size, y() / size, z());
}

E bend(const E& a, const E& radius) {
  const E up = radius - z();
  return remap(a, radius * atan2(x(), up), y(), radius - length(x(), up));
}

E attract(const E& a, const E& px, const E& py, const E& pz, const E& reach) {
  return about_point(a, px, py, pz, 1.0 + fading(px, py, pz, reach));
}
E repel(const E& a, const E& px, const E& py, const E& pz, const E& reach) {
  return about_point(a, px, py, pz, 1.0 - fading(px, py, pz, reach));
}

E repeat_x(const E& a, const E& period) { return remap(a, mod(x() + period / 2.0, period) - period / 2.0, y(), z()); }
E repeat_y(const E& a, const E& period) { return remap(a, x(), mod(y() + period / 2.0, period) - period / 2.0, z()); }
E repeat_z(const E& a, const E& period) { return remap(a, x(), y(), mod(z() + period / 2.0, period) - period / 2.0); }

E array_x(const E& a, int count, const E& dx) { return array_xy(a, count, 1, dx, 0.0); }

E array_xy(const E& a, int columns, int rows, const E& dx, const E& dy) {
  require_count(columns, "array");
  require_count(rows, "array");
  return united(0, rows, [&](int row) {
    return united(0, columns, [&](int column) {
      return move(a, static_cast<double>(column) * dx, static_cast<double>(row) * dy, 0.0);
    });
  });
}

E array_polar(const E& a, int count) {
  require_count(count, "array_polar");
  return united(0, count, [&](int i) { return rotate_z(a, 2 * std::numbers::pi * i / count); });
}

}  // namespace fieldfab::frep::shapes
