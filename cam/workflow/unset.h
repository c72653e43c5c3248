/// What a number is where nobody says: it then follows from other things.
#pragma once

namespace fieldfab::cam {

constexpr double unset = -987654321.0;

}  // namespace fieldfab::cam
