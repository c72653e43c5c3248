// The surface of a stock as one closed mesh (Hahn 4.3). Cubes of the lattice are looked at brick by brick, whatever cells their
// points belong to: since each point and each sample is owned once, there are no seams. Outside of the stock's box everything is
// air, and an edge that leaves the box crosses the surface where it leaves it: that makes the exterior mesh.
#include "fieldfab/cam/stock_surface.h"

#include <malloc.h>

#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "brick.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "marching.h"

namespace fieldfab::cam {

using Word = Occupancy::Word;

/// What of the surface a brick has: the edges whose lower points are its own, and the cubes whose lower corners are.
struct StockSurface::Piece {
  std::shared_ptr<const Brick> brick;  ///< what it was made from
  Region region;                       ///< of the lower points: the brick's, and at the lower faces of the stock those before it
  std::size_t words = 0;               ///< along a row; 0: nothing is crossed anywhere near
  std::array<std::vector<Word>, 3> crossed;  ///< edges by axis, row and bit
  std::vector<std::uint32_t> before;         ///< vertices before each word
  std::optional<Occupancy> shape;            ///< solid points of the brick and one more on each side, while it is made
  std::uint32_t edges = 0;                   ///< crossed ones
  /// Of the edges, and of loops' middles, which are counted on; with the cuts that made them.
  std::vector<std::array<float, 3>> vertices, middles;
  std::vector<std::uint32_t> cuts, middle_cuts;
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< of triangles: a vertex, and above `own_bits` whose it is, as `beside`
  static constexpr unsigned own_bits = 29;
  static constexpr std::uint32_t own_part = (1u << own_bits) - 1;

  [[nodiscard]] std::size_t size() const { return vertices.size() + middles.size(); }
  [[nodiscard]] std::size_t word_of(const Index3& p) const {
    const auto row = static_cast<std::size_t>(p[2] - region.lower[2]) * static_cast<std::size_t>(region.count(1)) +
                     static_cast<std::size_t>(p[1] - region.lower[1]);
    return row * words + static_cast<std::size_t>(p[0] - region.lower[0]) / 64;
  }
  [[nodiscard]] std::uint32_t vertex(const Index3& p, std::size_t axis) const {
    const std::size_t word = word_of(p);
    std::uint32_t count = before[word];
    for (std::size_t a = 0; a < axis; ++a) count += static_cast<std::uint32_t>(std::popcount(crossed[a][word]));
    const int bit = (p[0] - region.lower[0]) % 64;
    return count + static_cast<std::uint32_t>(std::popcount(crossed[axis][word] & ((Word{1} << bit) - 1)));
  }
  /// Calls with each crossed edge's lower point and axis, in the vertices' order.
  template <class Body>
  void for_each_edge(const Body& body) const {
    std::size_t word = 0;
    Index3 p;
    for (p[2] = region.lower[2]; p[2] <= region.upper[2]; ++p[2])
      for (p[1] = region.lower[1]; p[1] <= region.upper[1]; ++p[1])
        for (std::size_t w = 0; w < words; ++w, ++word)
          for (std::size_t axis = 0; axis < 3; ++axis)
            for (Word left = crossed[axis][word]; left; left &= left - 1) {
              p[0] = region.lower[0] + static_cast<int>(w) * 64 + std::countr_zero(left);
              body(p, axis);
            }
  }
  void clear() {
    for (std::vector<Word>& bits : crossed) bits.clear();
    before.clear(), vertices.clear(), cuts.clear();
    words = 0, edges = 0;
  }
};

namespace {

/// Bits of a row from a place on; 0 behind its end.
Word bits_from(const Word* row, std::size_t words, std::size_t at) {
  Word value = at / 64 < words ? row[at / 64] >> (at % 64) : 0;
  if (at % 64 && at / 64 + 1 < words) value |= row[at / 64 + 1] << (64 - at % 64);
  return value;
}

/// The bits of a row's word that belong to a region.
Word valid(const Region& region, std::size_t word) {
  const int left = region.count(0) - static_cast<int>(word) * 64;
  return left >= 64 ? ~Word{0} : (Word{1} << left) - 1;
}

}  // namespace

/// Makes pieces anew.
class StockSurface::Update {
 public:
  Update(StockSurface& surface, const Stock& stock, Progress& progress)
      : surface_(surface), pieces_(surface.pieces_), stock_(stock), lattice_(stock.lattice()), progress_(progress) {}

