#include "fieldfab/cam/simulate/frames.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "fieldfab/cam/simulate/picture.h"
#include "fieldfab/cam/stock/surface.h"
#include "fieldfab/core/error.h"
#include "fieldfab/render/triangles.h"

namespace fieldfab::cam {
namespace {

/// Half section of a zone from its lowest point on the axis to its highest, as (distance from the
/// axis, height).
std::vector<Vec2> half_section(const Zone& zone) {
  constexpr int steps = 12;
  std::vector<Vec2> points{{0, zone.z0}};
  if (zone.shape == Zone::Shape::frustum) {
    points.insert(points.end(), {{zone.r0, zone.z0}, {zone.r1, zone.z1}, {0, zone.z1}});
    return points;
  }
  // A ball is a ring of radius 0.
  const double disc = zone.shape == Zone::Shape::ball ? 0 : zone.r0,
               round = zone.shape == Zone::Shape::ball ? zone.r0 : zone.r1;
  points[0] = {0, zone.z0 - round};
  for (int i = 0; i <= steps; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / steps - 0.5);
    points.emplace_back(disc + round * std::cos(angle), zone.z0 + round * std::sin(angle));
  }
  points.emplace_back(0, zone.z0 + round);
  return points;
}

void add_turned(const std::vector<Vec2>& section, const ToolPose& pose, int parts, TriangleMesh& mesh) {
  int least = 0;
  pose.axis.cwiseAbs().minCoeff(&least);
  const Vec3 one = pose.axis.cross(Vec3::Unit(least)).normalized(), other = pose.axis.cross(one);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size()), n = static_cast<std::uint32_t>(parts);
  for (const Vec2& point : section)
    for (int k = 0; k < parts; ++k) {
      const double angle = 2 * std::numbers::pi * k / parts;
      const Vec3 at = pose.tip + point.y() * pose.axis + point.x() * (std::cos(angle) * one + std::sin(angle) * other);
      mesh.vertices.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z())});
    }
  for (std::uint32_t i = 0; i + 1 < section.size(); ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = first + i * n + k, b = first + i * n + (k + 1) % n;
      mesh.triangles.push_back({a, b, b + n});
      mesh.triangles.push_back({a, b + n, a + n});
    }
}

/// Renders pictures of successive times.
class Film {
 public:
  Film(const SimulationResult& result, const FrameSettings& settings)
      : result_(result), playhead_(result.playback()), settings_(settings) {
    view_.size = settings.size, view_.alpha = settings.alpha, view_.beta = settings.beta;
    view_.samples = 2;
    view_.window = window();
    for (const auto& [number, tool] : result.setup().tools)
      colour_of_.try_emplace(number, colour_of_tool(colour_of_.size() + 1));
  }

  Image frame(double seconds, Progress& progress) {
    surface_.update(playhead_.stock_after(playhead_.playback().done_after_seconds(seconds), progress), progress);
    std::vector<std::uint32_t> cuts;
    TriangleMesh mesh = surface_.mesh(&cuts);
    std::vector<Colour> colours;
    colours.reserve(mesh.vertices.size());
    for (const std::uint32_t cut : cuts) {
      const auto found = colour_of_.find(result_.cuts()[cut].move.tool);
      colours.push_back(found == colour_of_.end() ? colour_of_tool(0) : found->second);
    }
    add_tool(seconds, mesh, colours);
    return render({mesh.vertices, mesh.triangles, colours}, view_, progress).image;
  }

 private:
  /// Bounding box of the stock, with a margin for tools.
  [[nodiscard]] Box window() const {
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(settings_.beta, Vec3::UnitX()) * Eigen::AngleAxisd(settings_.alpha, Vec3::UnitZ())).matrix();
    Box frame = image_of(result_.setup().stock_box, turn, Vec3::Zero());
    const double room = 0.15 * frame.size().head<2>().maxCoeff();
    frame.upper.y() += room;
    return frame.grown(room);
  }

  /// Adds the tool in the pose of the current move.
  void add_tool(double seconds, TriangleMesh& mesh, std::vector<Colour>& colours) const {
    const Playback::Moment moment = playhead_.playback().at(seconds);
    constexpr std::array<std::pair<ToolRole, Colour>, 3> looks{
        {{ToolRole::cutting, {196, 202, 210}}, {ToolRole::shank, {128, 134, 142}}, {ToolRole::holder, {74, 78, 86}}}};
    for (const auto& [role, colour] : looks) {
      const TriangleMesh part = tool_mesh(playhead_.playback().tool(moment.move), role, moment.pose);
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
      for (const auto& t : part.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      colours.resize(mesh.vertices.size(), colour);
    }
  }

  const SimulationResult& result_;
  Playhead playhead_;
  FrameSettings settings_;
  RenderSettings view_;
  StockSurface surface_;
  std::map<int, Colour> colour_of_;
};

}  // namespace

TriangleMesh tool_mesh(const ToolSolid& tool, ToolRole role, const ToolPose& pose, int parts) {
  TriangleMesh mesh;
  for (const ToolPiece& piece : tool.pieces)
    if (piece.role == role)
      for (const Zone& zone : piece.zones) add_turned(half_section(zone), pose, parts, mesh);
  return mesh;
}

void write_frames(const SimulationResult& result, const std::filesystem::path& folder, const FrameSettings& settings,
                  Progress& progress) {
  if (settings.count < 1 || settings.count > 100'000 || settings.size < 16 || settings.size > 8192)
    throw Error(ErrorKind::bad_input, "frames", "1 to 100000 frames of 16 to 8192 pixels are wanted");
  const Playback* const playback = result.playback().get();
  if (!playback || playback->moves() == 0)
    throw Error(ErrorKind::bad_input, "frames", "nothing moved that could be shown");
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) throw Error(ErrorKind::io, folder.string(), "cannot be made: " + failed.message());
  const double seconds = playback->move(playback->moves() - 1).seconds;
  Film film(result, settings);
  for (int i = 1; i <= settings.count; ++i) {
    progress.report(static_cast<double>(i - 1) / settings.count, fmt::format("frame {} of {}", i, settings.count));
    write_png(film.frame(seconds * i / settings.count, progress), folder / fmt::format("frame_{:04d}.png", i));
  }
}

}  // namespace fieldfab::cam
