// PNG files as slices, through ITK.
#include <itkPNGImageIO.h>

#include <cstring>

#include "fieldfab/core/file.h"
#include "readers.h"

namespace fieldfab {
namespace {

class PngSlice final : public Slice {
 public:
  explicit PngSlice(Path path) : path_(std::move(path)) {
    const auto file = open();
    width = static_cast<int>(file->GetDimensions(0));
    height = static_cast<int>(file->GetDimensions(1));
    type = file->GetComponentType() == itk::IOComponentEnum::USHORT ? SampleType::uint16 : SampleType::uint8;
  }
  void read(float* out) const override {
    const auto file = open();
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    require_memory(static_cast<std::uintmax_t>(file->GetImageSizeInBytes()), path_.string());
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(file->GetImageSizeInBytes()));
    try {
      itk::ImageIORegion all(2);
      for (unsigned axis = 0; axis < 2; ++axis) all.SetSize(axis, file->GetDimensions(axis));
      file->SetIORegion(all);
      file->Read(bytes.data());
    } catch (const itk::ExceptionObject&) {
      refuse(path_, "is damaged or cut off");
    }
    const std::size_t channels = file->GetNumberOfComponents();
    const auto sample = [&](std::size_t i) {
      if (type == SampleType::uint8) return static_cast<float>(bytes[i]);
      std::uint16_t two = 0;
      std::memcpy(&two, bytes.data() + 2 * i, 2);
      return static_cast<float>(two);
    };
    for (std::size_t i = 0; i < pixels; ++i)
      out[i] =
          channels < 3 ? sample(i * channels) : grey(sample(i * channels), sample(i * channels + 1), sample(i * channels + 2));
  }

 private:
  [[nodiscard]] itk::PNGImageIO::Pointer open() const {
    itk::Object::GlobalWarningDisplayOff();
    auto file = itk::PNGImageIO::New();
    file->SetFileName(path_.string());
    try {
      if (!file->CanReadFile(path_.c_str())) refuse(path_, "is no PNG file, or a damaged one");
      file->ReadImageInformation();
    } catch (const itk::ExceptionObject&) {
      refuse(path_, "is no PNG file, or a damaged one");
    }
    return file;
  }
  Path path_;
};

}  // namespace

SlicePtr png_slice(const Path& path) { return std::make_unique<PngSlice>(path); }

}  // namespace fieldfab
