#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "deviation_gauge.h"

namespace fieldfab::cam {
namespace {

/// Farther than this is far, mm.
constexpr float far = 10;
/// Of a walk: how many steps, the longest one, and what is left when it has arrived, mm.
constexpr int steps = 8;
constexpr double longest_step = 2, arrived = 1e-5;
/// Gouges from this depth on are looked at twice, mm; and the rings in which that is done.
constexpr float doubted = 0.02F, narrowest = 0.005F, widest = 1;

/// Walks from points down a Field's slope to its surface: signed distances, exact where the Field is a distance, of second order
/// near the surface of any smooth one. Where values are no distances (fillets, noise between
/// samples) gouges are at most half as much too deep. `far` where no surface is found.
class Walks {
 public:
  Walks(const std::array<float, 3>* points, std::size_t count, float* distances)
      : points_(points), count_(count), distances_(distances), all_(count) {
    for (std::size_t i = 0; i < count; ++i) all_[i] = i;
  }

  void run(const Field& target) {
    // Most of a finished part is near: there, little of the target matters. What walks farther starts again.
    std::vector<std::size_t> far_ones;
    go(target, all_, 0.25, &far_ones);
    if (!far_ones.empty()) go(target, far_ones, steps * longest_step, nullptr);
    std::vector<std::size_t> doubtful;
    for (const std::size_t i : all_)
      if (distances_[i] < -doubted || (distances_[i] >= far && estimate_[i] < widest)) doubtful.push_back(i);
    look_around(target, std::move(doubtful));
  }

 private:
  [[nodiscard]] Vec3 place(std::size_t i) const { return {points_[i][0], points_[i][1], points_[i][2]}; }

  [[nodiscard]] double walked(std::size_t i) const {
    return (at_.col(static_cast<Eigen::Index>(i)).cast<double>() - place(i)).norm();
  }

  /// The points that leave their neighbourhood go to `leavers`, where there are such.
  void go(const Field& target, std::vector<std::size_t> points, double reach, std::vector<std::size_t>* leavers) {
    Box box{place(points[0]), place(points[0])};
    for (const std::size_t i : points) box = hull(box, {place(i), place(i)});
    const Restriction here = target.restricted(box.grown(reach + 0.01));
    std::vector<float> first(count_), across(count_, far);
    for (const std::size_t i : points) at_.col(i) = place(i).cast<float>();
    for (int step = 0; step < steps && !points.empty(); ++step) {
      const std::size_t n = points.size();
      for (std::size_t k = 0; k < n; ++k) x_[k] = at_(0, points[k]), y_[k] = at_(1, points[k]), z_[k] = at_(2, points[k]);
      here.field->gradients({x_.data(), y_.data(), z_.data(), n}, value_.data(), {dx_.data(), dy_.data(), dz_.data()});
      std::size_t on_the_way = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = points[k];
        if (step == 0) first[i] = value_[k];
        // Where a walk goes to and fro over the surface (noise between samples), the surface is no farther than that.
        if ((value_[k] < 0) != (first[i] < 0)) across[i] = std::min(across[i], static_cast<float>(walked(i)));
        const Vec3 slope(dx_[k], dy_[k], dz_[k]);
        const double steepness = slope.norm();
        const bool leads = steepness > 1e-9 && slope.allFinite() && std::isfinite(value_[k]);
        const double left = leads ? std::abs(value_[k]) / steepness : far;
        if (step == 0) estimate_[i] = std::min(left, std::abs(static_cast<double>(value_[k])));
        if (leads)
          at_.col(i) -= (slope * (std::clamp(value_[k] / steepness, -longest_step, longest_step) / steepness)).cast<float>();
        const double way = walked(i);
        if (leavers != nullptr && (way > reach || !leads)) {
          leavers->push_back(i);
          continue;
        }
        const float distance = left < 0.1 * way + 1e-3 ? std::min(static_cast<float>(way), across[i]) : across[i];
        distances_[i] = std::copysign(distance, first[i]);
        if (left > arrived && leads) points[on_the_way++] = i;
      }
      points.resize(on_the_way);
    }
  }

  /// For points that the slope says are near, whose walks have got lost: in which of ever wider rings there is a place of the
  /// other side.
  void look_around(const Field& target, std::vector<std::size_t> points) {
    for (float radius = narrowest; radius < widest && !points.empty(); radius *= 1.5F) {
      std::size_t left = 0;
      for (const std::size_t i : points) {
        if (std::abs(distances_[i]) <= radius) continue;
        if (passes_surface(target, i, radius))
          distances_[i] = std::copysign(radius, distances_[i]);
        else
          points[left++] = i;
      }
      points.resize(left);
    }
  }

  /// Whether any of 26 places around a point is on the other side of the surface.
  bool passes_surface(const Field& target, std::size_t i, float radius) {
    constexpr std::size_t around = 27;
    std::array<float, around> x, y, z, value;
    for (std::size_t k = 0; k < around; ++k) {
      const Eigen::Vector3f way(static_cast<float>(k % 3) - 1, static_cast<float>(k / 3 % 3) - 1, static_cast<float>(k / 9) - 1);
      const Eigen::Vector3f p = place(i).cast<float>() + (k == around / 2 ? way : way.normalized() * radius);
      x[k] = p.x(), y[k] = p.y(), z[k] = p.z();
    }
    target.values({x.data(), y.data(), z.data(), around}, value.data());
    return std::any_of(value.begin(), value.end(), [&](float v) { return (v < 0) != (value[around / 2] < 0); });
  }

  const std::array<float, 3>* points_;
  std::size_t count_;
  float* distances_;
  std::vector<std::size_t> all_;
  std::vector<double> estimate_ = std::vector<double>(count_);  ///< of each distance, at least
  Eigen::Matrix3Xf at_{3, static_cast<Eigen::Index>(count_)};
  std::vector<float> x_ = std::vector<float>(count_), y_ = x_, z_ = x_, value_ = x_, dx_ = x_, dy_ = x_, dz_ = x_;
};

}  // namespace

void DeviationGauge::measure(std::size_t piece, std::span<const SurfacePiece::Place> places) {
  std::vector<float>& at = at_[piece];
  const std::size_t first = at.size();
  at.resize(first + places.size());
  constexpr std::size_t block = 4096;
  for (std::size_t i = 0; i < places.size(); i += block)
    Walks(&places[i], std::min(block, places.size() - i), &at[first + i]).run(target_);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i][2] < floor_) at[first + i] = 0;
}

void DeviationGauge::look(std::size_t index, const SurfacePieces& pieces) {
  const SurfacePiece& piece = pieces[index];
  Sums& sums = sums_[index];
  for (std::uint32_t v = 0; v < piece.size(); ++v) {
    const Spot spot{at_[index][v], piece.cut(v), piece.place(v)};
    if (spot.deviation > sums.highest.deviation) sums.highest = spot;
    sums.deepest = std::max(sums.deepest, -spot.deviation);
    if (!(spot.deviation < -gouge_)) continue;
    const int line = line_of_cut_[std::min<std::size_t>(spot.cut, line_of_cut_.size() - 1)];
    if (line < 0) continue;
    const auto [found, fresh] = sums.gouges.try_emplace(line, spot);
    if (!fresh && spot.deviation < found->second.deviation) found->second = spot;
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

std::map<int, DeviationGauge::Spot> DeviationGauge::gouges() const {
  std::map<int, Spot> worst;
  for (const Sums& piece : sums_)
    for (const auto& [line, spot] : piece.gouges) {
      const auto [found, fresh] = worst.try_emplace(line, spot);
      if (!fresh && spot.deviation < found->second.deviation) found->second = spot;
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
