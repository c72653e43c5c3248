/// Random solids that are hard to mesh.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>

namespace fieldfab {

/// A union of some boxes, balls, cylinders and shells in random orientations, each with a dimension
/// far below a cell.
inline std::string random_thin_solid(std::mt19937& random) {
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto thin = [&] { return std::pow(10, number(-2, 0)); };
  const auto whole = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  std::string text;
  const int parts = whole(1, 4);
  for (int i = 0; i < parts; ++i) {
    std::string part;
    switch (whole(0, 5)) {
      case 0: part = fmt::format("box({}, {}, {})", number(1, 4), number(1, 4), thin()); break;
      case 1: part = fmt::format("box({}, {}, {})", thin(), number(1, 4), thin()); break;
      case 2: part = fmt::format("cylinder({}, {})", thin(), number(1, 4)); break;
      case 3: part = fmt::format("shell(sphere({}), {})", number(0.5, 2), thin()); break;
      case 4: part = fmt::format("sphere({})", thin()); break;
      default:
        part = fmt::format("difference(cylinder({0}, 3), cylinder({1}, 4))", number(0.5, 2), number(0.4, 1.9));
        break;
    }
    part = fmt::format("move(rotate_z(rotate_x({}, {}), {}), dx = {}, dy = {}, dz = {})", part, number(0, 180),
                       number(0, 180), number(-1, 1), number(-1, 1), number(-1, 1));
    if (i == 0)
      text = part;
    else
      text = fmt::format("{}({}, {})", whole(0, 2) == 0 ? "difference" : "union", text, part);
  }
  return text;
}

}  // namespace fieldfab
