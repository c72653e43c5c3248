#include "surface_pieces.h"

#include <algorithm>
#include <cmath>

#include "fieldfab/core/error.h"

namespace fieldfab::cam {

using Word = Occupancy::Word;

namespace {

/// 64 bits of a row from a position on; 0 beyond its end.
Word bits_from(const Word* row, std::size_t words, std::size_t at) {
  Word value = at / 64 < words ? row[at / 64] >> (at % 64) : 0;
  if (at % 64 && at / 64 + 1 < words) value |= row[at / 64 + 1] << (64 - at % 64);
  return value;
}

/// Mask of the bits of a row's word that belong to a region.
Word valid(const Region& region, std::size_t word) {
  const int left = region.count(0) - static_cast<int>(word) * 64;
  return left >= 64 ? ~Word{0} : (Word{1} << left) - 1;
}

}  // namespace

SurfacePieces::SurfacePieces(const Stock& stock)
    : lattice_(stock.lattice()), along_(stock.bricks_along_), pieces_(stock.bricks_.size()) {}

bool SurfacePieces::fits(const Stock& stock) const {
  const Box &was = lattice_.box(), &is = stock.lattice().box();
  return along_ == stock.bricks_along_ && lattice_.cells() == stock.lattice().cells() && was.lower == is.lower &&
         was.upper == is.upper;
}

std::size_t SurfacePieces::beside(std::size_t index, unsigned step) const {
  const auto nx = static_cast<std::size_t>(along_[0]), ny = static_cast<std::size_t>(along_[1]),
             nz = static_cast<std::size_t>(along_[2]);
  const std::size_t x = index % nx + (step & 1), y = index / nx % ny + (step >> 1 & 1),
                    z = index / nx / ny + (step >> 2 & 1);
  return x < nx && y < ny && z < nz ? (z * ny + y) * nx + x : pieces_.size();
}

std::vector<std::size_t> SurfacePieces::with_those_before(const std::vector<char>& some) const {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    bool any = false;
    for (unsigned step = 0; step < 8 && !any; ++step) {
      const std::size_t other = beside(i, step);
      any = other < pieces_.size() && some[other];
    }
    if (any) list.push_back(i);
  }
  return list;
}

std::vector<std::size_t> SurfacePieces::outdated(const Stock& stock) const {
  std::vector<char> other(pieces_.size());
  for (std::size_t i = 0; i < pieces_.size(); ++i) other[i] = pieces_[i].brick != stock.bricks_[i];
  return with_those_before(other);
}

std::vector<std::vector<std::size_t>> SurfacePieces::waves() const {
  constexpr std::size_t enough = 64;  // pieces per wave, enough to occupy many cores
  const auto nx = static_cast<std::size_t>(along_[0]), ny = static_cast<std::size_t>(along_[1]);
  const auto axis = static_cast<std::size_t>(std::max_element(along_.begin(), along_.end()) - along_.begin());
  const auto slices = static_cast<std::size_t>(along_[axis]), thick = (enough * slices + size() - 1) / size();
  std::vector<std::vector<std::size_t>> waves((slices + thick - 1) / thick);
  for (std::size_t i = 0; i < size(); ++i)
    waves[std::array{i % nx, i / nx % ny, i / nx / ny}[axis] / thick].push_back(i);
  return waves;
}

/// Solid points of a brick's region, extended by one point on each side.
Occupancy SurfacePieces::around(const Region& region, const Stock& stock) const {
  Region near = region;
  for (std::size_t a = 0; a < 3; ++a) --near.lower[a], ++near.upper[a];
  Occupancy shape(near);
  Index3 low, high;
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = std::max(near.lower[a], 0) / stock.brick_;
    high[a] = std::min(near.upper[a], lattice_.cells()[a]) / stock.brick_;
  }
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x) {
        const Brick& brick = *stock.bricks_[stock.brick_index(x, y, z)];
        if (!brick.empty()) brick.occupy(shape, lattice_);
      }
  return shape;
}

/// Whether the bricks around a uniform brick are uniform alike, so that there is no surface at it.
/// The stock's faces are surface.
bool SurfacePieces::quiet(std::size_t index, const Stock& stock) const {
  const Brick& brick = *stock.bricks_[index];
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
          b[a] = k / stock.brick_;
        }
        if (left) {
          if (!brick.empty()) return false;
          continue;
        }
        const Brick& other = *stock.bricks_[stock.brick_index(b[0], b[1], b[2])];
        if (!other.uniform() || other.empty() != brick.empty()) return false;
      }
  return true;
}

void SurfacePieces::make_vertices(std::size_t index, const Stock& stock) {
  find_edges(index, stock);
  place_vertices(index, stock);
}

