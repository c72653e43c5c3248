#include "lattice.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "fieldfab/core/error.h"

namespace fieldfab::contouring {
namespace {

// Shapes are drawn on round numbers, often multiples of the voxel. Planes at such multiples less a part of a voxel keep
// the surface from running along a plane, or close to one, wherever the bounds are.
const Vec3 shift{0.4142135, 0.3660254, 0.2886751};

constexpr int greatest_level = 20;     // of the root, in voxels
constexpr double floats_across = 256;  // the least number of floats across a cell

void check(const Box& bounds, double voxel) {
  if (!bounds.valid() || bounds.size().minCoeff() <= 0)
    throw Error(ErrorKind::bad_input, "bounds", "a region must be finite and have a positive size along x, y and z");
  if (!std::isfinite(voxel) || voxel <= 0)
    throw Error(ErrorKind::bad_input, "voxel", "must be a positive number of mm");
}

}  // namespace

Lattice::Lattice(const Box& bounds, double voxel, int depth) : voxel_(Vec3::Constant(voxel)) {
  check(bounds, voxel);
  constexpr double rounding = 1e-9;  // so that a multiple of the voxel is one
  const Eigen::Array3d first = (bounds.lower.array() / voxel + rounding).floor() - 1;
  origin_ = voxel * (first.matrix() - shift);
  set_levels(bounds, depth);
}

Lattice::Lattice(const Box& bounds, const Sampling& samples, int depth) : voxel_(samples.spacing) {
  check(bounds, voxel_.minCoeff());
  const Eigen::Array3d first = ((bounds.lower - samples.origin).array() / voxel_.array()).floor() - 1;
  origin_ = samples.origin + (first * voxel_.array()).matrix();
  set_levels(bounds, depth);
}

void Lattice::set_levels(const Box& bounds, int depth) {
  const double shortest = voxel_.minCoeff(), cells = (bounds.size().array() / voxel_.array()).maxCoeff() + 4;
  int root = block_level;  // in voxels
  while (root <= greatest_level && cells > std::ldexp(1.0, root)) ++root;
  if (root > greatest_level)
    throw Error(ErrorKind::too_large, "voxel",
                fmt::format("{:.3g} mm divides the region into {:.3g} cells a side; at most {} are possible", shortest,
                            cells, 1 << greatest_level));

  const double farthest =
      std::max(origin_.cwiseAbs().maxCoeff(), (origin_ + std::ldexp(1.0, root) * voxel_).cwiseAbs().maxCoeff());
  float_step_ = std::ldexp(farthest, -23);
  if (shortest < floats_across * float_step_ || farthest > 1e30)
    throw Error(
        ErrorKind::bad_input, "voxel",
        fmt::format("{:.3g} mm is too fine for coordinates of {:.3g} mm in single precision", shortest, farthest));
  voxel_level_ = 0;
  while (voxel_level_ < depth && std::ldexp(shortest, -voxel_level_ - 1) >= floats_across * float_step_) ++voxel_level_;
  finest_ = std::ldexp(1.0, -voxel_level_) * voxel_;
  root_level_ = root + voxel_level_;
}

Box Lattice::cube(const LatticePoint& lower, int level) const {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = plane(axis, lower[static_cast<std::size_t>(axis)]);
    box.upper[axis] = plane(axis, lower[static_cast<std::size_t>(axis)] + (1 << level));
  }
  return box;
}

}  // namespace fieldfab::contouring
