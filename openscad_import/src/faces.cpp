// A part's surface by exact arithmetic, where its leafs have flat faces.
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <functional>
#include <map>
#include <span>
#include <variant>

#include "boxes.h"
#include "fieldfab/core/error.h"
#include "fieldfab/mesh/exact_solid.h"
#include "leaf.h"
#include "surface_field.h"

namespace fieldfab::openscad {
namespace {

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

/// A plane of a solid's faces.
struct Face {
  Vec3 normal;
  double offset;  ///< mm, of the plane from the origin along its normal
  double area = 0;
  bool shared = false;  ///< another solid has faces in this plane
};
using Faces = std::vector<Face>;  // of one solid

Faces planes_of(const Polyhedron& solid) {
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

/// Marks what is in one plane, to OpenSCAD's six digits, with faces of another solid, whichever way these look.
void mark_shared(std::vector<Faces>& solids, double farthest) {
  struct Seen {
    double number;  // of the plane: those of different planes are different as a rule
    Face* face;
    double side;  // 1 or -1: its normal's
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

/// Three axes, as rows, along which a solid's first faces look. OpenSCAD writes turns with six digits, and so they are only
/// nearly across each other.
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

/// How much of a solid's shared faces looks along one of the axes: 0 to 1; 0 where it has none.
double share_along(const Eigen::Matrix3d& axes, const Faces& faces) {
  constexpr double nearly = 1e-9;
  double along = 0, all = 0;
  for (const Face& face : faces) {
    if (!face.shared) continue;
    all += face.area;
    for (Eigen::Index i = 0; i < 3; ++i)
      if (axes.row(i).transpose().cross(face.normal).norm() < nearly) along += face.area;
  }
  return all > 0 ? along / all : 0;
}

/// The axes, as rows, along which most faces look that share a plane: seen along them what was turned is of rounded numbers, and
/// faces that were drawn in one plane are in one.
Eigen::Matrix3d best_axes(const Part& part, double farthest) {
  std::vector<Faces> leafs;
  const std::function<void(const Part&)> visit = [&](const Part& here) {
    for (const PartPtr& child : here.children) visit(*child);
    if (here.leaf == nullptr) return;
    if (Faces faces = planes_of(here.leaf->polyhedron()); !faces.empty()) leafs.push_back(std::move(faces));
  };
  visit(part);
  mark_shared(leafs, farthest);
  for (Faces& faces : leafs)
    std::sort(faces.begin(), faces.end(),
              [](const Face& a, const Face& b) { return std::pair(a.shared, a.area) > std::pair(b.shared, b.area); });
  constexpr std::size_t most = 32;
  std::vector<Eigen::Matrix3d> known{Eigen::Matrix3d::Identity()};
  for (const Faces& faces : leafs) {
    if (!faces.front().shared) continue;
    const Eigen::Matrix3d axes = axes_of(faces);
    const double enough = 0.999 * share_along(axes, faces);
    const auto has_them = [&](const Eigen::Matrix3d& other) { return share_along(other, faces) >= enough; };
    if (known.size() < most && std::none_of(known.begin(), known.end(), has_them)) known.push_back(axes);
  }
  std::vector<double> shares;
  for (const Eigen::Matrix3d& axes : known) {
    shares.push_back(0);
    for (const Faces& faces : leafs) shares.back() += share_along(axes, faces);
  }
  return known[static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin())];
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

/// How leafs become solids.
struct Drawing {
  std::function<Polyhedron(const Leaf&)> solid;
  double same = 0;  ///< faces of boxes no farther apart are in one plane, mm
  /// How far the next solid is grown, mm; `taken` is how often it is taken away from what is taken away. Null where none is.
  std::function<double(int taken)> growth = nullptr;
};

/// Joins a part's leafs by exact arithmetic: boxes by their cells, as many together as can be, and all else by corefinement.
class Joiner {
 public:
  Joiner(Drawing drawing, Progress& progress) : drawing_(std::move(drawing)), progress_(progress) {}

  Polyhedron surface(const Part& part) {
    const Joined all = joined(part, 0);
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

  [[nodiscard]] bool grows() const { return drawing_.growth != nullptr; }
  Polyhedron surface(const Boxes& boxes, int taken) {
    return surface_of(boxes, drawing_.same, grows() ? drawing_.growth(taken) : 0, progress_);
  }

  Joined joined(const Part& part, int taken) {
    progress_.report(0, "joining solids");
    progress_.check();
    if (part.kind == Kind::nothing) return Boxes{};
    if (part.kind == Kind::leaf) {
      const Polyhedron solid = drawing_.solid(*part.leaf);
      if (const auto box = box_of(solid); box && box->size().minCoeff() > drawing_.same) return Boxes{Kind::leaf, *box, {}};
      return ExactSolid(grows() ? grown(solid, drawing_.growth(taken)) : solid);
    }
    if (part.kind == Kind::subtract) return difference(part.children, taken);
    return joined(part.kind, all(part.children, taken), taken);
  }

  Solids all(std::span<const PartPtr> parts, int taken) {
    Solids solids;
    for (const PartPtr& part : parts) {
      Joined one = joined(*part, taken);
      if (auto* boxes = std::get_if<Boxes>(&one))
        solids.boxes.push_back(std::move(*boxes));
      else
        solids.others.push_back(std::get<ExactSolid>(std::move(one)));
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

  Joined difference(std::span<const PartPtr> parts, int taken) {
    Joined first = joined(*parts.front(), taken);
    Solids others = all(parts.subspan(1), taken + 1);
    if (const auto* boxes = std::get_if<Boxes>(&first)) {
      Boxes rest{Kind::subtract, {}, {*boxes}};
      rest.children.insert(rest.children.end(), others.boxes.begin(), others.boxes.end());
      if (have_few_cells(rest, grows())) {
        first = std::move(rest);
        others.boxes.clear();
      }
    }
    if (others.boxes.empty() && others.others.empty()) return first;
    return combined(exact(first, taken), exact(joined(Kind::unite, std::move(others), taken + 1), taken + 1),
                    Operation::subtract);
  }

  ExactSolid exact(const Joined& joined, int taken) {
    if (const auto* boxes = std::get_if<Boxes>(&joined)) return ExactSolid(surface(*boxes, taken));
    return std::get<ExactSolid>(joined);
  }

  Drawing drawing_;
  Progress& progress_;
};

/// With corners on a lattice that is much finer than single precision, and coarser than what turning and moving loses in double:
/// so that corners which are to be the same are, and faces along the axes are in one plane.
Polyhedron settled(Polyhedron solid, double farthest) {
  const double step = std::exp2(std::ceil(std::log2(farthest)) - 34);
  for (Vec3& p : solid.vertices) p = (p / step).array().round().matrix() * step;
  return welded(solid);
}

std::optional<TriangleMesh> mesh_of(const Part& part, Joiner joiner, const Eigen::Affine3d& placement) {
  try {
    const Polyhedron surface = joiner.surface(part);
    if (surface.empty()) return std::nullopt;  // as it is for whoever looks for its bounds
    return in_single_precision(moved(surface, placement));
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled || error.kind() == ErrorKind::io) throw;
    return std::nullopt;
  }
}

}  // namespace

Polyhedron polyhedron_of(const Part& part, Progress& progress) {
  if (part.kind == Part::Kind::leaf) return part.leaf->polyhedron();
  return Joiner({[](const Leaf& leaf) { return leaf.polyhedron(); }}, progress).surface(part);
}

std::optional<TriangleMesh> faces_of(const Part& part, Progress& progress) {
  if (part.empty() || !all_flat(part)) return std::nullopt;
  const Box box = bounds_of(part);
  const double farthest = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
  Eigen::Affine3d turn = Eigen::Affine3d::Identity();
  turn.linear() = best_axes(part, farthest);
  const auto as_drawn = [&](const Leaf& leaf) {
    const Polyhedron solid = settled(moved(leaf.polyhedron(), turn), farthest);
    return leaf.convex() ? divided_evenly(convex_hull(solid.vertices)) : solid;
  };
  // Some last places of single precision.
  const double step = 4e-6 * farthest, same = 0.5 * step;  // OpenSCAD's six digits lose less
  if (auto surface = mesh_of(part, {{as_drawn, same}, progress}, turn.inverse())) return surface;
  // Grown by different amounts, faces that were in one plane and edges that were one line are apart; what is taken away is grown
  // more, so that no skin stays.
  constexpr int amounts = 8;
  int number = 0;
  const auto apart = [&](int taken) {
    const double growth = (1 + number + amounts * taken) * step;
    number = (number + 5) % amounts;
    return growth;
  };
  auto surface = mesh_of(part, {{as_drawn, same, apart}, progress}, turn.inverse());
  // What is no thicker than solids were grown is not there: they touched.
  if (surface && surface->volume() < 2 * amounts * step * surface->area()) surface.reset();
  return surface;
}

}  // namespace fieldfab::openscad
