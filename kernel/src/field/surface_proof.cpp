#include "fieldfab/field/surface_proof.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bitset>
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

/// Corners of up to eight boxes, each once: found by the planes that they lie in, of which boxes share most. Where
/// planes meet in a box, each of them shows at some corner.
class Corners {
 public:
  void add(const Box& box) {
    std::array<std::array<std::size_t, 3>, 2> plane;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      plane[0][axis] = plane_at(axis, static_cast<float>(box.lower[a]));
      plane[1][axis] = plane_at(axis, static_cast<float>(box.upper[a]));
    }
    for (unsigned i = 0; i < 8; ++i) add(plane[i & 1U][0], plane[i >> 1 & 1U][1], plane[i >> 2][2]);
  }

  /// Adds the directions of the gradients there. They are evaluated in one batch: eight points cost nearly as much as
  /// thirty. Returns the magnitude of the value nearest to zero if all values have one sign, otherwise 0.
  float add_gradients(const Field& field, std::vector<Eigen::Vector3f>& normals) const {
    if (count_ == 0) return 0;
    std::array<float, most> value, dx, dy, dz;
    field.gradients({x_.data(), y_.data(), z_.data(), count_}, value.data(), {dx.data(), dy.data(), dz.data()});
    for (std::size_t i = 0; i < count_; ++i) {
      const Eigen::Vector3f gradient(dx[i], dy[i], dz[i]);
      const float length = gradient.norm();
      if (std::isfinite(length) && length > 0) normals.push_back(gradient / length);
    }
    const float first = value[0];
    float least = std::abs(first);
    for (std::size_t i = 0; i < count_; ++i) {
      if (!((value[i] < 0) == (first < 0)) || std::isnan(value[i])) return 0;
      least = std::min(least, std::abs(value[i]));
    }
    return least;
  }

 private:
  static constexpr std::size_t most_planes = 16, most = 64;  // of eight boxes

  std::size_t plane_at(std::size_t axis, float at) {
    auto& planes = planes_[axis];
    std::size_t i = 0;
    while (i < plane_count_[axis] && planes[i] != at) ++i;
    if (i == plane_count_[axis]) planes[plane_count_[axis]++] = at;
    return i;
  }
  void add(std::size_t x, std::size_t y, std::size_t z) {
    const std::size_t corner = x + most_planes * (y + most_planes * z);
    if (there_[corner]) return;
    there_[corner] = true;
    x_[count_] = planes_[0][x], y_[count_] = planes_[1][y], z_[count_] = planes_[2][z];
    ++count_;
  }

  std::array<std::array<float, most_planes>, 3> planes_;
  std::array<std::size_t, 3> plane_count_{};
  std::bitset<most_planes * most_planes * most_planes> there_;
  std::array<float, most> x_, y_, z_;
  std::size_t count_ = 0;
};

/// Up to eight boxes that make up another one.
struct Boxes {
  std::size_t count = 8;
  std::array<Box, 8> box;
};

/// Parts of a box, and a Field with the same sign in each.
struct Parts : Boxes {
  Parts(const Field& field, const Boxes& boxes) : Boxes(boxes) {
    field.restrict_all({box.data(), count}, Purpose::occupancy, here);
  }
  /// Whether the Field's interval leaves room for a surface in a part.
  [[nodiscard]] bool undecided(std::size_t part) const { return !here[part].range.decided(); }

  std::array<Restriction, 8> here;
};

/// The cone about the directions that the surface is seen to face: its axis, and the cosine of its half angle.
struct Cone {
  Eigen::Vector3f axis = Eigen::Vector3f::UnitZ();
  float cosine = 1;
};

/// Directions, one coordinate after another: they are compared to axes in lanes.
class Directions {
 public:
  explicit Directions(const std::vector<Eigen::Vector3f>& directions)
      : count_((directions.size() + lanes - 1) / lanes * lanes) {
    static thread_local std::vector<float> kept;
    kept.resize(4 * count_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at_[axis] = kept.data() + axis * count_;
      const auto a = static_cast<Eigen::Index>(axis);
      for (std::size_t i = 0; i < directions.size(); ++i) at_[axis][i] = directions[i][a];
      // What fills the last lanes is not the first of any that are as far.
      for (std::size_t i = directions.size(); i < count_; ++i) at_[axis][i] = directions[0][a];
    }
    cosines_ = kept.data() + 3 * count_;
  }

  [[nodiscard]] Eigen::Vector3f operator[](std::size_t i) const { return {at_[0][i], at_[1][i], at_[2][i]}; }

