#include "fieldfab/field/surface_proof.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fieldfab {
namespace {

// Five directions about a middle one span a pyramid. A Field that grows along all five grows along all directions of
// the round cone in it; the tangent of the cone's half angle is that of the pyramid's edges times the cosine of 36
// degrees.
constexpr std::size_t edges_of_pyramid = 5;
constexpr double cosine_36 = 0.80901699;

/// The axes, and then the edges of a pyramid about `outward`.
std::array<Vec3, 3 + edges_of_pyramid> directions_about(const Vec3& outward, double tangent) {
  std::array<Vec3, 3 + edges_of_pyramid> directions{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  static const auto turns = [] {
    std::array<Eigen::Vector2d, edges_of_pyramid> made;
    for (std::size_t i = 0; i < edges_of_pyramid; ++i) {
      const double angle = 2 * 3.14159265358979 * static_cast<double>(i) / edges_of_pyramid;
      made[i] = {std::cos(angle), std::sin(angle)};
    }
    return made;
  }();
  const double length = std::sqrt(1 + tangent * tangent);
  const Vec3 across = tangent / length * outward.unitOrthogonal(), third = outward.cross(across);
  for (std::size_t i = 0; i < edges_of_pyramid; ++i)
    directions[3 + i] = outward / length + turns[i].x() * across + turns[i].y() * third;
  return directions;
}

/// Adds the directions of the gradients at the corners of a box: where planes meet in it, each of them shows at some
/// corner.
void add_gradients(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals) {
  std::array<float, 8> x, y, z, value, dx, dy, dz;
  for (unsigned i = 0; i < 8; ++i) {
    x[i] = static_cast<float>((i & 1U) != 0 ? box.upper.x() : box.lower.x());
    y[i] = static_cast<float>((i & 2U) != 0 ? box.upper.y() : box.lower.y());
    z[i] = static_cast<float>((i & 4U) != 0 ? box.upper.z() : box.lower.z());
  }
  field.gradients({x.data(), y.data(), z.data(), 8}, value.data(), {dx.data(), dy.data(), dz.data()});
  for (unsigned i = 0; i < 8; ++i) {
    const Eigen::Vector3f gradient(dx[i], dy[i], dz[i]);
    const float length = gradient.norm();
    if (std::isfinite(length) && length > 0) normals.push_back(gradient / length);
  }
}

/// The cone about the directions that the surface is seen to face: its axis, and the cosine of its half angle.
struct Cone {
  Eigen::Vector3f axis = Eigen::Vector3f::UnitZ();
  float cosine = 1;
};

const Eigen::Vector3f& farthest_from(const Eigen::Vector3f& axis, const std::vector<Eigen::Vector3f>& directions) {
  const Eigen::Vector3f* farthest = &directions.front();
  for (const Eigen::Vector3f& direction : directions)
    if (direction.dot(axis) < farthest->dot(axis)) farthest = &direction;
  return *farthest;
}

/// A narrow cone: the narrowest about the two or three directions that differ most, which then is turned towards what
/// it leaves out (Badoiu and Clarkson 2003, for balls). Not looked for where two directions differ so much that none
/// has a cosine of `least`.
Cone cone_about(const std::vector<Eigen::Vector3f>& directions, float least) {
  Cone cone;
  if (directions.empty()) return cone;
  const Eigen::Vector3f& one = farthest_from(directions.front(), directions);
  const Eigen::Vector3f& other = farthest_from(one, directions);
  if (one.dot(other) < 2 * least * least - 1) return {directions.front(), -1};
  const auto try_axis = [&](Eigen::Vector3f axis) {
    const float length = axis.norm();
    if (!(length > 1e-4F)) return;
    axis *= (axis.dot(one) < 0 ? -1 : 1) / length;
    if (const float cosine = farthest_from(axis, directions).dot(axis); cosine > cone.cosine) cone = {axis, cosine};
  };
  cone = {one, other.dot(one)};
  try_axis(one + other);
  constexpr float wide = 0.9F;
  if (cone.cosine > wide) return cone;
  const Eigen::Vector3f third = farthest_from(cone.axis, directions);
  try_axis((other - one).cross(third - one));
  constexpr int turns = 12;
  Eigen::Vector3f axis = cone.axis;
  for (int turn = 4; turn < 4 + turns && cone.cosine < wide; ++turn) {
    axis = (axis + (farthest_from(axis, directions) - axis) / static_cast<float>(turn)).normalized().eval();
    try_axis(axis);
  }
  return cone;
}

/// The cone of directions in which the Field must grow for a graph that is nowhere steeper than is allowed.
struct Wanted {
  explicit Wanted(int halvings) : tangent(1 / std::ldexp(steepest_in_cells, halvings)) {}
  /// The least cosine between a normal and the cone's axis.
  [[nodiscard]] float least_cosine() const { return static_cast<float>(tangent / std::sqrt(1 + tangent * tangent)); }
  [[nodiscard]] std::array<Vec3, 3 + edges_of_pyramid> directions(const Cone& cone) const {
    return directions_about(cone.axis.cast<double>(), tangent / cosine_36);
  }
  double tangent;
};

bool grows(std::span<const Interval> slopes) {
  return std::all_of(slopes.begin(), slopes.end(),
                     [](const Interval& slope) { return !slope.maybe_nan && slope.lower >= 0 && slope.upper > 0; });
}

std::array<Box, 8> halves(const Box& box) {
  std::array<Box, 8> parts;
  const Vec3 centre = box.centre();
  for (unsigned part = 0; part < 8; ++part)
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const bool upper = (part >> axis & 1U) != 0;
      parts[part].lower[axis] = upper ? centre[axis] : box.lower[axis];
      parts[part].upper[axis] = upper ? box.upper[axis] : centre[axis];
    }
  return parts;
}

/// Whether the Field grows along all `directions` wherever in the box its interval leaves room for a surface, as far as
/// its halves and quarters tell.
bool grows_where_undecided(const Field& field, const Box& box, std::span<const Vec3> directions, int depth) {
  std::array<Interval, edges_of_pyramid> slopes;
  field.slopes(box, directions, slopes);
  if (grows(slopes)) return true;
  if (depth == 0) return false;
  const std::array<Box, 8> parts = halves(box);
  std::array<Restriction, 8> here;
  field.restrict_all(parts, Purpose::value, here);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!here[i].range.decided() && !grows_where_undecided(*here[i].field, parts[i], directions, depth - 1))
      return false;
  return true;
}

