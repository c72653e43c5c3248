/// The surface of a stock by bricks (Hahn 4.3). The lattice's cubes are processed brick by brick,
/// independently of the cells of their points. There are no seams, because each point and each
/// sample has one owner. Outside of the stock's box everything is air. An edge that leaves the box
/// crosses the surface at the box, which makes the exterior mesh.
#pragma once

#include <bit>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "brick.h"
#include "cell.h"
#include "marching.h"

namespace fieldfab::cam {

/// The surface of a brick: the edges whose lower points, and the cubes whose lower corners, belong
/// to it.
struct SurfacePiece {
  using Word = Occupancy::Word;
  using Place = std::array<float, 3>;

  std::shared_ptr<const Brick> brick;        ///< source of the piece
  Region region;                             ///< of the lower points: the brick's region, extended by one
                                             ///< at the lower faces of the stock
  std::size_t words = 0;                     ///< per row; 0 if no edge is crossed
  std::array<std::vector<Word>, 3> crossed;  ///< crossed edges by axis, row and bit
  std::vector<std::uint32_t> before;         ///< number of vertices before each word
  std::optional<Occupancy> shape;            ///< solid points of the brick, extended by one on each
                                             ///< side; only during construction
  std::uint32_t edges = 0;                   ///< number of crossed edges
  /// Vertices of the edges, and of the loops' middles, which are numbered after them; with the cuts
  /// that made them.
  std::vector<Place> vertices, middles;
  std::vector<std::uint32_t> cuts, middle_cuts;
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< of triangles: index of a vertex, and
                                                      ///< above `own_bits` its owner as in `beside`
  /// A cube with triangles: its lower corner, and the number of triangles of cubes before it.
  struct Cube {
    std::array<std::int16_t, 3> from_lower;  ///< from the region's lower corner
    std::uint32_t first;
  };
  std::vector<Cube> cubes;  ///< only if asked for
  static constexpr unsigned own_bits = 29;
  static constexpr std::uint32_t own_part = (1u << own_bits) - 1;

  [[nodiscard]] std::size_t size() const { return vertices.size() + middles.size(); }
  [[nodiscard]] const Place& place(std::uint32_t v) const { return v < edges ? vertices[v] : middles[v - edges]; }
  [[nodiscard]] std::uint32_t cut(std::uint32_t v) const { return v < edges ? cuts[v] : middle_cuts[v - edges]; }
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
  /// Calls body(point, axis) with the lower point of each crossed edge, in the order of the
  /// vertices.
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

/// All pieces of a stock. They are made in two steps, both concurrently for many pieces: vertices
/// depend on bricks only, triangles also on the vertices of the pieces after them.
class SurfacePieces {
 public:
  explicit SurfacePieces(const Stock& stock);

  /// Whether the pieces belong to a stock with this lattice and these bricks.
  [[nodiscard]] bool fits(const Stock& stock) const;
  [[nodiscard]] const StockLattice& lattice() const { return lattice_; }
  [[nodiscard]] std::size_t size() const { return pieces_.size(); }
  [[nodiscard]] SurfacePiece& operator[](std::size_t index) { return pieces_[index]; }
  [[nodiscard]] const SurfacePiece& operator[](std::size_t index) const { return pieces_[index]; }
  /// Index of the neighbouring piece `step`, which has a bit each for +x, +y and +z; size() if
  /// there is none.
  [[nodiscard]] std::size_t beside(std::size_t index, unsigned step) const;
  /// Index of the piece that owns a triangle's corner.
  [[nodiscard]] std::size_t owner(std::size_t index, std::uint32_t corner) const {
    return corner >> SurfacePiece::own_bits ? beside(index, corner >> SurfacePiece::own_bits) : index;
  }
  /// The pieces whose bricks have changed, and their predecessors.
  [[nodiscard]] std::vector<std::size_t> outdated(const Stock& stock) const;
  /// The given pieces and their predecessors.
  [[nodiscard]] std::vector<std::size_t> with_those_before(const std::vector<char>& some) const;
  /// All pieces in groups, such that the pieces after a piece are in its own group or the next one.
  /// Groups are slices across the longest side; small slices are joined.
  [[nodiscard]] std::vector<std::vector<std::size_t>> waves() const;

  /// Adds the crossings of the edges that start at solid points of a brick.
  void add_crossings(std::size_t index, const Stock& stock, std::vector<StockCrossing>& list) const;
  void make_vertices(std::size_t index, const Stock& stock);
  /// Makes a piece's triangles, and the list of their cubes if wanted.
  void march(std::size_t index, const Stock& stock, bool with_cubes = false);

 private:
  void find_edges(std::size_t index, const Stock& stock);
  void place_vertices(std::size_t index, const Stock& stock);
  [[nodiscard]] bool outside(int k, std::size_t axis) const { return k < 0 || k > lattice_.cells()[axis]; }
  [[nodiscard]] Occupancy around(const Region& region, const Stock& stock) const;
  [[nodiscard]] bool quiet(std::size_t index, const Stock& stock) const;
  [[nodiscard]] SurfacePiece::Word at_x_faces(const Region& region, std::size_t word) const;
  [[nodiscard]] std::uint32_t vertex(std::size_t index, Index3 from, std::size_t axis) const;
  void add_polygons(std::size_t index, const Index3& p, const CubeCase& cube);

  StockLattice lattice_;
  Index3 along_;  ///< number of pieces along each axis
  std::vector<SurfacePiece> pieces_;
};

}  // namespace fieldfab::cam