  /// The first of those farthest from an axis.
  [[nodiscard]] Eigen::Vector3f farthest_from(const Eigen::Vector3f& axis) const {
    Lanes least = Lanes::Constant(std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < count_; i += lanes) {
      const auto lane = [&](const float* first) { return Eigen::Map<const Lanes>(first + i); };
      const Lanes cosines = axis.x() * lane(at_[0]) + (axis.y() * lane(at_[1]) + axis.z() * lane(at_[2]));
      Eigen::Map<Lanes>(cosines_ + i) = cosines;
      least = least.min(cosines);
    }
    const float* const farthest = std::find(cosines_, cosines_ + count_, least.minCoeff());
    return (*this)[static_cast<std::size_t>(farthest - cosines_)];
  }

 private:
  static constexpr int lanes = 8;
  using Lanes = Eigen::Array<float, lanes, 1>;
  std::size_t count_;  ///< a multiple of `lanes`
  std::array<float*, 3> at_;
  float* cosines_;
};

/// A narrow cone: the narrowest about the two or three directions that differ most, which then is turned towards what
/// it leaves out (Badoiu and Clarkson 2003, for balls). Not looked for where two directions differ so much that none
/// has a cosine of `least`.
Cone cone_about(const std::vector<Eigen::Vector3f>& seen, float least) {
  Cone cone;
  if (seen.empty()) return cone;
  const Directions directions(seen);
  const Eigen::Vector3f one = directions.farthest_from(directions[0]), other = directions.farthest_from(one);
  if (one.dot(other) < 2 * least * least - 1) return {directions[0], -1};
  const auto try_axis = [&](Eigen::Vector3f axis) {
    const float length = axis.norm();
    if (!(length > 1e-4F)) return;
    axis *= (axis.dot(one) < 0 ? -1 : 1) / length;
    if (const float cosine = directions.farthest_from(axis).dot(axis); cosine > cone.cosine) cone = {axis, cosine};
  };
  cone = {one, other.dot(one)};
  try_axis(one + other);
  constexpr float wide = 0.9F;
  if (cone.cosine > wide) return cone;
  const Eigen::Vector3f third = directions.farthest_from(cone.axis);
  try_axis((other - one).cross(third - one));
  constexpr int turns = 12;
  Eigen::Vector3f axis = cone.axis;
  for (int turn = 4; turn < 4 + turns && cone.cosine < wide; ++turn) {
    axis = (axis + (directions.farthest_from(axis) - axis) / static_cast<float>(turn)).normalized().eval();
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

/// Halves a box along each axis that the Field reads.
Boxes halves(const Field& field, const Box& box) {
  const unsigned unread = field.unread_axes();
  const Vec3 centre = box.centre();
  Boxes parts{0, {}};
  for (unsigned part = 0; part < 8; ++part) {
    if ((part & unread) != 0) continue;
    Box& half = parts.box[parts.count++] = box;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      if ((unread >> axis & 1U) == 0) ((part >> axis & 1U) != 0 ? half.lower : half.upper)[axis] = centre[axis];
  }
  return parts;
}

bool undecided_parts_grow(const Parts& parts, std::span<const Vec3> directions, int depth);

/// Whether the Field grows along all `directions` wherever in the box its interval leaves room for a surface, as far as
/// its halves and quarters tell.
bool grows_where_undecided(const Field& field, const Box& box, std::span<const Vec3> directions, int depth) {
  std::array<Interval, edges_of_pyramid> slopes;
  field.slopes(box, directions, slopes);
  if (grows(slopes)) return true;
  if (depth == 0) return false;
  const Parts parts(field, halves(field, box));
  return undecided_parts_grow(parts, directions, depth - 1);
}

bool undecided_parts_grow(const Parts& parts, std::span<const Vec3> directions, int depth) {
  for (std::size_t i = 0; i < parts.count; ++i)
    if (parts.undecided(i) && !grows_where_undecided(*parts.here[i].field, parts.box[i], directions, depth))
      return false;
  return true;
}

/// Adds the gradients at the corners of those parts that may hold a surface, or of their halves.
void add_gradients_where_undecided(const Field& field, const Parts& parts, int depth,
                                   std::vector<Eigen::Vector3f>& normals) {
  Corners corners;
  for (std::size_t i = 0; i < parts.count; ++i) {
    if (!parts.undecided(i)) continue;
    const Field& here = *parts.here[i].field;
    if (depth == 0)
      corners.add(parts.box[i]);
    else
      add_gradients_where_undecided(here, {here, halves(here, parts.box[i])}, depth - 1, normals);
  }
  if (depth == 0) corners.add_gradients(field, normals);
}

/// Eight slabs of a box across an axis.
Boxes slabs(const Box& box, Eigen::Index axis) {
  Boxes parts;
  parts.box.fill(box);
  for (std::size_t i = 0; i < parts.count; ++i) {
    const auto plane = [&](std::size_t n) {
      return n == parts.count
                 ? box.upper[axis]
                 : box.lower[axis] + static_cast<double>(n) / static_cast<double>(parts.count) * box.size()[axis];
    };
    parts.box[i].lower[axis] = plane(i);
    parts.box[i].upper[axis] = plane(i + 1);
  }
  return parts;
}

/// Tries the proof from parts: where the Field grows in each along the edges of a pyramid about the cone of directions
/// that the surface faces there. Parts that are decided lie on one side whatever their slopes.
SurfaceProof prove_by_parts(const Field& field, const Parts& parts, std::vector<Eigen::Vector3f>& normals,
                            const Wanted& wanted, int gradients_deep, int deep) {
  const std::size_t given = normals.size();
  add_gradients_where_undecided(field, parts, gradients_deep, normals);
  const Cone cone = cone_about(normals, wanted.least_cosine());
  normals.resize(given);
  SurfaceProof proof;
  proof.folded = cone.cosine < wanted.least_cosine();
  if (proof.folded) return proof;
  const auto directions = wanted.directions(cone);
  proof.one_sheet = undecided_parts_grow(parts, {directions.data() + 3, edges_of_pyramid}, deep);
  return proof;
}

/// The axis that the surface is seen to face most, and whether it is seen to face nothing else.
struct MainAxis {
  explicit MainAxis(const std::vector<Eigen::Vector3f>& normals) {
    Eigen::Vector3f facing = Eigen::Vector3f::Zero();
    for (const Eigen::Vector3f& normal : normals) facing += normal.cwiseAbs();
    constexpr float all = 0.999F;
    only = facing.maxCoeff(&axis) > all * static_cast<float>(normals.size());
  }
  Eigen::Index axis = 0;
  bool only = false;
};

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
  const Directions facing(directions);
  const Eigen::Vector3f one = facing.farthest_from(facing[0]);
  proof.folded = one.dot(facing.farthest_from(one)) < opposite;
  return proof;
}

}  // namespace