/// The gradients at the corners of a box, or of those of its parts that the Field's interval leaves room for a surface
/// in.
void add_gradients_where_undecided(const Field& field, const Box& box, int depth,
                                   std::vector<Eigen::Vector3f>& normals) {
  if (depth == 0) return add_gradients(field, box, normals);
  const std::array<Box, 8> parts = halves(box);
  std::array<Restriction, 8> here;
  field.restrict_all(parts, Purpose::value, here);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!here[i].range.decided()) add_gradients_where_undecided(*here[i].field, parts[i], depth - 1, normals);
}

/// Eight slabs of a box across an axis.
std::array<Box, 8> slabs(const Box& box, Eigen::Index axis) {
  std::array<Box, 8> parts;
  parts.fill(box);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto plane = [&](std::size_t n) {
      return n == parts.size()
                 ? box.upper[axis]
                 : box.lower[axis] + static_cast<double>(n) / static_cast<double>(parts.size()) * box.size()[axis];
    };
    parts[i].lower[axis] = plane(i);
    parts[i].upper[axis] = plane(i + 1);
  }
  return parts;
}

/// Whether the slabs across the axis that the surface is seen to face most show one sheet: of thin plates along the
/// axes the other face lies in slabs of its own.
bool is_one_sheet_in_slabs(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals,
                           const Wanted& wanted) {
  if (normals.empty()) return false;
  Eigen::Vector3f facing = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& normal : normals) facing += normal.cwiseAbs();
  Eigen::Index axis = 0;
  facing.maxCoeff(&axis);
  const std::array<Box, 8> parts = slabs(box, axis);
  std::array<Restriction, 8> here;
  field.restrict_all(parts, Purpose::value, here);
  const std::size_t given = normals.size();
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!here[i].range.decided()) add_gradients(*here[i].field, parts[i], normals);
  const Cone cone = cone_about(normals, wanted.least_cosine());
  normals.resize(given);
  if (cone.cosine < wanted.least_cosine()) return false;
  const auto directions = wanted.directions(cone);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!here[i].range.decided() &&
        !grows_where_undecided(*here[i].field, parts[i], {directions.data() + 3, edges_of_pyramid}, 0))
      return false;
  return true;
}

/// prove_sheet() from Field::facing(). Edges of triangles are not folded unless they are sharper than 30 degrees: those
/// of scans are too many, and are seen all the same.
SurfaceProof prove_by_facing(const Field& field, const Box& box, int halvings) {
  static thread_local std::vector<Eigen::Vector3f> directions;
  directions.clear();
  SurfaceProof proof;
  proof.known = true;
  proof.change = std::numeric_limits<double>::infinity();
  const float least = Wanted(halvings).least_cosine();
  constexpr float rounding = 1e-5F, opposite = -0.866F;
  proof.one_sheet = field.facing(box, directions) && cone_about(directions, least).cosine >= least + rounding;
  if (proof.one_sheet || directions.empty()) return proof;
  const Eigen::Vector3f& one = farthest_from(directions.front(), directions);
  proof.folded = one.dot(farthest_from(one, directions)) < opposite;
  return proof;
}

}  // namespace

