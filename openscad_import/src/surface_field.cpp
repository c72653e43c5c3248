#include "surface_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "fieldfab/field/distance_slopes.h"

namespace fieldfab::openscad {
namespace {

constexpr std::uint32_t most_triangles_in_group = 4;

using EdgeKey = std::pair<std::uint32_t, std::uint32_t>;
EdgeKey edge_key(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// A triangle with the outward normals of its face, its edges (ab, bc, ca) and its corners.
struct Facet {
  Vec3 a, b, c;
  std::array<Vec3, 7> normals;
};

/// Result of a search: square of the distance, vector from the nearest point, and the facet with
/// its normal there.
struct Found {
  double square = std::numeric_limits<double>::infinity();
  Vec3 to = Vec3::Zero();
  const Facet* facet = nullptr;
  std::size_t normal = 0;
};

/// Finds the nearest point of a triangle, by the Voronoi region of its features that contains the
/// point (Ericson 2005, 5.1.5).
void look(const Facet& f, const Vec3& p, Found& best) {
  const Vec3 ap = p - f.a;
  const double height = f.normals[0].dot(ap);
  if (height * height * (1 - 1e-9) > best.square) return;  // its plane is farther away
  const Vec3 ab = f.b - f.a, ac = f.c - f.a;
  const auto offer = [&](const Vec3& to, std::size_t normal) {
    const double square = to.squaredNorm();
    if (square < best.square) best = {square, to, &f, normal};
  };
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return offer(ap, 4);
  const Vec3 bp = p - f.b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return offer(bp, 5);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return offer(ap - ab * (d1 / (d1 - d3)), 1);
  const Vec3 cp = p - f.c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return offer(cp, 6);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return offer(ap - ac * (d2 / (d2 - d6)), 3);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return offer(bp - (f.c - f.b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))), 2);
  if (height * height < best.square) best = {height * height, height * f.normals[0], &f, 0};
}

using Facets = std::shared_ptr<const std::vector<Facet>>;

class SurfaceField final : public Field {
 public:
  SurfaceField(Facets facets, std::vector<std::uint32_t> kept, double growth)
      : facets_(std::move(facets)), kept_(std::move(kept)), growth_(growth) {
    groups_.reserve(kept_.size());
    divide(0, static_cast<std::uint32_t>(kept_.size()));
  }