  std::vector<std::size_t> run() {
    // A piece's edges depend on its brick and those after it; its triangles on the edges of pieces after it as well.
    const std::vector<std::size_t> changed =
        with_those_before([&](std::size_t i) { return pieces_[i]->brick != stock_.bricks_[i]; });
    std::vector<char> anew(pieces_.size());
    for (const std::size_t i : changed) anew[i] = 1;
    const std::vector<std::size_t> touched = with_those_before([&](std::size_t i) { return anew[i] != 0; });
    each(changed, [&](std::size_t i) { find_edges(i); });
    each(changed, [&](std::size_t i) { place_vertices(i); });
    each(touched, [&](std::size_t i) { march(i); });
    for (const std::size_t i : touched) pieces_[i]->shape.reset(), pieces_[i]->brick = stock_.bricks_[i];
    return touched;
  }

 private:
  template <class Body>
  void each(const std::vector<std::size_t>& list, const Body& body) {
    parallel_for(list.size(), [&](std::size_t k) {
      progress_.check();
      body(list[k]);
    });
  }

  /// The pieces of which it is true, and those just before them.
  template <class Test>
  std::vector<std::size_t> with_those_before(const Test& test) const {
    std::vector<std::size_t> list;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      bool any = false;
      for (unsigned step = 0; step < 8 && !any; ++step) {
        const std::size_t other = surface_.beside(i, step);
        any = other < pieces_.size() && test(other);
      }
      if (any) list.push_back(i);
    }
    return list;
  }

  [[nodiscard]] bool outside(int k, std::size_t axis) const { return k < 0 || k > lattice_.cells()[axis]; }

