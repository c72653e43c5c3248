/// Cutters for tests.
#pragma once

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"

namespace fieldfab::cam {

inline FieldPtr formula(const std::string& text) { return frep::make_field(frep::parse_infix(text)); }

inline Tool tool(const std::string& shape, double diameter, double corner = 0, double angle = 0) {
  Tool t;
  t.shape = tool_shape_named(shape, "test"), t.diameter = diameter, t.corner_radius = corner, t.angle = angle;
  return t;
}

}  // namespace fieldfab::cam