  void values(const Points& points, float* out) const noexcept override {
    const Facet* last = nullptr;
    for (std::size_t i = 0; i < points.count; ++i) {
      const Vec3 p(points.x[i], points.y[i], points.z[i]);
      out[i] = std::numeric_limits<float>::quiet_NaN();
      if (!p.allFinite()) continue;
      const Found found = nearest(p, last);
      last = found.facet;
      out[i] = static_cast<float>(signed_distance(found) - growth_);
    }
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    const Facet* last = nullptr;
    for (std::size_t i = 0; i < points.count; ++i) {
      const Vec3 p(points.x[i], points.y[i], points.z[i]);
      if (!p.allFinite()) {
        out[i] = slopes.dx[i] = slopes.dy[i] = slopes.dz[i] = std::numeric_limits<float>::quiet_NaN();
        continue;
      }
      const Found found = nearest(p, last);
      last = found.facet;
      const double distance = signed_distance(found);
      // On the surface the vector from the nearest point is undefined; the normal of the face is
      // not.
      const Vec3 slope = std::abs(distance) > 1e-9 ? Vec3(found.to / distance) : found.facet->normals[0];
      out[i] = static_cast<float>(distance - growth_);
      slopes.dx[i] = static_cast<float>(slope.x());
      slopes.dy[i] = static_cast<float>(slope.y());
      slopes.dz[i] = static_cast<float>(slope.z());
    }
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    double distance = 0;
    return range(box, distance);
  }
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    std::fill_n(out.begin(), directions.size(), Interval::unknown());
    if (!box.valid()) return;
    const Vec3 centre = box.centre();
    const double distance = signed_distance(nearest(centre)), reach = 0.5 * box.diagonal() * (1 + 1e-9) + 1e-9;
    constexpr std::size_t many = 512;
    const std::vector<std::uint32_t> near = within(centre, (std::abs(distance) + 2 * reach) * (1 + 1e-9) + 1e-9);
    std::vector<Vec3> normals, ways;
    if (near.size() <= many)
      for (const std::uint32_t i : near) {
        Found one;
        look((*facets_)[i], centre, one);
        normals.push_back((*facets_)[i].normals[0]);
        ways.push_back(distance < 0 ? Vec3(-one.to) : one.to);
      }
    const NormalCone cone(normals);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const auto steepest = static_cast<float>(directions[i].norm());
      out[i] = {-steepest, steepest, false};
      if (normals.empty()) continue;
      out[i] = common(out[i], cone.along(directions[i]));
      if (std::abs(distance) <= reach) continue;
      Interval all = slope_away_from(ways[0], reach, directions[i]);
      for (const Vec3& way : ways) {
        const Interval one = slope_away_from(way, reach, directions[i]);
        all = {std::min(all.lower, one.lower), std::max(all.upper, one.upper), false};
      }
      out[i] = common(out[i], all);
    }
  }
  void restrict_all(std::span<const Box> boxes, Purpose, std::span<Restriction> out) const override {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      double distance = 0;
      out[i] = {range(boxes[i], distance), *this};
      if (!boxes[i].lower.allFinite() || !boxes[i].upper.allFinite()) continue;
      std::vector<std::uint32_t> near =
          within(boxes[i].centre(), (std::abs(distance) + boxes[i].diagonal()) * (1 + 1e-9) + 1e-9);
      if (near.size() < kept_.size()) out[i].field = std::make_shared<SurfaceField>(facets_, std::move(near), growth_);
    }
  }
  [[nodiscard]] std::size_t cost() const noexcept override { return 60 * std::min<std::size_t>(kept_.size(), 20); }

 private:
  struct Group {
    Vec3 lower, upper;
    std::uint32_t first, count, second;

    [[nodiscard]] double square_distance(const Vec3& p) const {
      return (lower - p).cwiseMax(p - upper).cwiseMax(0).squaredNorm();
    }
  };

  void divide(std::uint32_t first, std::uint32_t count) {
    const std::size_t here = groups_.size();
    const auto begin = kept_.begin() + first, end = begin + count;
    const Facet& one = (*facets_)[*begin];
    Group group{one.a, one.a, first, count, 0};
    for (auto i = begin; i != end; ++i) {
      const Facet& f = (*facets_)[*i];
      group.lower = group.lower.cwiseMin(f.a).cwiseMin(f.b).cwiseMin(f.c);
      group.upper = group.upper.cwiseMax(f.a).cwiseMax(f.b).cwiseMax(f.c);
    }
    groups_.push_back(group);
    if (count <= most_triangles_in_group) return;
    Eigen::Index axis = 0;
    (group.upper - group.lower).maxCoeff(&axis);
    const auto middle = [&](std::uint32_t i) {
      const Facet& f = (*facets_)[i];
      return f.a[axis] + f.b[axis] + f.c[axis];
    };
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, end, [&](std::uint32_t a, std::uint32_t b) { return middle(a) < middle(b); });
    divide(first, half);
    groups_[here].second = static_cast<std::uint32_t>(groups_.size());
    divide(first + half, count - half);
  }

  /// Finds the nearest point. The facet nearest to another point, usually close to this one, prunes
  /// the search early. If several facets are equally near, `likely` decides between them; their
  /// normals at a common edge or corner are the same.
  [[nodiscard]] Found nearest(const Vec3& p, const Facet* likely = nullptr) const {
    Found best;
    if (likely != nullptr) look(*likely, p, best);
    std::array<std::pair<std::uint32_t, double>, 64> open;
    std::size_t count = 0;
    open[count++] = {0, 0};
    while (count > 0) {
      const auto [here, square] = open[--count];
      if (square > best.square) continue;
      const Group& group = groups_[here];
      if (group.second == 0) {
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) look((*facets_)[kept_[i]], p, best);
        continue;
      }
      const double one = groups_[here + 1].square_distance(p), two = groups_[group.second].square_distance(p);
      if (one <= two) {
        open[count++] = {group.second, two};
        open[count++] = {here + 1, one};
      } else {
        open[count++] = {here + 1, one};
        open[count++] = {group.second, two};
      }
    }
    return best;
  }
  static double signed_distance(const Found& found) {
    const double distance = std::sqrt(found.square);
    return found.to.dot(found.facet->normals[found.normal]) < 0 ? -distance : distance;
  }
  [[nodiscard]] std::vector<std::uint32_t> within(const Vec3& centre, double reach) const {
    std::vector<std::uint32_t> found, open{0};
    const double square = reach * reach;
    while (!open.empty()) {
      const std::uint32_t here = open.back();
      open.pop_back();
      const Group& group = groups_[here];
      if (group.square_distance(centre) > square) continue;
      if (group.second != 0) {
        open.push_back(group.second);
        open.push_back(here + 1);
        continue;
      }
      for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
        Found one;
        look((*facets_)[kept_[i]], centre, one);
        if (one.square <= square) found.push_back(kept_[i]);
      }
    }
    return found;
  }
  [[nodiscard]] Interval range(const Box& box, double& distance) const noexcept {
    if (!box.lower.allFinite() || !box.upper.allFinite()) return Interval::unknown();
    distance = signed_distance(nearest(box.centre()));
    const double reach = 0.5 * box.diagonal() * (1 + 1e-9) + 1e-9 + 1e-12 * std::abs(distance);
    return {static_cast<float>(distance - reach - growth_), static_cast<float>(distance + reach - growth_), false};
  }

  Facets facets_;
  std::vector<std::uint32_t> kept_;
  std::vector<Group> groups_;
  double growth_;
};