  /// Solid points of a brick's region and one more on each side.
  [[nodiscard]] Occupancy around(const Region& region) const {
    Region near = region;
    for (std::size_t a = 0; a < 3; ++a) --near.lower[a], ++near.upper[a];
    Occupancy shape(near);
    Index3 low, high;
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::max(near.lower[a], 0) / stock_.brick_;
      high[a] = std::min(near.upper[a], lattice_.cells()[a]) / stock_.brick_;
    }
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) {
          const Brick& brick = *stock_.bricks_[stock_.brick_index(x, y, z)];
          if (!brick.empty()) brick.occupy(shape, lattice_);
        }
    return shape;
  }

  /// Whether the bricks around a uniform one are uniform alike, so that there is no surface at it; the stock's faces are surface.
  [[nodiscard]] bool quiet(std::size_t index) const {
    const Brick& brick = *stock_.bricks_[index];
    if (!brick.uniform()) return false;
    const Region& r = brick.region();
    Index3 step;
    for (step[2] = -1; step[2] <= 1; ++step[2])
      for (step[1] = -1; step[1] <= 1; ++step[1])
        for (step[0] = -1; step[0] <= 1; ++step[0]) {
          Index3 b;
          bool left = false;
          for (std::size_t a = 0; a < 3; ++a) {
            const int k = step[a] < 0 ? r.lower[a] - 1 : step[a] ? r.upper[a] + 1 : r.lower[a];
            left |= outside(k, a);
            b[a] = k / stock_.brick_;
          }
          if (left) {
            if (!brick.empty()) return false;
            continue;
          }
          const Brick& other = *stock_.bricks_[stock_.brick_index(b[0], b[1], b[2])];
          if (!other.uniform() || other.empty() != brick.empty()) return false;
        }
    return true;
  }

  void find_edges(std::size_t index) {
    Piece& piece = *pieces_[index];
    piece.clear();
    piece.region = stock_.bricks_[index]->region();
    for (std::size_t a = 0; a < 3; ++a)
      if (piece.region.lower[a] == 0) piece.region.lower[a] = -1;
    if (quiet(index)) return;
    piece.shape.emplace(around(stock_.bricks_[index]->region()));
    const Occupancy& shape = *piece.shape;
    const Region& r = piece.region;
    piece.words = static_cast<std::size_t>((r.count(0) + 63) / 64);
    const std::size_t words = piece.words * static_cast<std::size_t>(r.count(1)) * static_cast<std::size_t>(r.count(2));
    for (std::vector<Word>& bits : piece.crossed) bits.assign(words, 0);
    piece.before.assign(words, 0);
    // The shape begins one point before the brick; the edges begin there, too, or one point later.
    const auto shift = static_cast<std::size_t>(r.lower[0] - shape.region().lower[0]);
    std::size_t word = 0;
    for (int z = r.lower[2]; z <= r.upper[2]; ++z)
      for (int y = r.lower[1]; y <= r.upper[1]; ++y)
        for (std::size_t w = 0; w < piece.words; ++w, ++word) {
          const auto bits = [&](int by, int bz, std::size_t more) {
            return bits_from(shape.row(by, bz), shape.words(), w * 64 + shift + more);
          };
          const Word here = bits(y, z, 0), all = valid(r, w);
          piece.crossed[0][word] = (here ^ bits(y, z, 1)) & all;
          piece.crossed[1][word] = (here ^ bits(y + 1, z, 0)) & all;
          piece.crossed[2][word] = (here ^ bits(y, z + 1, 0)) & all;
          // Of the edges that leave the stock's box at one point only the first has a vertex.
          if (y < 0 || y == lattice_.cells()[1]) piece.crossed[1][word] &= ~at_x_faces(r, w);
          if (z < 0 || z == lattice_.cells()[2])
            piece.crossed[2][word] &= y == 0 || y == lattice_.cells()[1] ? 0 : ~at_x_faces(r, w);
        }
    for (std::size_t i = 0; i < words; ++i) {
      piece.before[i] = piece.edges;
      for (const std::vector<Word>& bits : piece.crossed) piece.edges += static_cast<std::uint32_t>(std::popcount(bits[i]));
    }
    if (piece.edges >= 1u << (Piece::own_bits - 1)) throw Error(ErrorKind::too_large, "stock", "too much surface for one brick");
  }

  /// The bits of a row's word whose points lie on the stock's faces across x.
  [[nodiscard]] Word at_x_faces(const Region& r, std::size_t word) const {
    Word bits = 0;
    for (const int x : {0, lattice_.cells()[0]}) {
      const int bit = x - r.lower[0] - static_cast<int>(word) * 64;
      if (bit >= 0 && bit < 64) bits |= Word{1} << bit;
    }
    return bits;
  }

  void place_vertices(std::size_t index) {
    Piece& piece = *pieces_[index];
    piece.vertices.reserve(piece.edges), piece.cuts.reserve(piece.edges);
    const Vec3& origin = lattice_.box().lower;
    const Brick& own = *stock_.bricks_[index];
    piece.for_each_edge([&](const Index3& p, std::size_t axis) {
      Index3 q = p;
      ++q[axis];
      const auto a = static_cast<int>(axis);
      Vec3 place;
      for (int d = 0; d < 3; ++d) place[d] = lattice_.at(d, p[static_cast<std::size_t>(d)]);
      Sample sample;
      if (outside(p[axis], axis) || outside(q[axis], axis)) {
        // It leaves the stock's box: the vertex is the point itself, one for all edges that leave there.
        place[a] = lattice_.at(a, outside(p[axis], axis) ? q[axis] : p[axis]);
      } else {
        const bool upwards = own.solid(p, lattice_);
        const Index3& inner = upwards ? p : q;
        const Brick& owner = own.region().contains(inner) ? own : brick_at(inner);
        sample = owner.sample(inner, a, upwards, lattice_);
        // Not quite at the points themselves, where vertices of several edges would fall together.
        const double h = lattice_.spacing()[a], margin = 1e-3 * h, low = h * p[axis];
        place[a] = std::clamp(static_cast<double>(sample.at), low + margin, low + h - margin);
      }
      place += origin;
      piece.vertices.push_back({static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())});
      piece.cuts.push_back(sample.cut);
    });
  }

  [[nodiscard]] const Brick& brick_at(const Index3& p) const {
    return *stock_.bricks_[stock_.brick_index(p[0] / stock_.brick_, p[1] / stock_.brick_, p[2] / stock_.brick_)];
  }

  void march(std::size_t index) {
    Piece& piece = *pieces_[index];
    piece.corners.clear(), piece.middles.clear(), piece.middle_cuts.clear();
    if (piece.words == 0) return;
    if (!piece.shape) piece.shape.emplace(around(stock_.bricks_[index]->region()));
    const Occupancy& shape = *piece.shape;
    const auto& cases = cube_cases();
    const Region& r = piece.region;
    const auto shift = static_cast<std::size_t>(r.lower[0] - shape.region().lower[0]);
    Index3 p;
    for (p[2] = r.lower[2]; p[2] <= r.upper[2]; ++p[2])
      for (p[1] = r.lower[1]; p[1] <= r.upper[1]; ++p[1]) {
        const std::array<const Word*, 4> rows{shape.row(p[1], p[2]), shape.row(p[1] + 1, p[2]), shape.row(p[1], p[2] + 1),
                                              shape.row(p[1] + 1, p[2] + 1)};
        for (std::size_t w = 0; w < piece.words; ++w) {
          std::array<Word, 8> solid;
          Word any = 0, all = ~Word{0};
          for (std::size_t c = 0; c < 8; ++c) {
            solid[c] = bits_from(rows[c / 2], shape.words(), w * 64 + shift + c % 2);
            any |= solid[c], all &= solid[c];
          }
          for (Word active = any & ~all & valid(r, w); active; active &= active - 1) {
            const int bit = std::countr_zero(active);
            p[0] = r.lower[0] + static_cast<int>(w) * 64 + bit;
            std::size_t which = 0;
            for (std::size_t c = 0; c < 8; ++c) which |= (solid[c] >> bit & 1) << c;
            add_polygons(index, p, cases[which]);
          }
        }
      }
    piece.shape.reset();
    piece.corners.shrink_to_fit();
  }

  /// The vertex of a crossed edge, and whose it is.
  [[nodiscard]] std::uint32_t vertex(std::size_t index, Index3 from, std::size_t axis) const {
    const Piece& own = *pieces_[index];
    // Edges that leave the box at the same point share the vertex of the first.
    const bool before = from[axis] < 0;
    if (before || from[axis] == lattice_.cells()[axis]) {
      for (std::size_t other = 0; other < axis; ++other) {
        if (from[other] != 0 && from[other] != lattice_.cells()[other]) continue;
        if (before) ++from[axis];
        if (from[other] == 0) --from[other];
        axis = other;
        break;
      }
    }
    unsigned step = 0;
    for (std::size_t a = 0; a < 3; ++a)
      if (from[a] > own.region.upper[a]) step |= 1u << a;
    if (!step) return own.vertex(from, axis);
    return pieces_[surface_.beside(index, step)]->vertex(from, axis) | step << Piece::own_bits;
  }

  void add_polygons(std::size_t index, const Index3& p, const CubeCase& cube) {
    Piece& piece = *pieces_[index];
    std::array<std::uint32_t, 12> vertices;
    unsigned known = 0;
    const auto vertex_of = [&](std::int8_t edge) {
      const auto e = static_cast<std::size_t>(edge);
      if (known >> e & 1) return vertices[e];
      known |= 1u << e;
      const std::size_t axis = e / 4;
      Index3 from = p;
      from[(axis + 1) % 3] += static_cast<int>(e & 1), from[(axis + 2) % 3] += static_cast<int>(e >> 1 & 1);
      return vertices[e] = vertex(index, from, axis);
    };
    const auto first_middle = piece.edges + static_cast<std::uint32_t>(piece.middles.size());
    for (const auto& loop : cube.middles) {
      Vec3 sum = Vec3::Zero();
      std::uint32_t cut = 0;
      for (const std::int8_t edge : loop) {
        const std::uint32_t v = vertex_of(edge);
        const Piece& whose = *pieces_[surface_.beside(index, v >> Piece::own_bits)];
        const auto& at = whose.vertices[v & Piece::own_part];
        cut = std::max(cut, whose.cuts[v & Piece::own_part]);
        sum += Vec3(at[0], at[1], at[2]);
      }
      sum /= static_cast<double>(loop.size());
      piece.middles.push_back({static_cast<float>(sum.x()), static_cast<float>(sum.y()), static_cast<float>(sum.z())});
      piece.middle_cuts.push_back(cut);
    }
    for (const auto& triangle : cube.triangles) {
      std::array<std::uint32_t, 3> t;
      for (std::size_t i = 0; i < 3; ++i)
        t[i] = triangle[i] < 12 ? vertex_of(triangle[i]) : first_middle + static_cast<std::uint32_t>(triangle[i] - 12);
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) piece.corners.push_back(t);
    }
  }

  StockSurface& surface_;
  std::vector<std::unique_ptr<Piece>>& pieces_;
  const Stock& stock_;
  const StockLattice& lattice_;
  Progress& progress_;
};

