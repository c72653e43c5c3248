#include "seams.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <unordered_map>

namespace fieldfab::cam {
namespace {

using Plane = CutSurfaces::Plane;
using Place = SurfacePiece::Place;

// Least angle of an edge between two cuts, and within one cut, whose surface may also be curved.
constexpr double degree = 0.017453292519943295;
const double cosine_of_two = std::cos(3 * degree), cosine_of_one = std::cos(15 * degree);
/// In cells: how near to a face's border seams may lie, and how far outside of the face what they are drawn from.
constexpr double margin = 2e-3, most_overshoot = 0.2;
/// A plane that was found anew nearer to the edge belongs to the same surface if it has turned by less than this.
const double cosine_of_same = std::cos(25 * degree);

}  // namespace

void find_rim(std::span<const std::array<std::uint32_t, 3>> triangles, Rim& rim) {
  rim.clear();
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<std::uint32_t, 2> edge{t[i], t[(i + 1) % 3]};
      const auto back = std::find(rim.begin(), rim.end(), std::array{edge[1], edge[0]});
      if (back != rim.end())
        rim.erase(back);
      else
        rim.push_back(edge);
    }
}

class SeamFinder::Search {
 public:
  Search(const SeamFinder& finder, std::size_t index, const State& state)
      : finder_(finder), index_(index), piece_(finder.pieces_[index]), state_(state) {}

  SharpCubes run() {
    for (std::size_t k = 0; k < piece_.cubes.size(); ++k) {
      const std::size_t first = piece_.cubes[k].first;
      const std::size_t last = k + 1 < piece_.cubes.size() ? piece_.cubes[k + 1].first : piece_.corners.size();
      if (last > first) look(piece_.cubes[k], std::span(piece_.corners).subspan(first, last - first));
    }
    return std::move(found_);
  }

 private:
  /// What is needed of a vertex.
  struct Vertex {
    std::uint32_t corner, cut;
    std::uint8_t state;
    Place at;
  };

  [[nodiscard]] const StockLattice& lattice() const { return finder_.pieces_.lattice(); }
  [[nodiscard]] Vec3 from_corner(const Place& p) const { return Vec3(p[0], p[1], p[2]) - lattice().box().lower; }

  [[nodiscard]] Vertex vertex(std::uint32_t corner) const {
    const std::size_t owner = finder_.pieces_.owner(index_, corner);
    const std::uint32_t v = corner & SurfacePiece::own_part;
    const SurfacePiece& whose = finder_.pieces_[owner];
    return {corner, whose.cut(v), v < whose.edges ? state_(owner, v) : VertexState::axis_part, whose.place(v)};
  }
  [[nodiscard]] static Vec3 inward(const Vertex& v) {
    return Vec3::Unit(v.state & VertexState::axis_part) * (v.state & VertexState::upwards ? -1 : 1);
  }

  /// The plane tangent to the surface at a vertex; kept, since several cubes ask for it.
  const std::optional<Plane>& plane_at(const Vertex& v) {
    const auto [found, fresh] = planes_.try_emplace(v.corner);
    if (fresh) found->second = finder_.surfaces_.tangent(v.cut, from_corner(v.at), inward(v));
    return found->second;
  }

  [[nodiscard]] bool may_meet(const Vertex& a, const Vertex& b) const {
    if (!(a.cut && b.cut) && (a.cut == b.cut || !finder_.surfaces_.has_first())) return false;
    const std::uint8_t axis = a.state & VertexState::axis_part, other = b.state & VertexState::axis_part;
    if (axis == 3 || other == 3) return false;
    if (a.cut == b.cut && !finder_.surfaces_.has_edges(a.cut)) return false;
    // Most pairs are on one floor.
    const auto on_floor = [&](const Vertex& v) { return finder_.surfaces_.level_axis(v.cut) == axis; };
    return !(axis == other && a.at[axis] == b.at[axis] && on_floor(a) && (a.cut == b.cut || on_floor(b)));
  }
  bool meet(const Vertex& a, const Vertex& b) {
    if (!may_meet(a, b)) return false;
    const std::optional<Plane> one = plane_at(a), other = plane_at(b);
    return one && other && one->normal.dot(other->normal) < (a.cut == b.cut ? cosine_of_one : cosine_of_two);
  }

