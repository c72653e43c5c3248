#include <fmt/format.h>
#include <png.h>

#include <cmath>
#include <cstdlib>
#include <cstring>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/render/image.h"

namespace fieldfab {
namespace {

// libpng reports errors by longjmp unless its handlers throw. Ours throw through its C frames,
// which Debian builds with unwind tables.
[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  const auto* path = static_cast<const std::filesystem::path*>(png_get_error_ptr(png));
  throw Error(ErrorKind::bad_input, path->string(), fmt::format("PNG: {}", message));
}
void on_warning(png_structp, png_const_charp) {}

struct Source {
  const std::string& bytes;
  std::size_t at = 0;
};

/// libpng's two structures, freed on every exit path.
struct Reader {
  png_structp png;
  png_infop info = nullptr;
  explicit Reader(const std::filesystem::path& path)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, const_cast<std::filesystem::path*>(&path), on_error,
                                   on_warning)) {
    info = png_create_info_struct(png);
  }
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
};
struct Writer {
  png_structp png;
  png_infop info = nullptr;
  explicit Writer(const std::filesystem::path& path)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, const_cast<std::filesystem::path*>(&path), on_error,
                                    on_warning)) {
    info = png_create_info_struct(png);
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
};

}  // namespace

std::string png_bytes(const Image& image, const std::string& name) {
  if (image.width <= 0 || image.height <= 0) throw Error(ErrorKind::bad_input, name, "an image must have pixels");
  std::string bytes;
  Writer writer(name);
  png_set_write_fn(
      writer.png, &bytes,
      [](png_structp png, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
      },
      [](png_structp) {});
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
               image.depth, image.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  constexpr int quick = 4;  // about as small as by default, in less than half the time
  png_set_compression_level(writer.png, quick);
  if (image.pixels_per_mm > 0) {
    const auto per_metre = static_cast<png_uint_32>(std::lround(std::min(image.pixels_per_mm * 1000, 2e9)));
    png_set_pHYs(writer.png, writer.info, per_metre, per_metre, PNG_RESOLUTION_METER);
  }
  std::string low = fmt::format("{}", image.bounds.lower.z()), high = fmt::format("{}", image.bounds.upper.z());
  std::string low_key = "zmin", high_key = "zmax";
  png_text texts[2] = {};
  texts[0].compression = texts[1].compression = PNG_TEXT_COMPRESSION_NONE;
  texts[0].key = low_key.data(), texts[0].text = low.data();
  texts[1].key = high_key.data(), texts[1].text = high.data();
  if (image.has_heights) png_set_text(writer.png, writer.info, texts, 2);
  png_write_info(writer.png, writer.info);

  const auto row_samples = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  std::vector<png_byte> row(image.depth == 16 ? 2 * row_samples : 0);
  for (int y = 0; y < image.height; ++y) {
    const std::size_t first = static_cast<std::size_t>(y) * row_samples;
    for (std::size_t i = 0; image.depth == 16 && i < row_samples; ++i) {  // the high byte first
      row[2 * i] = static_cast<png_byte>(image.pixels16[first + i] >> 8);
      row[2 * i + 1] = static_cast<png_byte>(image.pixels16[first + i] & 255);
    }
    png_write_row(writer.png, image.depth == 16 ? row.data() : image.pixels8.data() + first);
  }
  png_write_end(writer.png, writer.info);
  return bytes;
}

void write_png(const Image& image, const std::filesystem::path& path) {
  write_file(path, png_bytes(image, path.string()));
}

namespace {

/// Refuses chunks that are longer than the rest of the file: libpng would allocate up to 2 GiB for a damaged length.
void require_whole_chunks(const std::string& bytes, const std::filesystem::path& path) {
  constexpr std::size_t signature = 8, around = 12;  // bytes; a chunk's length, name and checksum
  for (std::size_t at = signature; at < bytes.size();) {
    const std::size_t left = bytes.size() - at;
    const png_uint_32 length = left < around ? 0 : png_get_uint_32(reinterpret_cast<png_const_bytep>(&bytes[at]));
    if (left < around || length > left - around)
      throw Error(ErrorKind::bad_input, path.string(), "is a damaged PNG: it ends within a chunk");
    if (bytes.compare(at + 4, 4, "IEND") == 0) return;
    at += around + length;
  }
}

}  // namespace

Image read_png(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  if (bytes.size() < 8 || png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) != 0)
    throw Error(ErrorKind::bad_input, path.string(), "is not a PNG");
  require_whole_chunks(bytes, path);
  Source source{bytes};
  Reader reader(path);
  png_set_read_fn(reader.png, &source, [](png_structp png, png_bytep data, std::size_t size) {
    auto* from = static_cast<Source*>(png_get_io_ptr(png));
    if (size > from->bytes.size() - from->at) png_error(png, "the file ends too early");
    std::memcpy(data, from->bytes.data() + from->at, size);
    from->at += size;
  });
  png_set_user_limits(reader.png, 1 << 17, 1 << 17);
  png_read_info(reader.png, reader.info);

  Image image;
  image.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
  image.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
  png_set_palette_to_rgb(reader.png);
  if (png_get_bit_depth(reader.png, reader.info) < 8) png_set_expand_gray_1_2_4_to_8(reader.png);
  png_set_strip_alpha(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  image.depth = png_get_bit_depth(reader.png, reader.info);
  image.channels = png_get_channels(reader.png, reader.info) >= 3 ? 3 : 1;

  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  require_memory(row_bytes * static_cast<std::uintmax_t>(image.height) * 3, path.string());
  std::vector<png_byte> data(row_bytes * static_cast<std::size_t>(image.height));
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) rows.push_back(data.data() + static_cast<std::size_t>(y) * row_bytes);
  png_read_image(reader.png, rows.data());
  png_read_end(reader.png, reader.info);

  const std::size_t samples = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                              static_cast<std::size_t>(image.channels);
  if (image.depth == 16) {
    image.pixels16.resize(samples);
    for (std::size_t i = 0; i < samples; ++i)
      image.pixels16[i] = static_cast<std::uint16_t>(data[2 * i] << 8 | data[2 * i + 1]);
  } else {
    data.resize(samples);
    image.pixels8 = std::move(data);
  }

  if (png_uint_32 x = 0, y = 0; true) {
    int unit = 0;
    if (png_get_pHYs(reader.png, reader.info, &x, &y, &unit) != 0 && unit == PNG_RESOLUTION_METER)
      image.pixels_per_mm = x / 1000.0;
  }
  png_textp texts = nullptr;
  const int count = png_get_text(reader.png, reader.info, &texts, nullptr);
  int found = 0;
  for (int i = 0; i < count; ++i) {
    if (std::strcmp(texts[i].key, "zmin") == 0) image.bounds.lower.z() = std::atof(texts[i].text), ++found;
    if (std::strcmp(texts[i].key, "zmax") == 0) image.bounds.upper.z() = std::atof(texts[i].text), ++found;
  }
  image.has_heights = found == 2;
  if (image.pixels_per_mm > 0) {
    image.bounds.upper.x() = image.width / image.pixels_per_mm;
    image.bounds.upper.y() = image.height / image.pixels_per_mm;
  }
  return image;
}

}  // namespace fieldfab
