#include "rows.h"

namespace fieldfab::cam {

__attribute__((target_clones("avx2", "default"))) bool flag_contacts(const float* entry, const float* exit, const float* tops,
                                                                     int count, std::uint8_t* flags) {
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

__attribute__((target_clones("avx2", "default"))) bool flag_neighbours(const float* entry, const float* exit, const float* before,
                                                                       const float* here, const float* after, int count,
                                                                       std::uint8_t* flags) {
  unsigned any = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint8_t below = static_cast<std::uint8_t>((entry[i] < before[i]) | (entry[i] < after[i]) |
                                                         (entry[i] < here[i - 1]) | (entry[i] < here[i + 1]));
    const std::uint8_t flag = static_cast<std::uint8_t>(below & (entry[i] <= exit[i]));
    flags[i] = flag, any |= flag;
  }
  return any;
}

}  // namespace fieldfab::cam
