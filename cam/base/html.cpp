#include "html.h"

#include <fmt/format.h>

#include "fieldfab/core/text.h"

namespace fieldfab::cam {
namespace {

constexpr const char* style = R"(<style>
body { font: 15px/1.45 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; color: #222 }
h1 { font-size: 1.5em } h2 { font-size: 1.15em; margin-top: 1.6em }
table { border-collapse: collapse; width: 100% }
td, th { border-bottom: 1px solid #ccc; padding: .3em .6em; text-align: left } th { background: #f3f3f3 }
td.n { text-align: right }
.pictures svg, .pictures img { width: 48%; border: 1px solid #ccc; max-height: 28em }
.note { background: #fff3cd; padding: .5em .8em; margin: .4em 0 }
@media print { body { margin: 0 } }
</style>
)";

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return k < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) : 0U;
    };
    const std::uint32_t three = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63U] : '=';
  }
  return out;
}

}  // namespace

std::string html_text(const std::string& bytes) {
  std::string out;
  for (const char c : printable(bytes)) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default: out += c;
    }
  }
  return out;
}

std::string html_time(double seconds) {
  const int whole = static_cast<int>(seconds + 0.5);
  return whole >= 3600 ? fmt::format("{}:{:02d}:{:02d} h", whole / 3600, whole / 60 % 60, whole % 60)
                       : fmt::format("{}:{:02d} min", whole / 60, whole % 60);
}

std::string html_start(const std::string& title) {
  return fmt::format("<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>{0}</title>\n{1}<h1>{0}</h1>\n",
                     html_text(title), style);
}

std::string html_image(const Image& image, const std::string& description) {
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">\n", html_text(description),
                     base64(png_bytes(image)));
}

}  // namespace fieldfab::cam