  void look(const SurfacePiece::Cube& cube, std::span<const std::array<std::uint32_t, 3>> triangles) {
    if (plain(triangles)) return;
    find_rim(triangles, rim_);
    Index3 lower;
    for (std::size_t a = 0; a < 3; ++a) lower[a] = piece_.region.lower[a] + cube.from_lower[a];
    int meetings = 0;
    for (const auto& [from, to] : rim_) {
      const Vertex a = vertex(from), b = vertex(to);
      if (!meet(a, b)) continue;
      ++meetings;
      add_seam(lower, a, b);
    }
    if (!meetings) return;
    SharpCube sharp{lower, static_cast<std::uint32_t>(triangles.size()), false, {}};
    if (meetings > 2) find_corner(sharp);
    found_.cubes.push_back(sharp);
    found_.triangles.insert(found_.triangles.end(), triangles.begin(), triangles.end());
  }

  /// Whether all of a cube's vertices were made by one smooth cut, or are the stock's first surface.
  [[nodiscard]] bool plain(std::span<const std::array<std::uint32_t, 3>> triangles) const {
    std::uint32_t cut = 0;
    bool first = false;
    for (const auto& t : triangles)
      for (const std::uint32_t corner : t) {
        const SurfacePiece& whose = finder_.pieces_[finder_.pieces_.owner(index_, corner)];
        const std::uint32_t own = whose.cut(corner & SurfacePiece::own_part);
        if (own && cut && own != cut) return false;
        cut = std::max(cut, own), first |= !own;
      }
    if (cut && first && finder_.surfaces_.has_first()) return false;
    return !cut || !finder_.surfaces_.has_edges(cut);
  }

  /// Adds the seam between two vertices if they lie in one of the cube's upper faces; for the others, the cube before
  /// does it.
  void add_seam(const Index3& lower, const Vertex& a, const Vertex& b) {
    for (std::size_t d = 0; d < 3; ++d) {
      if (lower[d] + 1 > lattice().cells()[d]) continue;
      const float level = plane(lattice(), d, lower[d] + 1);
      if (a.at[d] != level || b.at[d] != level) continue;
      if (const std::optional<Place> place = crossing(lower, d, level, a, b))
        found_.seams.push_back({{a.corner, b.corner}, *place, std::max(a.cut, b.cut)});
      return;
    }
  }

