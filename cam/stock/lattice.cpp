#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fieldfab/cam/stock/lattice.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {

StockLattice::StockLattice(const Box& box, double cell, double height) : box_(box) {
  if (!box.valid() || box.size().minCoeff() <= 0) throw Error(ErrorKind::bad_input, "stock", "its box is empty");
  if (!(cell > 0) || !std::isfinite(cell))
    throw Error(ErrorKind::bad_input, "stock", fmt::format("a cell of {} mm", cell));
  for (int axis = 0; axis < 3; ++axis) {
    const double count = std::round(box.size()[axis] / (axis == 2 ? std::max(cell, height) : cell));
    if (count > 2097152) throw Error(ErrorKind::too_large, "stock", fmt::format("{:.0f} cells along an axis", count));
    cells_[static_cast<std::size_t>(axis)] = std::max(1, static_cast<int>(count));
    spacing_[axis] = box.size()[axis] / cells_[static_cast<std::size_t>(axis)];
    inverse_[axis] = 1 / spacing_[axis];
  }
}

}  // namespace fieldfab::cam
