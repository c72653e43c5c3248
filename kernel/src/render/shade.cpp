#include "shade.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fieldfab/core/clones.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

/// Twelve directions around.
const auto compass = [] {
  std::array<std::array<float, 2>, 12> made;
  for (std::size_t d = 0; d < made.size(); ++d) {
    const float angle = 6.2831853F * (static_cast<float>(d) + 0.25F) / static_cast<float>(made.size());
    made[d] = {std::cos(angle), std::sin(angle)};
  }
  return made;
}();

/// The nearest integer; for distances in pixels.
int nearest(float value) { return static_cast<int>(value + 65536.5F) - 65536; }

/// A pixel's neighbour at a distance, and the part of a row that has it.
struct Neighbour {
  int dy, from, to, dx;
  Neighbour(const PixelGrid& grid, float x, float y) : dy(nearest(y)), from(0), to(0), dx(nearest(x)) {
    from = std::max(0, -dx), to = std::min(grid.width, grid.width - dx);
  }
  [[nodiscard]] bool has_row(const PixelGrid& grid, int row) const { return row + dy >= 0 && row + dy < grid.height; }
};

/// Raises the slopes to the horizon of a row's pixels to those of their neighbours, `run` mm away.
FIELDFAB_CLONES void raise_horizon(const float* here, const float* there, float* steepest, int count, float run,
                                   float weight) {
  for (int x = 0; x < count; ++x) {
    const float rise = (there[x] - here[x]) / run * weight;
    steepest[x] = steepest[x] < rise ? rise : steepest[x];
  }
}

/// Adds the visible fraction of the sky above each horizon.
FIELDFAB_CLONES void add_sky(const float* steepest, float* sum, int count) {
  for (int x = 0; x < count; ++x) sum[x] += 1 - steepest[x] / std::sqrt(1 + steepest[x] * steepest[x]);
}

/// Lowers the fractions of a light that reach a row's pixels to what their neighbours leave of it. `rise`: of the ray
/// on its way to the neighbour, mm.
FIELDFAB_CLONES void lower_light(const float* here, const float* there, float* open, int count, float rise,
                                 float softness, float run) {
  for (int x = 0; x < count; ++x) {
    const float clear = here[x] + rise - there[x];
    const float left = 0.5F + softness * clear / run;
    open[x] = left < open[x] ? left : open[x];
  }
}

/// Returns the visible fraction of the sky above each pixel, 0 to 1: from horizons in twelve
/// directions, found in the height map at growing distances.
std::vector<float> find_openness(const PixelGrid& grid, const std::vector<float>& heights, Progress& progress) {
  std::vector<float> openness(grid.count(), 1);
  const float pixel = static_cast<float>(grid.region.size().x() / grid.width);
  const int reach = std::max(4, std::max(grid.width, grid.height) / 12);
  parallel_for(static_cast<std::size_t>(grid.height), [&](std::size_t row) {
    progress.check();
    const int y = static_cast<int>(row);
    const float* const here = &heights[grid.index(0, y)];
    std::vector<float> sum(static_cast<std::size_t>(grid.width)), steepest(sum.size());
    for (const auto& [cx, cy] : compass) {
      std::ranges::fill(steepest, 0.0F);
      for (float distance = 1.5F; distance < static_cast<float>(reach); distance *= 1.5F) {
        const Neighbour other(grid, cx * distance, cy * distance);
        if (!other.has_row(grid, y) || other.from >= other.to) break;
        raise_horizon(here + other.from, &heights[grid.index(other.from + other.dx, y + other.dy)],
                      &steepest[static_cast<std::size_t>(other.from)], other.to - other.from, distance * pixel,
                      1 - distance / static_cast<float>(reach));
      }
      add_sky(steepest.data(), sum.data(), grid.width);
    }
    for (int x = 0; x < grid.width; ++x)
      if (std::isfinite(here[x]))
        openness[grid.index(x, y)] = sum[static_cast<std::size_t>(x)] / static_cast<float>(compass.size());
  });
  return openness;
}