StockSurface::StockSurface() = default;
StockSurface::StockSurface(StockSurface&&) noexcept = default;
StockSurface& StockSurface::operator=(StockSurface&&) noexcept = default;
StockSurface::~StockSurface() = default;

std::size_t StockSurface::beside(std::size_t index, unsigned step) const {
  const auto nx = static_cast<std::size_t>(along_[0]), ny = static_cast<std::size_t>(along_[1]),
             nz = static_cast<std::size_t>(along_[2]);
  const std::size_t x = index % nx + (step & 1), y = index / nx % ny + (step >> 1 & 1), z = index / nx / ny + (step >> 2 & 1);
  return x < nx && y < ny && z < nz ? (z * ny + y) * nx + x : pieces_.size();
}

std::vector<std::size_t> StockSurface::update(const Stock& stock, Progress& progress) {
  const Box &was = lattice_.box(), &is = stock.lattice().box();
  if (pieces_.size() != stock.bricks_.size() || along_ != stock.bricks_along_ || lattice_.cells() != stock.lattice().cells() ||
      was.lower != is.lower || was.upper != is.upper) {
    lattice_ = stock.lattice();
    along_ = stock.bricks_along_;
    pieces_.clear();
    for (std::size_t i = 0; i < stock.bricks_.size(); ++i) pieces_.push_back(std::make_unique<Piece>());
  }
  try {
    return Update(*this, stock, progress).run();
  } catch (...) {
    pieces_.clear();
    throw;
  }
}

