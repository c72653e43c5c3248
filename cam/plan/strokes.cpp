#include "strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/chords.h"

namespace fieldfab::cam {
namespace {

constexpr double chord = 0.002;  // greatest deviation of chords from arcs, mm

/// Half section of a cutter, from the axis outwards: a polyline inside of it.
std::vector<Vec2> half_section(const Tool& tool) {
  if (!tool.points.empty()) return tool.points;
  const Profile profile = tool.profile();
  const FlatCornerCone form = profile.closed_form();
  constexpr int parts = 4;  // of the corner, in equal angles
  std::vector<Vec2> points;
  const auto add = [&](double distance) {
    const double d = std::min(distance, profile.radius());
    if (points.empty() || d > points.back().x() + 1e-9) points.emplace_back(d, profile.height(d));
  };
  add(0);
  add(form.flat);
  for (int i = 1; form.corner > 0 && i <= parts; ++i) {
    const double end = std::asin(std::min(1.0, form.widest / static_cast<double>(form.corner)));
    add(form.flat + form.corner * std::sin(end * i / parts));
  }
  add(profile.radius());
  return points;
}

}  // namespace

double half_diagonal(const StockLattice& lattice, const Vec3& axis) {
  int along = 0;
  if (axis.cwiseAbs().maxCoeff(&along) < 1 - 1e-9) return 0.5 * lattice.spacing().norm();
  return 0.5 * std::hypot(lattice.spacing()[(along + 1) % 3], lattice.spacing()[(along + 2) % 3]);
}

std::vector<ToolPiece> thinned(const Tool& tool, double by, double length) {
  std::vector<Vec2> section;
  const std::vector<Vec2> whole = half_section(tool);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    // From the place where the section is as wide as what it loses.
    if (i > 0 && whole[i - 1].x() < by && whole[i].x() > by) {
      const double share = (by - whole[i - 1].x()) / (whole[i].x() - whole[i - 1].x());
      section.emplace_back(0, whole[i - 1].y() + share * (whole[i].y() - whole[i - 1].y()));
    }
    if (whole[i].x() >= by) section.emplace_back(whole[i].x() - by, whole[i].y());
  }
  if (section.empty() || section.back().x() < 1e-6) return {};
  // Up to that height: shorter than the tip's own height, too.
  for (std::size_t i = 1; i < section.size(); ++i) {
    if (section[i].y() <= length) continue;
    const double share = std::clamp((length - section[i - 1].y()) / (section[i].y() - section[i - 1].y()), 0.0, 1.0);
    section[i] = section[i - 1] + share * (section[i] - section[i - 1]);
    section.resize(i + 1);
  }
  if (section.back().y() < length - 1e-9) section.emplace_back(section.back().x(), length);
  if (section.back().y() < section.front().y() + 1e-6) return {};
  return convex_pieces(section, ToolRole::cutting, "tool");
}

std::vector<Vec3> segments(const Vec3& from, const Move& move, double step) {
  std::vector<Vec3> ends;
  Path path;
  path.points = {{from, move.bulge}, {move.to}};
  double longest = step;
  if (move.bulge != 0) {
    const double radius = arc_between(from.head<2>(), move.to.head<2>(), move.bulge).radius;
    longest = std::min(step, chord_arc_length(radius, chord));
  }
  Vec3 last = from;
  for (const PathPoint& p : points_along(path, longest)) {
    const Vec3 way = p.at - last;
    const int parts = std::isfinite(step) ? std::max(1, static_cast<int>(std::ceil(way.norm() / step))) : 1;
    for (int k = 1; k <= parts; ++k)
      if (way.norm() > 0) ends.emplace_back(last + way * k / parts);
    last = p.at;
  }
  return ends;
}

}  // namespace fieldfab::cam
