/// Working memory of evaluations.
#pragma once

#include <cstddef>
#include <vector>

namespace fieldfab::frep {

/// Returns memory kept per thread for its batches. Frees large memory that a deep expression needed
/// before.
template <class T>
T* scratch(std::size_t count) {
  static thread_local std::vector<T> kept;
  std::vector<T>& memory = kept;
  constexpr std::size_t keep = (std::size_t{1} << 24) / sizeof(T);
  if (memory.size() < count || (memory.size() > keep && count < keep)) {
    memory = {};
    memory.resize(count);
  }
  return memory.data();
}

}  // namespace fieldfab::frep