/// The pieces put together; tells when the triangles and when the vertices of a piece are not needed any more.
template <class Surface, class TrianglesDone, class VerticesDone>
TriangleMesh StockSurface::collected(Surface& surface, std::vector<std::uint32_t>* cuts, const TrianglesDone& triangles_done,
                                     const VerticesDone& vertices_done) {
  TriangleMesh mesh;
  std::vector<std::uint32_t> first;
  std::size_t vertices = 0, triangles = 0;
  for (const auto& piece : surface.pieces_) {
    first.push_back(static_cast<std::uint32_t>(vertices));
    vertices += piece->size(), triangles += piece->corners.size();
  }
  if (vertices > std::numeric_limits<std::uint32_t>::max()) throw Error(ErrorKind::too_large, "stock", "too many vertices");
  mesh.triangles.reserve(triangles);
  for (std::size_t i = 0; i < surface.pieces_.size(); ++i) {
    std::array<std::uint32_t, 8> from{};
    for (unsigned step = 0; step < 8; ++step)
      if (const std::size_t other = surface.beside(i, step); other < first.size()) from[step] = first[other];
    for (std::array<std::uint32_t, 3> t : surface.pieces_[i]->corners) {
      for (std::uint32_t& v : t) v = from[v >> Piece::own_bits] + (v & Piece::own_part);
      mesh.triangles.push_back(t);
    }
    triangles_done(*surface.pieces_[i]);
  }
  mesh.vertices.reserve(vertices);
  if (cuts) cuts->clear(), cuts->reserve(vertices);
  for (const auto& piece : surface.pieces_) {
    append_vertices(*piece, mesh, cuts);
    vertices_done(*piece);
  }
  return mesh;
}

