// PNG files as slices, by libpng itself: in ITK an error of libpng ends the process.
#include <png.h>

#include <cstring>

#include "fieldfab/core/file.h"
#include "readers.h"

namespace fieldfab {
namespace {

[[noreturn]] void on_error(png_structp png, png_const_charp) {
  // Thrown through libpng's C frames, as in render/png.cpp.
  refuse(*static_cast<const Path*>(png_get_error_ptr(png)), "is no PNG file, or a damaged one");
}
void on_warning(png_structp, png_const_charp) {}

/// An open PNG file after its header; rows are converted to grey or colours, in 8 or 16 bits.
class PngFile {
 public:
  explicit PngFile(const Path& path)
      : bytes_(read_file(path)),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, const_cast<Path*>(&path), on_error, on_warning)) {
    if (png_ == nullptr || (info_ = png_create_info_struct(png_)) == nullptr) refuse(path, "cannot begin to read PNG");
    try {
      begin();
    } catch (...) {
      png_destroy_read_struct(&png_, &info_, nullptr);
      throw;
    }
  }
  ~PngFile() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  [[nodiscard]] std::size_t width() const { return png_get_image_width(png_, info_); }
  [[nodiscard]] std::size_t height() const { return png_get_image_height(png_, info_); }
  [[nodiscard]] std::size_t depth() const { return png_get_bit_depth(png_, info_); }
  [[nodiscard]] std::size_t channels() const { return png_get_channels(png_, info_); }
  [[nodiscard]] std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
  void read(std::vector<png_bytep>& rows) { png_read_image(png_, rows.data()); }

 private:
  void begin() {
    png_set_read_fn(png_, this, [](png_structp png, png_bytep data, std::size_t size) {
      auto& from = *static_cast<PngFile*>(png_get_io_ptr(png));
      if (size > from.bytes_.size() - from.at_) png_error(png, "the file ends too early");
      std::memcpy(data, from.bytes_.data() + from.at_, size);
      from.at_ += size;
    });
    png_set_user_limits(png_, 1 << 20, 1 << 20);
    // Texts, profiles and the like are skipped: libpng would allocate up to 2 GiB for a damaged length.
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_info(png_, info_);
    png_set_palette_to_rgb(png_);
    if (depth() < 8) png_set_expand_gray_1_2_4_to_8(png_);
    png_set_strip_alpha(png_);
    png_set_swap(png_);  // 16 bits in the byte order of this machine
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
  }

  std::string bytes_;
  std::size_t at_ = 0;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

class PngSlice final : public Slice {
 public:
  explicit PngSlice(Path path) : path_(std::move(path)) {
    const PngFile file(path_);
    width = static_cast<int>(file.width());
    height = static_cast<int>(file.height());
    type = file.depth() == 16 ? SampleType::uint16 : SampleType::uint8;
  }
  void read(float* out) const override {
    PngFile file(path_);
    const std::size_t channels = file.channels(), sample_bytes = file.depth() / 8;
    if (file.width() != static_cast<std::size_t>(width) || file.height() != static_cast<std::size_t>(height))
      refuse(path_, "has changed");
    require_memory(file.row_bytes() * file.height(), path_.string());
    std::vector<png_byte> bytes(file.row_bytes() * file.height());
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < file.height(); ++y) rows.push_back(bytes.data() + y * file.row_bytes());
    file.read(rows);
    const auto sample = [&](std::size_t i) {
      if (sample_bytes == 1) return static_cast<float>(bytes[i]);
      std::uint16_t two = 0;
      std::memcpy(&two, bytes.data() + 2 * i, 2);
      return static_cast<float>(two);
    };
    for (std::size_t i = 0; i < file.width() * file.height(); ++i)
      out[i] = channels < 3 ? sample(i * channels)
                            : grey(sample(i * channels), sample(i * channels + 1), sample(i * channels + 2));
  }

 private:
  Path path_;
};

}  // namespace

SlicePtr png_slice(const Path& path) { return std::make_unique<PngSlice>(path); }

}  // namespace fieldfab
