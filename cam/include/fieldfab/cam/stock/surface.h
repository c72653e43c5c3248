/// The surface of a stock, kept up to date while it is cut.
#pragma once

#include <memory>
#include <vector>

#include "fieldfab/cam/stock/drawn_surface.h"
#include "fieldfab/cam/stock/stock.h"

namespace fieldfab::cam {

class SurfacePieces;

/// The surface of a stock brick by brick: a piece is made anew only where the stock has changed since the last update (Hahn 4.3).
class StockSurface {
 public:
  StockSurface();
  StockSurface(StockSurface&&) noexcept;
  StockSurface& operator=(StockSurface&&) noexcept;
  ~StockSurface();

  /// Brings it up to date with a stock; with one of another lattice it begins anew. Returns the indices of the pieces that have
  /// changed. Throws cancelled; the next update then begins anew.
  std::vector<std::size_t> update(const Stock& stock, Progress& progress = Progress::none());

  [[nodiscard]] std::size_t pieces() const;
  /// One piece for drawing, with all of its vertices: all pieces together show the surface without gaps, but share no vertices.
  /// `cuts`, where asked for, gets the cut that made each vertex.
  [[nodiscard]] TriangleMesh piece(std::size_t index, std::vector<std::uint32_t>* cuts = nullptr) const;
  /// One piece as it is drawn, simplified; `coarse`: 1, or the edge of the blocks of cells that become one.
  [[nodiscard]] DrawnSurface drawn_piece(std::size_t index, int coarse = 1) const;
  /// All of it as one closed mesh, outwards, its level flats merged as those of Stock::mesh() are.
  [[nodiscard]] TriangleMesh mesh(std::vector<std::uint32_t>* cuts = nullptr) const;

 private:
  std::unique_ptr<SurfacePieces> pieces_;
};

}  // namespace fieldfab::cam