  /// The point of a cube's face on the tangent planes of two vertices.
  std::optional<Place> crossing(const Index3& lower, std::size_t d, float level, const Vertex& a, const Vertex& b) {
    const std::size_t u = (d + 1) % 3, v = (d + 2) % 3;
    const auto i = [](std::size_t axis) { return static_cast<Eigen::Index>(axis); };
    const Vec3 p = from_corner(a.at), q = from_corner(b.at);
    std::array<Plane, 2> planes{*plane_at(a), *plane_at(b)};
    const auto meeting = [&]() -> std::optional<Vec3> {
      Eigen::Matrix2d m;
      Vec2 side;
      for (int k = 0; k < 2; ++k) {
        const auto& [place, normal] = planes[static_cast<std::size_t>(k)];
        m.row(k) << normal[i(u)], normal[i(v)];
        side[k] = normal.dot(place) - normal[i(d)] * p[i(d)];
      }
      const double area = m.determinant();
      if (std::abs(area) < 0.02 * m.row(0).norm() * m.row(1).norm()) return {};
      const Vec2 solution = m.inverse() * side;
      Vec3 at = p;
      at[i(u)] = solution[0], at[i(v)] = solution[1];
      if (!at.allFinite()) return {};
      return at;
    };
    // An edge that lies a little outside of the face is drawn into it: the ridge that is less than a cell higher than
    // the last solid point.
    const auto overshoot = [&](Vec3& at) {
      double most = 0;
      for (const std::size_t axis : {u, v}) {
        const double cells = at[i(axis)] / lattice().spacing()[i(axis)] - lower[axis];
        const double kept = std::clamp(cells, margin, 1 - margin);
        most = std::max(most, std::abs(cells - kept));
        if (kept != cells) at[i(axis)] = (lower[axis] + kept) * lattice().spacing()[i(axis)];
      }
      return most;
    };
    std::optional<Vec3> at = meeting();
    // Curved surfaces: with planes that touch them nearer to the edge.
    for (int round = 0; round < 2 && at; ++round) {
      Vec3 within = *at;
      if (overshoot(within) > most_overshoot) break;
      for (std::size_t k = 0; k < 2; ++k) {
        const Vertex& whose = k ? b : a;
        const Vec3 near = within + 0.1 * ((k ? q : p) - within);
        const std::optional<Plane> closer = finder_.surfaces_.tangent(whose.cut, near, inward(whose));
        if (closer && closer->normal.dot(planes[k].normal) > cosine_of_same) planes[k] = *closer;
      }
      const Vec3 before = *at;
      at = meeting();
      if (at && (*at - before).norm() < 0.02 * lattice().spacing().minCoeff()) break;
    }
    if (!at) return {};
    const auto side_of = [&](const Vec3& x) { return (q - p).cross(x - p)[i(d)]; };
    const double side = side_of(*at);
    const Vec3 exact = *at;
    if (overshoot(*at) > most_overshoot || side * side_of(*at) <= 0) return {};
    const double cell = lattice().spacing().minCoeff();
    // A surface that bends within the cell, such as that of a small round tip, is no edge: near the crossing it has
    // other planes.
    for (std::size_t k = 0; k < 2 && a.cut == b.cut; ++k) {
      const Vec3 way = (k ? q : p) - exact;
      if (way.norm() < 0.1 * cell) continue;
      const std::optional<Plane> near = finder_.surfaces_.tangent(a.cut, exact + 0.1 * way, inward(k ? b : a));
      if (!near || near->normal.dot(planes[k].normal) < cosine_of_same) return {};
      if (std::abs(near->normal.dot(exact - near->place)) > 0.05 * cell) return {};
    }
    if ((*at - p).cross(q - p).norm() < 1e-3 * cell * (q - p).norm()) return {};  // nothing is cut off
    if (std::min((*at - p).norm(), (*at - q).norm()) < 1e-3 * cell) return {};
    const Vec3 place = *at + lattice().box().lower;
    Place result{static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())};
    result[d] = level;
    return result;
  }

  /// The point of a cube that is nearest to the planes of all its vertices, or to planes that touch the same surfaces
  /// nearer to that point.
  void find_corner(SharpCube& cube) {
    std::vector<std::pair<Vertex, Plane>> sides;
    Vec3 middle = Vec3::Zero();
    for (const auto& edge : rim_) {
      const Vertex a = vertex(edge[0]);
      middle += from_corner(a.at) / static_cast<double>(rim_.size());
      if ((a.state & VertexState::axis_part) == 3) continue;
      if (const std::optional<Plane>& plane = plane_at(a)) sides.emplace_back(a, *plane);
    }
    Vec3 at = nearest_to(sides, middle);
    if (!within(at, cube.lower)) return;
    for (auto& [vertex, plane] : sides) {
      const Vec3 near = at + 0.1 * (from_corner(vertex.at) - at);
      const std::optional<Plane> closer = finder_.surfaces_.tangent(vertex.cut, near, inward(vertex));
      if (closer && closer->normal.dot(plane.normal) > cosine_of_same) plane = *closer;
    }
    at = nearest_to(sides, middle);
    if (!within(at, cube.lower)) return;
    at += lattice().box().lower;
    cube.has_corner = true;
    cube.corner = {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z())};
  }
  [[nodiscard]] bool within(const Vec3& at, const Index3& lower) const {
    for (std::size_t a = 0; a < 3; ++a) {
      const auto i = static_cast<Eigen::Index>(a);
      const double cells = at[i] / lattice().spacing()[i] - lower[a];
      if (!(cells > margin && cells < 1 - margin)) return false;
    }
    return true;
  }
  /// The point with the least sum of squared distances from planes, in the directions that they determine.
  [[nodiscard]] static Vec3 nearest_to(const std::vector<std::pair<Vertex, Plane>>& sides, const Vec3& middle) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Vec3 rest = Vec3::Zero();
    for (const auto& [vertex, plane] : sides) {
      sum += plane.normal * plane.normal.transpose();
      rest += plane.normal * plane.normal.dot(plane.place - middle);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
    Vec3 at = middle;
    for (int k = 0; k < 3; ++k)
      if (solver.eigenvalues()[k] > 0.02 * solver.eigenvalues()[2])
        at += solver.eigenvectors().col(k) * (solver.eigenvectors().col(k).dot(rest) / solver.eigenvalues()[k]);
    return at;
  }

  const SeamFinder& finder_;
  std::size_t index_;
  const SurfacePiece& piece_;
  const State& state_;
  SharpCubes found_;
  Rim rim_;
  std::unordered_map<std::uint32_t, std::optional<Plane>> planes_;
};

SharpCubes SeamFinder::find(std::size_t index, const State& state) const { return Search(*this, index, state).run(); }

}  // namespace fieldfab::cam
