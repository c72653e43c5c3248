// Uncompressed samples in a file: .raw, .vol with its .vgi.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <regex>
#include <sstream>

#include "fieldfab/core/file.h"
#include "fieldfab/core/lower_case.h"
#include "readers.h"

namespace fieldfab {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n"), last = text.find_last_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

template <class Sample>
void convert(const std::byte* from, std::size_t count, bool swap, float* out) {
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::byte, sizeof(Sample)> bytes;
    std::memcpy(bytes.data(), from + i * sizeof(Sample), sizeof(Sample));
    if (swap) std::reverse(bytes.begin(), bytes.end());
    out[i] = static_cast<float>(std::bit_cast<Sample>(bytes));
  }
}

/// Reads by pread(), without mapping: pages read of a mapped file count as memory of this process.
class RawVolume final : public Volume {
 public:
  RawVolume(const Path& path, const RawLayout& layout)
      : Volume(layout.lattice, layout.type), path_(path), swap_(layout.big_endian), skip_(layout.skip) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail();
  }
  ~RawVolume() override { ::close(descriptor_); }
  RawVolume(const RawVolume&) = delete;
  RawVolume& operator=(const RawVolume&) = delete;

  void read(int first, int count, float* out) const override {
    constexpr std::size_t most = std::size_t{1} << 18;
    std::vector<std::byte> bytes(most);
    const std::size_t sample = size_of(type_), slice = lattice_.slice() * sample;
    std::uint64_t at = skip_ + static_cast<std::size_t>(first) * slice;
    for (std::size_t left = static_cast<std::size_t>(count) * slice; left > 0;) {
      const std::size_t part = std::min(left, most);
      fill(bytes.data(), part, at);
      to_floats(type_, bytes.data(), part / sample, swap_, out);
      out += part / sample, at += part, left -= part;
    }
  }

 private:
  [[noreturn]] void fail() const {
    throw Error(ErrorKind::io, path_.string(), fmt::format("cannot read: {}", std::strerror(errno)));
  }
  void fill(std::byte* to, std::size_t size, std::uint64_t at) const {
    while (size > 0) {
      const ssize_t got = ::pread(descriptor_, to, size, static_cast<off_t>(at));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) fail();
      if (got == 0) refuse(path_, "has become shorter while it was read");
      to += got, at += static_cast<std::uint64_t>(got), size -= static_cast<std::size_t>(got);
    }
  }

  Path path_;
  int descriptor_;
  bool swap_;
  std::uint64_t skip_;
};

/// Properties in a name such as bonsai_256x256x256_uint8.raw.
struct NameHints {
  std::optional<std::array<int, 3>> size;
  std::optional<SampleType> type;
  std::optional<bool> big_endian;
};

NameHints hints_in(const Path& path) {
  NameHints hints;
  const std::string name = lower_case(path.stem().string());
  static const std::regex sizes("(^|[^0-9])([0-9]{1,6})[x_]([0-9]{1,6})[x_]([0-9]{1,6})([^0-9]|$)");
  if (std::smatch found; std::regex_search(name, found, sizes))
    hints.size = {std::stoi(found[2]), std::stoi(found[3]), std::stoi(found[4])};
  std::string word;
  for (const char c : name + "_") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      word += c;
      continue;
    }
    if (const auto type = sample_type(word)) hints.type = type;
    if (word == "be" || word == "bigendian" || word == "big") hints.big_endian = true;
    if (word == "le" || word == "littleendian" || word == "little") hints.big_endian = false;
    word.clear();
  }
  return hints;
}

/// Returns the only type that gives a file of that many bytes.
std::optional<SampleType> type_by_size(std::uint64_t bytes, std::size_t samples) {
  for (const auto type : {SampleType::uint8, SampleType::uint16, SampleType::float32, SampleType::float64})
    if (bytes == samples * size_of(type)) return type;
  return std::nullopt;
}

SampleType type_of_vgi(const std::map<std::string, std::string>& settings, const Path& path) {
  const auto find = [&](const char* key) {
    const auto at = settings.find(key);
    return at == settings.end() ? std::string() : lower_case(at->second);
  };
  const std::string kind = find("datatype"), bits = find("bitsperelement");
  if (kind.starts_with("float")) return bits == "64" ? SampleType::float64 : SampleType::float32;
  if (kind == "double") return SampleType::float64;
  const bool has_sign = kind.starts_with("signed") || kind.starts_with("int");
  if (bits == "8") return has_sign ? SampleType::int8 : SampleType::uint8;
  if (bits == "16") return has_sign ? SampleType::int16 : SampleType::uint16;
  if (bits == "32") return has_sign ? SampleType::int32 : SampleType::uint32;
  refuse(path, fmt::format("unknown type of sample: datatype '{:.40}' with '{:.10}' bits", kind, bits));
}

}  // namespace

void to_floats(SampleType type, const std::byte* from, std::size_t count, bool swap, float* out) {
  switch (type) {
    case SampleType::uint8: return convert<std::uint8_t>(from, count, swap, out);
    case SampleType::int8: return convert<std::int8_t>(from, count, swap, out);
    case SampleType::uint16: return convert<std::uint16_t>(from, count, swap, out);
    case SampleType::int16: return convert<std::int16_t>(from, count, swap, out);
    case SampleType::uint32: return convert<std::uint32_t>(from, count, swap, out);
    case SampleType::int32: return convert<std::int32_t>(from, count, swap, out);
    case SampleType::float32: return convert<float>(from, count, swap, out);
    case SampleType::float64: return convert<double>(from, count, swap, out);
  }
}

