// square, circle, polygon, text, flat imports, and resize of flat shapes.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "evaluator.h"
#include "imports.h"

namespace fieldfab::openscad {

Region Evaluator::primitive(const Arguments& a, const Node& node) {
  if (node.name == "square") {
    const std::vector<double> size = a.numbers("size", {1, 1});
    if (!(size[0] > 0 && size[1] > 0 && std::isfinite(size[0]) && std::isfinite(size[1]))) return {};
    const double x = a.truth("center", false) ? -size[0] / 2 : 0, y = a.truth("center", false) ? -size[1] / 2 : 0;
    return {{{{x, y}, {x + size[0], y}, {x + size[0], y + size[1]}, {x, y + size[1]}}}};
  }
  const double r = a.number("r", 1);
  if (!(r > 0) || !std::isfinite(r)) return {};
  int count = sides(a, r, node);
  if (count == 0) count = 1440;  // deviates by 5e-6 of the radius from a circle
  Outline outline;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return {{outline}};
}

Region Evaluator::polygon(const Arguments& a) {
  const auto points = a.points("points", 2);
  auto paths = a.paths("paths", points.size());
  if (a.find("paths") == nullptr) {
    paths.emplace_back();
    for (std::uint32_t i = 0; i < points.size(); ++i) paths.back().push_back(i);
  }
  std::vector<Outline> outlines;
  for (const auto& path : paths) {
    Outline outline;
    for (const std::uint32_t i : path) outline.emplace_back(points[i][0], points[i][1]);
    outlines.push_back(std::move(outline));
  }
  return even_odd(outlines);
}

Region Evaluator::drawn(NodeIndex node) {
  const std::string text = print_csg(tree_, node);
  const auto known = drawings_.find(text);
  if (known != drawings_.end()) return known->second;
  return drawings_[text] = drawn_by_openscad(tree_, node, folder_, progress_);
}

std::vector<double> resize_factors(const std::vector<double>& wanted, const std::vector<double>& automatic,
                                   const std::vector<double>& size) {
  const std::size_t most = static_cast<std::size_t>(std::max_element(wanted.begin(), wanted.end()) - wanted.begin());
  const double other = wanted[most] > 0 && size[most] > 0 ? wanted[most] / size[most] : 1;
  std::vector<double> factors;
  for (std::size_t i = 0; i < size.size(); ++i)
    factors.push_back(wanted[i] > 0 && size[i] > 0 ? wanted[i] / size[i] : automatic[i] != 0 ? other : 1);
  return factors;
}

Region Evaluator::resized(const Arguments& a, const Node& node, int depth) {
  const Region region = united_flat(node, depth);
  if (region.empty()) return region;
  const Vec2 size = region.bounds().sizes();
  const std::vector<double> factors =
      resize_factors(a.numbers("newsize", {0, 0}), a.numbers("auto", {0, 0}), {size.x(), size.y()});
  return moved(region, Eigen::Affine2d(Eigen::Scaling(factors[0], factors[1])));
}

}  // namespace fieldfab::openscad
