/// The coordinates in which an expression was designed, before its parts were turned and moved.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// An expression in coordinates u, where x, y and z are `axes` * u.
struct FramedExpression {
  Expression expression;  ///< in which u stands as x, y and z
  Eigen::Matrix3d axes;
};

/// Rewrites an expression so that the linear forms a x + b y + c z + d it works on are along the axes: the forms used most, as
/// far as three of them are independent. Nothing where they already are. In that frame intervals are tight: a turned box is a
/// box.
std::optional<FramedExpression> in_own_frame(const Expression& expression);

/// The affine map from x, y and z to three coordinates, in double precision; nothing where they are no linear forms, or flatten
/// space.
std::optional<Eigen::Affine3d> affine_map(const Expression& x, const Expression& y, const Expression& z);

}  // namespace fieldfab::frep
