#include "polyhedron.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "surface_field.h"

namespace fieldfab::openscad {

std::vector<Plane> planes_of(const Polyhedron& convex) {
  // A face with many corners is many triangles. Triangles with nearly the same normal form one
  // plane, the outermost.
  constexpr double coarse = 4e-6, same = 1e-6;
  std::vector<Plane> planes;
  std::map<std::array<std::int64_t, 3>, std::vector<std::size_t>> by_normal;
  for (const Triangle& t : convex.triangles) {
    const Vec3 &a = convex.vertices[t[0]], &b = convex.vertices[t[1]], &c = convex.vertices[t[2]];
    const Vec3 area = (b - a).cross(c - a);
    if (!(area.norm() > 1e-12 * std::max((b - a).squaredNorm(), (c - a).squaredNorm()))) continue;
    const Vec3 normal = area.normalized();
    const double offset = normal.dot(a);
    std::array<std::int64_t, 3> key{};
    for (std::size_t i = 0; i < 3; ++i) key[i] = std::llround(normal[static_cast<Eigen::Index>(i)] / coarse);
    bool known = false;
    for (int near = 0; near < 27 && !known; ++near) {
      const std::array<std::int64_t, 3> other{key[0] + near % 3 - 1, key[1] + near / 3 % 3 - 1, key[2] + near / 9 - 1};
      const auto found = by_normal.find(other);
      if (found == by_normal.end()) continue;
      for (const std::size_t i : found->second) {
        if ((planes[i].normal - normal).norm() > same) continue;
        planes[i].offset = std::max(planes[i].offset, offset);
        known = true;
        break;
      }
    }
    if (known) continue;
    by_normal[key].push_back(planes.size());
    planes.push_back({normal, offset});
  }
  return planes;
}

bool is_convex(const Polyhedron& solid) {
  if (solid.empty()) return false;
  const double slack = 1e-6 * solid.bounds().diagonal();
  for (const Triangle& t : solid.triangles) {
    const Vec3& a = solid.vertices[t[0]];
    const Vec3 normal = (solid.vertices[t[1]] - a).cross(solid.vertices[t[2]] - a).normalized();
    for (const Vec3& p : solid.vertices)
      if (normal.dot(p - a) > slack) return false;
  }
  return true;
}

Polyhedron sweep(const Region& region, int steps, const std::function<Vec3(const Vec2&, int)>& place,
                 const SweepChoices& choices) {
  Polyhedron solid;
  std::size_t corners = 0;
  for (const Outline& outline : region.outlines) corners += outline.size();
  for (int step = 0; step <= steps; ++step)
    for (const Outline& outline : region.outlines)
      for (const Vec2& p : outline) solid.vertices.push_back(place(p, step));
  const auto at = [&](std::size_t corner, int step) {
    return static_cast<std::uint32_t>(static_cast<std::size_t>(step) * corners + corner);
  };
  for (int step = 0; step < steps; ++step) {
    std::size_t first = 0;
    for (const Outline& outline : region.outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t here = first + i, next = first + (i + 1) % outline.size();
        const std::uint32_t a = at(here, step), b = at(next, step), c = at(next, step + 1), d = at(here, step + 1);
        const auto& v = solid.vertices;
        const double ac = (v[a] - v[c]).norm(), bd = (v[b] - v[d]).norm(), same = 1e-9 * (ac + bd);
        if (choices.forwards_if_equal ? ac <= bd + same : ac < bd - same) {
          solid.triangles.push_back({a, b, c});
          solid.triangles.push_back({a, c, d});
        } else {
          solid.triangles.push_back({a, b, d});
          solid.triangles.push_back({b, c, d});
        }
      }
      first += outline.size();
    }
  }
  if (!choices.caps) return welded(solid);
  for (const auto& t : triangulate(region)) {
    solid.triangles.push_back({at(t[0], 0), at(t[2], 0), at(t[1], 0)});
    solid.triangles.push_back({at(t[0], steps), at(t[1], steps), at(t[2], steps)});
  }
  return welded(solid);
}

Polyhedron turned(const Region& profile, double first, double step, int steps, bool full) {
  const auto place = [&](const Vec2& p, int layer) -> Vec3 {
    const double angle = first + step * (full && layer == steps ? 0 : layer);
    return {p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()};
  };
  Polyhedron solid = sweep(profile, steps, place, {!full, false});
  if (step > 0)  // then x, z and the direction of rotation form a left-handed frame
    for (Triangle& t : solid.triangles) std::swap(t[1], t[2]);
  return solid;
}

Region slice(const Polyhedron& solid) {
  // A corner in the plane counts as above it. So each triangle is cut along one segment or not at
  // all.
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Outline> outlines;
  const auto edge = [](std::uint32_t a, std::uint32_t b) { return Edge(std::min(a, b), std::max(a, b)); };
  const auto above = [&](std::uint32_t i) { return solid.vertices[i].z() >= 0; };
  const auto crossing = [&](const Edge& e) -> Vec2 {
    const Vec3 &a = solid.vertices[e.first], &b = solid.vertices[e.second];
    const double t = a.z() / (a.z() - b.z());
    return (a + t * (b - a)).head<2>();
  };
  std::multimap<Edge, Edge> open;
  for (const Triangle& t : solid.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      if (above(a) == above(b) || above(a) == above(c)) continue;  // a is alone on its side
      const Edge out = edge(a, b), back = edge(a, c);
      if (above(a))
        open.emplace(out, back);
      else
        open.emplace(back, out);
    }
  while (!open.empty()) {
    const Edge start = open.begin()->first;
    Outline outline;
    Edge here = start;
    for (;;) {
      const auto found = open.find(here);
      if (found == open.end()) break;  // a hole in the surface: closed by a straight line
      outline.push_back(crossing(here));
      here = found->second;
      open.erase(found);
      if (here == start) break;
    }
    if (outline.size() >= 3) outlines.push_back(std::move(outline));
  }
  return wound(outlines);
}

Region shadow(const Polyhedron& solid) {
  // The outline of a triangle that faces up winds around its shadow. A common edge of two such
  // triangles is passed in both directions, which cancels. So the winding number of all rims around
  // a point is the number of triangles above it.
  const auto area = [&](const Triangle& t) {
    const Vec2 a = solid.vertices[t[0]].head<2>(), u = solid.vertices[t[1]].head<2>() - a,
               v = solid.vertices[t[2]].head<2>() - a;
    return u.x() * v.y() - u.y() * v.x();
  };
  std::multimap<std::uint32_t, std::uint32_t> rims;  // from corner to corner
  const bool closed = is_closed(solid);
  for (Triangle t : solid.triangles) {
    const double up = area(t);
    if (up == 0 || (closed && up < 0)) continue;
    if (up < 0) std::swap(t[1], t[2]);  // of an open surface, whose orientation is arbitrary
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      const auto [first, last] = rims.equal_range(to);
      const auto back = std::find_if(first, last, [&](const auto& edge) { return edge.second == from; });
      if (back != last)
        rims.erase(back);
      else
        rims.emplace(from, to);
    }
  }
  std::vector<Outline> outlines;
  while (!rims.empty()) {
    Outline outline;
    for (auto at = rims.begin(); at != rims.end();) {
      outline.push_back(solid.vertices[at->first].head<2>());
      const std::uint32_t next = at->second;
      rims.erase(at);
      at = rims.find(next);
    }
    outlines.push_back(std::move(outline));
  }
  return wound(outlines);
}

}  // namespace fieldfab::openscad
