#include "sheet.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"

namespace fieldfab::cam {
namespace {

/// A drawing of a part that lies flat, with its lower left corner at the origin.
Solid laid_flat(const Solid& part) {
  Eigen::Index thinnest = 0;
  part.bounds->size().minCoeff(&thinnest);
  Eigen::Affine3d turn = Eigen::Affine3d::Identity();
  if (!part.flat && thinnest == 0) turn.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY()));
  if (!part.flat && thinnest == 1) turn.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
  Box box = image_of(*part.bounds, turn.linear(), Vec3::Zero());
  if (box.size().y() > box.size().x()) {
    turn.prerotate(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
    box = image_of(*part.bounds, turn.linear(), Vec3::Zero());
  }
  const Vec3 move(-box.lower.x(), -box.lower.y(), -box.centre().z());
  turn.pretranslate(move);
  FieldPtr drawing = transform(part.field, turn);
  if (!part.flat) {
    // Made constant along z: the slice in the middle of the upper half, away from the floors of
    // pockets, which lie at half height.
    const auto coordinate = [](const std::string& text) { return frep::make_field(frep::parse_infix(text)); };
    drawing = map(drawing, coordinate("x"), coordinate("y"), coordinate(fmt::format("{:.9f}", 0.25 * box.size().z())));
  }
  return solid_of(drawing, "part", Box{Vec3::Zero(), Vec3(box.size().x(), box.size().y(), 0)}, true);
}

}  // namespace

Solid lay_on_sheet(const std::vector<Solid>& parts, const Vec2& sheet, double gap) {
  std::vector<Solid> flat;
  for (const Solid& part : parts) flat.push_back(laid_flat(part));
  std::stable_sort(flat.begin(), flat.end(),
                   [](const Solid& a, const Solid& b) { return a.bounds->size().y() > b.bounds->size().y(); });
  FieldPtr all;
  const double edge = gap / 2;  // from the sheet's edges, since cuts run beside the parts
  double x = edge, y = edge, row = 0;
  for (const Solid& part : flat) {
    const Vec3 size = part.bounds->size();
    if (x > edge && x + size.x() + edge > sheet.x()) x = edge, y += row + gap, row = 0;
    if (x + size.x() + edge > sheet.x() || y + size.y() + edge > sheet.y())
      throw Error(
          ErrorKind::bad_input, "sheet",
          fmt::format(
              "{} parts do not fit on a sheet of {:.4g} x {:.4g} mm, {:.4g} mm apart and {:.4g} mm from its edges",
              parts.size(), sheet.x(), sheet.y(), gap, edge));
    // Clipped to its own bounds, because a formula may define other solids elsewhere.
    const FieldPtr placed = translate(
        intersect(part.field, box_field({{-1e-3, -1e-3, -1}, {size.x() + 1e-3, size.y() + 1e-3, 1}})), {x, y, 0});
    all = all ? unite(all, placed) : placed;
    x += size.x() + gap;
    row = std::max(row, size.y());
  }
  return solid_of(all, "part", Box{Vec3::Zero(), Vec3(sheet.x(), sheet.y(), 0)}, true);
}

}  // namespace fieldfab::cam
