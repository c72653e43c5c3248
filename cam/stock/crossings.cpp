// Crossings of a stock's surface with the edges of its lattice.
#include "fieldfab/core/parallel.h"
#include "surface_pieces.h"

namespace fieldfab::cam {

void SurfacePieces::add_crossings(std::size_t index, const Stock& stock, std::vector<StockCrossing>& list) const {
  using Word = Occupancy::Word;
  const Brick& brick = *stock.bricks_[index];
  if (brick.empty() || quiet(index, stock)) return;
  const Region& region = brick.region();
  const Occupancy shape = around(region, stock);
  const auto place_of = [&](const Index3& p) {
    return Vec3(lattice_.at(0, p[0]), lattice_.at(1, p[1]), lattice_.at(2, p[2]));
  };
  const auto add = [&](const Index3& p, int axis, bool upwards) {
    const auto a = static_cast<std::size_t>(axis);
    StockCrossing crossing{place_of(p), place_of(p), axis, upwards, 0};
    if (!outside(p[a] + (upwards ? 1 : -1), a)) {
      const Sample sample = brick.sample(p, axis, upwards, lattice_);
      crossing.place[axis] = sample.at;
      crossing.cut = sample.cut;
    }
    crossing.solid += lattice_.box().lower, crossing.place += lattice_.box().lower;
    list.push_back(crossing);
  };
  // The shape has one more point on each side than the brick.
  const auto bits = [&](int y, int z, std::size_t word, int shift) {
    const Word* const row = shape.row(y, z);
    const std::size_t at = word * 64 + static_cast<std::size_t>(1 + shift);
    Word value = at / 64 < shape.words() ? row[at / 64] >> (at % 64) : 0;
    if (at % 64 && at / 64 + 1 < shape.words()) value |= row[at / 64 + 1] << (64 - at % 64);
    return value;
  };
  const int words = (region.count(0) + 63) / 64;
  for (int z = region.lower[2]; z <= region.upper[2]; ++z)
    for (int y = region.lower[1]; y <= region.upper[1]; ++y)
      for (int w = 0; w < words; ++w) {
        const auto word = static_cast<std::size_t>(w);
        const int left = region.count(0) - 64 * w;
        const Word solid = bits(y, z, word, 0) & (left >= 64 ? ~Word{0} : (Word{1} << left) - 1);
        if (!solid) continue;
        for (int axis = 0; axis < 3; ++axis)
          for (const int step : {-1, 1}) {
            const Word beside =
                bits(y + (axis == 1 ? step : 0), z + (axis == 2 ? step : 0), word, axis == 0 ? step : 0);
            for (Word open = solid & ~beside; open; open &= open - 1)
              add({region.lower[0] + 64 * w + std::countr_zero(open), y, z}, axis, step > 0);
          }
      }
}

std::vector<std::vector<StockCrossing>> Stock::crossings(Progress& progress) const {
  const SurfacePieces pieces(*this);
  std::vector<std::vector<StockCrossing>> found(bricks_.size());
  parallel_for(bricks_.size(), [&](std::size_t i) {
    progress.check();
    pieces.add_crossings(i, *this, found[i]);
  });
  return found;
}

}  // namespace fieldfab::cam
