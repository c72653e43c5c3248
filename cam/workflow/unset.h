/// What a number is where nobody says: it then follows from other things.
#pragma once

#include "fieldfab/cam/setting.h"

namespace fieldfab::cam {

constexpr double unset = -987654321.0;
inline bool is_set(const Values& values, const std::string& name) { return values.number(name) != unset; }

}  // namespace fieldfab::cam
