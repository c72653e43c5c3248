#include "contour_block.h"

#include <algorithm>
#include <cmath>

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

/// The samples of a block and what is found in them; lives on the stack of sample_block().
class BlockSampler {
 public:
  BlockSampler(const Field& field, const Lattice& lattice, const LatticePoint& lower, const ContourSettings& settings)
      : field_(field), lattice_(lattice), lower_(lower), settings_(settings) {
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i <= block_side; ++i)
        plane_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)] =
            static_cast<float>(lattice.plane(axis, lower[static_cast<std::size_t>(axis)] + i));
  }

  SampledBlock run() {
    SampledBlock result;
    result.block.lower = lower_;
    result.block.leaf_of.fill(Block::no_leaf);
    sample();
    if (take_plane(result)) return result;
    find_edges();
    if (edges_.empty()) {
      result.whole = Patch{static_cast<std::uint8_t>(inside_[0] ? 255 : 0), {}};
      return result;
    }
    locate_edges();
    find_normals();
    merge(result);
    for (const Edge& edge : edges_)
      if (edge.lower[0] < block_side && edge.lower[1] < block_side && edge.lower[2] < block_side)
        result.block.crossings.push_back({edge.axis, edge.lower, inside_[lower_end(edge)] != 0, edge.point});
    return result;
  }

 private:
  static std::size_t lower_end(const Edge& edge) {
    return static_cast<std::size_t>(point_index(edge.lower[0], edge.lower[1], edge.lower[2]));
  }

  void sample() {
    std::array<float, point_count> x, y, z;
    std::size_t at = 0;
    for (std::size_t k = 0; k < points_a_side; ++k)
      for (std::size_t j = 0; j < points_a_side; ++j)
        for (std::size_t i = 0; i < points_a_side; ++i, ++at) {
          x[at] = plane_[0][i];
          y[at] = plane_[1][j];
          z[at] = plane_[2][k];
        }
    field_.values({x.data(), y.data(), z.data(), point_count}, value_.data());
    for (std::size_t i = 0; i < point_count; ++i) inside_[i] = value_[i] < 0;
  }

  void find_edges() {
    edge_at_.fill(-1);
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      const int nx = points_a_side - (axis == 0), ny = points_a_side - (axis == 1), nz = points_a_side - (axis == 2);
      for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
          for (int x = 0; x < nx; ++x) {
            const int at = point_index(x, y, z);
            if (inside_[static_cast<std::size_t>(at)] == inside_[static_cast<std::size_t>(at + stride[axis])]) continue;
            edge_at_[static_cast<std::size_t>(axis * point_count + at)] = static_cast<std::int16_t>(edges_.size());
            edges_.push_back({axis, {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(z)}});
          }
    }
  }

  /// Finds each zero between its two lattice points: the Illinois form of false position, all edges in step, one batch a round.
  void locate_edges() {
    const std::size_t count = edges_.size();
    std::vector<float> x(count), y(count), z(count), value(count);
    struct Bracket {
      double low, high;              // positions along the edge's axis, mm
      double low_value, high_value;  // of opposite sign
      int stuck = 0;                 // +1/-1: which end was kept the last time
    };
    std::vector<Bracket> brackets(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Edge& edge = edges_[i];
      const std::size_t low = lower_end(edge), high = low + static_cast<std::size_t>(stride[edge.axis]);
      brackets[i] = {plane_[edge.axis][edge.lower[edge.axis]], plane_[edge.axis][edge.lower[edge.axis] + 1U], value_[low],
                     value_[high]};
      x[i] = plane_[0][edge.lower[0]];
      y[i] = plane_[1][edge.lower[1]];
      z[i] = plane_[2][edge.lower[2]];
    }
    const auto guess = [](const Bracket& b) {
      const double t = b.low_value / (b.low_value - b.high_value);
      return t >= 0 && t <= 1 ? b.low + t * (b.high - b.low) : 0.5 * (b.low + b.high);  // also where a value is infinite or NaN
    };
    const std::array<std::vector<float>*, 3> coordinate{&x, &y, &z};
    const double close_enough = std::max(1e-6 * lattice_.voxel(), 4 * lattice_.float_step());
    constexpr int rounds = 12;
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < count; ++i) (*coordinate[edges_[i].axis])[i] = static_cast<float>(guess(brackets[i]));
      field_.values({x.data(), y.data(), z.data(), count}, value.data());
      bool settled = true;
      for (std::size_t i = 0; i < count; ++i) {
        Bracket& b = brackets[i];
        const double at = (*coordinate[edges_[i].axis])[i], before = b.high - b.low;
        const double slope = std::abs(b.high_value - b.low_value) / before;
        if ((value[i] < 0) == (b.low_value < 0)) {
          b = {at, b.high, value[i], b.stuck < 0 ? 0.5 * b.high_value : b.high_value, -1};
        } else {
          b = {b.low, at, b.stuck > 0 ? 0.5 * b.low_value : b.low_value, value[i], 1};
        }
        settled = settled && (std::abs(value[i]) <= slope * close_enough || b.high - b.low <= close_enough);
      }
      if (settled) break;
    }
    for (std::size_t i = 0; i < count; ++i) {
      (*coordinate[edges_[i].axis])[i] = static_cast<float>(guess(brackets[i]));
      edges_[i].point.position = {x[i], y[i], z[i]};
    }
  }

  void find_normals() {
    const std::size_t count = edges_.size();
    std::vector<float> x(count), y(count), z(count), value(count), dx(count), dy(count), dz(count);
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = edges_[i].point.position.x();
      y[i] = edges_[i].point.position.y();
      z[i] = edges_[i].point.position.z();
    }
    field_.gradients({x.data(), y.data(), z.data(), count}, value.data(), {dx.data(), dy.data(), dz.data()});
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector3d slope(dx[i], dy[i], dz[i]);
      const double length = slope.norm();
      const bool usable = std::isfinite(length) && length > 0;
      edges_[i].point.normal = usable ? Eigen::Vector3f((slope / length).cast<float>()) : Eigen::Vector3f::Zero();
    }
  }

  [[nodiscard]] std::uint8_t corners(int x, int y, int z, int side) const {
    unsigned bits = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const int at = point_index(x + side * static_cast<int>(corner & 1U), y + side * static_cast<int>(corner >> 1 & 1U),
                                 z + side * static_cast<int>(corner >> 2));
      if (inside_[static_cast<std::size_t>(at)]) bits |= 1U << corner;
    }
    return static_cast<std::uint8_t>(bits);
  }

  /// The crossings in the closed cube; false where one of them has no normal, so that nothing may be concluded from planes.
  bool gather(int x, int y, int z, int side, std::vector<SurfacePoint>& points) const {
    points.clear();
    for (int axis = 0; axis < 3; ++axis) {
      const int nx = side + (axis != 0), ny = side + (axis != 1), nz = side + (axis != 2);
      for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j) {
          const std::int16_t* row = &edge_at_[static_cast<std::size_t>(axis * point_count + point_index(x, y + j, z + k))];
          for (int i = 0; i < nx; ++i) {
            if (row[i] < 0) continue;
            const SurfacePoint& point = edges_[static_cast<std::size_t>(row[i])].point;
            if (point.normal.isZero(0)) return false;
            points.push_back(point);
          }
        }
    }
    return true;
  }

  /// The common case of a block that a plane passes through: the samples are those of a linear function. A plane cuts every cube
  /// simply, so all cells merge at once, and only the edges on the block's faces will ever be asked for.
  bool take_plane(SampledBlock& result) const {
    const std::uint8_t bits = corners(0, 0, 0, block_side);
    if (settings_.max_error <= 0 || !is_simple(bits)) return false;
    Vec3 slope;
    for (std::size_t axis = 0; axis < 3; ++axis)
      slope[static_cast<Eigen::Index>(axis)] = (double{value_[static_cast<std::size_t>(block_side * stride[axis])]} - value_[0]) /
                                               (double{plane_[axis][block_side]} - plane_[axis][0]);
    const double length = slope.norm();
    if (!std::isfinite(length) || length == 0) return false;
    const auto tolerance = static_cast<float>(1e-3 * settings_.max_error * length);
    std::array<std::array<float, points_a_side>, 3> part;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < points_a_side; ++i)
        part[axis][i] = static_cast<float>(slope[static_cast<Eigen::Index>(axis)] * (double{plane_[axis][i]} - plane_[axis][0]));
    const float* value = value_.data();
    for (std::size_t k = 0; k < points_a_side; ++k)
      for (std::size_t j = 0; j < points_a_side; ++j, value += points_a_side) {
        const float start = value_[0] + part[1][j] + part[2][k];
        bool off = false;
        for (std::size_t i = 0; i < points_a_side; ++i) off |= !(std::abs(value[i] - (start + part[0][i])) <= tolerance);
        if (off) return false;
      }

    Patch patch;
    patch.corners = bits;
    const Eigen::Vector3f normal = (slope / length).cast<float>();
    Vec3 sum = Vec3::Zero();
    for (std::uint8_t axis = 0; axis < 3; ++axis)
      for (std::uint8_t p = 0; p <= block_side; ++p)
        for (std::uint8_t q = 0; q <= block_side; ++q) {
          if (p % block_side != 0 && q % block_side != 0) continue;
          for (std::uint8_t t = 0; t < block_side; ++t) {
            std::array<std::uint8_t, 3> lower{};
            lower[axis] = t, lower[(axis + 1U) % 3] = p, lower[(axis + 2U) % 3] = q;
            const auto at = static_cast<std::size_t>(point_index(lower[0], lower[1], lower[2]));
            const std::size_t next = at + static_cast<std::size_t>(stride[axis]);
            if (inside_[at] == inside_[next]) continue;
            SurfacePoint point{{plane_[0][lower[0]], plane_[1][lower[1]], plane_[2][lower[2]]}, normal};
            const double share = value_[at] / (double{value_[at]} - value_[next]);
            point.position[axis] = static_cast<float>(plane_[axis][t] + share * (double{plane_[axis][t + 1U]} - plane_[axis][t]));
            patch.points.push_back(point);
            sum += point.position.cast<double>();
            if (p < block_side && q < block_side) result.block.crossings.push_back({axis, lower, inside_[at] != 0, point});
          }
        }
    patch.vertex = sum / static_cast<double>(patch.points.size());
    result.whole = std::move(patch);
    return true;
  }

  /// Merges cells bottom-up, eight at a time, and lists the leafs that remain.
  void merge(SampledBlock& result) {
    // By level: whether each cube is one patch (or uniform). A cube that is not keeps its leafs below.
    std::array<std::array<bool, 512>, block_level + 1> one{};
    std::array<std::array<std::uint8_t, 512>, block_level + 1> signs{};
    std::array<std::array<Vec3, 64>, block_level + 1> vertex;
    const auto index = [](int x, int y, int z, int level) {
      const int side = block_side >> level;
      return static_cast<std::size_t>(x + side * (y + side * z));
    };
    for (int z = 0; z < block_side; ++z)
      for (int y = 0; y < block_side; ++y)
        for (int x = 0; x < block_side; ++x) {
          const std::uint8_t bits = corners(x, y, z, 1);
          signs[0][index(x, y, z, 0)] = bits;
          one[0][index(x, y, z, 0)] = bits == 0 || bits == 255 || is_simple(bits);
        }

    std::vector<SurfacePoint> points;
    for (int level = 1; level <= block_level; ++level) {
      const int side = 1 << level, count = block_side >> level;
      for (int z = 0; z < count; ++z)
        for (int y = 0; y < count; ++y)
          for (int x = 0; x < count; ++x) {
            std::array<std::uint8_t, 8> children{};
            bool all = true;
            unsigned any = 0, every = 255;
            for (unsigned child = 0; child < 8; ++child) {
              const std::size_t at = index(2 * x + static_cast<int>(child & 1U), 2 * y + static_cast<int>(child >> 1 & 1U),
                                           2 * z + static_cast<int>(child >> 2), level - 1);
              children[child] = signs[static_cast<std::size_t>(level) - 1][at];
              all = all && one[static_cast<std::size_t>(level) - 1][at];
              any |= children[child];
              every &= children[child];
            }
            const std::size_t at = index(x, y, z, level);
            const auto l = static_cast<std::size_t>(level);
            if (!all) continue;
            if (any == 0 || every == 255) {
              one[l][at] = true;
              signs[l][at] = static_cast<std::uint8_t>(any);
              continue;
            }
            std::uint8_t merged = 0;
            if (settings_.max_error <= 0 || !merge_corners(children, merged) ||
                !gather(x * side, y * side, z * side, side, points))
              continue;
            const LatticePoint lower{lower_[0] + x * side, lower_[1] + y * side, lower_[2] + z * side};
            one[l][at] = reproduces(points, lattice_.cube(lower, level), settings_.max_error, vertex[l][at]);
            signs[l][at] = merged;
          }
    }

    if (one[block_level][0]) {
      // edges_ of the whole block: gather() has just put them in `points`
      result.whole = Patch{signs[block_level][0], std::move(points), vertex[block_level][0]};
      return;
    }
    for (int z = 0; z < block_side; ++z)
      for (int y = 0; y < block_side; ++y)
        for (int x = 0; x < block_side; ++x) {
          if (result.block.leaf_of[Block::cell(x, y, z)] != Block::no_leaf) continue;
          int level = 0;
          while (one[static_cast<std::size_t>(level) + 1][index(x >> (level + 1), y >> (level + 1), z >> (level + 1), level + 1)])
            ++level;
          const std::size_t at = index(x >> level, y >> level, z >> level, level);
          const std::uint8_t bits = signs[static_cast<std::size_t>(level)][at];
          if (bits == 0 || bits == 255) continue;
          const auto number = static_cast<std::uint16_t>(result.block.leafs.size());
          const int mask = ~((1 << level) - 1), side = 1 << level;
          const LatticePoint lower{lower_[0] + (x & mask), lower_[1] + (y & mask), lower_[2] + (z & mask)};
          result.block.leafs.push_back(
              {lower, level, bits, level > 0 ? vertex[static_cast<std::size_t>(level)][at] : Vec3(Vec3::Zero())});
          for (int k = z & mask; k < (z & mask) + side; ++k)
            for (int j = y & mask; j < (y & mask) + side; ++j)
              for (int i = x & mask; i < (x & mask) + side; ++i) result.block.leaf_of[Block::cell(i, j, k)] = number;
        }
  }

  const Field& field_;
  const Lattice& lattice_;
  const LatticePoint lower_;
  const ContourSettings& settings_;
  std::array<std::array<float, points_a_side>, 3> plane_;
  std::array<float, point_count> value_;
  std::array<std::uint8_t, point_count> inside_;
  std::array<std::int16_t, 3 * point_count> edge_at_;
  std::vector<Edge> edges_;
};

}  // namespace

