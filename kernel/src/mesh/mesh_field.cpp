#include "fieldfab/mesh/mesh_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fieldfab/core/error.h"
#include "triangle_tree.h"
#include "winding.h"

namespace fieldfab {
namespace {

/// Whether each edge is passed as often in one direction as in the other.
bool is_closed(const TriangleMesh& mesh) {
  std::vector<std::uint64_t> passes;  // from and to, the smaller first; the lowest bit tells the direction
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = t[i], b = t[(i + 1) % 3];
      passes.push_back((std::min(a, b) << 32U | std::max(a, b)) << 1U | static_cast<std::uint64_t>(a < b));
    }
  std::sort(passes.begin(), passes.end());
  int balance = 0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    balance += (passes[i] & 1U) != 0 ? 1 : -1;
    if (i + 1 < passes.size() && passes[i] >> 1U == passes[i + 1] >> 1U) continue;
    if (balance != 0) return false;
  }
  return true;
}

/// Triangles without area have no plane to look for the nearest place in; their edges belong to others.
TriangleMesh with_areas(const TriangleMesh& mesh) {
  TriangleMesh rest{mesh.vertices, {}};
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](std::size_t i) {
      const auto& p = mesh.vertices[t[i]];
      return Vec3(p[0], p[1], p[2]);
    };
    if ((corner(1) - corner(0)).cross(corner(2) - corner(0)).squaredNorm() > 0) rest.triangles.push_back(t);
  }
  if (rest.triangles.empty()) throw Error(ErrorKind::bad_input, "mesh", "has no triangle with an area");
  return rest;
}

/// What was found at a point.
struct Look {
  Vec3 point = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  TriangleTree::Place nearest;
  double distance = 0;  ///< negative inside
};

class MeshField final : public Field {
 public:
  MeshField(const TriangleMesh& mesh, Progress& progress) : mesh_(mesh), closed_(is_closed(mesh)), tree_(with_areas(mesh)) {
    progress.report(0.5, "sorting triangles");
    if (!closed_) winding_.emplace(mesh);
    progress.check();
    bounds_ = mesh_.bounds();
    touching_ = 1e-6 * bounds_.diagonal();
  }

  [[nodiscard]] const TriangleMesh* closed_mesh() const { return closed_ ? &mesh_ : nullptr; }

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

  /// No value differs from that in the middle by more than the way there; but at a hole's virtual lid it changes its sign.
  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    if (!box.lower.allFinite() || !box.upper.allFinite())
      return {-static_cast<float>(bounds_.diagonal()), std::numeric_limits<float>::infinity(), true};
    const Vec3 centre = box.centre();
    const double away = std::abs(look(centre).distance);
    const double reach = 0.5 * box.diagonal() * (1 + 1e-6) + 1e-6 * (centre.cwiseAbs().maxCoeff() + away);
    const auto least = static_cast<float>((away - reach) * (1 - 1e-6)), most = static_cast<float>((away + reach) * (1 + 1e-6));
    if (!(least > 0)) return {-most, most, false};
    if (!closed_ && !(std::abs(std::abs(winding_->at(centre)) - 0.5) > 0.03 + reach * winding_->steepest(centre, reach)))
      return {-most, most, false};
    return is_inside(centre) ? Interval{-most, -least, false} : Interval{least, most, false};
  }
  [[nodiscard]] Box known_bounds() const noexcept override { return bounds_; }
  [[nodiscard]] std::size_t cost() const noexcept override { return 1000; }

 private:
  /// Looks at a point, from what was found at another, near it as a rule.
  [[nodiscard]] Look look(const Vec3& p, const Look& last = {}) const {
    if (!p.allFinite()) return {last.point, last.nearest, std::numeric_limits<double>::quiet_NaN()};
    const TriangleTree::Place nearest = tree_.nearest(p, last.nearest.triangle);
    // On the way no triangle of a closed mesh was met if there is none as near: the side is the same.
    const bool same_side = closed_ && (p - last.point).norm() < 0.999999 * std::abs(last.distance);  // not after NaN
    const bool inside = same_side ? last.distance < 0 : is_inside(p);
    return {p, nearest, (inside ? -1 : 1) * (p - nearest.at).norm()};
  }

  [[nodiscard]] bool is_inside(const Vec3& p) const { return closed_ ? tree_.winding(p) != 0 : std::abs(winding_->at(p)) > 0.5; }

  /// The normal of the nearest triangle, towards the outside: what way a point lies from where it is itself cannot be told.
  [[nodiscard]] Vec3 outward_at(const Look& look) const {
    const auto& [a, b, c] = tree_.corners(look.nearest.triangle);
    const Vec3 outward = (b - a).cross(c - a).normalized();
    return is_inside(look.point + 10 * touching_ * outward) ? Vec3(-outward) : outward;
  }

  TriangleMesh mesh_;
  bool closed_;
  TriangleTree tree_;
  std::optional<WindingNumber> winding_;  ///< of an open mesh
  Box bounds_;
  double touching_ = 0;  ///< mm; what is as near to a triangle is on it
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
  return std::make_shared<MeshField>(mesh, progress);
}

}  // namespace fieldfab
