#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "deviation_gauge.h"
#include "fieldfab/field/surface_distance.h"

namespace fieldfab::cam {
void DeviationGauge::measure(std::size_t piece, std::span<const SurfacePiece::Place> places) {
  const std::vector<float> more = distances(places);
  at_[piece].insert(at_[piece].end(), more.begin(), more.end());
}

std::vector<float> DeviationGauge::distances(std::span<const SurfacePiece::Place> places) const {
  std::vector<float> at(places.size());
  surface_distances(target_, places, at);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i][2] < floor_) at[i] = 0;
  return at;
}

void DeviationGauge::look(std::size_t index, const SurfacePieces& pieces) {
  const SurfacePiece& piece = pieces[index];
  Sums& sums = sums_[index];
  for (std::uint32_t v = 0; v < piece.size(); ++v) {
    const Spot spot{at_[index][v], piece.cut(v), piece.place(v)};
    if (spot.deviation > sums.highest.deviation) sums.highest = spot;
    sums.deepest = std::max(sums.deepest, -spot.deviation);
    if (!(spot.deviation < -gouge_)) continue;
    const Cut cut = cuts_[spot.cut];
    if (cut.by == CutBy::shank) continue;
    const Gouge gouge{spot, cut.move.line, cut.move.line};
    const auto [found, fresh] = sums.gouges.try_emplace(cut.move.pass, gouge);
    if (!fresh) found->second.add(gouge);
  }
  AreaHistogram areas;
  for (const auto& t : piece.corners) {
    std::array<Vec3, 3> p;
    double mean = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t owner = pieces.owner(index, t[i]);
      const std::uint32_t v = t[i] & SurfacePiece::own_part;
      const SurfacePiece::Place& place = pieces[owner].place(v);
      p[i] = {place[0], place[1], place[2]};
      mean += at_[owner][v] / 3.0;
    }
    const double area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
    sums.area += area, sums.sum += area * mean, sums.squares += area * mean * mean;
    areas.add(mean, area);
  }
  const std::scoped_lock alone(areas_alone_);
  areas_.add(areas);
}

Deviation DeviationGauge::result() const {
  Deviation result;
  Sums all;
  for (const Sums& piece : sums_) {
    all.area += piece.area, all.sum += piece.sum, all.squares += piece.squares;
    all.deepest = std::max(all.deepest, piece.deepest);
  }
  result.deepest = all.deepest, result.highest = std::max(highest().deviation, 0.0F);
  if (all.area > 0) result.mean = all.sum / all.area, result.root_mean_square = std::sqrt(all.squares / all.area);
  result.areas = areas_;
  return result;
}

void DeviationGauge::Gouge::add(const Gouge& other) {
  if (other.deepest.deviation < deepest.deviation) deepest = other.deepest;
  first_line = std::min(first_line, other.first_line), last_line = std::max(last_line, other.last_line);
}

std::map<std::uint32_t, DeviationGauge::Gouge> DeviationGauge::gouges() const {
  std::map<std::uint32_t, Gouge> worst;
  for (const Sums& piece : sums_)
    for (const auto& [pass, gouge] : piece.gouges) {
      const auto [found, fresh] = worst.try_emplace(pass, gouge);
      if (!fresh) found->second.add(gouge);
    }
  return worst;
}

DeviationGauge::Spot DeviationGauge::highest() const {
  Spot highest = Sums{}.highest;
  for (const Sums& piece : sums_)
    if (piece.highest.deviation > highest.deviation) highest = piece.highest;
  return highest;
}

}  // namespace fieldfab::cam
