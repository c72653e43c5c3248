/// Coordinates in which an expression was designed, before its parts were rotated and moved.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// An expression in coordinates u, where x, y and z are `axes` * u.
struct FramedExpression {
  Expression expression;  ///< in which u is written as x, y and z
  Eigen::Matrix3d axes;
};

/// Rewrites an expression so that its linear forms a x + b y + c z + d are along the axes: the most
/// frequent forms, up to three independent ones. Returns nullopt if they are along the axes
/// already. In that frame intervals are tight: a rotated box is an axis-aligned box.
std::optional<FramedExpression> in_own_frame(const Expression& expression);

/// Returns the affine map from x, y and z to three coordinates, in double precision; nullopt if
/// they are not linear forms, or if the map is singular.
std::optional<Eigen::Affine3d> affine_map(const Expression& x, const Expression& y, const Expression& z);

}  // namespace fieldfab::frep
