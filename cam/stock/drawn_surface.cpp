#include "fieldfab/cam/stock/drawn_surface.h"

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <unordered_map>

namespace fieldfab::cam {
namespace {

using Vec3f = Eigen::Vector3f;
// edge length in cells of the blocks whose vertices are merged on flats
constexpr int flat_block = 6;
constexpr std::uint32_t alone = ~0u;  // marks a vertex that is not merged
// orientations; smaller numbers are 2 * axis + (1 if negative)
constexpr unsigned tilted = 6, mixed = 7;

Vec3f vector(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

/// Orientation of a normal along an axis; `tilted` for any other normal.
unsigned level_way(const Vec3f& normal) {
  int axis = 0;
  const float most = normal.cwiseAbs().maxCoeff(&axis);
  return most > 0.999999F * normal.norm() ? 2 * static_cast<unsigned>(axis) + (normal[axis] < 0) : tilted;
}

unsigned nearest_way(const Vec3f& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<unsigned>(axis) + (normal[axis] < 0);
}

/// Vertex clustering.
class Simplifier {
 public:
  Simplifier(const DrawnSurface& surface, const StockLattice& lattice, const Box& region)
      : surface_(surface), lattice_(lattice), region_(region), cluster_(surface.vertices.size(), alone) {
    for (const auto& v : surface.vertices)
      places_.push_back(
          ((vector(v).cast<double>() - lattice.box().lower).cwiseQuotient(lattice.spacing())).cast<float>());
  }

  void unite_flats() {
    const std::vector<unsigned> ways = ways_of_triangles();
    std::unordered_map<Key, Cluster, Hash> found(cluster_.size() / 8);
    std::vector<Key> keys(cluster_.size());
    Cluster* cluster = nullptr;
    const Key* last = nullptr;
    for (std::uint32_t v = 0; v < cluster_.size(); ++v) {
      if (ways[v] >= tilted || at_border(v)) continue;
      const auto level = static_cast<Eigen::Index>(ways[v] / 2);
      keys[v] = {ways[v], surface_.cuts[v], std::bit_cast<std::uint32_t>(surface_.vertices[v][ways[v] / 2])};
      for (Eigen::Index a = 0, k = 3; a < 3; ++a)
        if (a != level)
          keys[v][static_cast<std::size_t>(k++)] = block(std::round(places_[v][a]) - inside(a), flat_block);
      // vertices come row by row
      if (cluster == nullptr || keys[v] != *last) cluster = &found[keys[v]], last = &keys[v];
      if (cluster->count++ == 0) cluster->whole = points_of_block(v, level);
    }
    cluster = nullptr;
    for (std::uint32_t v = 0; v < cluster_.size(); ++v)
      if (keys[v] != Key{}) {
        if (cluster == nullptr || keys[v] != *last) cluster = &found[keys[v]], last = &keys[v];
        if (cluster->count != cluster->whole) continue;  // part of the block is not flat
        if (cluster->number == alone) cluster->number = clusters_++;
        cluster_[v] = cluster->number;
      }
  }

  void unite_blocks(int size) {
    // Key: an orientation and three block indices of 20 bits each.
    std::unordered_map<std::uint64_t, std::uint32_t> found(cluster_.size() / 2);
    std::uint64_t last = ~std::uint64_t{0};
    std::uint32_t number = alone;
    for (std::uint32_t v = 0; v < cluster_.size(); ++v) {
      if (cluster_[v] != alone || at_border(v)) continue;
      std::uint64_t key = nearest_way(vector(surface_.normals[v]));
      for (Eigen::Index a = 0; a < 3; ++a) key = key << 20 | (block(places_[v][a], size) & 0xFFFFF);
      if (key != last) {  // vertices come row by row
        const auto [at, fresh] = found.try_emplace(key, clusters_);
        if (fresh) ++clusters_;
        last = key, number = at->second;
      }
      cluster_[v] = number;
    }
  }

  [[nodiscard]] DrawnSurface united() const {
    DrawnSurface out;
    std::vector<std::uint32_t> of_cluster(clusters_, alone), now(cluster_.size()), counts;
    for (std::uint32_t v = 0; v < cluster_.size(); ++v) {
      std::uint32_t own = alone;
      std::uint32_t& at = cluster_[v] == alone ? own : of_cluster[cluster_[v]];
      if (at == alone) {
        at = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.push_back({0, 0, 0}), out.normals.push_back({0, 0, 0}), out.cuts.push_back(surface_.cuts[v]);
        counts.push_back(0);
      }
      for (std::size_t a = 0; a < 3; ++a)
        out.vertices[at][a] += surface_.vertices[v][a], out.normals[at][a] += surface_.normals[v][a];
      ++counts[at];
      now[v] = at;
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const Vec3f normal = vector(out.normals[i]).normalized();
      for (std::size_t a = 0; a < 3; ++a)
        out.vertices[i][a] /= static_cast<float>(counts[i]), out.normals[i][a] = normal[static_cast<Eigen::Index>(a)];
    }
    for (const auto& t : surface_.triangles) {
      const std::array<std::uint32_t, 3> corners{now[t[0]], now[t[1]], now[t[2]]};
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
        out.triangles.push_back(corners);
    }
    return out;
  }

 private:
  using Key = std::array<std::uint32_t, 5>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::size_t hash = 0;
      for (const std::uint32_t part : key) hash = (hash ^ part) * 0x9E3779B97F4A7C15u, hash ^= hash >> 29;
      return hash;
    }
  };
  struct Cluster {
    std::uint32_t count = 0, whole = 0, number = alone;
  };

