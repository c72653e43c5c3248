// A part's surface by exact arithmetic, where its leafs have flat faces.
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <functional>
#include <map>

#include "exact_solid.h"
#include "fieldfab/core/error.h"
#include "leaf.h"
#include "surface_field.h"

namespace fieldfab::openscad {
namespace {

/// Gives the corners of a leaf; `taken` is how often it is taken away from what is taken away.
using CornersOf = std::function<Polyhedron(const Leaf&, int taken)>;

ExactSolid exact_of(const Part& part, const CornersOf& corners_of, Progress& progress, int taken = 0) {
  progress.report(0, "joining solids");  // this asks whether to go on
  progress.check();
  if (part.kind == Part::Kind::nothing) return {};
  if (part.kind == Part::Kind::leaf) return ExactSolid(corners_of(*part.leaf, taken));
  std::vector<ExactSolid> solids;
  for (const PartPtr& child : part.children) {
    const bool is_taken = part.kind == Part::Kind::subtract && !solids.empty();
    solids.push_back(exact_of(*child, corners_of, progress, taken + (is_taken ? 1 : 0)));
  }
  if (part.kind == Part::Kind::intersect) return all_of(std::move(solids), Operation::intersect, progress);
  if (part.kind == Part::Kind::unite) return all_of(std::move(solids), Operation::unite, progress);
  const ExactSolid first = std::move(solids.front());
  solids.erase(solids.begin());
  return combined(first, all_of(std::move(solids), Operation::unite, progress), Operation::subtract);
}

bool all_flat(const Part& part) {
  if (part.kind == Part::Kind::leaf) return part.leaf->has_flat_faces();
  return std::all_of(part.children.begin(), part.children.end(), [](const PartPtr& child) { return all_flat(*child); });
}

/// A convex solid whose faces of many corners, such as the ends of cylinders, are divided by halves, again and again: fans of
/// long triangles that lie in one plane with others cross them all.
Polyhedron divided_evenly(const Polyhedron& convex) {
  const auto normal_of = [&](const Triangle& t) {
    const Vec3& a = convex.vertices[t[0]];
    return (convex.vertices[t[1]] - a).cross(convex.vertices[t[2]] - a).normalized();
  };
  // Each edge with the triangle that has it in this direction; triangles are of one face where their normals are the same.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> triangle_at;
  for (std::size_t i = 0; i < convex.triangles.size(); ++i)
    for (std::size_t j = 0; j < 3; ++j) triangle_at[{convex.triangles[i][j], convex.triangles[i][(j + 1) % 3]}] = i;
  Polyhedron result{convex.vertices, {}};
  constexpr std::size_t none = -1;
  std::vector<std::size_t> face_of(convex.triangles.size(), none);  // the first triangle of the face that each belongs to
  for (std::size_t start = 0; start < convex.triangles.size(); ++start) {
    if (face_of[start] != none) continue;
    const Vec3 normal = normal_of(convex.triangles[start]);
    std::vector<std::size_t> face{start};
    std::map<std::uint32_t, std::uint32_t> rim;  // from corner to corner
    std::size_t edges = 0;
    face_of[start] = start;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Triangle& t = convex.triangles[face[i]];
      for (std::size_t j = 0; j < 3; ++j) {
        const auto beyond = triangle_at.find({t[(j + 1) % 3], t[j]});
        if (beyond != triangle_at.end() && face_of[beyond->second] == none &&
            (normal_of(convex.triangles[beyond->second]) - normal).norm() < 1e-9) {
          face_of[beyond->second] = start;
          face.push_back(beyond->second);
        } else if (beyond == triangle_at.end() || face_of[beyond->second] != start) {
          rim[t[j]] = t[(j + 1) % 3];
          ++edges;
        }
      }
    }
    std::vector<std::uint32_t> corners;
    for (auto at = rim.begin(); at != rim.end() && corners.size() <= rim.size();) {
      corners.push_back(at->first);
      at = rim.find(at->second);
      if (at == rim.begin()) break;
    }
    if (corners.size() != edges) {  // not one loop: left as it is
      for (const std::size_t i : face) result.triangles.push_back(convex.triangles[i]);
      continue;
    }
    const std::function<void(std::size_t, std::size_t)> divide = [&](std::size_t from, std::size_t to) {
      if (to - from < 2) return;
      const std::size_t middle = (from + to) / 2;
      result.triangles.push_back({corners[from], corners[middle], corners[to]});
      divide(from, middle);
      divide(middle, to);
    };
    divide(0, corners.size() - 1);
  }
  return is_closed(result) ? result : convex;  // slivers among its triangles can have any normal, and be a face of their own
}

/// The normals of a solid's faces with the area of each; of a round one's many.
std::vector<std::pair<Vec3, double>> areas_by_normal(const Polyhedron& solid) {
  std::map<std::array<std::int64_t, 3>, std::pair<Vec3, double>> found;
  for (const Triangle& t : solid.triangles) {
    const Vec3& a = solid.vertices[t[0]];
    const Vec3 area = (solid.vertices[t[1]] - a).cross(solid.vertices[t[2]] - a);
    if (!(area.norm() > 0)) continue;
    const Vec3 normal = area.normalized();
    std::array<std::int64_t, 3> key{};
    for (std::size_t i = 0; i < 3; ++i) key[i] = std::llround(1e8 * normal[static_cast<Eigen::Index>(i)]);
    found.try_emplace(key, normal, 0.0).first->second.second += area.norm();
  }
  std::vector<std::pair<Vec3, double>> all;
  for (const auto& [key, face] : found) all.push_back(face);
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  return all;
}

/// The axes, as rows, along which the greatest faces of most leafs look: seen along them what was turned is of rounded numbers,
/// and faces that were drawn in one plane are in one.
Eigen::Matrix3d best_axes(const Part& part) {
  struct Axes {
    Eigen::Matrix3d rows;
    std::size_t leafs;
  };
  std::vector<Axes> known{{Eigen::Matrix3d::Identity(), 0}};
  constexpr std::size_t most = 32;
  constexpr double nearly = 1e-9;
  const std::function<void(const Part&)> visit = [&](const Part& here) {
    for (const PartPtr& child : here.children) visit(*child);
    if (here.leaf == nullptr) return;
    const auto faces = areas_by_normal(here.leaf->polyhedron());
    if (faces.empty()) return;
    const Vec3 first = faces.front().first;
    const auto found = std::find_if(known.begin(), known.end(), [&](const Axes& axes) {
      return ((axes.rows * first).cwiseAbs().array() > nearly).count() == 1;
    });
    if (found != known.end()) {
      ++found->leafs;
    } else if (known.size() < most) {
      const auto across =
          std::find_if(faces.begin(), faces.end(), [&](const auto& face) { return std::abs(face.first.dot(first)) < nearly; });
      const Vec3 second = across != faces.end() ? across->first : Vec3(first.unitOrthogonal());
      Axes axes{Eigen::Matrix3d::Zero(), 1};
      axes.rows << first.transpose(), second.transpose(), first.cross(second).transpose();
      known.push_back(axes);
    }
  };
  visit(part);
  return std::max_element(known.begin(), known.end(), [](const Axes& a, const Axes& b) { return a.leafs < b.leafs; })->rows;
}

/// Each face moved out by `growth` mm, as far as its corners can follow: where more than three planes meet, as near as can be.
Polyhedron grown(const Polyhedron& solid, double growth) {
  std::vector<std::vector<Vec3>> normals(solid.vertices.size());
  for (const Triangle& t : solid.triangles) {
    const Vec3 &a = solid.vertices[t[0]], &b = solid.vertices[t[1]], &c = solid.vertices[t[2]];
    const Vec3 area = (b - a).cross(c - a);
    if (!(area.norm() > 0)) continue;
    const Vec3 normal = area.normalized();
    for (const std::uint32_t corner : t) normals[corner].push_back(normal);
  }
  constexpr double farthest = 4;  // a needle's point would go far
  Polyhedron result = solid;
  for (std::size_t i = 0; i < solid.vertices.size(); ++i) {
    if (normals[i].empty()) continue;
    Eigen::MatrixX3d planes(static_cast<Eigen::Index>(normals[i].size()), 3);
    for (std::size_t j = 0; j < normals[i].size(); ++j) planes.row(static_cast<Eigen::Index>(j)) = normals[i][j].transpose();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixX3d> solver(planes.rows(), 3);
    solver.setThreshold(1e-3);
    const Vec3 step = solver.compute(planes).solve(Eigen::VectorXd::Ones(planes.rows()));
    result.vertices[i] += growth * step * std::min(1.0, farthest / step.norm());
  }
  return result;
}

/// With corners on a lattice that is much finer than single precision, and coarser than what turning and moving loses in double:
/// so that corners which are to be the same are, and faces along the axes are in one plane.
Polyhedron settled(Polyhedron solid, double farthest) {
  const double step = std::exp2(std::ceil(std::log2(farthest)) - 34);
  for (Vec3& p : solid.vertices) p = (p / step).array().round().matrix() * step;
  return welded(solid);
}

/// With corners in single precision; nothing where the surface is no longer valid.
std::optional<TriangleMesh> rounded(const Polyhedron& exact) {
  const auto if_valid = [](const Polyhedron& surface) -> std::optional<TriangleMesh> {
    const TriangleMesh mesh = to_mesh(welded(to_polyhedron(to_mesh(surface))));
    return bounds_a_solid(to_polyhedron(mesh)) ? std::optional(mesh) : std::nullopt;
  };
  constexpr double narrowest = 1e-6;  // of the size: less may be turned over by rounding
  if (auto mesh = if_valid(exact)) return mesh;
  return if_valid(without_slivers(exact, narrowest * exact.bounds().diagonal()));
}

std::optional<TriangleMesh> surface_of(const Part& part, const CornersOf& corners_of, const Eigen::Affine3d& placement,
                                       Progress& progress) {
  try {
    const ExactSolid solid = exact_of(part, corners_of, progress);
    if (solid.empty()) return std::nullopt;  // as it is for whoever looks for its bounds
    return rounded(moved(solid.polyhedron(), placement));
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled || error.kind() == ErrorKind::io) throw;
    return std::nullopt;
  }
}

}  // namespace