void StockSurface::append_vertices(const Piece& piece, TriangleMesh& mesh, std::vector<std::uint32_t>* cuts) {
  for (const auto* part : {&piece.vertices, &piece.middles})
    mesh.vertices.insert(mesh.vertices.end(), part->begin(), part->end());
  if (!cuts) return;
  for (const auto* part : {&piece.cuts, &piece.middle_cuts}) cuts->insert(cuts->end(), part->begin(), part->end());
}

TriangleMesh StockSurface::piece(std::size_t index, std::vector<std::uint32_t>* cuts) const {
  const Piece& piece = *pieces_.at(index);
  TriangleMesh mesh;
  if (cuts) cuts->clear();
  append_vertices(piece, mesh, cuts);
  std::map<std::uint32_t, std::uint32_t> others;  // of the pieces beside it
  for (std::array<std::uint32_t, 3> t : piece.corners) {
    for (std::uint32_t& v : t) {
      const unsigned step = v >> Piece::own_bits;
      if (!step) continue;
      const auto [found, fresh] = others.try_emplace(v, static_cast<std::uint32_t>(mesh.vertices.size()));
      if (fresh) {
        const Piece& other = *pieces_[beside(index, step)];
        const std::uint32_t at = v & Piece::own_part;
        mesh.vertices.push_back(other.vertices[at]);
        if (cuts) cuts->push_back(other.cuts[at]);
      }
      v = found->second;
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

DrawnSurface StockSurface::drawn_piece(std::size_t index, int coarse) const {
  std::vector<std::uint32_t> cuts;
  const TriangleMesh mesh = piece(index, &cuts);
  const Region& own = pieces_[index]->region;
  Box region;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    // Where the stock ends, no piece follows.
    region.lower[i] = own.lower[a] < 0 ? -1e9 : own.lower[a];
    region.upper[i] = own.upper[a] >= lattice_.cells()[a] ? 1e9 : own.upper[a] + 1;
  }
  return simplified(drawn(mesh, std::move(cuts)), lattice_, region, coarse);
}

TriangleMesh StockSurface::mesh(std::vector<std::uint32_t>* cuts) const& {
  return collected(
      *this, cuts, [](const Piece&) {}, [](const Piece&) {});
}

TriangleMesh StockSurface::mesh(std::vector<std::uint32_t>* cuts) && {
  for (const auto& piece : pieces_) piece->crossed = {}, piece->before = {}, piece->brick.reset();
#ifdef __GLIBC__
  malloc_trim(0);  // glibc keeps what was freed for the threads that made it; the mesh's arrays could not use it
#endif
  return collected(
      *this, cuts, [](Piece& piece) { piece.corners = {}; },
      [](Piece& piece) { piece.vertices = {}, piece.middles = {}, piece.cuts = {}, piece.middle_cuts = {}; });
}

TriangleMesh Stock::mesh(std::vector<std::uint32_t>* cuts, Progress& progress) const {
  StockSurface surface;
  surface.update(*this, progress);
  return std::move(surface).mesh(cuts);
}

}  // namespace fieldfab::cam
