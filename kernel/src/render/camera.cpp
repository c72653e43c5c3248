#include "camera.h"

#include <Eigen/Geometry>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"

namespace fieldfab {
View look(const Field& field, const Box& bounds, const RenderSettings& settings) {
  if (!bounds.valid() || bounds.size().minCoeff() <= 0)
    throw Error(ErrorKind::bad_input, "bounds",
                "a picture of a solid needs finite bounds with a positive size along x, y and z");
  if (!std::isfinite(settings.alpha) || !std::isfinite(settings.beta))
    throw Error(ErrorKind::bad_input, "angle", "must be a finite number");
  if (!(settings.perspective >= 0 && settings.perspective <= 2))
    throw Error(ErrorKind::bad_input, "perspective", "must be from 0 to 2 radians (115 degrees)");

  View view{field.shared_from_this(), bounds};
  const auto framed = [&](View made) {
    if (settings.window) {
      made.region.lower.head<2>() = settings.window->lower.head<2>();
      made.region.upper.head<2>() = settings.window->upper.head<2>();
      if (!made.region.valid()) throw Error(ErrorKind::bad_input, "window", "must be finite and have a positive size");
    }
    return made;
  };
  const bool turned = settings.alpha != 0 || settings.beta != 0;
  if (!turned && settings.perspective == 0 && !settings.window) return view;
  // Rotation by alpha about z, then by beta about x (Keeter App. C).
  const Eigen::Affine3d turn(Eigen::AngleAxisd(settings.beta, Vec3::UnitX()) *
                             Eigen::AngleAxisd(settings.alpha, Vec3::UnitZ()));
  view.field = intersect(view.field, box_field(bounds));
  if (turned) view.field = transform(view.field, turn);
  view.region = image_of(bounds, turn.linear(), turn.translation());
  if (settings.perspective == 0) return framed(view);

  const Vec3 centre = turn * bounds.centre();
  view.distance = bounds.size().norm() / 2 / std::sin(settings.perspective / 2);
  view.field = seen_from_near(view.field, centre, view.distance);
  Vec3 reach = Vec3::Zero();
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 unit(corner & 1U, corner >> 1 & 1U, corner >> 2);
    const Vec3 p = turn * (bounds.lower + unit.cwiseProduct(bounds.size())) - centre;
    reach = reach.cwiseMax((p / (1 - p.z() / view.distance)).cwiseAbs());
  }
  view.region.lower.head<2>() = (centre - reach).head<2>();
  view.region.upper.head<2>() = (centre + reach).head<2>();
  view.centre = centre;
  return framed(view);
}

void straighten(const View& view, const PixelGrid& grid, const std::vector<float>& heights, Normals& normals) {
  if (view.distance == 0) return;
  const Eigen::Vector3f centre = view.centre.cast<float>();
  const auto distance = static_cast<float>(view.distance);
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column) {
      const std::size_t i = grid.index(column, row);
      if (!std::isfinite(heights[i])) continue;
      Eigen::Vector3f& n = normals[i];
      const float nearness = 1 - (heights[i] - centre.z()) / distance;
      n.head<2>() /= nearness;
      n.z() += ((grid.x(column) - centre.x()) * n.x() + (grid.y(row) - centre.y()) * n.y()) / distance;
      n.normalize();
    }
}

}  // namespace fieldfab
