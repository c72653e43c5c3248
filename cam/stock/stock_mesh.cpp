// The surface of a stock as one closed mesh (Hahn 4.3). Cubes of the lattice are looked at brick by brick, whatever cells their
// points belong to: since each point and each sample is owned once, there are no seams. Outside of the stock's box everything is
// air, and an edge that leaves the box crosses the surface where it leaves it: that makes the exterior mesh.
#include <bit>
#include <cmath>
#include <optional>

#include "brick.h"
#include "fieldfab/cam/stock.h"
#include "fieldfab/core/parallel.h"
#include "marching.h"

namespace fieldfab::cam {
namespace {

using Word = Occupancy::Word;

/// The crossed edges whose lower points a brick has, and their vertices' order: by axis, row and bit.
struct Edges {
  Region region;  ///< of the lower points: the brick's, and at the lower faces of the stock the points outside of it
  std::array<std::vector<Word>, 3> bits;
  std::array<std::vector<std::uint32_t>, 3> before;  ///< vertices before each word
  std::optional<Occupancy> shape;  ///< solid points of the region and one more on each side, until the surface is made
  std::size_t words = 0, first = 0, count = 0;  ///< first: index of its first vertex in the mesh

  [[nodiscard]] std::size_t word_of(const Index3& p) const {
    const auto row = static_cast<std::size_t>(p[2] - region.lower[2]) * static_cast<std::size_t>(region.count(1)) +
                     static_cast<std::size_t>(p[1] - region.lower[1]);
    return row * words + static_cast<std::size_t>(p[0] - region.lower[0]) / 64;
  }
  [[nodiscard]] std::uint32_t vertex(const Index3& p, std::size_t axis) const {
    const std::size_t word = word_of(p);
    const int bit = (p[0] - region.lower[0]) % 64;
    return static_cast<std::uint32_t>(first) + before[axis][word] +
           static_cast<std::uint32_t>(std::popcount(bits[axis][word] & ((Word{1} << bit) - 1)));
  }
};

/// Calls with each set bit's point, axis by axis.
template <class Body>
void for_each_edge(const Edges& edges, const Body& body) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t word = 0;
    Index3 p;
    for (p[2] = edges.region.lower[2]; p[2] <= edges.region.upper[2]; ++p[2])
      for (p[1] = edges.region.lower[1]; p[1] <= edges.region.upper[1]; ++p[1])
        for (std::size_t w = 0; w < edges.words; ++w, ++word)
          for (Word left = edges.bits[axis][word]; left; left &= left - 1) {
            p[0] = edges.region.lower[0] + static_cast<int>(w) * 64 + std::countr_zero(left);
            body(p, axis);
          }
  }
}

}  // namespace

/// Makes the mesh of one stock.
class StockMesher {
 public:
  StockMesher(const Stock& stock, Progress& progress) : stock_(stock), lattice_(stock.lattice()), progress_(progress) {}

  TriangleMesh make(std::vector<std::uint32_t>* cuts) {
    const std::size_t count = stock_.bricks_.size();
    edges_.resize(count);
    parallel_for(count, [&](std::size_t i) {
      progress_.check();
      find_edges(i);
    });
    std::size_t vertices = 0;
    for (Edges& edges : edges_) edges.first = vertices, vertices += edges.count;
    TriangleMesh mesh;
    mesh.vertices.resize(vertices);
    alias_.resize(vertices);
    if (cuts) cuts->resize(vertices);
    parallel_for(count, [&](std::size_t i) { place_vertices(i, mesh, cuts); });
    std::vector<Piece> pieces(count);
    parallel_for(count, [&](std::size_t i) {
      progress_.check();
      march(i, mesh, pieces[i]);
    });
    std::size_t triangles = 0;
    for (const Piece& piece : pieces) triangles += piece.triangles.size();
    mesh.triangles.reserve(triangles);
    for (const Piece& piece : pieces) {
      const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.insert(mesh.vertices.end(), piece.middles.begin(), piece.middles.end());
      if (cuts) cuts->resize(mesh.vertices.size(), 0);
      for (std::array<std::uint32_t, 3> t : piece.triangles) {
        for (std::uint32_t& v : t)
          if (v >= middle_from) v = offset + (v - middle_from);
        mesh.triangles.push_back(t);
      }
    }
    drop_unused(mesh, cuts);
    return mesh;
  }

