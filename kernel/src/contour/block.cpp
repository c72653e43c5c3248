#include "block.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>

#include "edges.h"

namespace fieldfab::contouring {
namespace {

constexpr int points_a_side = block_side + 1;
constexpr int point_count = points_a_side * points_a_side * points_a_side;
constexpr std::array<int, 3> stride{1, points_a_side, points_a_side* points_a_side};

constexpr int point_index(int x, int y, int z) { return x + stride[1] * y + stride[2] * z; }

/// An edge of the block's lattice with a sign change.
struct Edge {
  std::uint8_t axis;
  std::array<std::uint8_t, 3> lower;
  SurfacePoint point = {};
};

/// Samples of a block and what follows from them; lives on the stack of sample_block().
class BlockSampler {
 public:
  BlockSampler(const Field& field, const Lattice& lattice, const LatticePoint& lower, const ContourSettings& settings)
      : field_(field), unread_(field.unread_axes()), lattice_(lattice), lower_(lower), settings_(settings) {
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i <= block_side; ++i)
        plane_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)] = static_cast<float>(
            lattice.plane(axis, lower[static_cast<std::size_t>(axis)] + (i << lattice.voxel_level())));
  }

  BlockView view(Block& block) {
    BlockView seen;
    block.lower = lower_;
    sample();
    find_sign_changes();
    Patch whole;
    if (take_plane(block, whole)) {
      look_for_unclear_cells(whole.points, seen);
      if (seen.complete) seen.patch = std::move(whole);
      return seen;
    }
    find_edges();
    locate_edges();
    std::vector<SurfacePoint> points;
    points.reserve(edges_.size());
    for (const Edge& edge : edges_) points.push_back(edge.point);
    look_for_unclear_cells(points, seen);
    if (seen.complete) seen.patch = merge_all(block);
    return seen;
  }

  std::optional<Patch> run(Block& block) {
    block.lower = lower_;
    sample();
    find_sign_changes();
    if (Patch whole; block.divisions.empty() && take_plane(block, whole)) return whole;
    find_edges();
    locate_edges();
    return merge_all(block);
  }

 private:
  void look_for_unclear_cells(std::span<const SurfacePoint> points, BlockView& seen) const {
    std::array<std::uint8_t, block_side * block_side * block_side> signs;
    for (int z = 0; z < block_side; ++z)
      for (int y = 0; y < block_side; ++y)
        for (int x = 0; x < block_side; ++x) signs[Block::cell(x, y, z)] = corners(x, y, z, 1);
    seen.crossed = static_cast<std::size_t>(
        std::count_if(signs.begin(), signs.end(), [](std::uint8_t corners) { return !is_uniform(corners); }));
    seen.complete = true;
    if (settings_.depth == 0) return;
    seen.unclear = unclear_cells(field_, lattice_, lower_, {value_.data(), signs, points}, seen.known);
    seen.complete =
        std::all_of(seen.unclear.begin(), seen.unclear.end(), [](const UnclearCell& cell) { return !cell.field; });
  }

  std::optional<Patch> merge_all(Block& block) {
    if (edges_.empty() && block.divisions.empty()) {
      Patch whole;
      whole.corners = inside(0, 0, 0) ? 255 : 0;
      return whole;
    }
    block.crossings.reserve(edges_.size());
    for (const Edge& edge : edges_)
      if (edge.lower[0] < block_side && edge.lower[1] < block_side && edge.lower[2] < block_side)
        block.crossings.push_back(
            {edge.axis, edge.lower, inside(edge.lower[0], edge.lower[1], edge.lower[2]), edge.point});
    return merge(block);
  }

  static std::size_t lower_end(const Edge& edge) {
    return static_cast<std::size_t>(point_index(edge.lower[0], edge.lower[1], edge.lower[2]));
  }

  /// Points beside each other along axes that the Field does not read have one value.
  void sample() {
    std::array<float, point_count> x, y, z;
    std::array<std::size_t, 3> points;
    for (std::size_t axis = 0; axis < 3; ++axis) points[axis] = reads(axis) ? points_a_side : 1;
    std::size_t count = 0;
    for (std::size_t k = 0; k < points[2]; ++k)
      for (std::size_t j = 0; j < points[1]; ++j)
        for (std::size_t i = 0; i < points[0]; ++i, ++count) {
          x[count] = plane_[0][i];
          y[count] = plane_[1][j];
          z[count] = plane_[2][k];
        }
    field_.values({x.data(), y.data(), z.data(), count}, value_.data());
    if (count < point_count) spread(points);
    for (std::size_t row = 0; row < inside_.size(); ++row) {
      unsigned bits = 0;
      for (unsigned i = 0; i < points_a_side; ++i)
        bits |= static_cast<unsigned>(value_[row * points_a_side + i] < 0) << i;
      inside_[row] = static_cast<std::uint16_t>(bits);
    }
  }

  [[nodiscard]] bool reads(std::size_t axis) const { return (unread_ >> axis & 1U) == 0; }

  /// Copies the values at `points` along x, y and z to all points beside them, the last ones first.
  void spread(const std::array<std::size_t, 3>& points) {
    std::size_t to = point_count;
    for (std::size_t k = points_a_side; k-- > 0;)
      for (std::size_t j = points_a_side; j-- > 0;)
        for (std::size_t i = points_a_side; i-- > 0;)
          value_[--to] = value_[std::min(i, points[0] - 1) +
                                points[0] * (std::min(j, points[1] - 1) + points[1] * std::min(k, points[2] - 1))];
  }

  void find_sign_changes() {
    for (auto& rows : changes_) rows.fill(0);
    for (int z = 0; z < points_a_side; ++z)
      for (int y = 0; y < points_a_side; ++y) {
        const unsigned here = row(y, z);
        const auto at = static_cast<std::size_t>(y + points_a_side * z);
        changes_[0][at] = static_cast<std::uint16_t>((here ^ here >> 1) & ((1U << block_side) - 1));
        if (y < block_side) changes_[1][at] = static_cast<std::uint16_t>(here ^ row(y + 1, z));
        if (z < block_side) changes_[2][at] = static_cast<std::uint16_t>(here ^ row(y, z + 1));
      }
  }

  [[nodiscard]] unsigned row(int y, int z) const { return inside_[static_cast<std::size_t>(y + points_a_side * z)]; }
  [[nodiscard]] bool inside(int x, int y, int z) const { return (row(y, z) >> x & 1U) != 0; }

  /// Calls visit(x, y, z) for the lower end of each edge along `axis` with a sign change.
  template <class Visit>
  void for_sign_changes(int axis, const Visit& visit) const {
    for (int z = 0; z < points_a_side; ++z)
      for (int y = 0; y < points_a_side; ++y) {
        unsigned changes = changes_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(y + points_a_side * z)];
        for (; changes != 0; changes &= changes - 1) visit(std::countr_zero(changes), y, z);
      }
  }

  void find_edges() {
    edges_.reserve(2 * block_side * block_side);
    for (int axis = 0; axis < 3; ++axis)
      for_sign_changes(axis, [&](int x, int y, int z) {
        edge_at_[static_cast<std::size_t>(axis * point_count + point_index(x, y, z))] =
            static_cast<std::int16_t>(edges_.size());
        edges_.push_back({static_cast<std::uint8_t>(axis),
                          {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(z)}});
      });
  }

  /// Finds where the surface crosses the edges; once for edges that are alike, beside each other along an axis that
  /// the Field does not read.
  void locate_edges() {
    std::vector<CrossedEdge> edges;
    std::vector<std::uint32_t> found_at(edges_.size());  // by edge, in `edges`
    edges.reserve(edges_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Edge& edge = edges_[i];
      if (const std::size_t alike = first_alike(edge); alike < i) {
        found_at[i] = found_at[alike];
        continue;
      }
      found_at[i] = static_cast<std::uint32_t>(edges.size());
      const std::size_t low = lower_end(edge), high = low + static_cast<std::size_t>(stride[edge.axis]);
      edges.push_back({edge.axis,
                       {plane_[0][edge.lower[0]], plane_[1][edge.lower[1]], plane_[2][edge.lower[2]]},
                       plane_[edge.axis][edge.lower[edge.axis] + 1U],
                       value_[low],
                       value_[high]});
    }
    std::vector<SurfacePoint> points;
    locate_crossings(field_, edges, lattice_.voxel(), lattice_.float_step(), points);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      SurfacePoint& point = edges_[i].point = points[found_at[i]];
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (!reads(axis)) point.position[static_cast<Eigen::Index>(axis)] = plane_[axis][edges_[i].lower[axis]];
    }
  }

  /// The edge at the block's lower end along the axes that the Field does not read.
  [[nodiscard]] std::size_t first_alike(const Edge& edge) const {
    std::array<int, 3> at;
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = reads(axis) ? edge.lower[axis] : 0;
    return static_cast<std::size_t>(
        edge_at_[static_cast<std::size_t>(edge.axis * point_count + point_index(at[0], at[1], at[2]))]);
  }

  [[nodiscard]] std::uint8_t corners(int x, int y, int z, int side) const {
    unsigned bits = 0;
    for (int corner = 0; corner < 4; ++corner) {
      const unsigned here = row(y + side * (corner & 1), z + side * (corner >> 1)) >> x;
      bits |= ((here & 1U) | (here >> side & 1U) << 1) << (2 * corner);
    }
    return static_cast<std::uint8_t>(bits);
  }

  /// Collects the crossings in the closed cube. Returns false if one of them has no normal, since
  /// planes then prove nothing.
  bool gather(int x, int y, int z, int side, std::vector<SurfacePoint>& points) const {
    points.clear();
    for (int axis = 0; axis < 3; ++axis) {
      const int nx = side + (axis != 0), ny = side + (axis != 1), nz = side + (axis != 2);
      const unsigned wanted = ((1U << nx) - 1) << x;
      for (int k = z; k < z + nz; ++k)
        for (int j = y; j < y + ny; ++j) {
          unsigned changes =
              changes_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(j + points_a_side * k)] & wanted;
          for (; changes != 0; changes &= changes - 1) {
            const int at = axis * point_count + point_index(std::countr_zero(changes), j, k);
            const SurfacePoint& point = edges_[static_cast<std::size_t>(edge_at_[static_cast<std::size_t>(at)])].point;
            points.push_back(point);
          }
        }
    }
    for (int k = z; k < z + side; ++k)
      for (int j = y; j < y + side; ++j)
        for (int i = x; !divided_.empty() && i < x + side; ++i) {
          const std::uint32_t division = divided_[Block::cell(i, j, k)];
          if (division == Division::none) continue;
          const std::vector<SurfacePoint>& inner = patches_[division]->points;
          points.insert(points.end(), inner.begin(), inner.end());
        }
    return std::none_of(points.begin(), points.end(), [](const SurfacePoint& point) { return point.normal.isZero(0); });
  }

  /// Handles the common case of a block whose samples are those of a linear function. A plane cuts
  /// each cube simply, so all cells merge at once, and only the edges on the block's faces are
  /// needed later.
  bool take_plane(Block& block, Patch& patch) const {
    const std::uint8_t bits = corners(0, 0, 0, block_side);
    if (settings_.max_error <= 0 || !is_simple(bits)) return false;
    Vec3 slope;
    for (std::size_t axis = 0; axis < 3; ++axis)
      slope[static_cast<Eigen::Index>(axis)] =
          (double{value_[static_cast<std::size_t>(block_side * stride[axis])]} - value_[0]) /
          (double{plane_[axis][block_side]} - plane_[axis][0]);
    const double length = slope.norm();
    if (!std::isfinite(length) || length == 0) return false;
    const auto tolerance = static_cast<float>(1e-3 * settings_.max_error * length);
    std::array<std::array<float, points_a_side>, 3> part;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < points_a_side; ++i)
        part[axis][i] =
            static_cast<float>(slope[static_cast<Eigen::Index>(axis)] * (double{plane_[axis][i]} - plane_[axis][0]));
    const float* value = value_.data();
    for (std::size_t k = 0; k < points_a_side; ++k)
      for (std::size_t j = 0; j < points_a_side; ++j, value += points_a_side) {
        const float start = value_[0] + part[1][j] + part[2][k];
        bool off = false;
        for (std::size_t i = 0; i < points_a_side; ++i)
          off |= !(std::abs(value[i] - (start + part[0][i])) <= tolerance);
        if (off) return false;
      }

    patch.corners = bits;
    patch.points.reserve(8 * block_side);
    block.crossings.reserve(3 * block_side);
    const Eigen::Vector3f normal = (slope / length).cast<float>();
    Vec3 sum = Vec3::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis)
      for_sign_changes(static_cast<int>(axis), [&](int x, int y, int z) {
        const std::array<int, 3> lower{x, y, z};
        const int p = lower[(axis + 1) % 3], q = lower[(axis + 2) % 3];
        if (p % block_side != 0 && q % block_side != 0) return;
        const auto t = static_cast<std::size_t>(lower[axis]), at = static_cast<std::size_t>(point_index(x, y, z));
        const double here = value_[at], next = value_[at + static_cast<std::size_t>(stride[axis])];
        SurfacePoint point{{plane_[0][static_cast<std::size_t>(x)], plane_[1][static_cast<std::size_t>(y)],
                            plane_[2][static_cast<std::size_t>(z)]},
                           normal};
        point.position[static_cast<Eigen::Index>(axis)] = static_cast<float>(
            plane_[axis][t] + here / (here - next) * (double{plane_[axis][t + 1]} - plane_[axis][t]));
        patch.points.push_back(point);
        sum += point.position.cast<double>();
        if (p < block_side && q < block_side)
          block.crossings.push_back(
              {static_cast<std::uint8_t>(axis),
               {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(z)},
               here < 0,
               point});
      });
    patch.vertex = sum / static_cast<double>(patch.points.size());
    thin(patch.points, lattice_.cube(lower_, lattice_.voxel_level() + block_level));
    return true;
  }

  /// Finds the largest cubes of cells that are one patch each and lists them as leafs; or returns
  /// the one patch of the block.
  std::optional<Patch> merge(Block& block) {
    divided_ = block.division_of;
    merge_divisions(block);
    find_simple_cubes();
    block.leaf_of.assign(block_side * block_side * block_side, Block::no_leaf);
    if (std::optional<Patch> whole = descend(block, 0, 0, 0, block_level)) {
      block.leaf_of = {};
      return whole;
    }
    if (block.leafs.empty() && apart_.empty()) {
      Patch uniform;
      uniform.corners = inside(0, 0, 0) ? 255 : 0;
      return uniform;
    }
    for (const std::uint32_t division : apart_) add_leafs(block, division);
    return {};
  }

  /// Finds divided cells that are one patch in spite of the division, the latest divisions first.
  void merge_divisions(const Block& block) {
    patches_.resize(block.divisions.size());
    for (std::size_t i = block.divisions.size(); i-- > 0;) patches_[i] = merged(block.divisions[i]);
  }

  [[nodiscard]] std::optional<Patch> merged(const Division& division) const {
    std::array<std::uint8_t, 8> children{};
    Patch patch;
    for (const Crossing& crossing : division.crossings) patch.points.push_back(crossing.point);
    bool uniform = true;
    for (unsigned child = 0; child < 8; ++child) {
      children[child] = division.corners(child);
      if (division.parts[child] != Division::none) {
        const std::optional<Patch>& part = patches_[division.parts[child]];
        if (!part) return {};
        patch.points.insert(patch.points.end(), part->points.begin(), part->points.end());
      } else if (!is_uniform(children[child]) && !is_simple(children[child])) {
        return {};
      }
      uniform = uniform && children[child] == children[0] && is_uniform(children[child]);
    }
    if (uniform) {
      patch.corners = children[0];
      return patch;
    }
    if (settings_.max_error <= 0 || !merge_corners(children, patch.corners)) return {};
    for (const SurfacePoint& point : patch.points)
      if (point.normal.isZero(0)) return {};
    const Box cell = lattice_.cube(division.lower, division.level + 1);
    if (!reproduces(patch.points, cell, settings_, patch.vertex)) return {};
    return patch;
  }

  /// Lists the leafs of a divided cell that is not one patch.
  void add_leafs(Block& block, std::uint32_t number) {
    for (unsigned child = 0; child < 8; ++child) {
      Division& division = block.divisions[number];
      const std::uint32_t part = division.parts[child];
      const std::optional<Patch> patch = part == Division::none ? std::nullopt : patches_[part];
      if (part != Division::none && !patch) {
        add_leafs(block, part);
        continue;
      }
      const std::uint8_t signs = division.corners(child);
      if (is_uniform(signs)) continue;
      division.leafs[child] = static_cast<std::uint32_t>(block.leafs.size());
      const int level = division.level;
      const LatticePoint lower =
          moved(division.lower, static_cast<int>(child & 1U) << level, static_cast<int>(child >> 1 & 1U) << level,
                static_cast<int>(child >> 2) << level);
      const Vec3 vertex = patch ? patch->vertex : Vec3(Vec3::Zero());
      block.leafs.push_back({lower, vertex.cast<float>(), level, signs, patch.has_value()});
    }
  }

  static std::size_t cube_index(int x, int y, int z, int level) {
    return static_cast<std::size_t>((x >> level) +
                                    (block_side >> level) * ((y >> level) + (block_side >> level) * (z >> level)));
  }

  /// Finds the cubes that contain one patch or none by their signs, bottom-up by level.
  void find_simple_cubes() {
    for (int z = 0; z < block_side; ++z)
      for (int y = 0; y < block_side; ++y)
        for (int x = 0; x < block_side; ++x) {
          const std::uint8_t bits = corners(x, y, z, 1);
          const std::uint32_t division = divided_.empty() ? Division::none : divided_[Block::cell(x, y, z)];
          const bool simple =
              division == Division::none ? is_uniform(bits) || is_simple(bits) : patches_[division].has_value();
          cubes_[0][cube_index(x, y, z, 0)] = {bits, simple};
        }
    for (int level = 1; level <= block_level; ++level) {
      const int side = 1 << level;
      for (int z = 0; z < block_side; z += side)
        for (int y = 0; y < block_side; y += side)
          for (int x = 0; x < block_side; x += side) {
            std::array<std::uint8_t, 8> children{};
            bool all = true;
            unsigned any = 0, every = 255;
            for (int child = 0; child < 8; ++child) {
              const Cube& cube = cubes_[static_cast<std::size_t>(level) - 1][cube_index(
                  x + (child & 1) * side / 2, y + (child >> 1 & 1) * side / 2, z + (child >> 2) * side / 2, level - 1)];
              children[static_cast<std::size_t>(child)] = cube.corners;
              all = all && cube.simple;
              any |= cube.corners;
              every &= cube.corners;
            }
            Cube& cube = cubes_[static_cast<std::size_t>(level)][cube_index(x, y, z, level)];
            cube = {static_cast<std::uint8_t>(any), all};
            if (all && any != 0 && every != 255) cube.simple = merge_corners(children, cube.corners);
          }
    }
  }

  /// Makes the cube one leaf if one patch reproduces its content, or else leafs of its parts. A
  /// patch of the whole block is returned instead, since it may merge with those of other blocks.
  std::optional<Patch> descend(Block& block, int x, int y, int z, int level) {
    const Cube& cube = cubes_[static_cast<std::size_t>(level)][cube_index(x, y, z, level)];
    if (cube.simple && (cube.corners == 0 || cube.corners == 255)) return {};
    const int voxel = lattice_.voxel_level();
    const LatticePoint lower = moved(lower_, x << voxel, y << voxel, z << voxel);
    const int side = 1 << level;
    Vec3 vertex = Vec3::Zero();
    bool merged = level > 0;
    if (level == 0 && !divided_.empty() && divided_[Block::cell(x, y, z)] != Division::none) {
      const std::uint32_t division = divided_[Block::cell(x, y, z)];
      if (!cube.simple) {
        apart_.push_back(division);
        return {};
      }
      merged = true;
      vertex = patches_[division]->vertex;
    }
    if (level > 0) {
      const bool one = cube.simple && settings_.max_error > 0 && gather(x, y, z, side, points_) &&
                       reproduces(points_, lattice_.cube(lower, voxel + level), settings_, vertex);
      if (!one) {
        for (int child = 0; child < 8; ++child)
          descend(block, x + (child & 1) * side / 2, y + (child >> 1 & 1) * side / 2, z + (child >> 2) * side / 2,
                  level - 1);
        return {};
      }
      if (level == block_level) return Patch{cube.corners, std::move(points_), vertex};
    }
    const auto number = static_cast<std::uint16_t>(block.leafs.size());
    block.leafs.push_back({lower, vertex.cast<float>(), voxel + level, cube.corners, merged});
    for (int k = z; k < z + side; ++k)
      for (int j = y; j < y + side; ++j)
        for (int i = x; i < x + side; ++i) block.leaf_of[Block::cell(i, j, k)] = number;
    return {};
  }

  /// A cube of cells: the signs at its corners, and whether it may be one patch.
  struct Cube {
    std::uint8_t corners;
    bool simple;
  };

  const Field& field_;
  const unsigned unread_;  ///< its Field::unread_axes()
  const Lattice& lattice_;
  const LatticePoint lower_;
  const ContourSettings& settings_;
  std::array<std::array<float, points_a_side>, 3> plane_;
  std::array<float, point_count> value_;
  std::array<std::uint16_t, points_a_side * points_a_side> inside_;  // by row along x: one bit per point
  std::array<std::array<std::uint16_t, points_a_side * points_a_side>, 3>
      changes_;                                        // by axis and row: one bit per edge with a sign change
  std::array<std::int16_t, 3 * point_count> edge_at_;  // index into edges_, valid where the sign changes
  std::vector<Edge> edges_;
  std::array<std::array<Cube, 512>, block_level + 1> cubes_;  // by level; see cube_index()
  std::vector<SurfacePoint> points_;
  std::span<const std::uint32_t> divided_;     // Block::division_of
  std::vector<std::optional<Patch>> patches_;  // by division: its one patch, if it is one
  std::vector<std::uint32_t> apart_;           // divisions of whole cells whose parts are leafs
};

}  // namespace

