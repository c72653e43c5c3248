/// Incremental surface extraction of a stock.
#pragma once

#include <memory>
#include <vector>

#include "fieldfab/cam/stock/drawn_surface.h"
#include "fieldfab/cam/stock/stock.h"

namespace fieldfab::cam {

class SurfacePieces;

/// The surface of a stock by bricks. update() recomputes only pieces whose stock has changed since the last update
/// (Hahn 4.3).
class StockSurface {
 public:
  StockSurface();
  StockSurface(StockSurface&&) noexcept;
  StockSurface& operator=(StockSurface&&) noexcept;
  ~StockSurface();

  /// Updates the surface; starts anew for a stock with another lattice. Returns the indices of changed pieces. Throws
  /// Error(cancelled); the next update then starts anew.
  std::vector<std::size_t> update(const Stock& stock, Progress& progress = Progress::none());

  /// Number of pieces.
  [[nodiscard]] std::size_t pieces() const;
  /// Returns one piece with all its vertices. All pieces together cover the surface without gaps, but share no
  /// vertices. If `cuts` is not null, it receives the number of the cut that made each vertex.
  [[nodiscard]] TriangleMesh piece(std::size_t index, std::vector<std::uint32_t>* cuts = nullptr) const;
  /// Returns one simplified piece for display; `coarse` is 1, or the edge in cells of the blocks that are merged.
  [[nodiscard]] DrawnSurface drawn_piece(std::size_t index, int coarse = 1) const;
  /// Returns the whole surface as one closed mesh, oriented outward, with flat areas merged as in Stock::mesh().
  [[nodiscard]] TriangleMesh mesh(std::vector<std::uint32_t>* cuts = nullptr) const;

 private:
  std::unique_ptr<SurfacePieces> pieces_;
};

}  // namespace fieldfab::cam
