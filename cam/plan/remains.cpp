#include "remains.h"

#include <utility>
#include <vector>

namespace fieldfab::cam {

void mark_inside(const Loops& loops, Bitmap& cells) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(cells.height));
  for (const Loop& loop : loops)
    for (std::size_t i = 0, n = loop.points.size(); i < n; ++i) {
      Vec2 a = loop.points[i], b = loop.points[(i + 1) % n];
      if (a.y() > b.y()) std::swap(a, b);
      const auto row_above = [&](double y) { return static_cast<int>(std::ceil((y - cells.origin.y()) / cells.cell)); };
      for (int row = std::max(0, row_above(a.y())); row < std::min(cells.height, row_above(b.y())); ++row) {
        const double y = cells.origin.y() + row * cells.cell;
        crossings[static_cast<std::size_t>(row)].push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
      }
    }
  for (int row = 0; row < cells.height; ++row) {
    auto& at = crossings[static_cast<std::size_t>(row)];
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); i += 2)
      for (int c = static_cast<int>(std::ceil((at[i] - cells.origin.x()) / cells.cell));
           c < cells.width && cells.place(c, row).x() <= at[i + 1]; ++c)
        cells.at(c, row) = 1;
  }
}

}  // namespace fieldfab::cam
