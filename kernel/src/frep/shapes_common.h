/// Functions common to all shapes.
#pragma once

#include "fieldfab/frep/shapes.h"

namespace fieldfab::frep::shapes {

inline E x() { return Expression::x(); }
inline E y() { return Expression::y(); }
inline E z() { return Expression::z(); }

inline E length(const E& a, const E& b) { return sqrt(square(a) + square(b)); }
inline E length(const E& a, const E& b, const E& c) { return sqrt(square(a) + square(b) + square(c)); }
inline E positive(const E& a) { return max(a, 0.0); }
inline E clamp(const E& a, const E& low, const E& high) { return max(low, min(high, a)); }

/// Distance from (px, py) to the segment from (ax, ay) to (bx, by).
E segment_distance(const E& px, const E& py, const E& ax, const E& ay, const E& bx, const E& by);

/// Signed distance of the solid `inside` < 0, given the distance to its surface.
inline E with_sign_of(const E& inside, const E& distance) { return distance * compare(inside, 0.0); }

}  // namespace fieldfab::frep::shapes