SampledBlock sample_block(const Field& field, const Lattice& lattice, const LatticePoint& lower,
                          const ContourSettings& settings) {
  return BlockSampler(field, lattice, lower, settings).run();
}

bool is_flat(const std::vector<SurfacePoint>& points, double max_error, Vec3& vertex) {
  const Eigen::Vector3f origin = points[0].position, normal = points[0].normal;
  const auto tolerance = static_cast<float>(1e-3 * max_error);
  if (normal.isZero(0)) return false;
  Vec3 sum = Vec3::Zero();
  for (const SurfacePoint& point : points) {
    if ((point.normal - normal).squaredNorm() > 1e-8F || std::abs(normal.dot(point.position - origin)) > tolerance) return false;
    sum += point.position.cast<double>();
  }
  vertex = sum / static_cast<double>(points.size());
  return true;
}

bool reproduces(const std::vector<SurfacePoint>& points, const Box& cell, double max_error, Vec3& vertex) {
  if (is_flat(points, max_error, vertex)) return true;
  const PlacedVertex placed = place_vertex(points, cell);
  if (placed.error > max_error) return false;
  vertex = placed.position;
  // The surface leaves through the faces along curves with at most one bend each: the points on a face must agree to that too.
  std::vector<SurfacePoint> on_face;
  for (int axis = 0; axis < 3; ++axis)
    for (const double plane : {cell.lower[axis], cell.upper[axis]}) {
      on_face.clear();
      for (SurfacePoint point : points) {
        if (static_cast<double>(point.position[axis]) != plane) continue;
        point.normal[axis] = 0;
        on_face.push_back(point);
      }
      if (!on_face.empty() && place_vertex(on_face, cell).error > max_error) return false;
    }
  return true;
}

}  // namespace fieldfab::contouring
