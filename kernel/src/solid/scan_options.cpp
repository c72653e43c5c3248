// Options of open() for reading volumes.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "fieldfab/core/error.h"
#include "fieldfab/solid/open.h"

namespace fieldfab {
namespace {

using frep::OpenOption;

const OpenOption* find(std::span<const OpenOption> options, std::string_view name) {
  for (const OpenOption& option : options)
    if (option.name == name) return &option;
  return nullptr;
}

[[noreturn]] void refuse(std::string_view name, const std::string& message) {
  throw Error(ErrorKind::bad_input, std::string(name), message);
}

/// Returns an option as text; a number in its written form.
std::string words(const OpenOption& option) {
  if (const double* number = std::get_if<double>(&option.value)) return fmt::format("{}", *number);
  return std::get<std::string>(option.value);
}

double number(const OpenOption& option) {
  if (const double* plain = std::get_if<double>(&option.value)) return *plain;
  const std::string& text = std::get<std::string>(option.value);
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    refuse(option.name, fmt::format("expected a number, found '{:.60}'", text));
  return value;
}

/// Parses `count` numbers separated by commas.
template <class Number, std::size_t count>
std::array<Number, count> numbers(const OpenOption& option) {
  const std::string text = words(option);
  std::array<Number, count> found{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [next, failure] = std::from_chars(at, end, found[i]);
    const bool separated = next < end && (*next == ',' || *next == 'x');
    if (failure != std::errc{} || (i + 1 < count ? !separated : next != end))
      refuse(option.name, fmt::format("expected {} numbers apart by commas, found '{:.60}'", count, text));
    at = next + 1;
  }
  return found;
}

}  // namespace

double option_number(std::span<const OpenOption> options, std::string_view name, double otherwise) {
  const OpenOption* const option = find(options, name);
  return option == nullptr ? otherwise : number(*option);
}

ScanOptions scan_options(std::span<const OpenOption> options) {
  ScanOptions scan;
  const auto flag = [&](std::string_view name) { return option_number(options, name, 0) != 0; };
  if (const auto* option = find(options, "dims")) scan.file.size = numbers<int, 3>(*option);
  if (const auto* option = find(options, "type")) {
    scan.file.type = sample_type(words(*option));
    if (!scan.file.type) refuse("type", fmt::format("'{:.40}' is no type of sample", words(*option)));
  }
  if (const auto* option = find(options, "byte_order")) {
    const std::string order = words(*option);
    if (order != "big" && order != "little")
      refuse("byte_order", fmt::format("expected little or big, found '{:.40}'", order));
    scan.file.big_endian = order == "big";
  }
  if (const auto* option = find(options, "skip")) {
    const double bytes = number(*option);
    if (!(bytes >= 0) || bytes > 1e15 || bytes != std::floor(bytes)) refuse("skip", "expected a whole number of bytes");
    scan.file.skip = static_cast<std::uint64_t>(bytes);
  }
  if (const auto* option = find(options, "spacing")) {
    const auto mm = numbers<double, 3>(*option);
    scan.file.spacing = Vec3(mm[0], mm[1], mm[2]);
  }
  if (const auto* option = find(options, "series")) scan.file.series = words(*option);
  if (const auto* option = find(options, "crop")) scan.crop = numbers<int, 6>(*option);
  if (const auto* option = find(options, "denoise")) scan.clean.denoise = Denoising::parse(words(*option));
  scan.clean.keep_largest = flag("keep_largest");
  if (const auto* option = find(options, "min_island")) scan.clean.least_island = number(*option);
  if (const auto* option = find(options, "min_hole")) scan.clean.least_hole = number(*option);
  if (flag("fill_holes")) scan.clean.least_hole = std::numeric_limits<double>::infinity();
  if (const auto* option = find(options, "threshold")) {
    const double* const plain = std::get_if<double>(&option->value);
    scan.threshold =
        plain != nullptr ? ThresholdRule{ThresholdRule::Kind::value, *plain} : ThresholdRule::parse(words(*option));
  }
  scan.below = flag("below");
  return scan;
}

}  // namespace fieldfab
