// check(): each figure and its bound; docs/checks.md gives the reasons for the bounds.
#include "fieldfab/check/check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <random>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/operations.h"
#include "level_set.h"
#include "mesh_oracle.h"

namespace fieldfab {
namespace {

/// Side of a point, proved by the Field's interval around it: inside, outside, or undecided within
/// `reach` of the point.
enum class Side { inside, outside, near_surface };

Side side_of(const Field& solid, const Vec3& p, double reach) {
  const Interval range = solid.interval({p.array() - reach, p.array() + reach});
  return range.inside() ? Side::inside : range.outside() ? Side::outside : Side::near_surface;
}

/// Returns half of the points anywhere in the region, and half within a few voxels of the surface,
/// where errors are likely.
std::vector<Vec3> random_points(const Box& bounds, const TriangleMesh& mesh, const CheckSettings& settings) {
  std::mt19937 random(settings.seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < settings.samples; ++i) {
    const Vec3 r(unit(random), unit(random), unit(random));
    if (i % 2 == 0 || mesh.vertices.empty()) {
      points.push_back(bounds.lower + r.cwiseProduct(bounds.size()));
    } else {
      const auto& v =
          mesh.vertices[static_cast<std::size_t>(unit(random) * static_cast<double>(mesh.vertices.size() - 1))];
      points.push_back(Vec3(v[0], v[1], v[2]) + (r.array() - 0.5).matrix() * 8 * settings.voxel);
    }
  }
  return points;
}

/// A box that the Field's interval proves to be inside or outside.
struct ProvedBox {
  Box box;
  bool inside;
};

/// Searches for the surface top-down, at random: divides a box, and continues with a random half
/// among those that the interval leaves undecided. So thin parts are found in proportion to their
/// area, not to their volume, and independently of any lattice. Returns the last proved boxes of
/// each search, next to the surface.
std::vector<ProvedBox> proved_boxes(const FieldPtr& solid, const Box& bounds, const CheckSettings& settings,
                                    Progress& progress) {
  constexpr std::size_t kept = 3;
  const double smallest = settings.voxel / 64;
  std::vector<std::vector<ProvedBox>> found(static_cast<std::size_t>(settings.searches));
  parallel_for(found.size(), [&](std::size_t i) {
    if (i % 16 == 0) progress.check();
    std::mt19937 random(settings.seed + 2 + static_cast<std::uint32_t>(i));
    Box box = bounds;
    FieldPtr here = solid;
    while (box.size().maxCoeff() > smallest) {
      Eigen::Index axis = 0;
      box.size().maxCoeff(&axis);
      std::array<Box, 2> halves{box, box};
      halves[0].upper[axis] = halves[1].lower[axis] = box.centre()[axis];
      std::array<Restriction, 2> parts;
      here->restrict_all(halves, Purpose::value, parts);
      for (std::size_t half = 0; half < 2; ++half)
        if (parts[half].range.decided()) found[i].push_back({halves[half], parts[half].range.inside()});
      if (parts[0].range.decided() && parts[1].range.decided()) break;
      const std::size_t next = parts[0].range.decided() ? 1 : parts[1].range.decided() ? 0 : random() % 2;
      box = halves[next];
      here = parts[next].field;
    }
    if (found[i].size() > kept) found[i].erase(found[i].begin(), found[i].end() - kept);
  });
  std::vector<ProvedBox> all;
  for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

/// Returns points distributed evenly over the mesh's area.
std::vector<Vec3> surface_points(const TriangleMesh& mesh, const CheckSettings& settings) {
  std::vector<double> area_up_to;
  double total = 0;
  const auto corner = [&](const std::array<std::uint32_t, 3>& t, std::size_t i) {
    const auto& p = mesh.vertices[t[i]];
    return Vec3(p[0], p[1], p[2]);
  };
  for (const auto& t : mesh.triangles) {
    total += (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm();
    area_up_to.push_back(total);
  }
  std::mt19937 random(settings.seed + 1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < settings.samples; ++i) {
    const auto at =
        std::lower_bound(area_up_to.begin(), area_up_to.end() - 1, total * unit(random)) - area_up_to.begin();
    const auto& t = mesh.triangles[static_cast<std::size_t>(at)];
    double u = unit(random), v = unit(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    points.push_back(corner(t, 0) + u * (corner(t, 1) - corner(t, 0)) + v * (corner(t, 2) - corner(t, 0)));
  }
  return points;
}

/// Total length of the edges whose two triangles meet at more than 30 degrees, mm.
double sharp_length(const TriangleMesh& mesh) {
  struct Half {
    std::uint64_t edge;
    std::uint32_t triangle;
  };
  const auto at = [&](std::uint32_t v) { return Vec3(mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]); };
  const auto normal = [&](std::uint32_t t) {
    const auto& v = mesh.triangles[t];
    return (at(v[1]) - at(v[0])).cross(at(v[2]) - at(v[0])).normalized().eval();
  };
  std::vector<Half> halves;
  halves.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      halves.push_back({std::min(a, b) << 32 | std::max(a, b), t});
    }
  std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) { return a.edge < b.edge; });
  double length = 0;
  for (std::size_t i = 0; i + 1 < halves.size(); ++i)
    if (halves[i].edge == halves[i + 1].edge && normal(halves[i].triangle).dot(normal(halves[i + 1].triangle)) < 0.866)
      length += (at(static_cast<std::uint32_t>(halves[i].edge >> 32)) - at(static_cast<std::uint32_t>(halves[i].edge)))
                    .norm();
  return length;
}

class Checker {
 public:
  Checker(const Field& field, const Box& bounds, const CheckSettings& settings, Progress& progress)
      : solid_(intersect(field.shared_from_this(), box_field(bounds))),
        has_features_(!field.sampled()),
        bounds_(bounds),
        settings_(settings),
        progress_(progress) {
    if (settings_.max_error < 0) settings_.max_error = settings_.voxel / 10;
  }

