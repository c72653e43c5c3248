// Surface of a part by exact arithmetic, for leafs with flat faces.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <map>
#include <span>
#include <variant>

#include "boxes.h"
#include "fieldfab/core/error.h"
#include "fieldfab/mesh/exact_solid.h"
#include "frames.h"
#include "leaf.h"
#include "surface_field.h"

namespace fieldfab::openscad {
namespace {

bool all_flat(const Part& part) {
  if (part.kind == Part::Kind::leaf) return part.leaf->has_flat_faces();
  return std::all_of(part.children.begin(), part.children.end(), [](const PartPtr& child) { return all_flat(*child); });
}

/// Number of leafs that are not boxes, or not evidently.
std::size_t count_of_many_sided(const Part& part) {
  constexpr std::size_t triangles_of_box = 12;
  if (part.kind == Part::Kind::leaf) return part.leaf->polyhedron().triangles.size() == triangles_of_box ? 0 : 1;
  std::size_t count = 0;
  for (const PartPtr& child : part.children) count += count_of_many_sided(*child);
  return count;
}

/// Returns a convex solid whose faces with many corners, such as the ends of cylinders, are divided
/// in halves recursively. Fans of long triangles in one plane with others would intersect all of
/// them.
Polyhedron divided_evenly(const Polyhedron& convex) {
  const auto normal_of = [&](const Triangle& t) {
    const Vec3& a = convex.vertices[t[0]];
    return (convex.vertices[t[1]] - a).cross(convex.vertices[t[2]] - a).normalized();
  };
  // Maps each directed edge to its triangle. Triangles with the same normal belong to one face.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> triangle_at;
  for (std::size_t i = 0; i < convex.triangles.size(); ++i)
    for (std::size_t j = 0; j < 3; ++j) triangle_at[{convex.triangles[i][j], convex.triangles[i][(j + 1) % 3]}] = i;
  Polyhedron result{convex.vertices, {}};
  constexpr std::size_t none = -1;
  std::vector<std::size_t> face_of(convex.triangles.size(), none);  // by triangle: the first triangle of its face
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
    if (corners.size() != edges) {  // not one loop: unchanged
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
  // Slivers among the triangles can have any normal and become faces of their own.
  return is_closed(result) ? result : convex;
}

/// Moves each face outwards by `growth` mm, as far as its corners can follow; a corner of more than
/// three planes moves to the best approximation.
Polyhedron grown(const Polyhedron& solid, double growth) {
  std::vector<std::vector<Vec3>> normals(solid.vertices.size());
  for (const Triangle& t : solid.triangles) {
    const Vec3 &a = solid.vertices[t[0]], &b = solid.vertices[t[1]], &c = solid.vertices[t[2]];
    const Vec3 area = (b - a).cross(c - a);
    if (!(area.norm() > 0)) continue;
    const Vec3 normal = area.normalized();
    for (const std::uint32_t corner : t) normals[corner].push_back(normal);
  }
  constexpr double farthest = 4;  // the point of a needle would go far
  Polyhedron result = solid;
  for (std::size_t i = 0; i < solid.vertices.size(); ++i) {
    if (normals[i].empty()) continue;
    // The shortest of the steps that least miss the planes' new places.
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    Vec3 sum = Vec3::Zero(), step = Vec3::Zero();
    for (const Vec3& normal : normals[i]) squares += normal * normal.transpose(), sum += normal;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
    constexpr double parallel = 1e-6;  // a square of the sine, of planes that are one up to rounding
    for (Eigen::Index j = 0; j < 3; ++j)
      if (const Vec3 along = solver.eigenvectors().col(j);
          solver.eigenvalues()[j] > parallel * solver.eigenvalues().maxCoeff())
        step += along * along.dot(sum) / solver.eigenvalues()[j];
    result.vertices[i] += growth * step * std::min(1.0, farthest / step.norm());
  }
  return result;
}

/// Conversion of leafs to solids.
struct Drawing {
  std::function<Polyhedron(const Leaf&, const Eigen::Matrix3d& axes)> solid;
  double same = 0;  ///< faces of boxes at most this far apart are in one plane, mm
  /// Growth of the next solid, mm. `taken` is the number of differences in which the solid is on
  /// the subtracted side. Null for no growth.
  std::function<double(int taken)> growth = nullptr;
};

/// Joins the leafs of a part by exact arithmetic: boxes by their cells, as many together as
/// possible, and everything else by corefinement. Parts with their own frame are joined in that
/// frame first.
class Joiner {
 public:
  Joiner(Drawing drawing, const Frames& frames, Progress& progress)
      : drawing_(std::move(drawing)), frames_(frames), progress_(progress) {}

  /// Returns the surface along the axes of frames.whole().
  Polyhedron surface(const Part& part) {
    const Joined all = joined(part, {0, frames_.whole()});
    if (const auto* boxes = std::get_if<Boxes>(&all)) return surface(*boxes, 0);
    return std::get<ExactSolid>(all).polyhedron();
  }

 private:
  using Kind = Part::Kind;
  using Joined = std::variant<Boxes, ExactSolid>;  // boxes wait until they meet another solid
  struct Solids {
    std::vector<Boxes> boxes;
    std::vector<ExactSolid> others;
  };
  struct Place {
    int taken;  ///< number of differences in which the solid is on the subtracted side
    int frame;
  };

  [[nodiscard]] bool grows() const { return drawing_.growth != nullptr; }
  Polyhedron surface(const Boxes& boxes, int taken) {
    return surface_of(boxes, drawing_.same, grows() ? drawing_.growth(taken) : 0, progress_);
  }

  /// Whether parts have their own frame, in which they are to be joined.
  [[nodiscard]] bool has_own(const Part& part, const Place& at) const {
    return frames_.of(part) >= 0 && frames_.of(part) != at.frame;
  }
  ExactSolid turned(const Joined& solid, const Place& from, int to) {
    return exact(solid, from.taken).turned(frames_.turn(from.frame, to));
  }

  Joined joined(const Part& part, const Place& at) {
    progress_.report(0, "joining solids");
    progress_.check();
    if (part.kind == Kind::nothing) return Boxes{};
    if (has_own(part, at)) {
      const Place own{at.taken, frames_.of(part)};
      return turned(joined(part, own), own, at.frame);
    }
    if (part.kind == Kind::leaf) {
      const Polyhedron solid = drawing_.solid(*part.leaf, frames_.axes(at.frame));
      if (const auto box = box_of(solid); box && box->size().minCoeff() > drawing_.same)
        return Boxes{Kind::leaf, *box, {}};
      return ExactSolid(grows() ? grown(solid, drawing_.growth(at.taken)) : solid);
    }
    if (part.kind == Kind::subtract) return difference(part.children, at);
    return joined(part.kind, all(part.kind, part.children, at), at.taken);
  }

  /// Evaluates the parts. Those of each other frame are joined first, as `kind`.
  Solids all(Kind kind, std::span<const PartPtr> parts, const Place& at) {
    Solids solids;
    std::map<int, std::vector<PartPtr>> elsewhere;
    for (const PartPtr& part : parts) {
      if (has_own(*part, at)) {
        elsewhere[frames_.of(*part)].push_back(part);
        continue;
      }
      Joined one = joined(*part, at);
      if (auto* boxes = std::get_if<Boxes>(&one))
        solids.boxes.push_back(std::move(*boxes));
      else
        solids.others.push_back(std::get<ExactSolid>(std::move(one)));
    }
    for (const auto& [frame, group] : elsewhere) {
      const Place own{at.taken, frame};
      solids.others.push_back(turned(joined(kind, all(kind, group, own), at.taken), own, at.frame));
    }
    return solids;
  }

  Joined joined(Kind kind, Solids solids, int taken) {
    Boxes boxes{kind, {}, std::move(solids.boxes)};
    if (have_few_cells(boxes, grows())) {
      if (solids.others.empty()) return boxes;
      if (!boxes.children.empty()) solids.others.push_back(exact(boxes, taken));
    } else {
      for (const Boxes& child : boxes.children) solids.others.push_back(exact(child, taken));
    }
    return all_of(std::move(solids.others), kind == Kind::unite ? Operation::unite : Operation::intersect, progress_);
  }

  Joined difference(std::vector<PartPtr> parts, const Place& at) {
    std::vector<PartPtr> rest(parts.begin() + 1, parts.end());
    Joined first;
    if (has_own(*parts.front(), at)) {  // subtract the solids of the same frame in that frame
      const Place own{at.taken, frames_.of(*parts.front())};
      const auto other = std::stable_partition(rest.begin(), rest.end(),
                                               [&](const PartPtr& part) { return frames_.of(*part) == own.frame; });
      parts.resize(1);
      parts.insert(parts.end(), rest.begin(), other);
      rest.erase(rest.begin(), other);
      first = turned(difference(parts, own), own, at.frame);
    } else {
      first = joined(*parts.front(), at);
    }
    const Place within{at.taken + 1, at.frame};
    Solids others = all(Kind::unite, rest, within);
    if (const auto* boxes = std::get_if<Boxes>(&first)) {
      Boxes whole{Kind::subtract, {}, {*boxes}};
      whole.children.insert(whole.children.end(), others.boxes.begin(), others.boxes.end());
      if (have_few_cells(whole, grows())) {
        first = std::move(whole);
        others.boxes.clear();
      }
    }
    if (others.boxes.empty() && others.others.empty()) return first;
    return combined(exact(first, at.taken), exact(joined(Kind::unite, std::move(others), within.taken), within.taken),
                    Operation::subtract);
  }

  ExactSolid exact(const Joined& joined, int taken) {
    if (const auto* boxes = std::get_if<Boxes>(&joined)) return ExactSolid(surface(*boxes, taken));
    return std::get<ExactSolid>(joined);
  }

  Drawing drawing_;
  const Frames& frames_;
  Progress& progress_;
};

/// Rounds corners to a lattice that is much finer than single precision and coarser than the loss
/// of rotations and translations in double precision. So corners that should coincide do, and faces
/// along the axes are in one plane.
Polyhedron settled(Polyhedron solid, double farthest) {
  const double step = std::exp2(std::ceil(std::log2(farthest)) - 34);
  for (Vec3& p : solid.vertices) p = (p / step).array().round().matrix() * step;
  return welded(solid);
}

std::optional<TriangleMesh> mesh_of(const Part& part, Joiner joiner, const Eigen::Affine3d& placement) {
  try {
    const Polyhedron surface = joiner.surface(part);
    if (surface.empty()) return std::nullopt;  // the search for bounds handles empty solids
    return in_single_precision(moved(surface, placement));
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled || error.kind() == ErrorKind::io) throw;
    return std::nullopt;
  }
}

}  // namespace

Polyhedron polyhedron_of(const Part& part, Progress& progress) {
  if (part.kind == Part::Kind::leaf) return part.leaf->polyhedron();
  const Drawing drawing{[](const Leaf& leaf, const Eigen::Matrix3d&) { return leaf.polyhedron(); }};
  return Joiner(drawing, Frames(), progress).surface(part);
}

std::optional<TriangleMesh> faces_of(const Part& part, Progress& progress) {
  constexpr std::size_t most = 1500;  // Minkowski sums have thousands of overlapping pieces; a contour is faster
  if (part.empty() || !all_flat(part) || count_of_many_sided(part) > most) return std::nullopt;
  const Box box = bounds_of(part);
  const double farthest = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
  const Frames frames(part, farthest);
  const Eigen::Affine3d placement(frames.axes(frames.whole()).inverse());
  const auto as_drawn = [&](const Leaf& leaf, const Eigen::Matrix3d& axes) {
    const Polyhedron solid = settled(moved(leaf.polyhedron(), Eigen::Affine3d(axes)), farthest);
    return leaf.convex() ? divided_evenly(convex_hull(solid.vertices)) : solid;
  };
  // Several last places of single precision.
  const double step = 4e-6 * farthest, same = 0.5 * step;  // OpenSCAD's six digits lose less
  // A surface that is thinner remains only between different triangulations of faces in one plane,
  // or between solids that were grown; it is ignored.
  const auto is_thin = [](const TriangleMesh& surface, double thinnest) {
    return surface.volume() < thinnest * surface.area();
  };
  if (auto surface = mesh_of(part, {{as_drawn, same}, frames, progress}, placement);
      surface && !is_thin(*surface, same))
    return surface;
  // Growth by different amounts separates faces that were in one plane and edges that were one
  // line. Subtracted solids grow more, so that no skin remains.
  constexpr int amounts = 8;
  int number = 0;
  const auto apart = [&](int taken) {
    const double growth = (1 + number + amounts * taken) * step;
    number = (number + 5) % amounts;
    return growth;
  };
  auto surface = mesh_of(part, {{as_drawn, same, apart}, frames, progress}, placement);
  if (surface && is_thin(*surface, 2 * amounts * step)) surface.reset();
  return surface;
}

}  // namespace fieldfab::openscad