double angle_at(const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 u = q - p, v = r - p;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

bool is_closed(const Polyhedron& solid) {
  std::map<EdgeKey, std::pair<int, int>> passes;
  for (const Triangle& t : solid.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      auto& [there, back] = passes[edge_key(t[i], t[(i + 1) % 3])];
      ++(t[i] < t[(i + 1) % 3] ? there : back);
    }
  return std::all_of(passes.begin(), passes.end(), [](const auto& edge) { return edge.second == std::pair(1, 1); });
}

FieldPtr surface_field(const Polyhedron& solid, double growth) {
  std::map<EdgeKey, Vec3> edges;
  std::vector<Vec3> corners(solid.vertices.size(), Vec3::Zero()), faces;
  for (const Triangle& t : solid.triangles) {
    const Vec3 &a = solid.vertices[t[0]], &b = solid.vertices[t[1]], &c = solid.vertices[t[2]];
    faces.push_back((b - a).cross(c - a).normalized());  // 0 for a triangle without area
    for (std::size_t i = 0; i < 3; ++i) {
      edges.try_emplace(edge_key(t[i], t[(i + 1) % 3]), Vec3::Zero()).first->second += faces.back();
      corners[t[i]] +=
          faces.back() * angle_at(solid.vertices[t[i]], solid.vertices[t[(i + 1) % 3]], solid.vertices[t[(i + 2) % 3]]);
    }
  }
  auto facets = std::make_shared<std::vector<Facet>>();
  std::vector<std::uint32_t> all;
  for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
    const Triangle& t = solid.triangles[i];
    if (faces[i].squaredNorm() < 0.5) continue;
    facets->push_back({solid.vertices[t[0]],
                       solid.vertices[t[1]],
                       solid.vertices[t[2]],
                       {faces[i], edges[edge_key(t[0], t[1])], edges[edge_key(t[1], t[2])], edges[edge_key(t[2], t[0])],
                        corners[t[0]], corners[t[1]], corners[t[2]]}});
    all.push_back(static_cast<std::uint32_t>(all.size()));
  }
  return std::make_shared<SurfaceField>(std::move(facets), std::move(all), growth);
}

}  // namespace fieldfab::openscad
