/// Memory to evaluate in.
#pragma once

#include <cstddef>
#include <vector>

namespace fieldfab::frep {

/// Memory that each thread keeps for its batches; a deep expression may have taken much, which is given back here.
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
