#include "edges.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace fieldfab::contouring {
namespace {

/// Points of a batch in the layout of Field.
struct Batch {
  explicit Batch(std::size_t count) : x(count), y(count), z(count), value(count) {}
  [[nodiscard]] Points points() const { return {x.data(), y.data(), z.data(), x.size()}; }
  std::vector<float>& along(int axis) { return axis == 0 ? x : axis == 1 ? y : z; }

  std::vector<float> x, y, z, value;
};

/// A part of an edge that contains its zero.
struct Bracket {
  double low, high;              // positions along the edge's axis, mm
  double low_value, high_value;  // of opposite sign
  int stuck = 0;                 // +1 or -1: the end that was kept the last time

  [[nodiscard]] double guess() const {
    const double t = low_value / (low_value - high_value);
    return t >= 0 && t <= 1 ? low + t * (high - low) : 0.5 * (low + high);  // bisection if a value is infinite or NaN
  }
};

/// Finds each zero between its two lattice points by regula falsi in the Illinois form. All edges advance in step, one
/// batch per round. Three other places find zeros in batches: raster.cpp, cam/plan/contour.cpp and
/// cam/stock/field_brick.cpp. They differ in precision, rounds and bisection, on which meshes, pictures and programs
/// depend to the last bit; so each has its own loop. This one works with doubles and stops at a tolerance of the value
/// or of the bracket.
void find_zeros(const Field& field, const std::vector<CrossedEdge>& edges, double close_enough, Batch& batch) {
  const std::size_t count = edges.size();
  std::vector<Bracket> brackets(count);
  for (std::size_t i = 0; i < count; ++i) {
    const CrossedEdge& edge = edges[i];
    brackets[i] = {edge.lower[edge.axis], edge.upper, edge.lower_value, edge.upper_value};
    batch.x[i] = edge.lower.x(), batch.y[i] = edge.lower.y(), batch.z[i] = edge.lower.z();
  }
  constexpr int rounds = 30;
  for (int round = 0; round < rounds; ++round) {
    // Regula falsi converges slowly if the slopes on both sides differ much; so every third round
    // bisects.
    const bool halve = round % 3 == 2;
    for (std::size_t i = 0; i < count; ++i)
      batch.along(edges[i].axis)[i] =
          static_cast<float>(halve ? 0.5 * (brackets[i].low + brackets[i].high) : brackets[i].guess());
    field.values(batch.points(), batch.value.data());
    bool settled = true;
    for (std::size_t i = 0; i < count; ++i) {
      Bracket& b = brackets[i];
      const double at = batch.along(edges[i].axis)[i], before = b.high - b.low;
      const double slope = std::abs(b.high_value - b.low_value) / before;
      const double value = batch.value[i];
      if ((value < 0) == (b.low_value < 0)) {
        b = {at, b.high, value, b.stuck < 0 ? 0.5 * b.high_value : b.high_value, -1};
      } else {
        b = {b.low, at, b.stuck > 0 ? 0.5 * b.low_value : b.low_value, value, 1};
      }
      settled = settled && (std::abs(value) <= slope * close_enough || b.high - b.low <= close_enough);
    }
    if (settled) break;
  }
  for (std::size_t i = 0; i < count; ++i) batch.along(edges[i].axis)[i] = static_cast<float>(brackets[i].guess());
}

}  // namespace

void locate_crossings(const Field& field, const std::vector<CrossedEdge>& edges, double side, double float_step,
                      std::vector<SurfacePoint>& points) {
  const std::size_t count = edges.size();
  points.resize(count);
  if (count == 0) return;
  Batch batch(count);
  find_zeros(field, edges, std::max(1e-6 * side, 4 * float_step), batch);
  std::vector<float> dx(count), dy(count), dz(count);
  field.gradients(batch.points(), batch.value.data(), {dx.data(), dy.data(), dz.data()});
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d slope(dx[i], dy[i], dz[i]);
    const double length = slope.norm();
    const bool usable = std::isfinite(length) && length > 0;
    points[i] = {{batch.x[i], batch.y[i], batch.z[i]},
                 usable ? Eigen::Vector3f((slope / length).cast<float>()) : Eigen::Vector3f::Zero()};
  }
}

}  // namespace fieldfab::contouring
