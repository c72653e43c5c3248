#include "contour_doubt.h"

#include <algorithm>
#include <map>

#include "fieldfab/core/together.h"

namespace fieldfab::contouring {
void DoubtMap::add(std::span<const UnclearCell> cells) {
  const int mask = ~((1 << lattice_.voxel_level()) - 1);
  for (const UnclearCell& cell : cells)
    cells_.push_back({{cell.lower[0] & mask, cell.lower[1] & mask, cell.lower[2] & mask},
                      lattice_.cube(cell.lower, cell.level),
                      lattice_.side(cell.level)});
}

void DoubtMap::write(Certainty& certainty) const {
  if (cells_.empty()) {
    certainty.doubt = Doubt::none;
    return;
  }
  std::map<LatticePoint, std::uint32_t> by_voxel;
  Together together(cells_.size());
  for (std::uint32_t i = 0; i < cells_.size(); ++i) {
    const auto [found, fresh] = by_voxel.emplace(cells_[i].voxel, i);
    if (!fresh) together.join(found->second, i);
  }
  const int step = 1 << lattice_.voxel_level();
  for (const auto& [voxel, i] : by_voxel)
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
          if (const auto found = by_voxel.find(moved(voxel, x * step, y * step, z * step)); found != by_voxel.end())
            together.join(found->second, i);

  std::map<std::uint32_t, UncertainPlace> places;
  for (std::uint32_t i = 0; i < cells_.size(); ++i) {
    const auto [found, fresh] = places.emplace(together.of(i), UncertainPlace{cells_[i].box, cells_[i].side});
    UncertainPlace& place = found->second;
    place.box = {place.box.lower.cwiseMin(cells_[i].box.lower), place.box.upper.cwiseMax(cells_[i].box.upper)};
    place.thickness = std::max(place.thickness, cells_[i].side);
  }
  certainty.count = places.size();
  for (const auto& [root, place] : places) certainty.places.push_back(place);
  const auto longest = [](const UncertainPlace& place) { return place.box.size().maxCoeff(); };
  std::stable_sort(certainty.places.begin(), certainty.places.end(),
                   [&](const UncertainPlace& a, const UncertainPlace& b) { return longest(a) > longest(b); });
  certainty.largest = longest(certainty.places.front());
  for (const UncertainPlace& place : certainty.places) certainty.thickness = std::max(certainty.thickness, place.thickness);
  if (certainty.places.size() > Certainty::most_places) certainty.places.resize(Certainty::most_places);
}

}  // namespace fieldfab::contouring
