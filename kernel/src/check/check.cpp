// check(): each figure and its bound; docs/checks.md says why each bound is what it is.
#include "fieldfab/check/check.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/mesh/contour.h"
#include "level_set.h"
#include "mesh_oracle.h"

namespace fieldfab {
namespace {

/// What the Field says of a point: inside or outside for sure, with no surface within `reach`, or nothing.
enum class Side { inside, outside, near_surface };

Side side_of(const Field& solid, const Vec3& p, double reach) {
  const Interval range = solid.interval({p.array() - reach, p.array() + reach});
  return range.inside() ? Side::inside : range.outside() ? Side::outside : Side::near_surface;
}

/// Half of the points anywhere in the region, half within a few voxels of the surface, where mistakes would be.
std::vector<Vec3> random_points(const Box& bounds, const TriangleMesh& mesh, const CheckSettings& settings) {
  std::mt19937 random(settings.seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < settings.samples; ++i) {
    const Vec3 r(unit(random), unit(random), unit(random));
    if (i % 2 == 0 || mesh.vertices.empty()) {
      points.push_back(bounds.lower + r.cwiseProduct(bounds.size()));
    } else {
      const auto& v = mesh.vertices[static_cast<std::size_t>(unit(random) * static_cast<double>(mesh.vertices.size() - 1))];
      points.push_back(Vec3(v[0], v[1], v[2]) + (r.array() - 0.5).matrix() * 8 * settings.voxel);
    }
  }
  return points;
}

class Checker {
 public:
  Checker(const Field& field, const Box& bounds, const CheckSettings& settings, Progress& progress)
      : solid_(intersect(field.shared_from_this(), box_field(bounds))), bounds_(bounds), settings_(settings), progress_(progress) {
    if (settings_.max_error < 0) settings_.max_error = settings_.voxel / 10;
  }

  CheckReport run() {
    mesh_ = contour(*solid_, bounds_, {settings_.voxel, settings_.max_error, true}, progress_);
    check_validity();
    points_ = random_points(bounds_, mesh_, settings_);
    check_asdf();
    if (report_.passed() && !mesh_.triangles.empty()) check_sides();
    check_level_set();
    return std::move(report_);
  }

 private:
  void row(std::string name, double measured, double bound, std::string unit = "") { report_.rows.push_back({std::move(name), measured, bound, std::move(unit)}); }

  void check_validity() {
    progress_.check();
    progress_.report(0, "checking the mesh with CGAL");
    const MeshVerdict verdict = inspect(mesh_);
    valid_ = verdict.valid();
    row("mesh: not manifold (CGAL)", verdict.manifold ? 0 : 1, 0);
    row("mesh: not closed (CGAL)", verdict.closed ? 0 : 1, 0);
    row("mesh: not oriented outward (CGAL)", verdict.outward ? 0 : 1, 0);
    row("mesh: self-intersections (CGAL)", static_cast<double>(verdict.self_intersections), 0);
    row("mesh: degenerate triangles (CGAL)", static_cast<double>(verdict.degenerate), 0);
    row("mesh: volume against CGAL's", std::abs(mesh_.volume() - verdict.volume), 1e-6 * std::abs(verdict.volume), "mm3");
  }

