#include "needs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace fieldfab::contouring {
namespace {

/// Distance along `direction` from `p` to the nearest change of side, at most `reach` mm.
std::optional<double> way_out(const Field& solid, const Vec3& p, const Vec3& direction, double reach) {
  const bool inside = solid.value(p) < 0;
  double near = 0;
  for (double far = reach / 256; far <= reach; far *= 2) {
    if ((solid.value(p + far * direction) < 0) == inside) {
      near = far;
      continue;
    }
    for (int i = 0; i < 12; ++i) {
      const double middle = 0.5 * (near + far);
      ((solid.value(p + middle * direction) < 0) == inside ? near : far) = middle;
    }
    return far;
  }
  return std::nullopt;
}

/// Thickness of the solid or of the gap, whichever is thinner, near the middle of a cell, mm.
std::optional<double> thickness_in(const Field& solid, const UncertainCell& cell) {
  const double reach = 2 * cell.side;
  Vec3 p = cell.box.centre();
  for (int step = 0; step < 8; ++step) {  // towards the surface
    const double value = solid.value(p);
    const Vec3 slope = solid.gradient(p);
    if (!std::isfinite(value) || !slope.allFinite() || !(slope.norm() > 0)) return std::nullopt;
    const Vec3 direction = slope.normalized();
    if (const auto through = way_out(solid, p, direction, reach), back = way_out(solid, p, -direction, reach);
        through && back)
      return *through + *back;
    const Vec3 way = -1.2 * value / slope.squaredNorm() * slope;
    p += way * std::min(1.0, cell.side / std::max(way.norm(), 1e-300));
  }
  return std::nullopt;
}

}  // namespace

void estimate_needs(const Field& solid, std::span<const UncertainCell> cells, Certainty& certainty) {
  constexpr std::size_t samples = 300;
  const std::size_t stride = cells.size() / samples + 1;
  std::vector<double> found;
  for (std::size_t i = 0; i < cells.size(); i += stride)
    if (const std::optional<double> thickness = thickness_in(solid, cells[i])) found.push_back(*thickness);
  if (found.empty()) return;
  // Most places are at least that thick; the few thinner ones are halved one by one.
  const auto thin = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 10);
  std::nth_element(found.begin(), thin, found.end());
  certainty.wanted_voxel = *thin / 2;
  // Two sheets. Each meets about 1.5 cells for each cell's area that it covers, and has about four
  // triangles for each smaller cell's area: two where it is flat and faces an axis, six where it is
  // bent.
  constexpr double per_area = 2 * 4 / 1.5;
  for (const UncertainCell& cell : cells)
    certainty.wanted_triangles += per_area * std::pow(cell.side / certainty.wanted_voxel, 2);
}

}  // namespace fieldfab::contouring
