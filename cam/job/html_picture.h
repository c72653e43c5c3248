/// A program's picture as an element of an HTML page: an <svg>, or if that would be large, an <img>
/// with embedded pixels.
#pragma once

#include <string>

#include "fieldfab/cam/job/picture.h"

namespace fieldfab::cam {

std::string html_picture(const Program& program, const PictureSettings& settings);

}  // namespace fieldfab::cam
