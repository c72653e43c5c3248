#include "fieldfab/mesh/mesh_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

#include "fieldfab/core/error.h"
#include "fieldfab/mesh/exact_solid.h"
#include "fieldfab/mesh/mesh_distances.h"
#include "triangle_tree.h"
#include "winding.h"

namespace fieldfab {
namespace {

bool has_area(const TriangleMesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    const auto corner = [&](std::size_t i) {
      const auto& p = mesh.vertices[t[i]];
      return Vec3(p[0], p[1], p[2]);
    };
    return (corner(1) - corner(0)).cross(corner(2) - corner(0)).squaredNorm() > 0;
  });
}

/// Decides whether a point is inside: whether the magnitude of the winding number exceeds 1/2. The
/// number is that of the mesh with lids, an integer found by ray casting, minus that of the lids,
/// which are few. For a soup of pieces it is a sum over all triangles.
class Inside {
 public:
  Inside(const TriangleMesh& mesh, const TriangleTree& tree) : tree_(tree), middle_(mesh.bounds().centre().z()) {
    const Lids lids = lids_of(mesh);
    if (lids.triangles.empty()) return;
    number_.emplace(mesh);
    if (lids.triangles.size() > mesh.triangles.size() / 2) return;
    TriangleMesh alone{mesh.vertices, lids.triangles};
    alone.vertices.insert(alone.vertices.end(), lids.middles.begin(), lids.middles.end());
    lids_.emplace(Lid{TriangleTree(alone), WindingNumber(alone)});
  }

  [[nodiscard]] bool closed() const { return !number_; }
  [[nodiscard]] bool at(const Vec3& p) const { return std::abs(number(p)) > 0.5; }
  /// Whether all points within `reach`, which contains no triangle, are on the same side.
  [[nodiscard]] bool same_within(const Vec3& p, double reach) const {
    constexpr double rounding = 0.03;  // error of winding numbers, in which groups of triangles count as one
    return closed() || std::abs(std::abs(number(p)) - 0.5) > rounding + reach * number_->steepest(p, reach);
  }

 private:
  struct Lid {
    TriangleTree tree;
    WindingNumber number;
  };
  [[nodiscard]] double number(const Vec3& p) const {
    if (number_ && !lids_) return number_->at(p);
    const bool from_above = p.z() > middle_;  // the shorter way
    const int turns = tree_.turns(p, from_above);
    return lids_ ? turns + lids_->tree.turns(p, from_above) - lids_->number.at(p) : turns;
  }

  const TriangleTree& tree_;
  double middle_;
  std::optional<WindingNumber> number_;  ///< of an open mesh
  std::optional<Lid> lids_;
};

/// Result of a search at a point.
struct Look {
  Vec3 point = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  TriangleTree::Place nearest;
  double distance = 0;  ///< negative inside
};

class MeshField final : public Field {
 public:
  explicit MeshField(const TriangleMesh& mesh)
      : mesh_(mesh),
        tree_(mesh_),
        inside_(mesh_, tree_),
        bounds_(mesh_.bounds()),
        touching_(1e-6 * bounds_.diagonal()) {}

  [[nodiscard]] const TriangleMesh* closed_mesh() const { return inside_.closed() ? &mesh_ : nullptr; }

  void values(const Points& points, float* out) const noexcept override {
    Look last;
    for (std::size_t i = 0; i < points.count; ++i) {
      last = look({points.x[i], points.y[i], points.z[i]}, last);
      out[i] = static_cast<float>(last.distance);
    }
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    Look last;
    for (std::size_t i = 0; i < points.count; ++i) {
      last = look({points.x[i], points.y[i], points.z[i]}, last);
      const bool on_surface = std::abs(last.distance) < touching_;
      const Vec3 slope = on_surface ? outward_at(last) : Vec3((last.point - last.nearest.at) / last.distance);
      out[i] = static_cast<float>(last.distance);
      slopes.dx[i] = static_cast<float>(slope.x());
      slopes.dy[i] = static_cast<float>(slope.y());
      slopes.dz[i] = static_cast<float>(slope.z());
    }
  }