namespace {

SurfaceProof prove_by_slopes(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals, double side,
                             int halvings) {
  const std::size_t given = normals.size();
  Corners corners;
  corners.add(box);
  const float least = corners.add_gradients(field, normals);
  const Wanted wanted(halvings);
  const Cone cone = cone_about(normals, wanted.least_cosine());
  normals.resize(given);
  SurfaceProof proof;
  proof.folded = cone.cosine < wanted.least_cosine();
  const auto directions = wanted.directions(cone);
  std::array<Interval, 3 + edges_of_pyramid> slopes;
  const std::size_t count = proof.folded ? 3 : directions.size();
  field.slopes(box, {directions.data(), count}, {slopes.data(), count});
  double change = 0, change_to_corner = 0;
  proof.known = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    proof.known = proof.known && !slopes[axis].maybe_nan;
    const double steepest = std::max(std::abs(slopes[axis].lower), std::abs(slopes[axis].upper));
    change += steepest;
    change_to_corner += steepest * box.size()[static_cast<Eigen::Index>(axis)] / 2;
  }
  constexpr double rounding = 1.001;
  proof.change = proof.known ? rounding * change * side / 2 : std::numeric_limits<double>::infinity();
  proof.empty = proof.known && static_cast<double>(least) > rounding * change_to_corner;
  if (proof.folded || !proof.known) return proof;
  const std::span<Interval> along{slopes.data() + 3, edges_of_pyramid};
  proof.one_sheet = grows(along);
  // Where a face of the solid may reach into the box that no sample is on, the directions in which the Field may fall
  // tell which way to turn. Where it may fall by much along all of them, no turn helps.
  constexpr int turns = 3;
  constexpr double step = 0.3;
  auto edges = directions;
  Vec3 axis = cone.axis.cast<double>();
  const bool hopeless =
      std::all_of(along.begin(), along.end(), [](const Interval& slope) { return slope.lower < -0.2F * slope.upper; });
  for (int turn = 0; turn < turns && !proof.one_sheet && !hopeless; ++turn) {
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
  const MainAxis main(normals);
  const auto prove_by_slabs = [&] {
    return prove_by_parts(field, {field, slabs(box, main.axis)}, normals, wanted, 0, 0);
  };
  SurfaceProof proof;
  if (main.only) proof = prove_by_slabs();
  if (proof.one_sheet) return proof;
  const Parts parts(field, halves(field, box));
  proof = prove_by_parts(field, parts, normals, wanted, 0, deep);
  if (proof.one_sheet) return proof;
  if (!main.only && !normals.empty())
    if (const SurfaceProof of_slabs = prove_by_slabs(); of_slabs.one_sheet) return of_slabs;
  return deep > 0 ? prove_by_parts(field, parts, normals, wanted, 1, deep) : proof;
}

}  // namespace fieldfab
