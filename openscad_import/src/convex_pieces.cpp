#include "convex_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/mesh/exact_solid.h"

namespace fieldfab::openscad {
namespace {

constexpr std::size_t most_hollows = 12, most_pieces = 1000;

double volume_of(const Polyhedron& solid) {
  double six = 0;
  const Vec3& origin = solid.vertices.front();
  for (const Triangle& t : solid.triangles)
    six += (solid.vertices[t[0]] - origin).dot((solid.vertices[t[1]] - origin).cross(solid.vertices[t[2]] - origin));
  return six / 6;
}

/// A face with corners of the solid beyond its plane.
struct Hollow {
  Vec3 normal, place;
  double area;
};

/// Returns the hollows of a solid, one per plane, the greatest first; none if the solid is convex.
std::vector<Hollow> hollows_of(const Polyhedron& solid) {
  const double slack = 1e-7 * solid.bounds().diagonal();
  std::vector<Hollow> found;
  for (const Triangle& t : solid.triangles) {
    const Vec3 &a = solid.vertices[t[0]], &b = solid.vertices[t[1]], &c = solid.vertices[t[2]];
    const Vec3 cross = (b - a).cross(c - a);
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    if (cross.norm() < slack * longest) continue;  // rounding decides the orientation of a sliver
    const Vec3 normal = cross.normalized();
    const auto beyond = [&](const Vec3& p) { return normal.dot(p - a) > slack; };
    if (std::any_of(solid.vertices.begin(), solid.vertices.end(), beyond)) found.push_back({normal, a, cross.norm()});
  }
  std::stable_sort(found.begin(), found.end(), [](const Hollow& a, const Hollow& b) { return a.area > b.area; });
  std::vector<Hollow> planes;
  for (const Hollow& one : found) {
    constexpr double nearly = 1e-6;
    const bool known = std::any_of(planes.begin(), planes.end(), [&](const Hollow& other) {
      return (one.normal - other.normal).norm() < nearly && std::abs(one.normal.dot(one.place - other.place)) < slack;
    });
    if (!known) planes.push_back(one);
  }
  return planes;
}

/// Returns everything beyond a plane, within `reach` mm.
Polyhedron half_space(const Hollow& plane, const Vec3& centre, double reach) {
  const Vec3 middle = centre + plane.normal.dot(plane.place - centre) * plane.normal;
  const Vec3 u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(middle + reach * (((i & 1) != 0 ? u : Vec3(-u)) + ((i & 2) != 0 ? v : Vec3(-v))) +
                         ((i & 4) != 0 ? reach : 0) * plane.normal);
  return convex_hull(corners);
}

using Pieces = std::vector<Polyhedron>;

/// Cuts a solid along the planes of its faces. Returns nullopt if too many faces are not convex, or
/// if a cut fails.
std::optional<Pieces> cut_open(const Polyhedron& solid, Progress& progress) {
  const double reach = 2 * solid.bounds().diagonal(), volume = volume_of(solid), crumb = 1e-9 * volume;
  const Vec3 centre = solid.bounds().centre();
  Pieces pieces;
  try {
    std::vector<ExactSolid> open{ExactSolid(solid)};
    while (!open.empty()) {
      progress.check();
      if (pieces.size() + open.size() > most_pieces) return std::nullopt;
      const ExactSolid here = std::move(open.back());
      open.pop_back();
      const Polyhedron surface = here.polyhedron();
      const std::vector<Hollow> hollows = hollows_of(surface);
      if (hollows.empty()) {
        pieces.push_back(convex_hull(surface.vertices));
        continue;
      }
      if (hollows.size() > most_hollows) return std::nullopt;
      bool cut = false;
      for (auto plane = hollows.begin(); plane != hollows.end() && !cut; ++plane) {
        const ExactSolid beyond(half_space(*plane, centre, reach));
        std::vector<ExactSolid> halves;
        for (const auto operation : {Operation::intersect, Operation::subtract}) {
          ExactSolid half = combined(here, beyond, operation);
          if (!half.empty() && volume_of(half.polyhedron()) > crumb) halves.push_back(std::move(half));
        }
        cut = halves.size() == 2;
        if (cut) open.insert(open.end(), halves.begin(), halves.end());
      }
      if (!cut) return std::nullopt;
    }
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) throw;
    return std::nullopt;
  }
  double sum = 0;
  for (const Polyhedron& piece : pieces) sum += piece.empty() ? 0 : volume_of(piece);
  constexpr double nearly = 1e-6;
  if (std::abs(sum - volume) > nearly * volume) return std::nullopt;
  std::erase_if(pieces, [](const Polyhedron& piece) { return piece.empty(); });
  return pieces;
}

/// Returns the part of a convex solid on the inner side of a plane; empty if it has no thickness.
Polyhedron cut_off(const Polyhedron& convex, const Plane& plane, double slack) {
  std::vector<Vec3> kept;
  std::vector<double> height;
  for (const Vec3& p : convex.vertices) height.push_back(plane.normal.dot(p) - plane.offset);
  for (std::size_t i = 0; i < height.size(); ++i)
    if (height[i] <= 0) kept.push_back(convex.vertices[i]);
  if (kept.empty() || *std::min_element(height.begin(), height.end()) > -slack) return {};
  if (kept.size() == height.size()) return convex;
  for (const Triangle& t : convex.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t u = t[i], v = t[(i + 1) % 3];
      if (height[u] < 0 && height[v] > 0)  // one of the two directions of each edge
        kept.push_back(convex.vertices[u] +
                       height[u] / (height[u] - height[v]) * (convex.vertices[v] - convex.vertices[u]));
    }
  return convex_hull(kept);
}

/// Returns the difference of two convex solids in pieces: beyond the first plane of `other`, within
/// the first but beyond the second, and so on.
Pieces without(const Polyhedron& convex, const Polyhedron& other, double slack) {
  Pieces pieces;
  Polyhedron rest = convex;
  for (const Plane& plane : planes_of(other)) {
    if (Polyhedron beyond = cut_off(rest, {-plane.normal, -plane.offset}, slack); !beyond.empty())
      pieces.push_back(std::move(beyond));
    rest = cut_off(rest, plane, slack);
    if (rest.empty()) return pieces;
  }
  return pieces;
}

Polyhedron common_to(Polyhedron convex, const Polyhedron& other, double slack) {
  for (const Plane& plane : planes_of(other))
    if (!convex.empty()) convex = cut_off(convex, plane, slack);
  return convex;
}

bool meet(const Polyhedron& a, const Polyhedron& b) { return intersection(a.bounds(), b.bounds()).valid(); }

std::optional<Pieces> pieces_in(const Part& part, double slack, Progress& progress) {
  progress.check();
  if (part.kind == Part::Kind::nothing) return Pieces{};
  if (part.kind == Part::Kind::leaf) {
    Polyhedron solid = part.leaf->polyhedron();
    if (part.leaf->convex() || is_convex(solid)) return Pieces{convex_hull(solid.vertices)};
    return cut_open(solid, progress);
  }
  std::optional<Pieces> all;
  for (const PartPtr& child : part.children) {
    const auto own = pieces_in(*child, slack, progress);
    if (!own) return std::nullopt;
    if (!all) {
      all = own;
    } else if (part.kind == Part::Kind::unite) {
      all->insert(all->end(), own->begin(), own->end());
    } else if (part.kind == Part::Kind::intersect) {
      Pieces common;
      for (const Polyhedron& a : *all)
        for (const Polyhedron& b : *own)
          if (meet(a, b)) common.push_back(common_to(a, b, slack));
      all = std::move(common);
    } else {
      for (const Polyhedron& b : *own) {
        Pieces rest;
        for (const Polyhedron& a : *all) {
          Pieces left = meet(a, b) ? without(a, b, slack) : Pieces{a};
          rest.insert(rest.end(), left.begin(), left.end());
        }
        if (rest.size() > most_pieces) return std::nullopt;
        all = std::move(rest);
      }
    }
    std::erase_if(*all, [](const Polyhedron& piece) { return piece.empty(); });
    if (all->size() > most_pieces) return std::nullopt;
  }
  return all;
}

}  // namespace

std::optional<std::vector<Polyhedron>> convex_pieces(const Part& part, Progress& progress) {
  constexpr double thinnest = 1e-9;  // relative to the size
  return pieces_in(part, thinnest * bounds_of(part).diagonal(), progress);
}

}  // namespace fieldfab::openscad
