#include "fieldfab/cam/plan/free_space.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace fieldfab::cam {
namespace {

constexpr int cells_a_side = 128;

}  // namespace

FreeSpace::FreeSpace(FieldPtr part, const Box& bounds, Progress& progress)
    : part_(std::move(part)), bounds_(bounds), cell_(std::max(bounds.size().maxCoeff() / cells_a_side, 1e-6)) {
  count_ = (bounds.size() / cell_).array().ceil().cast<int>().max(1).min(cells_a_side);
  steps_.assign(index(count_ - Eigen::Vector3i::Ones()) + 1, 255);
  fill(*part_, Eigen::Vector3i::Zero(), cells_a_side);
  progress.check();
  // Chamfer distance: number of steps to the nearest such cell in the 26-neighbourhood, by a
  // forward and a backward sweep.
  const auto relax = [&](int direction) {
    const auto first = [&](int axis) { return direction > 0 ? 0 : count_[axis] - 1; };
    const auto inside = [&](int axis, int i) { return i >= 0 && i < count_[axis]; };
    for (int z = first(2); inside(2, z); z += direction)
      for (int y = first(1); inside(1, y); y += direction)
        for (int x = first(0); inside(0, x); x += direction) {
          std::uint8_t& here = steps_[index({x, y, z})];
          for (int k = 0; k < 13; ++k) {  // the neighbours visited earlier
            const int dx = k % 3 - 1, dy = k / 3 % 3 - 1, dz = k / 9 - 1;
            const Eigen::Vector3i at(x + direction * dx, y + direction * dy, z + direction * dz);
            if (inside(0, at.x()) && inside(1, at.y()) && inside(2, at.z()))
              here = std::min<std::uint8_t>(here, static_cast<std::uint8_t>(std::min(254, +steps_[index(at)]) + 1));
          }
        }
    progress.check();
  };
  relax(1), relax(-1);
}

/// Marks the cells of a cube that may contain part of the solid.
void FreeSpace::fill(const Field& part, const Eigen::Vector3i& from, int size) {
  if ((from.array() >= count_.array()).any()) return;
  const Box box{bounds_.lower + cell_ * from.cast<double>(),
                bounds_.lower + cell_ * (from.array() + size).matrix().cast<double>()};
  const Restriction inside = part.restricted(box, Purpose::occupancy);
  if (inside.range.outside()) return;
  if (size == 1 || inside.range.inside()) {
    const Eigen::Vector3i end = (from.array() + size).min(count_.array());
    for (int z = from.z(); z < end.z(); ++z)
      for (int y = from.y(); y < end.y(); ++y)
        for (int x = from.x(); x < end.x(); ++x) steps_[index({x, y, z})] = 0;
    return;
  }
  for (int child = 0; child < 8; ++child)
    fill(*inside.field, from + size / 2 * Eigen::Vector3i(child & 1, child >> 1 & 1, child >> 2), size / 2);
}

/// Radius of a ball about a point that is proved to be clear, mm; 0 if unknown.
double FreeSpace::room(const Vec3& p) const {
  const Vec3 nearest = p.cwiseMax(bounds_.lower).cwiseMin(bounds_.upper);
  const double outside = (p - nearest).norm();
  const Vec3 at = (nearest - bounds_.lower) / cell_;
  const Eigen::Vector3i c = at.cast<int>().cwiseMin(count_ - Eigen::Vector3i::Ones());
  const int steps = steps_[index(c)];
  if (steps < 1) return outside;
  // All cells fewer steps away are clear.
  const Vec3 within = at - c.cast<double>();
  const double least = std::min(within.minCoeff(), (1 - within.array()).minCoeff());
  return std::hypot(outside, (steps - 1 + std::max(0.0, least)) * cell_);
}

bool FreeSpace::clear(const Vec3& tip, const Vec3& axis, const Frustum& piece, double tolerance) const {
  const Vec3 side = axis.unitOrthogonal(), other = axis.cross(side);
  const double widest = std::max(piece.radius_from, piece.radius_to);
  struct Block {
    Vec3 lower, upper;  // two directions across the axis, then along it
  };
  std::vector<Block> open{{{-widest, -widest, piece.from}, {widest, widest, piece.to}}};
  int looked_at = 0;
  while (!open.empty()) {
    const Block block = open.back();
    open.pop_back();
    const Vec3 size = block.upper - block.lower, middle = 0.5 * (block.lower + block.upper);
    // Point of the block nearest to the tool's axis, across the axis.
    const Eigen::Vector2d nearest(std::max({block.lower.x(), -block.upper.x(), 0.0}),
                                  std::max({block.lower.y(), -block.upper.y(), 0.0}));
    const auto radius = [&](double along) {
      const double length = piece.to - piece.from, share = length > 0 ? (along - piece.from) / length : 0;
      return piece.radius_from + share * (piece.radius_to - piece.radius_from);
    };
    if (nearest.norm() > std::max(radius(block.lower.z()), radius(block.upper.z()))) continue;
    const Vec3 at = tip + middle.x() * side + middle.y() * other + middle.z() * axis;
    const double half = 0.5 * size.norm();
    if (room(at) >= half) continue;
    if (++looked_at > 20000) return false;
    if (half < 2 * cell_) {
      const Eigen::Matrix3d turned = (Eigen::Matrix3d() << side, other, axis).finished();
      const Vec3 reach = 0.5 * (turned.cwiseAbs() * size);
      const Interval range = part_->interval({at - reach, at + reach});
      if (range.outside()) continue;
      if (range.inside()) return false;
    }
    if (half <= tolerance) return false;
    Eigen::Index longest = 0;
    size.maxCoeff(&longest);
    Block low = block, high = block;
    low.upper[longest] = high.lower[longest] = middle[longest];
    // The half nearer to the part first, because it more often decides the test.
    const auto centre = [&](const Block& b) {
      const Vec3 m = 0.5 * (b.lower + b.upper);
      return Vec3(tip + m.x() * side + m.y() * other + m.z() * axis);
    };
    if (room(centre(low)) < room(centre(high))) std::swap(low, high);
    open.push_back(low), open.push_back(high);
  }
  return true;
}

}  // namespace fieldfab::cam
