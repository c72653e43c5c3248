// Stacks of images, and TIFF files.
#include <tiffio.h>

#include <algorithm>
#include <cstring>

#include "fieldfab/core/file.h"
#include "readers.h"

namespace fieldfab {
namespace {

class SliceStack final : public Volume {
 public:
  SliceStack(std::vector<SlicePtr> slices, const SampleLattice& lattice, SampleType type)
      : Volume(lattice, type), slices_(std::move(slices)) {}
  void read(int first, int count, float* out) const override {
    for (int k = 0; k < count; ++k, out += lattice_.slice()) slices_[static_cast<std::size_t>(first + k)]->read(out);
  }

 private:
  std::vector<SlicePtr> slices_;
};

using TiffFile = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

TiffFile open_tiff(const Path& path) {
  // libtiff would write messages to stderr; an Error is thrown instead.
  TIFFSetErrorHandler(nullptr);
  TIFFSetWarningHandler(nullptr);
  TiffFile file(TIFFOpen(path.c_str(), "rm"), &TIFFClose);
  if (!file) refuse(path, "is no TIFF file, or a damaged one");
  return file;
}

class TiffPage final : public Slice {
 public:
  TiffPage(Path path, std::uint64_t offset, TIFF* file) : path_(std::move(path)), offset_(offset) {
    std::uint32_t columns = 0, rows = 0;
    TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &columns);
    TIFFGetField(file, TIFFTAG_IMAGELENGTH, &rows);
    TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &bits_);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &channels_);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &format_);
    TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &planes_);
    TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &photometric_);
    if (columns == 0 || rows == 0 || columns > 1 << 20 || rows > 1 << 20)
      refuse(path_, fmt::format("an impossible picture of {} x {} pixels", columns, rows));
    width = static_cast<int>(columns);
    height = static_cast<int>(rows);
    const bool real = format_ == SAMPLEFORMAT_IEEEFP, has_sign = format_ == SAMPLEFORMAT_INT;
    if (bits_ == 8 && !real)
      type = has_sign ? SampleType::int8 : SampleType::uint8;
    else if (bits_ == 16 && !real)
      type = has_sign ? SampleType::int16 : SampleType::uint16;
    else if (bits_ == 32)
      type = real ? SampleType::float32 : has_sign ? SampleType::int32 : SampleType::uint32;
    else if (bits_ == 64 && real)
      type = SampleType::float64;
    else
      refuse(path_, fmt::format("samples of {} bits are not read; known are 8, 16 and 32 bits, and 64 for real numbers",
                                bits_));
    if (channels_ != 1 && (channels_ < 3 || channels_ > 4 || real))
      refuse(path_, fmt::format("{} numbers a pixel; one is wanted", channels_));
    if (photometric_ == PHOTOMETRIC_PALETTE) {
      if (bits_ > 16 || channels_ != 1) refuse(path_, "a palette of an impossible kind");
      type = SampleType::uint8;
      format_ = SAMPLEFORMAT_UINT;  // palette indices, whatever the file states
    }
  }

  void read(float* out) const override {
    const TiffFile file = open_tiff(path_);
    if (TIFFSetSubDirectory(file.get(), offset_) != 1) damaged();
    const std::size_t row_bytes = static_cast<std::size_t>(width) * channels_ * (bits_ / 8U);
    if (TIFFIsTiled(file.get()) != 0) {
      read_tiles(file.get(), out);
    } else {
      const bool apart = planes_ == PLANARCONFIG_SEPARATE && channels_ > 1;
      if (apart) refuse(path_, "colours in planes of their own are not read");
      // A hostile file can state any size, so memory is allocated only if lines really have that
      // length.
      if (static_cast<std::size_t>(TIFFScanlineSize(file.get())) != row_bytes) damaged();
      std::vector<std::uint8_t> row(row_bytes);
      for (int y = 0; y < height; ++y) {
        if (TIFFReadScanline(file.get(), row.data(), static_cast<std::uint32_t>(y)) != 1) damaged();
        greys(row.data(), static_cast<std::size_t>(width),
              out + static_cast<std::size_t>(y) * static_cast<std::size_t>(width));
      }
    }
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (photometric_ == PHOTOMETRIC_PALETTE) look_up(file.get(), out, pixels);
    if (photometric_ == PHOTOMETRIC_MINISWHITE && type == SampleType::uint8)
      for (std::size_t i = 0; i < pixels; ++i) out[i] = 255 - out[i];
    if (photometric_ == PHOTOMETRIC_MINISWHITE && type == SampleType::uint16)
      for (std::size_t i = 0; i < pixels; ++i) out[i] = 65535 - out[i];
  }

 private:
  [[noreturn]] void damaged() const { refuse(path_, "is damaged or cut off"); }

  void read_tiles(TIFF* file, float* out) const {
    std::uint32_t columns = 0, rows = 0;
    TIFFGetField(file, TIFFTAG_TILEWIDTH, &columns);
    TIFFGetField(file, TIFFTAG_TILELENGTH, &rows);
    const std::size_t row_bytes = std::size_t{columns} * channels_ * (bits_ / 8U);
    if (columns == 0 || rows == 0 || columns > 1 << 16 || rows > 1 << 16 || planes_ == PLANARCONFIG_SEPARATE ||
        static_cast<std::size_t>(TIFFTileSize(file)) != row_bytes * rows)
      damaged();
    require_memory(row_bytes * rows, path_.string());
    std::vector<std::uint8_t> tile(row_bytes * rows);
    const auto w = static_cast<std::uint32_t>(width), h = static_cast<std::uint32_t>(height);
    for (std::uint32_t y = 0; y < h; y += rows)
      for (std::uint32_t x = 0; x < w; x += columns) {
        if (TIFFReadTile(file, tile.data(), x, y, 0, 0) < 0) damaged();
        for (std::uint32_t j = 0; j < std::min(rows, h - y); ++j)
          greys(tile.data() + j * row_bytes, std::min(columns, w - x), out + std::size_t{y + j} * w + x);
      }
  }

  template <class Sample>
  void greys_of(const std::uint8_t* from, std::size_t count, float* out) const {
    for (std::size_t i = 0; i < count; ++i) {
      std::array<Sample, 4> sample{};
      std::memcpy(sample.data(), from + i * channels_ * sizeof(Sample),
                  std::min<std::size_t>(channels_, 4) * sizeof(Sample));
      out[i] = channels_ == 1
                   ? static_cast<float>(sample[0])
                   : grey(static_cast<float>(sample[0]), static_cast<float>(sample[1]), static_cast<float>(sample[2]));
    }
  }
  void greys(const std::uint8_t* from, std::size_t count, float* out) const {
    const bool has_sign = format_ == SAMPLEFORMAT_INT;
    if (format_ == SAMPLEFORMAT_IEEEFP)
      return bits_ == 64 ? greys_of<double>(from, count, out) : greys_of<float>(from, count, out);
    if (bits_ == 8)
      return has_sign ? greys_of<std::int8_t>(from, count, out) : greys_of<std::uint8_t>(from, count, out);
    if (bits_ == 16)
      return has_sign ? greys_of<std::int16_t>(from, count, out) : greys_of<std::uint16_t>(from, count, out);
    return has_sign ? greys_of<std::int32_t>(from, count, out) : greys_of<std::uint32_t>(from, count, out);
  }

  /// Converts palette indices to the grey of the colours, 0 to 255.
  void look_up(TIFF* file, float* out, std::size_t count) const {
    std::uint16_t *red = nullptr, *green = nullptr, *blue = nullptr;
    if (TIFFGetField(file, TIFFTAG_COLORMAP, &red, &green, &blue) != 1) damaged();
    const std::size_t colours = std::size_t{1} << bits_;
    // Some writers fill palettes with 8 bits, against the standard.
    std::uint16_t most = 0;
    for (std::size_t i = 0; i < colours; ++i) most = std::max({most, red[i], green[i], blue[i]});
    const float step = most > 255 ? 257 : 1;
    std::vector<float> greys(colours);
    for (std::size_t i = 0; i < colours; ++i) {
      const auto part = [&](std::uint16_t c) { return std::floor(static_cast<float>(c) / step); };
      greys[i] = grey(part(red[i]), part(green[i]), part(blue[i]));
    }
    for (std::size_t i = 0; i < count; ++i) out[i] = greys[static_cast<std::size_t>(out[i])];
  }

  Path path_;
  std::uint64_t offset_;
  std::uint16_t bits_ = 1, channels_ = 1, format_ = SAMPLEFORMAT_UINT, planes_ = PLANARCONFIG_CONTIG, photometric_ = 0;
};

}  // namespace