void SurfacePieces::find_edges(std::size_t index, const Stock& stock) {
  SurfacePiece& piece = pieces_[index];
  piece.clear();
  piece.region = stock.bricks_[index]->region();
  for (std::size_t a = 0; a < 3; ++a)
    if (piece.region.lower[a] == 0) piece.region.lower[a] = -1;
  if (quiet(index, stock)) return;
  piece.shape.emplace(around(stock.bricks_[index]->region(), stock));
  const Occupancy& shape = *piece.shape;
  const Region& r = piece.region;
  piece.words = static_cast<std::size_t>((r.count(0) + 63) / 64);
  const std::size_t words = piece.words * static_cast<std::size_t>(r.count(1)) * static_cast<std::size_t>(r.count(2));
  for (std::vector<Word>& bits : piece.crossed) bits.assign(words, 0);
  piece.before.assign(words, 0);
  // The shape starts one point before the brick; the edges start there or one point later.
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
        // Of the edges that leave the stock's box at one point, only the first has a vertex.
        if (y < 0 || y == lattice_.cells()[1]) piece.crossed[1][word] &= ~at_x_faces(r, w);
        if (z < 0 || z == lattice_.cells()[2])
          piece.crossed[2][word] &= y == 0 || y == lattice_.cells()[1] ? 0 : ~at_x_faces(r, w);
      }
  for (std::size_t i = 0; i < words; ++i) {
    piece.before[i] = piece.edges;
    for (const std::vector<Word>& bits : piece.crossed)
      piece.edges += static_cast<std::uint32_t>(std::popcount(bits[i]));
  }
  if (piece.edges >= 1u << (SurfacePiece::own_bits - 1))
    throw Error(ErrorKind::too_large, "stock", "too much surface for one brick");
}

/// Mask of the bits of a row's word whose points lie on the stock's faces perpendicular to x.
SurfacePiece::Word SurfacePieces::at_x_faces(const Region& r, std::size_t word) const {
  Word bits = 0;
  for (const int x : {0, lattice_.cells()[0]}) {
    const int bit = x - r.lower[0] - static_cast<int>(word) * 64;
    if (bit >= 0 && bit < 64) bits |= Word{1} << bit;
  }
  return bits;
}

void SurfacePieces::place_vertices(std::size_t index, const Stock& stock) {
  SurfacePiece& piece = pieces_[index];
  piece.vertices.reserve(piece.edges), piece.cuts.reserve(piece.edges);
  const Vec3& origin = lattice_.box().lower;
  const Brick& own = *stock.bricks_[index];
  const auto brick_at = [&](const Index3& p) -> const Brick& {
    return *stock.bricks_[stock.brick_index(p[0] / stock.brick_, p[1] / stock.brick_, p[2] / stock.brick_)];
  };
  piece.for_each_edge([&](const Index3& p, std::size_t axis) {
    Index3 q = p;
    ++q[axis];
    const auto a = static_cast<int>(axis);
    Vec3 place;
    for (int d = 0; d < 3; ++d) place[d] = lattice_.at(d, p[static_cast<std::size_t>(d)]);
    Sample sample;
    if (outside(p[axis], axis) || outside(q[axis], axis)) {
      // The edge leaves the stock's box: the vertex is the point itself, shared by all edges that
      // leave there.
      place[a] = lattice_.at(a, outside(p[axis], axis) ? q[axis] : p[axis]);
    } else {
      const bool upwards = own.solid(p, lattice_);
      const Index3& inner = upwards ? p : q;
      const Brick& owner = own.region().contains(inner) ? own : brick_at(inner);
      sample = owner.sample(inner, a, upwards, lattice_);
      // Kept off the lattice points, where vertices of several edges would coincide.
      const double h = lattice_.spacing()[a], margin = 1e-3 * h, low = h * p[axis];
      place[a] = std::clamp(static_cast<double>(sample.at), low + margin, low + h - margin);
    }
    place += origin;
    piece.vertices.push_back(
        {static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())});
    piece.cuts.push_back(sample.cut);
  });
}

void SurfacePieces::march(std::size_t index, const Stock& stock, bool with_cubes) {
  SurfacePiece& piece = pieces_[index];
  piece.brick = stock.bricks_[index];
  piece.corners.clear(), piece.cubes.clear(), piece.middles.clear(), piece.middle_cuts.clear();
  if (piece.words == 0) return;
  if (!piece.shape) piece.shape.emplace(around(stock.bricks_[index]->region(), stock));
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
          if (with_cubes) {
            std::array<std::int16_t, 3> from_lower;
            for (std::size_t a = 0; a < 3; ++a) from_lower[a] = static_cast<std::int16_t>(p[a] - r.lower[a]);
            piece.cubes.push_back({from_lower, static_cast<std::uint32_t>(piece.corners.size())});
          }
          add_polygons(index, p, cases[which]);
        }
      }
    }
  piece.shape.reset();
  piece.corners.shrink_to_fit();
}

/// The vertex of a crossed edge, with its owner.
std::uint32_t SurfacePieces::vertex(std::size_t index, Index3 from, std::size_t axis) const {
  const SurfacePiece& own = pieces_[index];
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
  return pieces_[beside(index, step)].vertex(from, axis) | step << SurfacePiece::own_bits;
}

void SurfacePieces::add_polygons(std::size_t index, const Index3& p, const CubeCase& cube) {
  SurfacePiece& piece = pieces_[index];
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
      const SurfacePiece& whose = pieces_[beside(index, v >> SurfacePiece::own_bits)];
      const auto& at = whose.vertices[v & SurfacePiece::own_part];
      cut = std::max(cut, whose.cuts[v & SurfacePiece::own_part]);
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

}  // namespace fieldfab::cam