 private:
  static constexpr std::uint32_t middle_from = 0xC0000000;  ///< vertices from here on are a piece's own
  struct Piece {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<float, 3>> middles;
  };

  [[nodiscard]] std::size_t brick_of(const Index3& p) const {
    std::array<int, 3> b;
    for (std::size_t a = 0; a < 3; ++a) b[a] = std::clamp(p[a], 0, lattice_.cells()[a]) / stock_.brick_;
    return stock_.brick_index(b[0], b[1], b[2]);
  }

  /// Solid points of a brick's region and one more on each side.
  [[nodiscard]] Occupancy around(const Region& region) const {
    Region near = region;
    for (std::size_t a = 0; a < 3; ++a) --near.lower[a], ++near.upper[a];
    Occupancy shape(near);
    // Bricks side by side, and of each the points that are wanted.
    Index3 low, high;
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::max(near.lower[a], 0) / stock_.brick_;
      high[a] = std::min(near.upper[a], lattice_.cells()[a]) / stock_.brick_;
    }
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) {
          const Brick& brick = *stock_.bricks_[stock_.brick_index(x, y, z)];
          if (brick.empty()) continue;
          brick.occupy(shape, lattice_);
        }
    return shape;
  }

  /// Whether the bricks around a uniform one are uniform alike, so that there is no surface at it; the stock's faces are surface.
  [[nodiscard]] bool quiet(std::size_t index) const {
    const Brick& brick = *stock_.bricks_[index];
    if (!brick.uniform()) return false;
    const Region& r = brick.region();
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          Index3 p{dx < 0 ? r.lower[0] - 1
                   : dx   ? r.upper[0] + 1
                          : r.lower[0],
                   dy < 0 ? r.lower[1] - 1
                   : dy   ? r.upper[1] + 1
                          : r.lower[1],
                   dz < 0 ? r.lower[2] - 1
                   : dz   ? r.upper[2] + 1
                          : r.lower[2]};
          bool outside = false;
          for (std::size_t a = 0; a < 3; ++a) outside |= p[a] < 0 || p[a] > lattice_.cells()[a];
          if (outside) {
            if (!brick.empty()) return false;
            continue;
          }
          const Brick& other = *stock_.bricks_[brick_of(p)];
          if (!other.uniform() || other.empty() != brick.empty()) return false;
        }
    return true;
  }

  void find_edges(std::size_t index) {
    Edges& edges = edges_[index];
    const Brick& brick = *stock_.bricks_[index];
    edges.region = brick.region();
    for (std::size_t a = 0; a < 3; ++a)
      if (edges.region.lower[a] == 0) edges.region.lower[a] = -1;
    if (quiet(index)) return;
    edges.shape.emplace(around(brick.region()));
    const Occupancy& shape = *edges.shape;
    const Region& near = shape.region();
    edges.words = static_cast<std::size_t>((edges.region.count(0) + 63) / 64);
    const std::size_t words =
        edges.words * static_cast<std::size_t>(edges.region.count(1)) * static_cast<std::size_t>(edges.region.count(2));
    for (std::size_t a = 0; a < 3; ++a) edges.bits[a].assign(words, 0), edges.before[a].assign(words, 0);
    // The shape begins one point before the brick; the edges begin there, too, or one point later.
    const auto shift = static_cast<std::size_t>(edges.region.lower[0] - near.lower[0]);
    const auto bits = [&](int y, int z, std::size_t w, std::size_t more) -> Word {
      const std::size_t at = w * 64 + shift + more;
      const Word* row = shape.row(y, z);
      Word value = at / 64 < shape.words() ? row[at / 64] >> (at % 64) : 0;
      if (at % 64 && at / 64 + 1 < shape.words()) value |= row[at / 64 + 1] << (64 - at % 64);
      return value;
    };
    std::size_t word = 0;
    for (int z = edges.region.lower[2]; z <= edges.region.upper[2]; ++z)
      for (int y = edges.region.lower[1]; y <= edges.region.upper[1]; ++y)
        for (std::size_t w = 0; w < edges.words; ++w, ++word) {
          const int left = edges.region.count(0) - static_cast<int>(w) * 64;
          const Word valid = left >= 64 ? ~Word{0} : (Word{1} << left) - 1;
          const Word here = bits(y, z, w, 0), x1 = bits(y, z, w, 1), y1 = bits(y + 1, z, w, 0), z1 = bits(y, z + 1, w, 0);
          edges.bits[0][word] = (here ^ x1) & valid;
          edges.bits[1][word] = (here ^ y1) & valid;
          edges.bits[2][word] = (here ^ z1) & valid;
        }
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t i = 0; i < words; ++i) {
        edges.before[a][i] = static_cast<std::uint32_t>(edges.count);
        edges.count += static_cast<std::size_t>(std::popcount(edges.bits[a][i]));
      }
  }

  void place_vertices(std::size_t index, TriangleMesh& mesh, std::vector<std::uint32_t>* cuts) {
    const Edges& edges = edges_[index];
    if (!edges.count) return;
    std::size_t at = edges.first;
    const Vec3& origin = lattice_.box().lower;
    for_each_edge(edges, [&](const Index3& p, std::size_t axis) {
      Index3 q = p;
      ++q[axis];
      const auto a = static_cast<int>(axis);
      Vec3 place;
      std::uint32_t alias = static_cast<std::uint32_t>(at);
      Sample sample;
      if (p[axis] < 0 || p[axis] == lattice_.cells()[axis]) {
        // It leaves the stock's box: the vertex is the point itself, one for all edges that leave there.
        const Index3& inner = p[axis] < 0 ? q : p;
        for (int d = 0; d < 3; ++d) place[d] = lattice_.at(d, inner[static_cast<std::size_t>(d)]);
        for (std::size_t other = 0; other < axis; ++other) {
          if (inner[other] != 0 && inner[other] != lattice_.cells()[other]) continue;
          Index3 from = inner;
          if (inner[other] == 0) --from[other];
          alias = edges_[brick_of(from)].vertex(from, other);
          break;
        }
      } else {
        const bool upwards = stock_.solid(p);
        const Index3& inner = upwards ? p : q;
        sample = stock_.bricks_[brick_of(inner)]->sample(inner, a, upwards, lattice_);
        for (int d = 0; d < 3; ++d) place[d] = lattice_.at(d, p[static_cast<std::size_t>(d)]);
        // Not quite at the points themselves, where vertices of several edges would fall together.
        const double h = lattice_.spacing()[a], margin = 1e-3 * h, low = h * p[axis];
        place[a] = std::clamp(static_cast<double>(sample.at), low + margin, low + h - margin);
      }
      mesh.vertices[at] = {static_cast<float>(origin.x() + place.x()), static_cast<float>(origin.y() + place.y()),
                           static_cast<float>(origin.z() + place.z())};
      if (cuts) (*cuts)[at] = sample.cut;
      alias_[at] = alias;
      ++at;
    });
  }

  void march(std::size_t index, const TriangleMesh& mesh, Piece& piece) const {
    const Edges& edges = edges_[index];
    // Cubes whose lower corners are the brick's; those of neighbours have some of the edges.
    if (edges.words == 0) return;
    const Occupancy& shape = *edges.shape;
    const Region& near = shape.region();
    const auto& cases = cube_cases();
    const auto shift = static_cast<std::size_t>(edges.region.lower[0] - near.lower[0]);
    const auto bits = [&](const Word* row, std::size_t at) -> Word {
      Word value = at / 64 < shape.words() ? row[at / 64] >> (at % 64) : 0;
      if (at % 64 && at / 64 + 1 < shape.words()) value |= row[at / 64 + 1] << (64 - at % 64);
      return value;
    };
    Index3 p;
    for (p[2] = edges.region.lower[2]; p[2] <= edges.region.upper[2]; ++p[2])
      for (p[1] = edges.region.lower[1]; p[1] <= edges.region.upper[1]; ++p[1]) {
        const std::array<const Word*, 4> rows{shape.row(p[1], p[2]), shape.row(p[1] + 1, p[2]), shape.row(p[1], p[2] + 1),
                                              shape.row(p[1] + 1, p[2] + 1)};
        for (std::size_t w = 0; w < edges.words; ++w) {
          const int left = edges.region.count(0) - static_cast<int>(w) * 64;
          const Word valid = left >= 64 ? ~Word{0} : (Word{1} << left) - 1;
          std::array<Word, 8> corners;
          Word any = 0, all = ~Word{0};
          for (std::size_t c = 0; c < 8; ++c) {
            corners[c] = bits(rows[c / 2], w * 64 + shift + c % 2);
            any |= corners[c], all &= corners[c];
          }
          for (Word active = any & ~all & valid; active; active &= active - 1) {
            const int bit = std::countr_zero(active);
            p[0] = edges.region.lower[0] + static_cast<int>(w) * 64 + bit;
            std::size_t which = 0;
            for (std::size_t c = 0; c < 8; ++c) which |= (corners[c] >> bit & 1) << c;
            polygons(edges, p, cases[which], mesh, piece);
          }
        }
      }
  }

  void polygons(const Edges& own, const Index3& p, const CubeCase& cube, const TriangleMesh& mesh, Piece& piece) const {
    std::array<std::uint32_t, 12> vertices;
    unsigned known = 0;
    const auto vertex = [&](std::int8_t edge) {
      const auto e = static_cast<std::size_t>(edge);
      if (known >> e & 1) return vertices[e];
      known |= 1u << e;
      const std::size_t axis = e / 4;
      Index3 from = p;
      from[(axis + 1) % 3] += static_cast<int>(e & 1), from[(axis + 2) % 3] += static_cast<int>(e >> 1 & 1);
      const std::uint32_t v = own.region.contains(from) ? own.vertex(from, axis) : edges_[brick_of(from)].vertex(from, axis);
      return vertices[e] = alias_[v];
    };
    const auto first_middle = static_cast<std::uint32_t>(piece.middles.size());
    for (const auto& loop : cube.middles) {
      Vec3 sum = Vec3::Zero();
      for (const std::int8_t edge : loop) {
        const auto& at = mesh.vertices[vertex(edge)];
        sum += Vec3(at[0], at[1], at[2]);
      }
      sum /= static_cast<double>(loop.size());
      piece.middles.push_back({static_cast<float>(sum.x()), static_cast<float>(sum.y()), static_cast<float>(sum.z())});
    }
    for (const auto& triangle : cube.triangles) {
      std::array<std::uint32_t, 3> t;
      for (std::size_t i = 0; i < 3; ++i)
        t[i] = triangle[i] < 12 ? vertex(triangle[i]) : middle_from + first_middle + static_cast<std::uint32_t>(triangle[i] - 12);
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) piece.triangles.push_back(t);
    }
  }

  /// Leaves out the vertices of which others stand in their place.
  static void drop_unused(TriangleMesh& mesh, std::vector<std::uint32_t>* cuts) {
    constexpr std::uint32_t unused = 0xFFFFFFFF;
    std::vector<std::uint32_t> renamed(mesh.vertices.size(), unused);
    for (const auto& t : mesh.triangles)
      for (const std::uint32_t v : t) renamed[v] = 0;
    std::uint32_t next = 0;
    for (std::size_t v = 0; v < renamed.size(); ++v) {
      if (renamed[v] == unused) continue;
      mesh.vertices[next] = mesh.vertices[v];
      if (cuts) (*cuts)[next] = (*cuts)[v];
      renamed[v] = next++;
    }
    mesh.vertices.resize(next);
    if (cuts) cuts->resize(next);
    for (auto& t : mesh.triangles)
      for (std::uint32_t& v : t) v = renamed[v];
  }

  const Stock& stock_;
  const StockLattice& lattice_;
  Progress& progress_;
  std::vector<Edges> edges_;
  std::vector<std::uint32_t> alias_;
};

TriangleMesh Stock::mesh(std::vector<std::uint32_t>* cuts, Progress& progress) const {
  return StockMesher(*this, progress).make(cuts);
}

}  // namespace fieldfab::cam
