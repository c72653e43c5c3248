#include "fieldfab/cam/stock/surface.h"

#include <map>

#include "closed_mesh.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "surface_pieces.h"

namespace fieldfab::cam {

StockSurface::StockSurface() = default;
StockSurface::StockSurface(StockSurface&&) noexcept = default;
StockSurface& StockSurface::operator=(StockSurface&&) noexcept = default;
StockSurface::~StockSurface() = default;

std::size_t StockSurface::pieces() const { return pieces_ ? pieces_->size() : 0; }

std::vector<std::size_t> StockSurface::update(const Stock& stock, Progress& progress) {
  if (!pieces_ || !pieces_->fits(stock)) pieces_ = std::make_unique<SurfacePieces>(stock);
  SurfacePieces& pieces = *pieces_;
  const auto each = [&](const std::vector<std::size_t>& list, const auto& body) {
    parallel_for(list.size(), [&](std::size_t k) {
      progress.check();
      body(list[k]);
    });
  };
  try {
    // A piece's edges depend on its brick and the bricks after it. Its triangles depend on the
    // edges of pieces after it as well.
    const std::vector<std::size_t> changed = pieces.outdated(stock);
    std::vector<char> anew(pieces.size());
    for (const std::size_t i : changed) anew[i] = 1;
    std::vector<std::size_t> touched = pieces.with_those_before(anew);
    each(changed, [&](std::size_t i) { pieces.make_vertices(i, stock); });
    each(touched, [&](std::size_t i) { pieces.march(i, stock); });
    return touched;
  } catch (...) {
    pieces_.reset();
    throw;
  }
}

TriangleMesh StockSurface::piece(std::size_t index, std::vector<std::uint32_t>* cuts) const {
  if (index >= pieces()) throw Error(ErrorKind::bad_input, "surface", "it has no such piece");
  const SurfacePiece& piece = (*pieces_)[index];
  TriangleMesh mesh;
  if (cuts) cuts->clear();
  const auto add = [&](const SurfacePiece& whose, std::uint32_t v) {
    mesh.vertices.push_back(whose.place(v));
    if (cuts) cuts->push_back(whose.cut(v));
  };
  for (std::uint32_t v = 0; v < piece.size(); ++v) add(piece, v);
  std::map<std::uint32_t, std::uint32_t> others;  // vertices of neighbouring pieces
  for (std::array<std::uint32_t, 3> t : piece.corners) {
    for (std::uint32_t& v : t) {
      const std::size_t owner = pieces_->owner(index, v);
      if (owner == index) continue;
      const auto [found, fresh] = others.try_emplace(v, static_cast<std::uint32_t>(mesh.vertices.size()));
      if (fresh) add((*pieces_)[owner], v & SurfacePiece::own_part);
      v = found->second;
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

DrawnSurface StockSurface::drawn_piece(std::size_t index, int coarse) const {
  std::vector<std::uint32_t> cuts;
  const TriangleMesh mesh = piece(index, &cuts);
  const Region& own = (*pieces_)[index].region;
  const StockLattice& lattice = pieces_->lattice();
  Box region;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    // At the end of the stock there is no next piece.
    region.lower[i] = own.lower[a] < 0 ? -1e9 : own.lower[a];
    region.upper[i] = own.upper[a] >= lattice.cells()[a] ? 1e9 : own.upper[a] + 1;
  }
  return simplified(drawn(mesh, std::move(cuts)), lattice, region, coarse);
}

TriangleMesh StockSurface::mesh(std::vector<std::uint32_t>* cuts) const {
  ClosedMesh closed = pieces_ ? closed_mesh(*pieces_) : ClosedMesh{};
  if (cuts) *cuts = std::move(closed.cuts);
  return std::move(closed.mesh);
}

}  // namespace fieldfab::cam