std::vector<SlicePtr> tiff_pages(const Path& path) {
  const TiffFile file = open_tiff(path);
  std::vector<SlicePtr> pages;
  std::vector<std::uint64_t> seen;
  do {
    const std::uint64_t offset = TIFFCurrentDirOffset(file.get());
    if (pages.size() > 100'000) refuse(path, "more than 100000 pages");
    pages.push_back(std::make_unique<TiffPage>(path, offset, file.get()));
  } while (TIFFReadDirectory(file.get()) == 1);
  return pages;
}

VolumePtr stack_of(std::vector<SlicePtr> slices, const std::vector<Path>& files, SampleLattice lattice) {
  for (std::size_t i = 1; i < slices.size(); ++i) {
    const Slice &first = *slices[0], &here = *slices[i];
    const Path& path = files[std::min(i, files.size() - 1)];
    if (first.width != here.width || first.height != here.height)
      refuse(path, fmt::format("slice {} has {} x {} pixels, the first has {} x {}", i + 1, here.width, here.height,
                               first.width, first.height));
    if (first.type != here.type)
      refuse(path,
             fmt::format("slice {} has samples of {}, the first of {}", i + 1, name(here.type), name(first.type)));
  }
  lattice.size = {slices[0]->width, slices[0]->height, static_cast<int>(slices.size())};
  sample_count({lattice.size[0], lattice.size[1], lattice.size[2]}, files[0]);
  const SampleType type = slices[0]->type;
  return std::make_shared<SliceStack>(std::move(slices), lattice, type);
}

}  // namespace fieldfab
