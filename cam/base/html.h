/// What the HTML pages for the person at the machine have in common.
#pragma once

#include <string>

#include "fieldfab/render/image.h"

namespace fieldfab::cam {

/// Text from files as text of a page: markup is escaped, bytes that are no UTF-8 and control characters are replaced.
std::string html_text(const std::string& bytes);
/// "1:02:03 h" or "2:03 min".
std::string html_time(double seconds);
/// A page's beginning up to its heading; `title` is text, not markup.
std::string html_start(const std::string& title);
/// An <img> with its pixels in it; `description` is text, not markup.
std::string html_image(const Image& image, const std::string& description);

}  // namespace fieldfab::cam