  void check_asdf() {
    const auto asdf = Asdf::build(*solid_, bounds_, {settings_.voxel, settings_.max_error, true}, progress_);
    progress_.report(0, "checking the distance field");
    const AsdfStatistics counts = asdf->statistics();
    row("asdf: bytes a cell", static_cast<double>(counts.bytes) / static_cast<double>(counts.cells()), 24);
    // Within a voxel of a point lie all the samples that decide it.
    const double reach = asdf->voxel() + 2 * settings_.max_error;
    std::atomic<int> wrong{0}, astray{0};
    parallel_for(points_.size(), [&](std::size_t i) {
      if (i % 64 == 0) progress_.check();
      if (!bounds_.contains(points_[i])) return;
      const Side side = side_of(*solid_, points_[i], reach);
      if (side != Side::near_surface && (asdf->value(points_[i]) < 0) != (side == Side::inside)) ++wrong;
    });
    row("asdf: points on the wrong side, of those sure", wrong, 0);
    // The other way round: where the mesh says there is surface, the distance field must have some within two voxels.
    const std::size_t stride = std::max<std::size_t>(1, mesh_.vertices.size() / static_cast<std::size_t>(settings_.samples));
    const Box inner = bounds_.grown(-2.5 * asdf->voxel());
    parallel_for(mesh_.vertices.size() / stride, [&](std::size_t i) {
      if (i % 64 == 0) progress_.check();
      const auto& v = mesh_.vertices[i * stride];
      const Vec3 p(v[0], v[1], v[2]);
      if (inner.valid() && inner.contains(p) && side_of(*asdf, p, 2 * asdf->voxel()) != Side::near_surface) ++astray;
    });
    row("asdf: share of mesh vertices it has no surface near", mesh_.vertices.empty() ? 0 : 100.0 * astray / (static_cast<double>(mesh_.vertices.size()) / static_cast<double>(stride)), 1, "%");
  }

  void check_sides() {
    const MeshOracle oracle(mesh_);
    int wrong = 0;
    const double reach = settings_.voxel * 1.5;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i % 64 == 0) progress_.check();
      const Side side = side_of(*solid_, points_[i], reach);
      if (side != Side::near_surface && oracle.inside(points_[i]) != (side == Side::inside)) ++wrong;
    }
    row("mesh: points on the wrong side, of those sure (CGAL)", wrong, 0);
  }

  void check_level_set() {
    progress_.report(0, "checking against OpenVDB");
    const double voxel = settings_.voxel;
    const LevelSet level_set(*solid_, bounds_, voxel, progress_);
    const double area = mesh_.area(), volume = mesh_.volume();
    // Both stand for the same surface to a part of a voxel: so volumes differ by that part of area x voxel.
    row("volume against OpenVDB's level set", std::abs(level_set.volume() - volume), 0.25 * area * voxel, "mm3");
    row("area against OpenVDB's level set", std::abs(level_set.area() - area), 0.15 * area + 24 * voxel * voxel, "mm2");
    if (mesh_.triangles.empty() || level_set.empty() || !valid_) return;

    double sum = 0, farthest = 0;
    for (const auto& v : mesh_.vertices) {
      const double distance = std::abs(level_set.value({v[0], v[1], v[2]}));
      sum += distance;
      farthest = std::max(farthest, distance);
    }
    row("mesh vertices to OpenVDB's surface, mean", sum / static_cast<double>(mesh_.vertices.size()) / voxel, 0.35, "vox");
    row("mesh vertices to OpenVDB's surface, farthest", farthest / voxel, 3, "vox");

    const MeshOracle oracle(mesh_);
    const std::vector<Vec3> points = level_set.surface_points();
    const std::size_t stride = std::max<std::size_t>(1, points.size() / 50000);
    sum = farthest = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); i += stride, ++count) {
      if (count % 64 == 0) progress_.check();
      const double distance = oracle.distance(points[i]);
      sum += distance;
      farthest = std::max(farthest, distance);
    }
    row("OpenVDB's surface to the mesh, mean", count > 0 ? sum / static_cast<double>(count) / voxel : 0, 0.35, "vox");
    row("OpenVDB's surface to the mesh, farthest", farthest / voxel, 3, "vox");
  }

  FieldPtr solid_;
  Box bounds_;
  CheckSettings settings_;
  Progress& progress_;
  TriangleMesh mesh_;
  bool valid_ = false;
  std::vector<Vec3> points_;
  CheckReport report_;
};

}  // namespace

bool CheckReport::passed() const {
  return std::all_of(rows.begin(), rows.end(), [](const CheckRow& row) { return row.passed(); });
}

CheckReport check(const Field& field, const Box& bounds, const CheckSettings& settings, Progress& progress) {
  return Checker(field, bounds, settings, progress).run();
}

}  // namespace fieldfab