  CheckReport run() {
    ContourMesh made = contour(*solid_, bounds_, {settings_.voxel, settings_.max_error, has_features_}, progress_);
    report_.certainty = std::move(made.certainty);
    mesh_ = std::move(made);
    check_validity();
    points_ = random_points(bounds_, mesh_, settings_);
    if (!mesh_.triangles.empty()) surface_ = surface_points(mesh_, settings_);
    check_asdf();
    if (report_.passed() && !mesh_.triangles.empty()) check_sides();
    if (valid_) check_completeness();
    report_.measures = measure(*solid_, bounds_, {}, progress_);
    check_level_set();
    return std::move(report_);
  }

 private:
  void row(std::string name, double measured, double bound, std::string unit = "") {
    report_.rows.push_back({std::move(name), measured, bound, std::move(unit)});
  }

  /// Whether the solid and the space outside are about two voxels thick at a point of the surface:
  /// along the normal, and to at least one side along each direction across it. So edges and
  /// corners count as thick, ends of wires do not. Of thinner parts two lattices may each see or
  /// miss some, and both are right.
  [[nodiscard]] bool resolved(const Vec3& p) const {
    const Vec3 slope = solid_->gradient(p);
    const double length = slope.norm();
    if (!std::isfinite(length) || length == 0) return false;
    const Vec3 normal = slope / length, across = normal.unitOrthogonal(), third = normal.cross(across);
    std::array<float, 48> x, y, z, value;
    std::size_t count = 0;
    const auto add = [&](const Vec3& at) {
      x[count] = static_cast<float>(at.x()), y[count] = static_cast<float>(at.y()),
      z[count] = static_cast<float>(at.z());
      ++count;
    };
    const double voxel = settings_.voxel;
    constexpr int directions = 8;
    for (const double side : {-1.0, 1.0}) {
      for (const double t : {0.5, 1.0, 1.5, 2.0}) add(p + side * t * voxel * normal);
      for (int i = 0; i < 2 * directions; ++i) {
        const double angle = 3.14159265358979 * i / directions;
        add(p + voxel * (side * normal + 1.5 * (std::cos(angle) * across + std::sin(angle) * third)));
      }
    }
    solid_->values({x.data(), y.data(), z.data(), count}, value.data());
    for (std::size_t half = 0; half < 2; ++half) {
      const float* v = value.data() + half * count / 2;
      const auto right = [&](float f) { return (f < 0) == (half == 0); };
      for (std::size_t i = 0; i < 4; ++i)
        if (!right(v[i])) return false;
      for (std::size_t i = 4; i < 4 + directions; ++i)
        if (!right(v[i]) && !right(v[i + directions])) return false;
    }
    return true;
  }

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
    row("mesh: volume against CGAL's", std::abs(mesh_.volume() - verdict.volume), 1e-6 * std::abs(verdict.volume),
        "mm3");
  }

