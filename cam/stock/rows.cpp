#include "rows.h"

#include <algorithm>
#include <cmath>

#include "fieldfab/core/clones.h"

namespace fieldfab::cam {

FIELDFAB_CLONES bool flag_contacts(const float* entry, const float* exit, const float* tops, int count,
                                   std::uint8_t* flags) {
  unsigned any = 0;
  if (tops == nullptr) {
    for (int i = 0; i < count; ++i) {
      const std::uint8_t flag = entry[i] <= exit[i];
      flags[i] = flag, any |= flag;
    }
    return any;
  }
  for (int i = 0; i < count; ++i) {
    const std::uint8_t flag = static_cast<std::uint8_t>((entry[i] <= exit[i]) & (entry[i] < tops[i]));
    flags[i] = flag, any |= flag;
  }
  return any;
}

FIELDFAB_CLONES bool flag_neighbours(const float* entry, const float* exit, const float* before, const float* here,
                                     const float* after, int count, float inverse, std::uint8_t* flags) {
  unsigned any = 0;
  for (int i = 0; i < count; ++i) {
    const float most = std::max(std::max(before[i], after[i]), std::max(here[i - 1], here[i + 1]));
    // The first point at or above the entry, or the one before it if rounding could matter.
    const float first = std::ceil(entry[i] * inverse - 0.01f);
    const std::uint8_t flag = static_cast<std::uint8_t>((first <= most) & (entry[i] <= exit[i]));
    flags[i] = flag, any |= flag;
  }
  return any;
}

FIELDFAB_CLONES void load_tops(const float* tops, int count, double spacing, float last, float* points) {
  if (tops == nullptr) {
    std::fill(points, points + count, last);
    return;
  }
  const auto inverse = static_cast<float>(1 / spacing);
  for (int i = 0; i < count; ++i) {
    const float near = std::min(std::floor(tops[i] * inverse + 0.01f), last);
    // A column whose top coincides with a point excludes that point.
    points[i] = static_cast<float>(static_cast<double>(near) * spacing) >= tops[i] ? near - 1 : near;
  }
}

}  // namespace fieldfab::cam
