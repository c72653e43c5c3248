#include "fieldfab/render/triangles.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "shade.h"
#include "to_image.h"
#include "triangle_raster.h"

namespace fieldfab {
namespace {

/// Faces that are inclined more than this to the mean normal of a corner meet there at an edge: cos
/// of 40 degrees.
constexpr double smooth = 0.766;

Vec3 normal_of(std::span<const Vec3> vertices, const std::array<std::uint32_t, 3>& t) {
  return (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
}

/// Returns the mean normal of the faces around each vertex, weighted by area.
std::vector<Vec3> normals_of_vertices(std::span<const Vec3> vertices,
                                      std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<Vec3> normals(vertices.size(), Vec3::Zero());
  for (const auto& t : triangles) {
    const Vec3 normal = normal_of(vertices, t);
    for (const std::uint32_t corner : t) normals[corner] += normal;
  }
  for (Vec3& n : normals) n.normalize();
  return normals;
}

/// Properties of the visible triangles by pixel.
struct Surface {
  Normals normals;
  std::vector<Eigen::Vector3f> materials;
};

Surface surface_of(const Triangles& triangles, std::span<const Vec3> vertices, const SeenTriangles& seen,
                   const PixelGrid& grid, Progress& progress) {
  Surface surface;
  surface.normals.assign(grid.count(), Eigen::Vector3f::UnitZ());
  if (!triangles.colours.empty()) surface.materials.assign(grid.count(), Eigen::Vector3f::Zero());
  const std::vector<Vec3> at_vertex = normals_of_vertices(vertices, triangles.triangles);
  parallel_for(static_cast<std::size_t>(grid.height), [&](std::size_t row) {
    progress.check();
    for (int column = 0; column < grid.width; ++column) {
      const std::size_t i = grid.index(column, static_cast<int>(row));
      if (seen.triangles[i] == SeenTriangles::none) continue;
      const auto& t = triangles.triangles[seen.triangles[i]];
      const auto shares = shares_at(vertices, t, grid.x(column), grid.y(static_cast<int>(row)));
      const Vec3 flat = normal_of(vertices, t).normalized();
      Vec3 normal = Vec3::Zero();
      for (std::size_t k = 0; k < 3; ++k)
        normal += std::clamp(shares[k], 0.0, 1.0) * (at_vertex[t[k]].dot(flat) > smooth ? at_vertex[t[k]] : flat);
      if (normal.z() < 0) normal = -normal;  // the inner side of an open surface
      surface.normals[i] = normal.normalized().cast<float>();
      if (surface.materials.empty()) continue;
      for (std::size_t k = 0; k < 3; ++k)
        for (int c = 0; c < 3; ++c) {
          const double screen = triangles.colours[t[k]][static_cast<std::size_t>(c)] / 255.0;
          surface.materials[i][c] += static_cast<float>(std::clamp(shares[k], 0.0, 1.0) * screen * screen);
        }
    }
  });
  return surface;
}

/// Returns the nearest height of each samples x samples pixels, for lookups in the finished image.
std::vector<float> nearest_heights(const PixelGrid& grid, const std::vector<float>& heights, int samples) {
  const PixelGrid small{grid.width / samples, grid.height / samples, grid.region};
  std::vector<float> out(small.count(), -std::numeric_limits<float>::infinity());
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column) {
      float& height = out[small.index(column / samples, row / samples)];
      height = std::max(height, heights[grid.index(column, row)]);
    }
  return out;
}

void check(const Triangles& triangles, const RenderSettings& settings) {
  const auto refuse = [](const char* what, const std::string& message) {
    throw Error(ErrorKind::bad_input, what, message);
  };
  if (settings.mode == RenderMode::bitmap)
    refuse("mode", "triangles have no bitmap; shaded, normals and height are possible");
  if (settings.samples < 1 || settings.samples > 4)
    refuse("samples", fmt::format("{} samples; from 1 to 4 are possible", settings.samples));
  if (!std::isfinite(settings.alpha) || !std::isfinite(settings.beta)) refuse("angle", "must be a finite number");
  if (settings.perspective != 0) refuse("perspective", "triangles are seen from infinitely far: it must be 0");
  if (!triangles.colours.empty() && triangles.colours.size() != triangles.vertices.size())
    refuse("colours", fmt::format("{} for {} vertices", triangles.colours.size(), triangles.vertices.size()));
  for (const auto& t : triangles.triangles)
    if (*std::max_element(t.begin(), t.end()) >= triangles.vertices.size())
      refuse("triangles", "one has a vertex that is not there");
}

}  // namespace

Vec3 TrianglePicture::on_picture(const Vec3& place) const {
  const Vec3 p = turn * place, size = image.bounds.size();
  return {(p.x() - image.bounds.lower.x()) / size.x() * image.width,
          (image.bounds.upper.y() - p.y()) / size.y() * image.height, p.z()};
}

bool TrianglePicture::shows(const Vec3& place, double slack) const {
  const Vec3 p = on_picture(place);
  if (!(p.x() >= 0 && p.y() >= 0 && p.x() < image.width && p.y() < image.height)) return false;
  const auto i =
      static_cast<std::size_t>(p.y()) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(p.x());
  return heights[i] <= p.z() + slack;
}

TrianglePicture render(const Triangles& triangles, const RenderSettings& settings, Progress& progress) {
  check(triangles, settings);
  TrianglePicture made;
  made.turn =
      (Eigen::AngleAxisd(settings.beta, Vec3::UnitX()) * Eigen::AngleAxisd(settings.alpha, Vec3::UnitZ())).matrix();
  std::vector<Vec3> vertices(triangles.vertices.size());
  Box region{Vec3::Constant(std::numeric_limits<double>::infinity()),
             Vec3::Constant(-std::numeric_limits<double>::infinity())};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& v = triangles.vertices[i];
    vertices[i] = made.turn * Vec3(v[0], v[1], v[2]);
    if (vertices[i].allFinite()) region = hull(region, {vertices[i], vertices[i]});
  }
  if (region.valid()) {
    constexpr double margin = 0.03;  // of the longer side
    region = region.grown(margin * region.size().head<2>().maxCoeff());
  } else if (settings.window) {
    region.lower.z() = region.upper.z() = 0;
  } else {
    throw Error(ErrorKind::bad_input, "triangles", "there are none to make a picture of");
  }
  if (settings.window) {
    region.lower.head<2>() = settings.window->lower.head<2>(),
    region.upper.head<2>() = settings.window->upper.head<2>();
    if (!region.valid()) throw Error(ErrorKind::bad_input, "window", "must be finite and have a positive size");
  }
  PixelGrid grid = PixelGrid::over(region, settings.size);
  const int samples = settings.mode == RenderMode::shaded ? settings.samples : 1;
  grid.width *= samples, grid.height *= samples;
  progress.report(0, "rendering");
  const SeenTriangles seen = rasterise_triangles(vertices, triangles.triangles, grid, progress);
  made.heights = nearest_heights(grid, seen.heights, samples);
  if (settings.mode == RenderMode::height) return made.image = height_map(grid, seen.heights), made;
  const Surface surface = surface_of(triangles, vertices, seen, grid, progress);
  made.image = settings.mode == RenderMode::normals
                   ? normal_map(grid, seen.heights, surface.normals)
                   : picture(grid, shade(grid, seen.heights, surface.normals, surface.materials, progress), samples);
  return made;
}

}  // namespace fieldfab