std::size_t sample_count(const std::array<long long, 3>& size, const Path& path) {
  double product = 1;
  for (const long long n : size) {
    if (n < 2)
      refuse(path, fmt::format("{} x {} x {} samples; a solid needs two along each axis", size[0], size[1], size[2]));
    product *= static_cast<double>(n);
  }
  for (const long long n : size)
    if (n > (1 << 24) || product > 1e13)
      refuse(path, fmt::format("{} x {} x {} samples are more than there can be", size[0], size[1], size[2]));
  return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
}

std::map<std::string, std::string> read_settings(const Path& path) {
  std::map<std::string, std::string> settings;
  std::istringstream text(read_file(path, 1 << 20));
  for (std::string line; std::getline(text, line);) {
    const auto equals = line.find('=');
    if (equals == std::string::npos) continue;
    settings.try_emplace(lower_case(trimmed(line.substr(0, equals))), trimmed(line.substr(equals + 1)));
  }
  return settings;
}

std::optional<std::array<double, 3>> three_numbers(std::string_view text) {
  std::array<double, 3> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (double& number : numbers) {
    while (at < end && (*at == ' ' || *at == ',' || *at == '\t' || (*at == 'x' && &number != numbers.data()))) ++at;
    const auto [next, failure] = std::from_chars(at, end, number);
    if (failure != std::errc{}) return std::nullopt;
    at = next;
  }
  return at == end ? std::optional(numbers) : std::nullopt;
}

VolumePtr open_samples(const Path& path, const RawLayout& layout) {
  const auto& n = layout.lattice.size;
  const std::size_t expected = sample_count({n[0], n[1], n[2]}, path) * size_of(layout.type);
  require_regular_file(path);
  const std::uint64_t there = std::filesystem::file_size(path);
  if (layout.skip > there || there - layout.skip != expected)
    refuse(path, fmt::format("holds {} bytes; {} x {} x {} samples of {} after a header of {} bytes are {}", there,
                             n[0], n[1], n[2], name(layout.type), layout.skip, layout.skip + expected));
  return std::make_shared<RawVolume>(path, layout);
}

VolumePtr open_vgi(const Path& path, const VolumeFileOptions& options) {
  const auto settings = read_settings(path);
  const auto number_list = [&](const char* key) -> std::optional<std::array<double, 3>> {
    const auto at = settings.find(key);
    return at == settings.end() ? std::nullopt : three_numbers(at->second);
  };
  RawLayout layout;
  if (options.size) {
    layout.lattice.size = *options.size;
  } else {
    const auto size = number_list("size");
    if (!size) refuse(path, "does not tell the volume's size: no line such as 'size = 255 255 511'");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!((*size)[axis] >= 2 && (*size)[axis] <= 1 << 24)) refuse(path, "tells an impossible size");
      layout.lattice.size[axis] = static_cast<int>((*size)[axis]);
    }
  }
  auto spacing = number_list("resolution");
  if (!spacing) spacing = number_list("samplingdistance");
  if (spacing) {
    const auto unit = settings.find("unit");
    const double mm = unit == settings.end() || unit->second == "mm" ? 1
                      : unit->second == "m"                          ? 1000
                      : unit->second == "um"                         ? 1e-3
                                                                     : 1;
    layout.lattice.spacing = mm * Vec3((*spacing)[0], (*spacing)[1], (*spacing)[2]);
    if (!layout.lattice.spacing.allFinite() || layout.lattice.spacing.minCoeff() <= 0)
      refuse(path, "tells an impossible resolution");
  }
  layout.type = options.type ? *options.type : type_of_vgi(settings, path);
  layout.big_endian = options.big_endian.value_or(false);
  if (const auto skip = settings.find("skipheader"); skip != settings.end())
    std::from_chars(skip->second.data(), skip->second.data() + skip->second.size(), layout.skip);
  layout.skip = options.skip.value_or(layout.skip);
  const auto data_name = settings.find("name");
  Path data = path;
  data.replace_extension(".vol");
  // Only in the folder of the header: a file must not choose which other files are read.
  if (data_name != settings.end()) {
    const Path named = path.parent_path() / Path(data_name->second).filename();
    if (std::filesystem::exists(named) && !std::filesystem::is_directory(named)) data = named;
  }
  return open_samples(data, layout);
}

VolumePtr open_raw(const Path& path, const VolumeFileOptions& options) {
  Path header = path;
  header.replace_extension(".vgi");
  if (std::filesystem::exists(header)) return open_vgi(header, options);
  if (header = path.string() + ".vgi"; std::filesystem::exists(header)) return open_vgi(header, options);

  const NameHints hints = hints_in(path);
  const auto size = options.size ? options.size : hints.size;
  if (!size) refuse(path, "does not tell its size: give --dims X,Y,Z, or a name such as scan_256x256x128_uint16.raw");
  RawLayout layout;
  layout.lattice.size = *size;
  const std::size_t samples = sample_count({(*size)[0], (*size)[1], (*size)[2]}, path);
  layout.skip = options.skip.value_or(0);
  auto type = options.type ? options.type : hints.type;
  if (const std::uint64_t bytes = std::filesystem::file_size(path); !type && bytes >= layout.skip)
    type = type_by_size(bytes - layout.skip, samples);
  if (!type)
    refuse(path,
           fmt::format(
               "{} bytes are no whole number of bytes for each of {} x {} x {} samples; give --dims, --type and --skip",
               std::filesystem::file_size(path), (*size)[0], (*size)[1], (*size)[2]));
  layout.type = *type;
  layout.big_endian = options.big_endian.value_or(hints.big_endian.value_or(false));
  return open_samples(path, layout);
}

}  // namespace fieldfab