Polyhedron polyhedron_of(const Part& part, Progress& progress) {
  if (part.kind == Part::Kind::leaf) return part.leaf->polyhedron();
  return exact_of(
             part, [](const Leaf& leaf, int) { return leaf.polyhedron(); }, progress)
      .polyhedron();
}

std::optional<TriangleMesh> faces_of(const Part& part, Progress& progress) {
  if (part.empty() || !all_flat(part)) return std::nullopt;
  const Box box = bounds_of(part);
  const double farthest = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
  Eigen::Affine3d turn = Eigen::Affine3d::Identity();
  turn.linear() = best_axes(part);
  const auto as_drawn = [&](const Leaf& leaf, int) {
    const Polyhedron solid = settled(moved(leaf.polyhedron(), turn), farthest);
    return leaf.convex() ? divided_evenly(convex_hull(solid.vertices)) : solid;
  };
  if (auto surface = surface_of(part, as_drawn, turn.inverse(), progress)) return surface;
  // Grown by different amounts, faces that were in one plane and edges that were one line are apart; what is taken away is grown
  // more, so that no skin stays. A step is some last places of single precision.
  const double step = 4e-6 * farthest;
  constexpr int amounts = 8;
  int number = 0;
  const auto set_apart = [&](const Leaf& leaf, int taken) {
    number = (number + 5) % amounts;
    return grown(as_drawn(leaf, taken), (1 + number + amounts * taken) * step);
  };
  auto surface = surface_of(part, set_apart, turn.inverse(), progress);
  // What is no thicker than solids were grown is not there: they touched.
  if (surface && surface->volume() < 2 * amounts * step * surface->area()) surface.reset();
  return surface;
}

}  // namespace fieldfab::openscad
