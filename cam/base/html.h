/// Common parts of the HTML pages for the machine's operator.
#pragma once

#include <string>

#include "fieldfab/render/image.h"

namespace fieldfab::cam {

/// Converts text from files to text of a page: escapes markup, and replaces invalid UTF-8 and
/// control characters.
std::string html_text(const std::string& bytes);
/// "1:02:03 h" or "2:03 min".
std::string html_time(double seconds);
/// Start of a page including its heading; `title` is text, not markup.
std::string html_start(const std::string& title);
/// An <img> element with embedded pixels; `description` is text, not markup.
std::string html_image(const Image& image, const std::string& description);

}  // namespace fieldfab::cam
