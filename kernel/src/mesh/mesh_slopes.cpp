// No distance changes by more than the way: what is known without a look at the triangles. Two looks tell more.
//
// Off the surface the nearest place is on one of the triangles that can be nearest somewhere in the ball, and the gradient points
// away from it (slope_away_from()).
//
// At the surface the normals of these triangles bound the gradient (NormalCone), if the mesh is there the boundary of a solid,
// which a mesh with overlaps need not be. It is, if in a cylinder about the ball
//   - all triangles face the same way, along the cylinder's axis, so that the winding number falls by 1 at each on the way along,
//   - no triangle meets the cylinder's ends, and the number at one end is 1 more than at the other, and one of the two is 0:
// each line along the axis then passes the surface once, from the inside to the outside or back.
#include "mesh_slopes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "fieldfab/field/distance_slopes.h"

namespace fieldfab {
namespace {

constexpr std::size_t most_triangles = 512;
constexpr double steepest_face = 0.3;  // cosine of the angle between a face's normal and the axis, at least

class MeshSlopes {
 public:
  MeshSlopes(const TriangleTree& tree, const Windings& windings, const DistanceBall& ball)
      : tree_(tree), windings_(windings), ball_(ball), nearest_(std::abs(ball.distance) + 2 * ball.reach) {
    nearest_ += 1e-9 * (nearest_ + ball.centre.cwiseAbs().maxCoeff());
  }

  void run(std::span<const Vec3> directions, std::span<Interval> out) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const auto steepest = static_cast<float>(directions[i].norm());
      out[i] = {-steepest, steepest, false};
    }
    if (!tree_.within(ball_.centre, nearest_, most_triangles, near_)) return;
    for (const std::uint32_t triangle : near_) add_normal(triangle);
    const double away = std::abs(ball_.distance) - ball_.reach;
    if (away > 0) look_from_afar(directions, out);
    constexpr double far = 2;  // in radii: there the way tells enough
    if (away > far * ball_.reach) return;
    if (const std::optional<double> side = side_of_normals())
      for (std::size_t i = 0; i < directions.size(); ++i) out[i] = common(out[i], cone_->along(*side * directions[i]));
  }

 private:
  [[nodiscard]] Vec3 normal_of(std::uint32_t triangle) const {
    const auto& [a, b, c] = tree_.corners(triangle);
    return (b - a).cross(c - a).normalized();  // 0 where it has no area
  }

  void add_normal(std::uint32_t triangle) {
    const Vec3 normal = normal_of(triangle);
    if (normal.squaredNorm() > 0.5) normals_.push_back(normal);
  }

  void look_from_afar(std::span<const Vec3> directions, std::span<Interval> out) const {
    const double side = ball_.distance < 0 ? -1 : 1;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      std::optional<Interval> all;
      for (const std::uint32_t triangle : near_) {
        const auto& [a, b, c] = tree_.corners(triangle);
        const Vec3 way = ball_.centre - nearest_place(ball_.centre, a, b, c);
        const bool face = shadow_is_within(a, b, c);
        const Interval one = slope_away_from(side * way, face ? 0 : ball_.reach, directions[i]);
        all = all ? Interval{std::min(all->lower, one.lower), std::max(all->upper, one.upper), false} : one;
      }
      if (all) out[i] = common(out[i], *all);
    }
  }

  /// Whether the whole ball lies above or below a triangle: then the way is along its normal.
  [[nodiscard]] bool shadow_is_within(const Vec3& a, const Vec3& b, const Vec3& c) const {
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const auto clears = [&](const Vec3& from, const Vec3& to) {
      return normal.cross((to - from).normalized()).dot(ball_.centre - from) > ball_.reach;
    };
    return clears(a, b) && clears(b, c) && clears(c, a);
  }

  /// 1 where the normals of all that is near point from the inside to the outside, -1 where they all point back, if it is known.
  std::optional<double> side_of_normals() {
    if (normals_.empty()) return {};
    cone_.emplace(normals_);
    if (!(cone_->cosine() > steepest_face)) return {};
    // A low cylinder meets fewer other faces, a high one holds all of a surface that is no steeper than those that are near.
    const double cosine = cone_->cosine(), tangent = std::sqrt(1 - cosine * cosine) / cosine, radius = 1.001 * nearest_;
    for (const double rise : {0.05, 1.05, 2.05}) {
      if (const std::optional<double> side = side_in(radius, radius * (1 + rise * tangent))) return side;
      if (tangent < 0.1) break;
    }
    return {};
  }
  std::optional<double> side_in(double radius, double half_height) {
    const double around = std::hypot(radius, half_height);
    if (!windings_.tell_sides(ball_.centre, around)) return {};
    wide_.clear();
    if (!tree_.within(ball_.centre, around, most_triangles, wide_)) return {};
    for (const std::uint32_t triangle : wide_) {
      const Vec3 normal = normal_of(triangle);
      if (normal.squaredNorm() > 0.5 && !(normal.dot(cone_->axis()) > 0.01)) return {};
      if (meets_end(triangle, half_height, radius) || meets_end(triangle, -half_height, radius)) return {};
    }
    const Vec3 up = half_height * cone_->axis();
    const int below = windings_.number(ball_.centre - up), above = windings_.number(ball_.centre + up);
    if (below == 1 && above == 0) return 1;
    if (below == 0 && above == -1) return -1;
    return {};
  }

  /// Whether a triangle meets the disc about the axis at some height over the centre.
  [[nodiscard]] bool meets_end(std::uint32_t triangle, double height, double radius) const {
    const auto& corners = tree_.corners(triangle);
    const Vec3 middle = ball_.centre + height * cone_->axis();
    std::array<double, 3> over;
    for (std::size_t i = 0; i < 3; ++i) over[i] = (corners[i] - middle).dot(cone_->axis());
    // It meets the disc's plane in a line from one of its edges to another.
    std::array<Vec3, 3> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if ((over[i] <= 0) == (over[next] <= 0)) continue;
      ends[count++] = corners[i] + over[i] / (over[i] - over[next]) * (corners[next] - corners[i]) - middle;
    }
    if (count < 2) return false;
    const Vec3 along = ends[1] - ends[0];
    const double square = along.squaredNorm();
    const double at = square > 0 ? std::clamp(-ends[0].dot(along) / square, 0.0, 1.0) : 0;
    return (ends[0] + at * along).norm() <= radius;
  }

  const TriangleTree& tree_;
  const Windings& windings_;
  DistanceBall ball_;
  double nearest_;  ///< mm from the centre: nowhere in the ball is the nearest place farther off
  std::vector<std::uint32_t> near_, wide_;
  std::vector<Vec3> normals_;
  std::optional<NormalCone> cone_;
};

}  // namespace

void mesh_slopes(const TriangleTree& tree, const Windings& windings, const DistanceBall& ball, std::span<const Vec3> directions,
                 std::span<Interval> out) {
  MeshSlopes(tree, windings, ball).run(directions, out);
}

}  // namespace fieldfab