BlockView view_block(const Field& field, const Lattice& lattice, const LatticePoint& lower,
                     const ContourSettings& settings, Block& block) {
  return BlockSampler(field, lattice, lower, settings).view(block);
}

std::optional<Patch> sample_block(const Field& field, const Lattice& lattice, const LatticePoint& lower,
                                  const ContourSettings& settings, Block& block) {
  return BlockSampler(field, lattice, lower, settings).run(block);
}

double permitted_error(const ContourSettings& settings, double side) {
  return settings.max_error * std::min(1.0, side / settings.voxel);
}

bool is_flat(const std::vector<SurfacePoint>& points, double max_error, Vec3& vertex) {
  const Eigen::Vector3f origin = points[0].position, normal = points[0].normal;
  const auto tolerance = static_cast<float>(1e-3 * max_error);
  if (normal.isZero(0)) return false;
  Vec3 sum = Vec3::Zero();
  for (const SurfacePoint& point : points) {
    if ((point.normal - normal).squaredNorm() > 1e-8F || std::abs(normal.dot(point.position - origin)) > tolerance)
      return false;
    sum += point.position.cast<double>();
  }
  vertex = sum / static_cast<double>(points.size());
  return true;
}

void thin(std::vector<SurfacePoint>& points, const Box& cell) {
  std::vector<SurfacePoint> kept;
  kept.reserve(12);
  const Eigen::Vector3f normal = points[0].normal;
  for (int axis = 0; axis < 3; ++axis)
    for (const double plane : {cell.lower[axis], cell.upper[axis]}) {
      const Eigen::Vector3f along = normal.cross(Eigen::Vector3f::Unit(axis));
      const SurfacePoint* first = nullptr;
      const SurfacePoint* last = nullptr;
      for (const SurfacePoint& point : points) {
        if (static_cast<double>(point.position[axis]) != plane) continue;
        if (first == nullptr || point.position.dot(along) < first->position.dot(along)) first = &point;
        if (last == nullptr || point.position.dot(along) > last->position.dot(along)) last = &point;
      }
      if (first != nullptr) kept.push_back(*first);
      if (last != first) kept.push_back(*last);
    }
  if (!kept.empty()) points = std::move(kept);
}