/// Returns the fraction of a light from `direction` that reaches each pixel, 0 to 1. Shadows are
/// soft: points that are nearly hidden count as half hidden.
std::vector<float> find_light(const PixelGrid& grid, const std::vector<float>& heights,
                              const Eigen::Vector3f& direction, Progress& progress) {
  std::vector<float> light(grid.count(), 1);
  const float pixel = static_cast<float>(grid.region.size().x() / grid.width);
  const float along = direction.head<2>().norm(), dx = direction.x() / along, dy = -direction.y() / along;
  const float rise = direction.z() / along * pixel;  // per pixel of distance
  const float reach = static_cast<float>(std::max(grid.width, grid.height)) / 3;
  constexpr float softness = 12;  // full light if the clearance exceeds the length of the ray over this
  parallel_for(static_cast<std::size_t>(grid.height), [&](std::size_t row) {
    progress.check();
    const int y = static_cast<int>(row);
    const float* const here = &heights[grid.index(0, y)];
    std::vector<float> open(static_cast<std::size_t>(grid.width), 1.0F);
    for (float distance = 2; distance < reach; distance += 0.5F + 0.03F * distance) {
      const Neighbour other(grid, dx * distance, dy * distance);
      if (!other.has_row(grid, y) || other.from >= other.to) break;
      lower_light(here + other.from, &heights[grid.index(other.from + other.dx, y + other.dy)],
                  &open[static_cast<std::size_t>(other.from)], other.to - other.from, rise * distance, softness,
                  distance * pixel);
    }
    for (int x = 0; x < grid.width; ++x)
      if (std::isfinite(here[x])) light[grid.index(x, y)] = std::max(0.0F, open[static_cast<std::size_t>(x)]);
  });
  return light;
}

Eigen::Vector3f background(float down) {
  const Eigen::Vector3f colour =
      (1 - down) * Eigen::Vector3f(0.955F, 0.965F, 0.98F) + down * Eigen::Vector3f(0.82F, 0.85F, 0.89F);
  return colour.cwiseProduct(colour);
}

/// Whether the background is next to a pixel of the surface: a dark line there shows flat designs from above, whose
/// colour may be that of the background.
bool is_silhouette(const PixelGrid& grid, const std::vector<float>& heights, int x, int y) {
  const auto is_empty = [&](int u, int v) {
    return u >= 0 && v >= 0 && u < grid.width && v < grid.height && !std::isfinite(heights[grid.index(u, v)]);
  };
  return is_empty(x - 1, y) || is_empty(x + 1, y) || is_empty(x, y - 1) || is_empty(x, y + 1);
}

}  // namespace

std::vector<Eigen::Vector3f> shade(const PixelGrid& grid, const std::vector<float>& heights, const Normals& normals,
                                   const std::vector<Eigen::Vector3f>& materials, Progress& progress) {
  const Eigen::Vector3f key = Eigen::Vector3f(-0.45F, 0.55F, 0.75F).normalized(),
                        fill = Eigen::Vector3f(0.7F, -0.2F, 0.45F).normalized();
  const Eigen::Vector3f warm(1.0F, 0.96F, 0.90F), cool(0.62F, 0.74F, 1.0F), sky(0.78F, 0.86F, 1.0F);
  const std::vector<float> openness = find_openness(grid, heights, progress),
                           light = find_light(grid, heights, key, progress);
  std::vector<Eigen::Vector3f> colours(grid.count());
  parallel_for(static_cast<std::size_t>(grid.height), [&](std::size_t row) {
    for (int x = 0; x < grid.width; ++x) {
      const std::size_t i = grid.index(x, static_cast<int>(row));
      if (!std::isfinite(heights[i])) {
        colours[i] = background(static_cast<float>(row) / static_cast<float>(grid.height));
        continue;
      }
      const Eigen::Vector3f& n = normals[i];
      const float open = openness[i], lit = light[i] * std::max(0.0F, n.dot(key));
      const float shine = light[i] * std::pow(std::max(0.0F, (2 * n.dot(key) * n - key).z()), 24.0F);
      const float edge = std::max(0.0F, 1 - n.z()), rim = edge * edge * edge * std::max(0.0F, n.y());
      const Eigen::Vector3f& material = materials.empty() ? plain_material : materials[i];
      colours[i] =
          material.cwiseProduct(0.30F * open * (0.6F + 0.4F * n.z()) * sky + 0.74F * (0.5F + 0.5F * open) * lit * warm +
                                0.22F * std::max(0.0F, n.dot(fill)) * cool + 0.25F * rim * open * sky);
      colours[i] += Eigen::Vector3f::Constant(0.18F * shine * open);
      if (is_silhouette(grid, heights, x, static_cast<int>(row))) colours[i] *= 0.15F;
    }
  });
  return colours;
}

}  // namespace fieldfab