  /// Values change by at most the distance from the middle, except at the virtual lid of a hole,
  /// where the sign changes. Beyond the bounds of a closed mesh each value is at least the distance
  /// to them, however long the box is.
  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    const Vec3 apart = (box.lower - bounds_.upper).cwiseMax(bounds_.lower - box.upper).cwiseMax(0);
    const float beyond = inside_.closed() ? static_cast<float>(apart.norm() * (1 - 1e-6)) : 0;
    if (!box.lower.allFinite() || !box.upper.allFinite())
      return {beyond > 0 ? beyond : -static_cast<float>(bounds_.diagonal()), std::numeric_limits<float>::infinity(),
              true};
    const Vec3 centre = box.centre();
    const double away = std::abs(look(centre).distance);
    const double reach = 0.5 * box.diagonal() * (1 + 1e-6) + 1e-6 * (centre.cwiseAbs().maxCoeff() + away);
    const auto least = static_cast<float>((away - reach) * (1 - 1e-6)),
               most = static_cast<float>((away + reach) * (1 + 1e-6));
    if (beyond > 0) return {std::max(least, beyond), most, false};
    if (!(least > 0)) {
      const double margin = slack(box);
      if (!inside_.closed() || any_in(box.grown(margin))) return {-most, most, false};
      const auto nearest = static_cast<float>(margin / 2);
      return inside_.at(centre) ? Interval{-most, -nearest, false} : Interval{nearest, most, false};
    }
    if (!inside_.same_within(centre, reach)) return {-most, most, false};
    return inside_.at(centre) ? Interval{-most, -least, false} : Interval{least, most, false};
  }
  /// If triangles neither intersect nor touch each other, a line leaves the solid at each triangle
  /// that faces along it, and enters it at all others.
  [[nodiscard]] bool faceted() const noexcept override {
    std::call_once(looked_, [&] { simple_ = inside_.closed() && bounds_a_solid(to_polyhedron(mesh_)); });
    return simple_;
  }
  bool facing(const Box& box, std::vector<Eigen::Vector3f>& directions) const noexcept override {
    if (!faceted()) return false;
    constexpr std::size_t few = 256;
    const std::size_t first = directions.size();
    bool one_way = true;
    tree_.visit_in(box.grown(slack(box)), [&](std::uint32_t triangle) {
      const auto& [a, b, c] = tree_.corners(triangle);
      const Vec3 across = (b - a).cross(c - a);
      if (!(across.squaredNorm() > 0)) return true;  // its edges belong to other triangles, too
      const Eigen::Vector3f normal = across.normalized().cast<float>();
      for (std::size_t i = directions.size(); i-- > first;) {
        if (directions[i] == normal) return true;
        constexpr float opposite = -0.999F;
        if (directions[i].dot(normal) < opposite) one_way = false;
      }
      directions.push_back(normal);
      return one_way && directions.size() < first + few;
    });
    return one_way && directions.size() < first + few;
  }
  [[nodiscard]] Box known_bounds() const noexcept override { return bounds_; }
  [[nodiscard]] std::size_t cost() const noexcept override { return 1000; }

 private:
  /// Tolerance for triangles beside a box that count as inside, mm, for rounding.
  [[nodiscard]] double slack(const Box& box) const {
    return 1e-6 * (bounds_.diagonal() + box.lower.cwiseAbs().maxCoeff() + box.upper.cwiseAbs().maxCoeff());
  }
  [[nodiscard]] bool any_in(const Box& box) const {
    bool any = false;
    tree_.visit_in(box, [&](std::uint32_t) {
      any = true;
      return false;
    });
    return any;
  }

  /// Finds the nearest triangle and the distance, starting from the result for another point that
  /// is usually near.
  [[nodiscard]] Look look(const Vec3& p, const Look& last = {}) const {
    if (!p.allFinite()) return {last.point, last.nearest, std::numeric_limits<double>::quiet_NaN()};
    const TriangleTree::Place nearest = tree_.nearest(p, last.nearest.triangle);
    // No triangle of a closed mesh lies between the points if none is as near: the side is the
    // same. NaN in the last result gives false.
    const bool same_side = inside_.closed() && (p - last.point).norm() < 0.999999 * std::abs(last.distance);
    const bool inside = same_side ? last.distance < 0 : inside_.at(p);
    return {p, nearest, (inside ? -1 : 1) * (p - nearest.at).norm()};
  }

  /// Outward normal of the nearest triangle. For a point on the surface the direction from the
  /// nearest point is undefined.
  [[nodiscard]] Vec3 outward_at(const Look& look) const {
    const auto& [a, b, c] = tree_.corners(look.nearest.triangle);
    const Vec3 outward = (b - a).cross(c - a).normalized();
    return inside_.at(look.point + 10 * touching_ * outward) ? Vec3(-outward) : outward;
  }

  TriangleMesh mesh_;
  TriangleTree tree_;
  Inside inside_;
  Box bounds_;
  double touching_;  ///< mm; points that are as near to a triangle are on it
  mutable std::once_flag looked_;
  mutable bool simple_ = false;  ///< once looked_: closed, outward, and triangles meet only in common edges
};

}  // namespace

const TriangleMesh* closed_mesh_of(const Field& field) {
  const auto* const mesh = dynamic_cast<const MeshField*>(&field);
  return mesh != nullptr ? mesh->closed_mesh() : nullptr;
}

FieldPtr mesh_field(const TriangleMesh& mesh, Progress& progress) {
  if (mesh.triangles.empty()) throw Error(ErrorKind::bad_input, "mesh", "has no triangles");
  for (const auto& p : mesh.vertices)
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw Error(ErrorKind::bad_input, "mesh", "a vertex is not at a finite place");
  if (!has_area(mesh)) throw Error(ErrorKind::bad_input, "mesh", "has no triangle with an area");
  progress.report(0, "sorting triangles");
  progress.check();
  return std::make_shared<MeshField>(mesh);
}

}  // namespace fieldfab
