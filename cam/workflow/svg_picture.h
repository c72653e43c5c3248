/// A program's picture as SVG text, for the set-up sheet.
#pragma once

#include <string>

#include "fieldfab/cam/picture.h"

namespace fieldfab::cam {

std::string svg_picture(const Program& program, const PictureSettings& settings);

}  // namespace fieldfab::cam
