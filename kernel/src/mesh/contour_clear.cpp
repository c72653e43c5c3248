#include "contour_clear.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contour_octree.h"

namespace fieldfab::contouring {
namespace {

// Five directions about a middle one span a pyramid. A Field that grows along all five grows along all directions of the round
// cone in it; the tangent of the cone's half angle is that of the pyramid's edges times the cosine of 36 degrees.
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

/// Adds the directions of the gradients at the corners of a box: where planes meet in it, each of them shows at some corner.
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

/// A narrow cone: the narrowest about the two or three directions that differ most, which then is turned towards what it leaves
/// out (Badoiu and Clarkson 2003, for balls). Not looked for where two directions differ so much that none has a cosine of
/// `least`.
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
  explicit Wanted(int halvings) : tangent(1 / std::ldexp(steepest_in_voxels, halvings)) {}
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

/// Whether the Field grows along all `directions` wherever in the box its interval leaves room for a surface, as far as its
/// halves and quarters tell.
bool grows_where_undecided(const Field& field, const Box& box, std::span<const Vec3> directions, int depth) {
  std::array<Interval, edges_of_pyramid> slopes;
  field.slopes(box, directions, slopes);
  if (grows(slopes)) return true;
  if (depth == 0) return false;
  const std::array<Box, 8> parts = halves(box);
  std::array<Restriction, 8> here;
  field.restrict_all(parts, Purpose::value, here);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!here[i].range.decided() && !grows_where_undecided(*here[i].field, parts[i], directions, depth - 1)) return false;
  return true;
}

/// The gradients at the corners of a box, or of those of its parts that the Field's interval leaves room for a surface in.
void add_gradients_where_undecided(const Field& field, const Box& box, int depth, std::vector<Eigen::Vector3f>& normals) {
  if (depth == 0) return add_gradients(field, box, normals);
  const std::array<Box, 8> parts = halves(box);
  std::array<Restriction, 8> here;
  field.restrict_all(parts, Purpose::value, here);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!here[i].range.decided()) add_gradients_where_undecided(*here[i].field, parts[i], depth - 1, normals);
}

}  // namespace

