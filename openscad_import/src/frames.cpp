#include "frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace fieldfab::openscad {
namespace {

/// The plane of some faces of a solid.
struct Face {
  Vec3 normal;
  double offset;  ///< mm, distance of the plane from the origin along its normal
  double area = 0;
  bool shared = false;  ///< whether another solid has faces in this plane
};
using Faces = std::vector<Face>;  // of one solid

Faces flat_faces(const Polyhedron& solid) {
  std::map<std::array<std::int64_t, 4>, Face> found;
  const double size = solid.bounds().diagonal();
  for (const Triangle& t : solid.triangles) {
    const Vec3& a = solid.vertices[t[0]];
    const Vec3 area = (solid.vertices[t[1]] - a).cross(solid.vertices[t[2]] - a);
    if (!(area.norm() > 0)) continue;
    const Vec3 normal = area.normalized();
    const double offset = normal.dot(a);
    const auto whole = [](double x) { return static_cast<std::int64_t>(std::llround(1e8 * x)); };
    const std::array key{whole(normal.x()), whole(normal.y()), whole(normal.z()), whole(offset / size)};
    found.try_emplace(key, Face{normal, offset}).first->second.area += area.norm();
  }
  Faces all;
  for (const auto& [key, face] : found) all.push_back(face);
  return all;
}

/// Marks planes that contain faces of another solid, of either orientation, within OpenSCAD's six
/// digits.
void mark_shared(std::vector<Faces>& solids, double farthest) {
  struct Seen {
    double number;  // hash of the plane: usually different for different planes
    Face* face;
    double side;  // 1 or -1: sign of its normal
    std::size_t solid;
  };
  constexpr double nearly = 1e-5;
  const Vec3 way(0.61803, 0.54931, 0.56226);
  std::vector<Seen> all;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (Face& face : solids[i]) {
      const double side = way.dot(face.normal) > 0 ? 1 : -1;
      all.push_back({side * (way.dot(face.normal) + face.offset / farthest), &face, side, i});
    }
  std::sort(all.begin(), all.end(), [](const Seen& a, const Seen& b) { return a.number < b.number; });
  for (auto a = all.begin(); a != all.end(); ++a)
    for (auto b = a + 1; b != all.end() && b->number - a->number < nearly; ++b)
      if (a->solid != b->solid && (a->side * a->face->normal - b->side * b->face->normal).norm() < nearly &&
          std::abs(a->side * a->face->offset - b->side * b->face->offset) < nearly * farthest) {
        a->face->shared = b->face->shared = true;
        break;
      }
}

/// Returns three axes, as rows, along normals of a solid's first faces. OpenSCAD writes rotations
/// with six digits, so the normals are only nearly perpendicular.
Eigen::Matrix3d axes_of(const Faces& faces) {
  const auto normal_across = [&](const Vec3& a, const Vec3& b, const Vec3& if_none) {
    constexpr double nearly = 1e-4;
    const auto face = std::find_if(faces.begin(), faces.end(), [&](const Face& other) {
      return std::abs(other.normal.dot(a)) < nearly && std::abs(other.normal.dot(b)) < nearly;
    });
    return face != faces.end() ? face->normal : if_none;
  };
  const Vec3 first = faces.front().normal, second = normal_across(first, first, first.unitOrthogonal());
  const Vec3 cross = first.cross(second).normalized(), third = normal_across(first, second, cross);
  Eigen::Matrix3d axes;
  axes << first.transpose(), second.transpose(), (third.dot(cross) > 0 ? third : Vec3(-third)).transpose();
  return axes;
}

/// Share of a solid's shared faces, weighted by area, that are perpendicular to one of the axes: 0
/// to 1; 0 without such faces.
double share_along(const Eigen::Matrix3d& axes, const Faces& faces) {
  constexpr double nearly = 1e-9;
  double along = 0, all = 0;
  for (const Face& face : faces) {
    if (!face.shared) continue;
    all += face.area * face.area;
    for (Eigen::Index i = 0; i < 3; ++i)
      if (axes.row(i).transpose().cross(face.normal).norm() < nearly) along += face.area * face.area;
  }
  return all > 0 ? along / all : 0;
}

/// Rounds a number that differs from a whole one only by rounding errors.
double without_rounding(double x) {
  constexpr double nearly = 1e-12;
  return std::abs(x - std::round(x)) < nearly ? std::round(x) : x;
}

}  // namespace

Frames::Frames() : axes_{Eigen::Matrix3d::Identity()} {}

Frames::Frames(const Part& part, double farthest) : Frames() {
  std::vector<const Part*> leafs;
  std::vector<Faces> faces;
  const std::function<void(const Part&)> visit = [&](const Part& here) {
    for (const PartPtr& child : here.children) visit(*child);
    if (here.leaf == nullptr) return;
    leafs.push_back(&here);
    faces.push_back(flat_faces(here.leaf->polyhedron()));
  };
  visit(part);
  mark_shared(faces, farthest);
  constexpr std::size_t most = 32;
  constexpr double as_good = 0.9;
  for (Faces& own : faces) {
    std::sort(own.begin(), own.end(),
              [](const Face& a, const Face& b) { return std::pair(a.shared, a.area) > std::pair(b.shared, b.area); });
    if (own.empty() || !own.front().shared || axes_.size() == most) continue;
    const Eigen::Matrix3d axes = axes_of(own);
    const double enough = as_good * share_along(axes, own);
    const auto has_them = [&](const Eigen::Matrix3d& other) { return share_along(other, own) >= enough; };
    if (std::none_of(axes_.begin(), axes_.end(), has_them)) axes_.push_back(axes);
  }

  std::map<const Part*, std::vector<double>> shares;
  for (std::size_t i = 0; i < leafs.size(); ++i) {
    std::vector<double>& own = shares[leafs[i]];
    own.clear();  // a leaf can be in a design twice
    for (const Eigen::Matrix3d& axes : axes_) own.push_back(share_along(axes, faces[i]));
  }
  // Chooses the best frame of a part; prefers the inherited frame if it is as good.
  const auto choose = [&](const std::vector<double>& sums, int otherwise) {
    const auto best = std::max_element(sums.begin(), sums.end());
    if (*best == 0) return any;
    const bool good = otherwise >= 0 && sums[static_cast<std::size_t>(otherwise)] >= as_good * *best;
    return good ? otherwise : static_cast<int>(best - sums.begin());
  };
  const std::function<std::vector<double>(const Part&)> sum_up = [&](const Part& here) {
    if (const auto found = shares.find(&here); found != shares.end()) return found->second;
    std::vector<double> sums(axes_.size(), 0);
    for (const PartPtr& child : here.children) {
      const std::vector<double> one = sum_up(*child);
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += one[k];
    }
    return shares[&here] = sums;
  };
  const std::function<void(const Part&, int)> settle = [&](const Part& here, int around) {
    const int own = of_[&here] = choose(shares[&here], around);
    for (const PartPtr& child : here.children) settle(*child, own == any ? around : own);
  };
  sum_up(part);
  whole_ = std::max(0, choose(shares[&part], 0));
  settle(part, whole_);
}

int Frames::of(const Part& part) const {
  const auto found = of_.find(&part);
  return found != of_.end() ? found->second : any;
}

Eigen::Matrix3d Frames::turn(int from, int to) const {
  return (axes(to) * axes(from).inverse()).unaryExpr(&without_rounding);
}

}  // namespace fieldfab::openscad
