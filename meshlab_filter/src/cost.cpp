#include "cost.h"

#include <fmt/format.h>

#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "solids.h"

namespace fieldfab::meshlab {
namespace {
constexpr double bytes_a_place = 20;   // per sample: distances during computation, and the volume that keeps them
constexpr double bytes_a_cell = 1200;  // per cell that the surface passes
}  // namespace

std::string as_bytes(double bytes) {
  constexpr const char* units[] = {"bytes", "kB", "MB", "GB", "TB", "PB"};
  std::size_t unit = 0;
  for (; bytes >= 1000 && unit + 1 < std::size(units); ++unit) bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

double lattice_cost(const Box& bounds, double voxel) {
  return ((bounds.size().array() / voxel) + 6).prod() * bytes_a_place;
}

double surface_cost(double area, double voxel) { return area / (voxel * voxel) * bytes_a_cell; }

void require_surface(const Box& bounds, double voxel) {
  const Vec3 size = bounds.size();
  require(surface_cost(2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()), voxel), voxel, 2);
}

void require(double cost, double voxel, double power) {
  const double free = 0.9 * static_cast<double>(available_memory());
  if (cost <= free) return;
  throw Error(ErrorKind::too_large, "Voxel",
              fmt::format("{:.3g} mm would take about {} of memory and {} are free; {:.2g} mm would fit", voxel,
                          as_bytes(cost), as_bytes(free), 1.1 * voxel * std::pow(cost / free, 1 / power)));
}

}  // namespace fieldfab::meshlab