Proof look(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals, double side, int halvings) {
  const std::size_t given = normals.size();
  add_gradients(field, box, normals);
  const Wanted wanted(halvings);
  const Cone cone = cone_about(normals, wanted.least_cosine());
  normals.resize(given);
  Proof proof;
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
  // Where a face of the solid may reach into the box that no sample is on, the directions in which the Field may fall tell which
  // way to turn.
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

Proof look_closer(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals, int halvings, int deep) {
  const Wanted wanted(halvings);
  const std::array<Box, 8> parts = halves(box);
  std::array<Restriction, 8> here;
  field.restrict_all(parts, Purpose::value, here);
  const std::size_t given = normals.size();
  Proof proof;
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

namespace {

/// Looks at a block, then at its parts where that is not enough.
class BlockInspector {
 public:
  BlockInspector(const Lattice& lattice, const LatticePoint& block, const BlockSamples& samples)
      : lattice_(lattice), block_(block), samples_(samples) {
    open_.fill(true);
  }

  std::vector<UnclearCell> run(const Field& field) {
    if (!field.affine()) {
      std::vector<std::uint32_t> points(samples_.points.size());
      for (std::uint32_t i = 0; i < points.size(); ++i) points[i] = i;
      inspect({0, 0, 0}, block_side, field, points);
    } else {
      known_ = true;
    }
    if (failures_ > rough)
      for (UnclearCell& cell : unclear_) cell.field.reset(), cell.folded = false;
    return std::move(unclear_);
  }
  [[nodiscard]] bool known() const { return known_; }

 private:
  using Corner = std::array<int, 3>;  // in cells from the block's
  static constexpr int rough = 256;   // as many folded cells, half of the block, are no sheet: smaller ones would be folded, too

  [[nodiscard]] LatticePoint point(const Corner& at) const {
    const int step = lattice_.voxel_level();
    return moved(block_, at[0] << step, at[1] << step, at[2] << step);
  }
  [[nodiscard]] Box cube(const Corner& at, int side) const {
    int level = lattice_.voxel_level();
    for (int s = side; s > 1; s /= 2) ++level;
    return lattice_.cube(point(at), level).grown(overlap * lattice_.voxel());
  }

  void add(const Corner& at, FieldPtr field, bool folded) {
    unclear_.push_back({point(at), lattice_.voxel_level(), std::move(field), folded});
  }

  /// Whether a cell's corners show several patches, or a face that could be joined in two ways.
  [[nodiscard]] bool is_ambiguous(const Corner& at) const {
    const std::uint8_t corners = samples_.corners[Block::cell(at[0], at[1], at[2])];
    return !is_uniform(corners) && !is_simple(corners);
  }

  [[nodiscard]] bool any_open(const Corner& at, int side) const {
    for (int z = at[2]; z < at[2] + side; ++z)
      for (int y = at[1]; y < at[1] + side; ++y)
        for (int x = at[0]; x < at[0] + side; ++x)
          if (open_[Block::cell(x, y, z)]) return true;
    return false;
  }

  void inspect(const Corner& at, int side, const Field& field, std::span<const std::uint32_t> points) {
    if (field.smooth() || failures_ > rough) return leave_open_cells(at, side);
    const Box box = cube(at, side);
    normals_.clear();
    for (const std::uint32_t i : points) add_normal(samples_.points[i], normals_);
    const Proof proof = look(field, box, normals_, lattice_.voxel(), 0);
    known_ = known_ || proof.known;
    if (proof.one_sheet) return;
    if (proof.known) close_far_cells(at, side, proof.change);
    if (side == 1) {
      if (!open_[Block::cell(at[0], at[1], at[2])]) return;
      // Where it has been to no avail often, it is not worth much more.
      constexpr int patience = 24;
      const Proof closer = look_closer(field, box, normals_, 0, failures_ > patience + successes_ ? 0 : 2);
      ++(closer.one_sheet ? successes_ : failures_);
      if (!closer.one_sheet) add(at, field.shared_from_this(), closer.folded || is_ambiguous(at));
      return;
    }
    inspect_parts(at, side / 2, field, proof.known, points);
  }

  void inspect_parts(const Corner& at, int half, const Field& field, bool known, std::span<const std::uint32_t> points) {
    std::array<Corner, 8> corner;
    std::array<Box, 8> boxes;
    std::size_t count = 0;
    for (int part = 0; part < 8; ++part) {
      const Corner here{at[0] + (part & 1) * half, at[1] + (part >> 1 & 1) * half, at[2] + (part >> 2) * half};
      if (!any_open(here, half)) continue;
      corner[count] = here;
      boxes[count++] = cube(here, half);
    }
    std::array<Restriction, 8> parts;
    field.restrict_all({boxes.data(), count}, Purpose::value, parts);
    const bool simpler = std::any_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(count),
                                     [&](const Restriction& part) { return part.field.get() != &field; });
    if (!simpler && !known) return leave_open_cells(at, 2 * half);
    std::vector<std::uint32_t> inner;
    for (std::size_t i = 0; i < count; ++i) {
      if (parts[i].range.decided()) continue;
      inner.clear();
      for (const std::uint32_t j : points)
        if (boxes[i].contains(samples_.points[j].position.cast<double>())) inner.push_back(j);
      inspect(corner[i], half, *parts[i].field, inner);
    }
  }

  /// A Field that is the same in the parts of a cube (a mesh, a scan) is dear to ask, and tells little more of each: what is
  /// still open there is not looked into.
  void leave_open_cells(const Corner& at, int side) {
    for (int z = at[2]; z < at[2] + side; ++z)
      for (int y = at[1]; y < at[1] + side; ++y)
        for (int x = at[0]; x < at[0] + side; ++x)
          if (open_[Block::cell(x, y, z)]) add({x, y, z}, nullptr, false);
  }

  /// Cells whose corners are all on one side, farther from zero than the value can change on the way to any point of the cell.
  void close_far_cells(const Corner& at, int side, double change) {
    constexpr int row = block_side + 1;
    for (int z = at[2]; z < at[2] + side; ++z)
      for (int y = at[1]; y < at[1] + side; ++y)
        for (int x = at[0]; x < at[0] + side; ++x) {
          const std::size_t cell = Block::cell(x, y, z);
          if (!open_[cell] || !is_uniform(samples_.corners[cell])) continue;
          const float* value = samples_.values + x + row * (y + row * z);
          float least = std::numeric_limits<float>::infinity();
          for (const int corner : {0, 1, row, row + 1, row * row, row * row + 1, row * row + row, row * row + row + 1})
            least = std::min(least, std::abs(value[corner]));
          if (static_cast<double>(least) > change) open_[cell] = false;
        }
  }

  const Lattice& lattice_;
  const LatticePoint& block_;
  const BlockSamples& samples_;
  std::array<bool, block_side * block_side * block_side> open_;
  std::vector<UnclearCell> unclear_;
  std::vector<Eigen::Vector3f> normals_;
  int failures_ = 0, successes_ = 0;  ///< of looking closer
  bool known_ = false;
};

}  // namespace

std::vector<UnclearCell> unclear_cells(const Field& field, const Lattice& lattice, const LatticePoint& block,
                                       const BlockSamples& samples, bool& known) {
  BlockInspector inspector(lattice, block, samples);
  std::vector<UnclearCell> unclear = inspector.run(field);
  known = known || inspector.known();
  return unclear;
}

}  // namespace fieldfab::contouring
