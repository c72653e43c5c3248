#include "fieldfab/cam/base/tool_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fieldfab/core/error.h"

namespace fieldfab::cam {
namespace {

Zone frustum(double z0, double r0, double z1, double r1) { return {Zone::Shape::frustum, z0, z1, r0, r1, true, true}; }

double upper_end(const Zone& zone) {
  return zone.shape == Zone::Shape::frustum ? zone.z1 : zone.z0 + (zone.shape == Zone::Shape::ball ? zone.r0 : zone.r1);
}

/// The cutting part up to the height `length`, for shapes without a free profile.
ToolPiece cutter(const Tool& tool, double length) {
  const double r = tool.radius();
  ToolPiece piece;
  double reached = 0;  // upper end of the tip
  const auto cone = [&](double from, double from_radius) {
    const double slope = std::tan(tool.angle / 2);  // radius per height
    if (!(slope > 0)) throw Error(ErrorKind::bad_input, "tool", fmt::format("tool {} needs an angle", tool.number));
    const double end = from + (r - from_radius) / slope;
    piece.zones.push_back(
        frustum(from, from_radius, std::min(end, length), std::min(r, from_radius + (length - from) * slope)));
    reached = std::min(end, length);
  };
  if (tool.shape == ToolShape::ball) {
    piece.zones.push_back({Zone::Shape::ball, r, 0, r, 0, false, false});
    reached = r;
  } else if (tool.shape == ToolShape::bull && tool.corner_radius > 0) {
    piece.zones.push_back(
        {Zone::Shape::ring, tool.corner_radius, 0, r - tool.corner_radius, tool.corner_radius, false, false});
    reached = tool.corner_radius;
  } else if (tool.shape == ToolShape::v) {
    cone(0, tool.tip_diameter / 2);
  } else if (tool.shape == ToolShape::drill) {
    cone(0, 0);
  } else if (tool.shape == ToolShape::tapered) {
    // The cone is tangent to the ball of the tip: the normals agree there.
    const double half = tool.angle / 2, tip = tool.corner_radius;
    piece.zones.push_back({Zone::Shape::ball, tip, 0, tip, 0, false, false});
    cone(tip * (1 - std::sin(half)), tip * std::cos(half));
    piece.zones.back().lower_edge = false;
  }
  if (reached < length) {
    piece.zones.push_back(frustum(reached, r, length, r));
    if (tool.shape == ToolShape::ball || tool.shape == ToolShape::bull) piece.zones.back().lower_edge = reached == 0;
  }
  return piece;
}

}  // namespace

double widest(const Zone& zone) {
  if (zone.shape == Zone::Shape::frustum) return std::max(zone.r0, zone.r1);
  return zone.shape == Zone::Shape::ball ? zone.r0 : zone.r0 + zone.r1;
}

double ToolSolid::radius() const {
  double most = 0;
  for (const ToolPiece& piece : pieces)
    for (const Zone& zone : piece.zones) most = std::max(most, widest(zone));
  return most;
}

double ToolSolid::length() const {
  double most = 0;
  for (const ToolPiece& piece : pieces)
    for (const Zone& zone : piece.zones) most = std::max(most, upper_end(zone));
  return most;
}

ToolSolid ToolSolid::shrunk(double by) const {
  ToolSolid result;
  for (const ToolPiece& piece : pieces) {
    ToolPiece smaller{piece.role, {}};
    for (Zone zone : piece.zones) {
      if (zone.shape == Zone::Shape::ball) {
        zone.r0 -= by;
        if (zone.r0 <= 0) continue;
      } else if (zone.shape == Zone::Shape::ring) {
        zone.r1 -= by;
        if (zone.r1 <= 0) continue;
      } else {
        const double slope = (zone.r1 - zone.r0) / (zone.z1 - zone.z0), along = by * std::sqrt(1 + slope * slope);
        // Inner ends of a smooth piece keep their height, so that its zones still join.
        const double low = zone.lower_edge ? by : 0, high = zone.upper_edge ? by : 0;
        zone.r0 += slope * low - along, zone.r1 -= slope * high + along;
        zone.z0 += low, zone.z1 -= high;
        if (zone.z1 <= zone.z0 || (zone.r0 <= 0 && zone.r1 <= 0)) continue;
        if (zone.r0 < 0) zone.z0 -= zone.r0 / slope, zone.r0 = 0;
        if (zone.r1 < 0) zone.z1 -= zone.r1 / slope, zone.r1 = 0;
      }
      smaller.zones.push_back(zone);
    }
    if (!smaller.zones.empty()) result.pieces.push_back(std::move(smaller));
  }
  return result;
}

std::vector<ToolPiece> convex_pieces(const std::vector<Vec2>& section, ToolRole role, const std::string& place) {
  std::vector<ToolPiece> pieces;
  for (std::size_t i = 0; i < section.size(); ++i) {
    if (!section[i].allFinite() || section[i].x() < 0)
      throw Error(ErrorKind::bad_input, place, "a section has finite points that are not left of the axis");
    if (i && section[i].y() < section[i - 1].y() - 1e-9)
      throw Error(ErrorKind::bad_input, place, "the heights of a section must not fall");
  }
  double last_slope = 0;
  for (std::size_t i = 1; i < section.size(); ++i) {
    const Vec2 &a = section[i - 1], &b = section[i];
    if (b.y() - a.y() < 1e-9) continue;  // a step: the next zone has another radius
    const double slope = (b.x() - a.x()) / (b.y() - a.y());
    const Zone zone = frustum(a.y(), a.x(), b.y(), b.x());
    // The zone is joined to the piece below if the outline is convex there and has no step
    // outwards.
    const bool convex = !pieces.empty() && slope <= last_slope + 1e-9 &&
                        std::abs(pieces.back().zones.back().r1 - a.x()) < 1e-9 &&
                        std::abs(pieces.back().zones.back().z1 - a.y()) < 1e-9;
    if (convex)
      pieces.back().zones.push_back(zone);
    else
      pieces.push_back({role, {zone}});
    last_slope = slope;
  }
  if (pieces.empty()) throw Error(ErrorKind::bad_input, place, "a section needs two points at different heights");
  return pieces;
}

ToolSolid tool_solid(const Tool& tool) {
  if (tool.shape != ToolShape::form) (void)tool.profile();  // the tool's own errors first
  ToolSolid solid;
  double length = tool.flute > 0 ? tool.flute : tool.length > 0 ? tool.length : 10 * tool.diameter;
  if (tool.shape == ToolShape::profile || tool.shape == ToolShape::form) {
    std::vector<Vec2> section = tool.points;
    if (section.empty()) throw Error(ErrorKind::bad_input, "tool", fmt::format("tool {} has no profile", tool.number));
    const double top = section.back().y();
    if (length > top + 1e-9) section.emplace_back(section.back().x(), length);
    length = std::max(length, top);
    solid.pieces = convex_pieces(section, ToolRole::cutting, "tool");
  } else {
    solid.pieces.push_back(cutter(tool, length));
  }
  const double to_holder = tool.length > 0 ? tool.length : length;
  if (to_holder > length + 1e-9) {
    const double shank = tool.shank > 0 ? tool.shank / 2 : tool.radius();
    solid.pieces.push_back({ToolRole::shank, {frustum(length, shank, to_holder, shank)}});
  }
  if (tool.holder_diameter > 0)
    solid.pieces.push_back({ToolRole::holder,
                            {frustum(to_holder, tool.holder_diameter / 2,
                                     to_holder + (tool.holder_length > 0 ? tool.holder_length : tool.holder_diameter),
                                     tool.holder_diameter / 2)}});
  return solid;
}

}  // namespace fieldfab::cam