  void check_asdf() {
    const auto asdf = Asdf::build(*solid_, bounds_, {settings_.voxel, settings_.max_error, true}, progress_);
    progress_.report(0, "checking the distance field");
    const AsdfStatistics counts = asdf->statistics();
    row("asdf: bytes a cell", static_cast<double>(counts.bytes) / static_cast<double>(counts.cells()), 24);
    // All samples that decide a point are within a voxel of it.
    const double reach = asdf->voxel() + 2 * settings_.max_error;
    std::atomic<int> wrong{0}, astray{0};
    parallel_for(points_.size(), [&](std::size_t i) {
      if (i % 64 == 0) progress_.check();
      if (!bounds_.contains(points_[i])) return;
      const Side side = side_of(*solid_, points_[i], reach);
      if (side != Side::near_surface && (asdf->value(points_[i]) < 0) != (side == Side::inside)) ++wrong;
    });
    row("asdf: points on the wrong side, of those sure", wrong, 0);
    // The converse: near each point of the mesh's surface the distance field must have a surface
    // within two voxels.
    const Box inner = bounds_.grown(-2.5 * asdf->voxel());
    std::atomic<int> looked{0};
    parallel_for(surface_.size(), [&](std::size_t i) {
      if (i % 64 == 0) progress_.check();
      if (!inner.valid() || !inner.contains(surface_[i]) || !resolved(surface_[i])) return;
      ++looked;
      if (side_of(*asdf, surface_[i], 2 * asdf->voxel()) != Side::near_surface) ++astray;
    });
    row("asdf: share of the mesh it has no surface near", looked == 0 ? 0 : 100.0 * astray / looked, 0.1, "%");
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

  /// Space that is proved to be solid or empty, and more than a cell from the mesh's surface, must
  /// be so in the mesh.
  void check_completeness() {
    progress_.report(0, "searching for lost parts");
    std::optional<MeshOracle> oracle;
    if (!mesh_.triangles.empty()) oracle.emplace(mesh_);
    int lost = 0;
    for (const ProvedBox& proved : proved_boxes(solid_, bounds_, settings_, progress_)) {
      const Vec3 p = proved.box.centre();
      if (oracle ? oracle->inside(p) != proved.inside && oracle->distance(p) > settings_.voxel : proved.inside) ++lost;
    }
    row("mesh: places lost or filled, of those proved", lost, 0);
  }

  void check_level_set() {
    progress_.report(0, "checking against OpenVDB");
    const double voxel = settings_.voxel;
    const std::unique_ptr<LevelSet> level_set = LevelSet::of(*solid_, bounds_, voxel, progress_);
    const double area = mesh_.area(), volume = mesh_.volume();
    std::vector<Vec3> mine;
    for (std::size_t i = 0; i < surface_.size(); ++i) {
      if (i % 64 == 0) progress_.check();
      if (resolved(surface_[i])) mine.push_back(surface_[i]);
    }
    const double thin =
        surface_.empty() ? 0 : area * (1 - static_cast<double>(mine.size()) / static_cast<double>(surface_.size()));
    // Both represent the same surface within a fraction of a voxel. So volumes differ by that
    // fraction of area x voxel, and by more where the solid is thin.
    const Enclosed& proved = report_.measures.volume;
    row("volume beyond what its Field proves", std::max({0.0, proved.lower - volume, volume - proved.upper}),
        0.25 * area * voxel + thin * voxel, "mm3");
    row("volume against OpenVDB's level set", std::abs(level_set->volume() - volume),
        0.25 * area * voxel + thin * voxel, "mm3");
    // A level set rounds each sharp edge by about a voxel, and may miss thin parts.
    row("area against OpenVDB's level set", std::abs(level_set->area() - area),
        0.1 * area + 2 * voxel * sharp_length(mesh_) + thin, "mm2");
    if (mine.empty() || level_set->empty() || !valid_) return;

    double sum = 0, farthest = 0;
    for (const Vec3& p : mine) {
      const double distance = std::abs(level_set->value(p));
      sum += distance;
      farthest = std::max(farthest, distance);
    }
    row("mesh to OpenVDB's surface, mean", sum / static_cast<double>(mine.size()) / voxel, 0.35, "vox");
    row("mesh to OpenVDB's surface, farthest", farthest / voxel, 2, "vox");

    const MeshOracle oracle(mesh_);
    const std::vector<Vec3> theirs = level_set->surface_points();
    const std::size_t stride = std::max<std::size_t>(1, theirs.size() / 50000);
    sum = farthest = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < theirs.size(); i += stride) {
      if (i / stride % 64 == 0) progress_.check();
      if (!resolved(theirs[i])) continue;
      const double distance = oracle.distance(theirs[i]);
      sum += distance;
      farthest = std::max(farthest, distance);
      ++count;
    }
    row("OpenVDB's surface to the mesh, mean", count > 0 ? sum / static_cast<double>(count) / voxel : 0, 0.35, "vox");
    row("OpenVDB's surface to the mesh, farthest", farthest / voxel, 2, "vox");
  }

  FieldPtr solid_;
  bool has_features_;
  Box bounds_;
  CheckSettings settings_;
  Progress& progress_;
  TriangleMesh mesh_;
  bool valid_ = false;
  std::vector<Vec3> points_;   ///< anywhere
  std::vector<Vec3> surface_;  ///< on the mesh, evenly distributed
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