namespace {

SurfaceProof prove_by_slopes(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals, double side,
                             int halvings) {
  const std::size_t given = normals.size();
  add_gradients(field, box, normals);
  const Wanted wanted(halvings);
  const Cone cone = cone_about(normals, wanted.least_cosine());
  normals.resize(given);
  SurfaceProof proof;
  proof.folded = cone.cosine < wanted.least_cosine();
  const auto directions = wanted.directions(cone);
  std::array<Interval, 3 + edges_of_pyramid> slopes;
  const std::size_t count = proof.folded ? 3 : directions.size();
  field.slopes(box, {directions.data(), count}, {slopes.data(), count});
  double change = 0;
  proof.known = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    proof.known = proof.known && !slopes[axis].maybe_nan;
    change += std::max(std::abs(slopes[axis].lower), std::abs(slopes[axis].upper));
  }
  constexpr double rounding = 1.001;
  proof.change = proof.known ? rounding * change * side / 2 : std::numeric_limits<double>::infinity();
  if (proof.folded || !proof.known) return proof;
  const std::span<Interval> along{slopes.data() + 3, edges_of_pyramid};
  proof.one_sheet = grows(along);
  // Where a face of the solid may reach into the box that no sample is on, the directions in which the Field may fall
  // tell which way to turn.
  constexpr int turns = 3;
  constexpr double step = 0.3;
  auto edges = directions;
  Vec3 axis = cone.axis.cast<double>();
  for (int turn = 0; turn < turns && !proof.one_sheet; ++turn) {
    Vec3 away = Vec3::Zero();
    for (std::size_t i = 0; i < edges_of_pyramid; ++i) away += std::min(0.0F, along[i].lower) * (edges[3 + i] - axis);
    if (!(away.norm() > 0)) break;
    axis = (axis + step * away.normalized()).normalized();
    edges = directions_about(axis, wanted.tangent / cosine_36);
    field.slopes(box, {edges.data() + 3, edges_of_pyramid}, along);
    proof.one_sheet = grows(along);
  }
  return proof;
}

}  // namespace

SurfaceProof prove_sheet(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals, double side,
                         int halvings) {
  if (field.faceted()) return prove_by_facing(field, box, halvings);
  SurfaceProof proof = prove_by_slopes(field, box, normals, side, halvings);
  if (proof.one_sheet || !proof.known) return proof;
  const FieldPtr merged = field.without_seams();
  if (!merged) return proof;
  const SurfaceProof again = prove_by_slopes(*merged, box, normals, side, halvings);
  proof.one_sheet = again.one_sheet || merged->interval(box).decided();
  proof.folded = again.folded;
  return proof;
}

SurfaceProof prove_sheet_by_parts(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals,
                                  int halvings, int deep) {
  // What is no number is outside, which a formula without seams may forget.
  if (const FieldPtr merged = field.without_seams(); merged && !field.interval(box).maybe_nan)
    return prove_sheet_by_parts(*merged, box, normals, halvings, deep);
  const Wanted wanted(halvings);
  SurfaceProof proof;
  proof.one_sheet = is_one_sheet_in_slabs(field, box, normals, wanted);
  if (proof.one_sheet) return proof;
  const std::array<Box, 8> parts = halves(box);
  std::array<Restriction, 8> here;
  field.restrict_all(parts, Purpose::value, here);
  const std::size_t given = normals.size();
  for (int depth = 0; depth <= std::min(deep, 1) && !proof.one_sheet; ++depth) {
    normals.resize(given);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (!here[i].range.decided()) add_gradients_where_undecided(*here[i].field, parts[i], depth, normals);
    const Cone cone = cone_about(normals, wanted.least_cosine());
    proof.folded = cone.cosine < wanted.least_cosine();
    if (proof.folded) continue;
    const auto directions = wanted.directions(cone);
    const std::span<const Vec3> edges{directions.data() + 3, edges_of_pyramid};
    proof.one_sheet = true;
    for (std::size_t i = 0; i < parts.size() && proof.one_sheet; ++i)
      proof.one_sheet = here[i].range.decided() || grows_where_undecided(*here[i].field, parts[i], edges, deep);
  }
  return proof;
}

}  // namespace fieldfab
