#include "mesh_heights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fieldfab/mesh/mesh_field.h"

namespace fieldfab::cam {
namespace {

struct Range {
  int first, last;
};
/// Range of the `count` positions origin + i * step within [low, high].
Range places(double low, double high, double origin, double step, int count) {
  return {std::max(0, static_cast<int>(std::ceil((low - origin) / step - 1e-9))),
          std::min(count - 1, static_cast<int>(std::floor((high - origin) / step + 1e-9)))};
}

}  // namespace

template <class Visit>
void MeshHeights::each_bin(const Rectangle& box, const Visit& visit) const {
  const auto bin = [&](double at, double origin, int count) {
    return static_cast<int>(std::clamp(std::floor((at - origin) / bins_.cell), 0.0, count - 1.0));
  };
  for (int row = bin(box.lower.y(), bins_.origin.y(), bins_.height);
       row <= bin(box.upper.y(), bins_.origin.y(), bins_.height); ++row)
    for (int column = bin(box.lower.x(), bins_.origin.x(), bins_.width);
         column <= bin(box.upper.x(), bins_.origin.x(), bins_.width); ++column)
      visit(bins_.index(column, row));
}

std::unique_ptr<MeshHeights> MeshHeights::of(const Field& field, const Rectangle& area) {
  const Framed framed = field.framed(Purpose::occupancy);
  const TriangleMesh* const mesh = closed_mesh_of(*framed.field);
  if (mesh == nullptr) return nullptr;
  auto made = std::make_unique<MeshHeights>();
  std::vector<Vec3> vertices;
  vertices.reserve(mesh->vertices.size());
  for (const auto& v : mesh->vertices) vertices.emplace_back(framed.origin + framed.axes * Vec3(v[0], v[1], v[2]));
  for (const auto& t : mesh->triangles) {
    const Triangle triangle{vertices[t[0]], vertices[t[1]], vertices[t[2]]};
    const Vec2 a = (triangle[1] - triangle[0]).head<2>(), b = (triangle[2] - triangle[0]).head<2>();
    if (a.x() * b.y() - a.y() * b.x() != 0) made->triangles_.push_back(triangle);
  }
  // About as many bins as triangles.
  const double cell = std::max(std::sqrt(area.size().prod() / static_cast<double>(made->triangles_.size() + 1)), 1e-9);
  made->bins_ = Lattice<std::uint32_t>(std::min(4096, static_cast<int>(area.size().x() / cell) + 1),
                                       std::min(4096, static_cast<int>(area.size().y() / cell) + 1), 0, area.lower, 0);
  made->bins_.cell = std::max(area.size().x() / made->bins_.width, area.size().y() / made->bins_.height);
  // Counting sort.
  made->starts_.assign(made->bins_.values.size() + 1, 0);
  for (int round = 0; round < 2; ++round) {
    for (std::size_t k = 0; k < made->triangles_.size(); ++k) {
      Rectangle box = Rectangle::nothing();
      for (const Vec3& v : made->triangles_[k]) box.add(v.head<2>());
      made->each_bin(box, [&](std::size_t bin) {
        if (round == 0)
          ++made->starts_[bin + 1];
        else
          made->members_[made->bins_.values[bin]++] = static_cast<std::uint32_t>(k);
      });
    }
    if (round > 0) break;
    for (std::size_t i = 1; i < made->starts_.size(); ++i) made->starts_[i] += made->starts_[i - 1];
    made->members_.resize(made->starts_.back());
    std::copy(made->starts_.begin(), made->starts_.end() - 1, made->bins_.values.begin());
  }
  return made;
}

double MeshHeights::highest(const Rectangle& square) const {
  double highest = -std::numeric_limits<double>::infinity();
  each_bin(square, [&](std::size_t bin) {
    for (std::uint32_t m = starts_[bin]; m < starts_[bin + 1]; ++m) {
      const Triangle& t = triangles_[members_[m]];
      if (std::max({t[0].z(), t[1].z(), t[2].z()}) <= highest) continue;
      // The triangle clipped to the square: the extremum is at a corner.
      std::vector<Vec3> corners(t.begin(), t.end());
      for (int side = 0; side < 4 && !corners.empty(); ++side) {
        const int axis = side / 2;
        const double sign = side % 2 == 0 ? 1 : -1, limit = side % 2 == 0 ? square.lower[axis] : square.upper[axis];
        std::vector<Vec3> kept;
        for (std::size_t i = 0; i < corners.size(); ++i) {
          const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
          const double from = sign * (a[axis] - limit), to = sign * (b[axis] - limit);
          if (from >= 0) kept.push_back(a);
          if ((from > 0 && to < 0) || (from < 0 && to > 0)) kept.push_back(a + (b - a) * from / (from - to));
        }
        corners = std::move(kept);
      }
      for (const Vec3& corner : corners) highest = std::max(highest, corner.z());
    }
  });
  return highest;
}

std::vector<float> MeshHeights::heights(const Rectangle& area, int wide, int high, double low) const {
  std::vector<float> found(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), static_cast<float>(low));
  const Vec2 step(area.size().x() / (wide - 1), area.size().y() / (high - 1));
  each_bin(area, [&](std::size_t bin) {
    for (std::uint32_t m = starts_[bin]; m < starts_[bin + 1]; ++m) {
      const Triangle& t = triangles_[members_[m]];
      // Plane of the triangle, and the signs of its edge functions.
      const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
      const double turn = normal.z() > 0 ? 1 : -1;
      const auto [lowest, highest] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
      const Range rows = places(lowest, highest, area.lower.y(), step.y(), high);
      for (int row = rows.first; row <= rows.last; ++row) {
        // Interval of the row inside of the triangle.
        const double y = area.lower.y() + row * step.y();
        double from = -1e300, to = 1e300;
        for (int e = 0; e < 3; ++e) {
          const Vec3 &a = t[static_cast<std::size_t>(e)], &b = t[static_cast<std::size_t>((e + 1) % 3)];
          // turn * ((b - a) x (p - a)) >= 0, with a tolerance so that no sample is lost between two
          // triangles.
          const double slope = -turn * (b.y() - a.y()),
                       value = turn * ((b.x() - a.x()) * (y - a.y()) + (b.y() - a.y()) * a.x());
          const double slack = 1e-9 * (std::abs(b.x() - a.x()) + std::abs(b.y() - a.y()));
          if (slope > 0)
            from = std::max(from, -(value + slack) / slope);
          else if (slope < 0)
            to = std::min(to, -(value + slack) / slope);
          else if (value < -slack)
            to = -1e300;
        }
        const Range columns = places(from, to, area.lower.x(), step.x(), wide);
        for (int column = columns.first; column <= columns.last; ++column) {
          const double x = area.lower.x() + column * step.x();
          const double z = t[0].z() - (normal.x() * (x - t[0].x()) + normal.y() * (y - t[0].y())) / normal.z();
          float& here =
              found[static_cast<std::size_t>(row) * static_cast<std::size_t>(wide) + static_cast<std::size_t>(column)];
          here = std::max(here, static_cast<float>(std::min(z, std::max({t[0].z(), t[1].z(), t[2].z()}))));
        }
      }
    }
  });
  return found;
}

}  // namespace fieldfab::cam