/// Greatest distance of points of a curve across a face of `cell` (flat along `axis`) from the
/// straight line between its ends, which lie on the rim of the face, mm.
static double off_straight(const std::vector<SurfacePoint>& points, int axis, const Box& cell) {
  std::vector<Vec3> ends;
  for (const SurfacePoint& point : points) {
    const Vec3 p = point.position.cast<double>();
    for (const int along : {(axis + 1) % 3, (axis + 2) % 3})
      if (p[along] == cell.lower[along] || p[along] == cell.upper[along]) {
        // thin() keeps some points twice.
        if (std::find(ends.begin(), ends.end(), p) == ends.end()) ends.push_back(p);
        break;
      }
  }
  if (ends.size() != 2) return 0;
  const Vec3 way = ends[1] - ends[0];
  const double length = way.norm();
  double farthest = 0;
  for (const SurfacePoint& point : points) {
    const Vec3 off = point.position.cast<double>() - ends[0];
    farthest = std::max(farthest, length > 0 ? off.cross(way).norm() / length : off.norm());
  }
  return farthest;
}

bool reproduces(const std::vector<SurfacePoint>& points, const Box& cell, const ContourSettings& settings,
                Vec3& vertex) {
  const double max_error = permitted_error(settings, cell.size().minCoeff());
  if (is_flat(points, max_error, vertex)) return true;
  const PlacedVertex placed = place_vertex(points, cell);
  if (placed.error > max_error) return false;
  vertex = placed.position;
  // The surface leaves through the faces along curves with at most one bend each, or with none if
  // there are to be no features. The points on a face must agree with that too.
  std::vector<SurfacePoint> on_face;
  for (int axis = 0; axis < 3; ++axis)
    for (const double plane : {cell.lower[axis], cell.upper[axis]}) {
      on_face.clear();
      for (SurfacePoint point : points) {
        if (static_cast<double>(point.position[axis]) != plane) continue;
        point.normal[axis] = 0;
        on_face.push_back(point);
      }
      Vec3 unused;
      if (on_face.empty() || is_flat(on_face, max_error, unused)) continue;
      if (place_vertex(on_face, cell).error > max_error) return false;
      if (!settings.features && off_straight(on_face, axis, cell) > max_error) return false;
    }
  return true;
}

}  // namespace fieldfab::contouring
