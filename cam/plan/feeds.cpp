#include "fieldfab/cam/plan/feeds.h"

#include <algorithm>
#include <cmath>

#include "base/toml_table.h"
#include "fieldfab/cam/base/tool_solid.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {

/// A part of a feed.
struct MeasuredStock::Piece {
  std::size_t move;    // its index
  double share;        // of the move, at the piece's end
  double length;       // mm
  bool descends;       // towards the material
  double section = 0;  // cross-section of what it removes, mm^2
  double factor = 1;   // of the planned feed
};

namespace {

/// Less than a chip of 0.01 mm by 0.01 mm is air, as in simulations.
constexpr double air = 1e-4;
/// Feeds differ by at least this factor: each is a line of the program.
constexpr double ladder = 1.15;
/// Sine of the angle from which on a move counts as a descent.
constexpr double steep = 0.01;

/// Thickness of the thickest chip at a width of cut, in parts of the feed per tooth.
double chip(double width, double radius) {
  return width >= radius ? 1 : std::sqrt(std::max(0.0, width * (2 * radius - width))) / radius;
}

double bulge_of(double bulge, double share) { return std::tan(std::atan(bulge) * share); }

}  // namespace

FeedLimits feed_limits_of(const TomlTable& table) {
  table.only({"least", "most"});
  FeedLimits limits;
  limits.least = table.number("least").value_or(limits.least);
  limits.most = table.number("most").value_or(limits.most);
  require_possible(limits, table.place("least"), table.place("most"));
  return limits;
}

void require_possible(const FeedLimits& limits, const std::string& place_of_least, const std::string& place_of_most) {
  if (!(limits.least > 0 && limits.least <= 1))
    throw Error(ErrorKind::bad_input, place_of_least, "least must be above 0 and at most 1");
  if (!(limits.most >= 1 && limits.most <= 100))
    throw Error(ErrorKind::bad_input, place_of_most, "most must be from 1 to 100");
}

/// Executes the moves in short pieces; moves with a turning axis in one.
std::vector<MeasuredStock::Piece> MeasuredStock::measure(const std::vector<Move>& moves, const Tool& tool,
                                                         const Plane& plane, Progress& progress) {
  // Shorter pieces would measure the lattice.
  const double step = std::max(3 * stock_.lattice().spacing().maxCoeff(), tool.diameter / 6);
  std::vector<ToolPiece> cutter;
  for (ToolPiece& piece : tool_solid(tool).pieces)
    if (piece.role == ToolRole::cutting) cutter.push_back(std::move(piece));
  std::vector<Piece> pieces;
  std::vector<Stroke> strokes;
  const auto pose = [&](const Vec3& tip, const Vec3& axis) { return ToolPose{plane.out_of(tip), plane.axes * axis}; };
  for (std::size_t k = 1; k < moves.size(); ++k) {
    const Move &last = moves[k - 1], &move = moves[k];
    if (move.rapid()) continue;
    const double length = length_between(last.to, move.to, move.bulge);
    const bool turns = (move.axis - last.axis).norm() > 1e-9;
    const bool descends = (last.to - move.to).dot(move.axis) > steep * length;
    const int count = turns ? 1 : std::max(1, static_cast<int>(std::ceil(length / step)));
    ToolPose from = pose(last.to, last.axis);
    for (int i = 1; i <= count; ++i) {
      const double share = static_cast<double>(i) / count;
      const ToolPose to = pose(place_between(last.to, move.to, move.bulge, share), move.axis);
      for (const ToolPiece& piece : cutter) strokes.push_back({&piece, from, to});
      pieces.push_back({k, share, length / count, descends});
      from = to;
    }
  }
  const std::vector<StrokeResult> removed = stock_.cut(strokes, progress);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = 0; j < cutter.size(); ++j)
      pieces[i].section += removed[i * cutter.size() + j].volume / std::max(pieces[i].length, 1e-9);
  return pieces;
}

std::vector<Move> MeasuredStock::adjust(const std::vector<Move>& moves, const Tool& tool, const Plane& plane,
                                        double width, const FeedLimits& limits, FeedReport& report,
                                        Progress& progress) {
  std::vector<Piece> pieces = measure(moves, tool, plane, progress);
  std::vector<std::pair<double, double>> sections;  // with the lengths along which they are met
  double way = 0;
  for (const Piece& piece : pieces)
    if (piece.section > air && !piece.descends) sections.emplace_back(piece.section, piece.length), way += piece.length;
  std::sort(sections.begin(), sections.end());
  report = {};
  for (double done = 0; const auto& [section, length] : sections) {
    report.usual = section;
    if ((done += length) >= 0.9 * way) break;
  }
  const double radius = tool.radius(), usual_width = std::clamp(width, 1e-6, 2 * radius);
  const auto wanted = [&](const Piece& piece) {
    if (piece.section <= air) return limits.most;
    if (piece.descends || report.usual <= 0) return 1.0;
    const double part = piece.section / report.usual;
    const double factor = part > 1 ? 1 / part : chip(usual_width, radius) / chip(part * usual_width, radius);
    return std::clamp(factor, limits.least, limits.most);
  };
  // A piece is as slow as its neighbours want: it begins before the material does, and measures are as coarse as
  // pieces.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Piece& piece = pieces[i];
    piece.factor = wanted(piece);
    if (i > 0 && pieces[i - 1].move + 1 >= piece.move) piece.factor = std::min(piece.factor, wanted(pieces[i - 1]));
    if (i + 1 < pieces.size() && pieces[i + 1].move <= piece.move + 1)
      piece.factor = std::min(piece.factor, wanted(pieces[i + 1]));
    if (piece.factor < limits.most)
      piece.factor =
          std::max(limits.least, std::pow(ladder, std::floor(std::log(piece.factor) / std::log(ladder) + 1e-9)));
    const double rate = moves[piece.move].feed * piece.section;
    report.rate_before = std::max(report.rate_before, rate);
    report.rate_after = std::max(report.rate_after, rate * piece.factor);
  }
  std::vector<Move> adjusted;
  std::size_t next = 0;
  for (std::size_t k = 0; k < moves.size(); ++k) {
    if (k == 0 || moves[k].rapid()) {
      adjusted.push_back(moves[k]);
      continue;
    }
    for (double begin = 0; next < pieces.size() && pieces[next].move == k;) {
      const double factor = pieces[next].factor;
      while (next + 1 < pieces.size() && pieces[next + 1].move == k && pieces[next + 1].factor == factor) ++next;
      const double end = pieces[next++].share;
      Move move = moves[k];
      move.to = end == 1 ? move.to : place_between(moves[k - 1].to, move.to, move.bulge, end);
      move.bulge = bulge_of(move.bulge, end - begin);
      move.feed *= factor;
      adjusted.push_back(move);
      begin = end;
    }
  }
  return adjusted;
}

}  // namespace fieldfab::cam
