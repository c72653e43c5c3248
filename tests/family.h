/// How much of a large family of cases a test tries.
#pragma once

#include <cstdlib>

namespace fieldfab {

/// Chooses between a small sample, always the same, and the whole family, which `./dev test --full` tries: it sets
/// FIELDFAB_FULL.
template <class Number>
Number sample_or_all(Number sample, Number all) {
  return std::getenv("FIELDFAB_FULL") != nullptr ? all : sample;
}

}  // namespace fieldfab