  /// Index of a block, offset so that it is never 0: 0 marks empty keys.
  static std::uint32_t block(float place, int size) {
    return static_cast<std::uint32_t>(std::floor(place / static_cast<float>(size))) + 0x40000000u;
  }

  /// Start of the interior behind the region's border, so that blocks of flats start there as well.
  [[nodiscard]] float inside(Eigen::Index axis) const {
    return region_.lower[axis] < -1 ? 0 : static_cast<float>(region_.lower[axis]) + 2;
  }

  /// Number of lattice points of a block that lies wholly on a flat; smaller at the end of its
  /// region.
  [[nodiscard]] std::uint32_t points_of_block(std::uint32_t v, Eigen::Index level) const {
    float points = 1;
    for (Eigen::Index a = 0; a < 3; ++a) {
      if (a == level) continue;
      const float first = inside(a), size = flat_block, place = std::round(places_[v][a]) - first;
      const auto end =
          static_cast<float>(std::min(region_.upper[a], lattice_.cells()[static_cast<std::size_t>(a)] + 1.0));
      points *= std::min(size, end - first - size * std::floor(place / size));
    }
    return static_cast<std::uint32_t>(points);
  }

  [[nodiscard]] bool at_border(std::uint32_t v) const {
    const Vec3f &place = places_[v], lower = region_.lower.cast<float>(), upper = region_.upper.cast<float>();
    return ((place - lower).array() < 1.001F).any() || ((upper - place).array() < 0.001F).any();
  }

  /// Common orientation of each vertex's triangles; `tilted` or `mixed` if there is none.
  [[nodiscard]] std::vector<unsigned> ways_of_triangles() const {
    constexpr unsigned unknown = 8;
    std::vector<unsigned> ways(cluster_.size(), unknown);
    for (const auto& t : surface_.triangles) {
      const Vec3f a = vector(surface_.vertices[t[0]]);
      const Vec3f area = (vector(surface_.vertices[t[1]]) - a).cross(vector(surface_.vertices[t[2]]) - a);
      if (area == Vec3f::Zero()) continue;
      const unsigned way = level_way(area);
      for (const std::uint32_t v : t) ways[v] = ways[v] == unknown || ways[v] == way ? way : mixed;
    }
    return ways;
  }

  const DrawnSurface& surface_;
  const StockLattice& lattice_;
  Box region_;
  std::vector<Vec3f> places_;  ///< of the vertices, in cells
  std::vector<std::uint32_t> cluster_;
  std::uint32_t clusters_ = 0;
};

}  // namespace

DrawnSurface drawn(const TriangleMesh& mesh, std::vector<std::uint32_t> cuts) {
  DrawnSurface out{mesh.vertices, {}, mesh.triangles, std::move(cuts)};
  std::vector<Vec3f> sums(mesh.vertices.size(), Vec3f::Zero());
  for (const auto& t : mesh.triangles) {
    const Vec3f a = vector(mesh.vertices[t[0]]);
    const Vec3f area = (vector(mesh.vertices[t[1]]) - a).cross(vector(mesh.vertices[t[2]]) - a);
    for (const std::uint32_t v : t) sums[v] += area;
  }
  out.normals.reserve(sums.size());
  for (const Vec3f& sum : sums) {
    const Vec3f normal = sum.normalized();
    out.normals.push_back({normal.x(), normal.y(), normal.z()});
  }
  return out;
}

DrawnSurface simplified(const DrawnSurface& surface, const StockLattice& lattice, const Box& region, int coarse) {
  Simplifier simplifier(surface, lattice, region);
  simplifier.unite_flats();
  if (coarse > 1) simplifier.unite_blocks(coarse);
  return simplifier.united();
}

}  // namespace fieldfab::cam
