// Medical formats, through ITK: MetaImage, NRRD, NIfTI and DICOM.
#include <itkGDCMImageIO.h>
#include <itkGDCMSeriesFileNames.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>

#include "fieldfab/core/copy_of_process.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/lower_case.h"
#include "volume/parts.h"
#include "volume/read_in_copy.h"

namespace fieldfab {
namespace {

using Component = itk::IOComponentEnum;

constexpr const char *library = "ITK", *dicom_library = "GDCM";

std::optional<SampleType> type_of(Component component) {
  switch (component) {
    case Component::UCHAR: return SampleType::uint8;
    case Component::CHAR: return SampleType::int8;
    case Component::USHORT: return SampleType::uint16;
    case Component::SHORT: return SampleType::int16;
    case Component::UINT: return SampleType::uint32;
    case Component::INT: return SampleType::int32;
    case Component::FLOAT: return SampleType::float32;
    case Component::DOUBLE: return SampleType::float64;
    case Component::ULONG:
    case Component::ULONGLONG: return sizeof(long) == 4 ? std::optional(SampleType::uint32) : std::nullopt;
    default: return std::nullopt;
  }
}

/// Returns the last line of ITK's message, which describes the fault; the others trace the calls
/// from the outermost function inwards.
std::string said(const itk::ExceptionObject& error) {
  std::string text = error.GetDescription();
  text.erase(text.find_last_not_of(" \n\r\t") + 1);
  text.erase(0, text.find_last_of('\n') + 1);
  for (const std::string_view before : {"] ", "): ", ": "})
    if (const auto at = text.rfind(before); at != std::string::npos) text.erase(0, at + before.size());
  return text.substr(0, 160);
}

/// During its lifetime libraries (MetaIO, nifti_clib) write nothing to stderr.
class Hushed {
 public:
  Hushed() : before_(std::cerr.rdbuf(nullptr)) { itk::Object::GlobalWarningDisplayOff(); }
  ~Hushed() {
    std::cerr.rdbuf(before_);
    std::cerr.clear();
  }
  Hushed(const Hushed&) = delete;
  Hushed& operator=(const Hushed&) = delete;

 private:
  std::streambuf* before_;
};

/// Reads the header; throws bad_input with ITK's message.
template <class Io>
typename Io::Pointer opened(const Path& path, const char* kind) {
  const Hushed hushed;
  auto io = Io::New();
  io->SetFileName(path.string());
  try {
    io->ReadImageInformation();
  } catch (const itk::ExceptionObject& error) {
    refuse(path, fmt::format("is no {} file, or a damaged one: {}", kind, said(error)));
  }
  return io;
}

/// Returns the lattice of the samples. A two-dimensional image has one slice.
SampleLattice lattice_of(const itk::ImageIOBase& io, const Path& path, bool one_slice_will_do) {
  const unsigned dimensions = io.GetNumberOfDimensions();
  if (io.GetNumberOfComponents() != 1)
    refuse(path, fmt::format("{} numbers a sample; one is wanted", io.GetNumberOfComponents()));
  for (unsigned axis = 3; axis < dimensions; ++axis)
    if (io.GetDimensions(axis) > 1) refuse(path, fmt::format("{} dimensions; a volume has three", dimensions));
  if (dimensions < 2) refuse(path, fmt::format("{} dimensions; a volume has three", dimensions));
  SampleLattice lattice;
  std::array<long long, 3> size{1, 1, 1};
  for (unsigned axis = 0; axis < std::min(dimensions, 3U); ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    size[axis] = static_cast<long long>(std::min<std::uint64_t>(io.GetDimensions(axis), 1ULL << 40));
    lattice.spacing[a] = io.GetSpacing(axis);
    lattice.origin[a] = io.GetOrigin(axis);
    const std::vector<double> direction = io.GetDirection(axis);
    for (unsigned row = 0; row < 3 && row < direction.size(); ++row)
      lattice.axes(static_cast<Eigen::Index>(row), a) = direction[row];
  }
  if (!one_slice_will_do || size[2] > 1) sample_count(size, path);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    if (size[axis] > 1 << 24) refuse(path, "an impossible size");
    lattice.size[axis] = static_cast<int>(size[axis]);
    if (lattice.spacing[a] < 0) lattice.spacing[a] *= -1, lattice.axes.col(a) *= -1;
    if (lattice.spacing[a] == 0 && axis == 2) lattice.spacing[a] = 1;
  }
  if (!lattice.spacing.allFinite() || lattice.spacing.minCoeff() <= 0 || !lattice.origin.allFinite() ||
      !lattice.axes.allFinite() || std::abs(lattice.axes.determinant()) < 1e-6)
    refuse(path, "tells distances or directions that are not possible");
  return lattice;
}

/// Reads all samples, after the header.
void read_samples(itk::ImageIOBase& io, SampleType type, std::size_t count, const Path& path, float* out) {
  const std::size_t size = count * size_of(type);
  if (static_cast<std::size_t>(io.GetImageSizeInBytes()) != size)
    refuse(path, "holds another number of samples than it tells");
  std::vector<std::byte> bytes(size);
  {
    const Hushed hushed;
    try {
      itk::ImageIORegion all(io.GetNumberOfDimensions());
      for (unsigned axis = 0; axis < io.GetNumberOfDimensions(); ++axis) all.SetSize(axis, io.GetDimensions(axis));
      io.SetIORegion(all);
      io.Read(bytes.data());
    } catch (const itk::ExceptionObject& error) {
      refuse(path, "cannot be read: " + said(error));
    }
  }
  to_floats(type, bytes.data(), count, false, out);
}

SampleType known_type(const itk::ImageIOBase& io, const Path& path) {
  const auto type = type_of(io.GetComponentType());
  if (!type)
    refuse(path, "samples of " + itk::ImageIOBase::GetComponentTypeAsString(io.GetComponentType()) + " are not read");
  return *type;
}

/// Factors that convert positions and spacings of a file to mm. ITK reads units of NIfTI only. It scales spacings, and
/// positions from version 5.3 on.
struct Units {
  double origin = 1, spacing = 1;
  void apply(SampleLattice& lattice) const { lattice.origin *= origin, lattice.spacing *= spacing; }
};

double mm_of(std::string unit, const Path& path) {
  if (unit.ends_with('s') && unit.size() > 2) unit.pop_back();
  if (unit.empty() || unit == "mm" || unit == "millimeter" || unit == "millimetre") return 1;
  if (unit == "um" || unit == "µm" || unit == "micron" || unit == "micrometer" || unit == "micrometre") return 1e-3;
  if (unit == "nm" || unit == "nanometer" || unit == "nanometre") return 1e-6;
  if (unit == "cm" || unit == "centimeter" || unit == "centimetre") return 10;
  if (unit == "m" || unit == "meter" || unit == "metre") return 1000;
  if (unit == "in" || unit == "inch" || unit == "inche") return 25.4;
  refuse(path, fmt::format("has the unit '{:.30}'; known are mm, um, nm, cm, m and in", unit));
}

/// Returns the units in the header's field "space units", one in quotes per axis; otherwise in
/// "units".
Units units_of_nrrd(const Path& path) {
  std::ifstream text(path, std::ios::binary);
  std::string of_space, of_axes;
  for (std::string line; std::getline(text, line) && !line.empty() && line != "\r";) {
    if (line.starts_with("space units:")) of_space = line;
    if (line.starts_with("units:")) of_axes = line;
  }
  std::optional<double> unit;
  const std::string& told = of_space.empty() ? of_axes : of_space;
  for (std::size_t at = told.find('"'); at != std::string::npos; at = told.find('"', at + 1)) {
    const std::size_t end = std::min(told.find('"', at + 1), told.size());
    const double mm = mm_of(told.substr(at + 1, end - at - 1), path);
    if (unit && *unit != mm) refuse(path, "has different units along its axes");
    unit = mm;
    at = end;
  }
  return {unit.value_or(1), unit.value_or(1)};
}

/// Header of a NIfTI-1 file, possibly compressed, in either byte order.
class NiftiHeader {
 public:
  explicit NiftiHeader(const Path& path) : path_(path) {
    const std::unique_ptr<gzFile_s, decltype(&gzclose)> file(gzopen(path.c_str(), "rb"), &gzclose);
    if (file) gzread(file.get(), bytes_.data(), static_cast<unsigned>(bytes_.size()));
    other_order_ = size() != 348 && size() != 540;
    if (size() == 540) refuse(path, "is a NIfTI-2 file; NIfTI-1 is read");
    if (size() != 348) refuse(path, "is no NIfTI file, or a damaged one");
  }
  /// Refuses headers that make nifti_clib write to stderr, or ITK end the process or never end (transforms that are not
  /// finite, or far too large).
  void require_sound() const {
    const int dimensions = at<std::int16_t>(40), type = at<std::int16_t>(70);
    if (dimensions < 1 || dimensions > 7) refuse(path_, fmt::format("{} dimensions; a volume has three", dimensions));
    for (int axis = 1; axis <= dimensions; ++axis)
      if (at<std::int16_t>(40 + 2 * static_cast<std::size_t>(axis)) < 1) refuse(path_, "an impossible size");
    constexpr std::array types{2, 4, 8, 16, 32, 64, 128, 256, 512, 768, 1024, 1280, 1536, 1792, 2048, 2304};
    if (std::find(types.begin(), types.end(), type) == types.end())
      refuse(path_, fmt::format("samples of an unknown type, {}", type));
    require_finite(76, 8);
    if (at<std::int16_t>(252) > 0) require_finite(256, 6);
    if (at<std::int16_t>(254) > 0) require_finite(280, 12);
  }
  /// The lowest three bits of byte 123 are the unit of space.
  [[nodiscard]] Units units() const {
    if (ITK_VERSION_MAJOR > 5 || ITK_VERSION_MINOR >= 3) return {};
    switch (static_cast<unsigned char>(bytes_[123]) & 7) {
      case 1: return {1000, 1};
      case 3: return {1e-3, 1};
      default: return {};
    }
  }

 private:
  [[nodiscard]] int size() const { return at<std::int32_t>(0); }
  void require_finite(std::size_t first, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i)
      // ITK decomposes the matrix in single precision, without an end where squares overflow.
      if (constexpr float most = 1e12F; !(std::abs(at<float>(first + 4 * i)) <= most))
        refuse(path_, "tells distances or directions that are not possible");
  }
  template <class Number>
  [[nodiscard]] Number at(std::size_t place) const {
    std::array<char, sizeof(Number)> bytes{};
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(place), bytes.size(), bytes.begin());
    if (other_order_) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Number>(bytes);
  }

  const Path& path_;
  std::array<char, 348> bytes_{};
  bool other_order_ = false;
};

/// Reads all samples of an opened file.
Samples read_whole(itk::ImageIOBase& io, const Path& path, const Room& room, const Units& units = {}) {
  SampleLattice lattice = lattice_of(io, path, false);
  units.apply(lattice);
  const SampleType type = known_type(io, path);
  require_memory(lattice.count() * (size_of(type) + sizeof(float)), path.string());
  read_samples(io, type, lattice.count(), path, room(lattice.count()));
  return {lattice, type};
}

/// Throws if a file is too short. nifti_clib reads missing bytes as zeros, so the bytes are counted
/// first, uncompressed if needed. NIfTI-1 has the bits per sample at byte 72, and the offset of the
/// samples at 108.
void require_all_bytes(const Path& path, std::int64_t samples) {
  const std::unique_ptr<gzFile_s, decltype(&gzclose)> file(gzopen(path.c_str(), "rb"), &gzclose);
  std::vector<char> part(1 << 18);
  std::int64_t bytes = 0;
  int got = 0;
  std::int16_t bits = 0;
  float begin = 0;
  while (file && (got = gzread(file.get(), part.data(), static_cast<unsigned>(part.size()))) > 0) {
    if (bytes == 0 && got >= 112) std::memcpy(&bits, part.data() + 72, 2), std::memcpy(&begin, part.data() + 108, 4);
    bytes += got;
  }
  int failure = Z_OK;
  if (file) gzerror(file.get(), &failure);
  if (bits != 8 && bits != 16 && bits != 32 && bits != 64) bits = 8;
  if (!(begin >= 348 && begin < 1e6F)) begin = 348;  // the other byte order, or NIfTI-2
  const std::int64_t least = static_cast<std::int64_t>(begin) + samples * (bits / 8);
  if (got < 0 || failure != Z_OK || bytes < least) refuse(path, fmt::format("is cut off after {} bytes", bytes));
}

/// Opens MetaImage. MetaIO fills missing samples of a short file with arbitrary values, so the size
/// is checked first. Uncompressed samples, in the file or in a single other one, are read on
/// demand.
VolumePtr open_meta(const Path& path, Progress& progress) {
  const auto read_header = [&](const Room&) {
    const auto io = opened<itk::MetaImageIO>(path, "MetaImage");
    return Samples{lattice_of(*io, path, false), known_type(*io, path)};
  };
  auto [lattice, type, no_threshold] = read_in_copy(path, library, read_header, progress).samples;
  std::ifstream text(path, std::ios::binary);
  std::string data_file, unit;
  bool compressed = false, big_endian = false;
  long long header = 0;
  for (std::string line; data_file.empty() && std::getline(text, line) && line.size() < 4096;) {
    const auto equals = line.find('=');
    if (equals == std::string::npos) continue;
    const auto trim = [](std::string s) {
      s.erase(0, s.find_first_not_of(" \t"));
      s.erase(s.find_last_not_of(" \t\r") + 1);
      return s;
    };
    const std::string key = trim(line.substr(0, equals)), value = trim(line.substr(equals + 1));
    if (key == "CompressedData") compressed = value == "True" || value == "true" || value == "1";
    if (key == "BinaryDataByteOrderMSB" || key == "ElementByteOrderMSB")
      big_endian = value == "True" || value == "true" || value == "1";
    if (key == "HeaderSize") header = std::strtoll(value.c_str(), nullptr, 10);
    if (key == "DistanceUnits") unit = value;
    if (key == "ElementDataFile") data_file = value;
  }
  if (data_file.empty()) refuse(path, "does not tell where its samples are (ElementDataFile)");
  const bool local = data_file == "LOCAL" || data_file == "Local" || data_file == "local";
  const double mm = mm_of(unit, path);
  const bool several = data_file.find('%') != std::string::npos || data_file == "LIST";
  const Path data = local ? path : Path(data_file).is_absolute() ? Path(data_file) : path.parent_path() / data_file;
  if (!several) require_regular_file(data);
  const auto read_samples_too = [&](const Room& room) {
    return read_whole(*opened<itk::MetaImageIO>(path, "MetaImage"), path, room, {mm, mm});
  };
  if (compressed || several) return volume_read_in_copy(path, library, read_samples_too, progress);
  Units{mm, mm}.apply(lattice);
  if (std::error_code none; header < 0 && std::filesystem::is_regular_file(data, none))  // the samples are at its end
    header = std::max<long long>(0, static_cast<long long>(std::filesystem::file_size(data)) -
                                        static_cast<long long>(lattice.count() * size_of(type)));
  RawLayout layout{lattice, type, big_endian,
                   local ? static_cast<std::uint64_t>(text.tellg()) : static_cast<std::uint64_t>(header)};
  return open_samples(data, layout);
}

/// Throws unless a separate file of samples, which NrrdIO opens by itself, is a regular file.
void require_nrrd_samples(const Path& path) {
  std::ifstream text(path, std::ios::binary);
  for (std::string line; std::getline(text, line) && !line.empty() && line.size() < 4096;)
    for (const std::string_view key : {"data file:", "datafile:"}) {
      if (!line.starts_with(key)) continue;
      line.erase(0, line.find_first_not_of(" \t", key.size()));
      line.erase(line.find_last_not_of(" \t\r") + 1);
      if (!line.empty() && line.find('%') == std::string::npos && !line.starts_with("LIST"))
        require_regular_file(path.parent_path() / line);
    }
}

/// Slices in separate files, through GDCM.
class DicomSlice final : public Slice {
 public:
  explicit DicomSlice(Path path) : path_(std::move(path)) {
    const auto io = opened<itk::GDCMImageIO>(path_, "DICOM");
    lattice = lattice_of(*io, path_, true);
    if (lattice.size[2] != 1) refuse(path_, "holds more than one slice, where each file should be one");
    width = lattice.size[0];
    height = lattice.size[1];
    type = known_type(*io, path_);
  }
  void read(float* out) const override {
    const auto io = opened<itk::GDCMImageIO>(path_, "DICOM");
    read_samples(*io, type, lattice.slice(), path_, out);
  }
  SampleLattice lattice;

 private:
  Path path_;
};

std::string list_of_series(const itk::GDCMSeriesFileNames::SeriesUIDContainerType& series,
                           itk::GDCMSeriesFileNames& names) {
  std::string list;
  for (std::size_t i = 0; i < series.size(); ++i)
    list +=
        fmt::format("{}{}: {} ({} files)", i == 0 ? "" : "; ", i + 1, series[i], names.GetFileNames(series[i]).size());
  return list;
}

/// Refuses a MetaImage with an impossible number of dimensions: ITK would read that many numbers of each line.
void require_meta_dimensions(const Path& path) {
  std::string head(1 << 16, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  for (std::size_t at = head.find("NDims"); at != std::string::npos; at = head.find("NDims", at + 1)) {
    const std::size_t value = head.find_first_not_of(" \t=:", at + 5);
    if (value == std::string::npos) return;
    if (at > 0 && head[at - 1] != '\n' && head[at - 1] != '\r') continue;  // not a key
    const double count = std::strtod(head.c_str() + value, nullptr);
    if (!(count >= 1 && count <= 10)) refuse(path, fmt::format("{:.9g} dimensions; a volume has three", count));
  }
}

Samples read_nrrd(const Path& path, const Room& room) {
  return read_whole(*opened<itk::NrrdImageIO>(path, "NRRD"), path, room, units_of_nrrd(path));
}

Samples read_nifti(const Path& path, const Room& room) {
  const NiftiHeader header(path);
  header.require_sound();
  {
    const Hushed hushed;
    if (!itk::NiftiImageIO::New()->CanReadFile(path.c_str())) refuse(path, "is no NIfTI file, or a damaged one");
  }
  const auto io = opened<itk::NiftiImageIO>(path, "NIfTI");
  require_all_bytes(path, static_cast<std::int64_t>(io->GetImageSizeInComponents()));
  return read_whole(*io, path, room, header.units());
}

VolumePtr open(const Path& path, Progress& progress) {
  const std::string extension = lower_extension(path);
  if (extension == ".mha" || extension == ".mhd") {
    require_meta_dimensions(path);
    return open_meta(path, progress);
  }
  const bool nrrd = extension == ".nrrd" || extension == ".nhdr";
  if (nrrd) require_nrrd_samples(path);
  const auto read = [&](const Room& room) { return nrrd ? read_nrrd(path, room) : read_nifti(path, room); };
  return volume_read_in_copy(path, library, read, progress);
}

/// Reads a file of one or several slices.
Samples read_dicom_file(const Path& path, const Room& room) {
  return read_whole(*opened<itk::GDCMImageIO>(path, "DICOM"), path, room);
}

VolumePtr open_dicom_file(const Path& path, Progress& progress) {
  const auto read = [&](const Room& room) { return read_dicom_file(path, room); };
  return volume_read_in_copy(path, dicom_library, read, progress);
}

/// Opens a series of a folder.
VolumePtr open_sound_series(const Path& path, const std::string& wanted, Progress& progress) {
  std::vector<std::string> files;
  {
    const Hushed hushed;
    const auto names = itk::GDCMSeriesFileNames::New();
    names->SetUseSeriesDetails(true);
    names->SetDirectory(path.string());
    const auto series = names->GetSeriesUIDs();
    if (series.empty()) refuse(path, "holds no DICOM series");
    std::size_t chosen = series.size();
    for (std::size_t i = 0; i < series.size(); ++i)
      if (series[i] == wanted || std::to_string(i + 1) == wanted) chosen = i;
    for (std::size_t i = 0; i < series.size() && chosen == series.size(); ++i)
      if (!wanted.empty() && series[i].find(wanted) != std::string::npos) chosen = i;
    if (wanted.empty() && series.size() == 1) chosen = 0;
    if (chosen == series.size())
      refuse(path, fmt::format("{}: {}",
                               wanted.empty() ? fmt::format("holds {} series; choose one with --series", series.size())
                                              : fmt::format("holds no series '{}'", wanted),
                               list_of_series(series, *names)));
    files = names->GetFileNames(series[chosen]);
  }
  if (files.size() == 1) return open_dicom_file(files[0], progress);
  struct Placed {
    std::unique_ptr<DicomSlice> slice;
    Path path;
    double along;  // along the normal of the slices
  };
  std::vector<Placed> placed;
  for (const std::string& file : files) {
    progress.check();
    progress.report(static_cast<double>(placed.size()) / static_cast<double>(files.size()), "reading DICOM headers");
    placed.push_back({std::make_unique<DicomSlice>(file), file, 0});
  }
  const Vec3 normal = placed[0].slice->lattice.axes.col(0).cross(placed[0].slice->lattice.axes.col(1));
  for (Placed& here : placed) {
    here.along = normal.dot(here.slice->lattice.origin);
    if (!here.slice->lattice.axes.leftCols<2>().isApprox(placed[0].slice->lattice.axes.leftCols<2>(), 1e-4))
      refuse(here.path, "is a slice in another direction than the first of its series");
  }
  std::stable_sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.along < b.along; });
  std::vector<double> gaps;
  for (std::size_t i = 1; i < placed.size(); ++i) gaps.push_back(placed[i].along - placed[i - 1].along);
  std::vector<double> sorted = gaps;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double gap = sorted[sorted.size() / 2];
  if (!(gap > 0))
    refuse(path,
           "has several slices at one place: choose between them with --series, or put one set in a folder of its own");
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (std::abs(gaps[i] - gap) > 0.1 * gap)
      refuse(path,
             fmt::format(
                 "the slices {} and {} are {:.4g} mm apart, the others {:.4g} mm: slices are missing or twice there",
                 placed[i].path.filename().string(), placed[i + 1].path.filename().string(), gaps[i], gap));
  SampleLattice lattice = placed[0].slice->lattice;
  const Vec3 step = (placed.back().slice->lattice.origin - lattice.origin) / static_cast<double>(placed.size() - 1);
  lattice.spacing.z() = step.norm();
  lattice.axes.col(2) = step.normalized();
  if (lattice.axes.col(2).isApprox(normal, 1e-5)) lattice.axes.col(2) = normal;
  std::vector<SlicePtr> slices;
  std::vector<Path> paths;
  for (Placed& here : placed) slices.push_back(std::move(here.slice)), paths.push_back(here.path);
  return stack_of(std::move(slices), paths, lattice);
}

VolumePtr open_dicom_tried(const Path& path, const std::string& series, Progress& progress) {
  progress.report(0, "reading DICOM files");
  if (!std::filesystem::is_directory(path)) return open_dicom_file(path, progress);
  // Slices of a series are read later, in this process, when they are asked for; Debian's GDCM has assertions, which
  // would end it.
  const auto read_series = [&] {
    const VolumePtr volume = open_sound_series(path, series, Progress::none());
    std::vector<float> slice(volume->lattice().slice());
    for (int k = 0; k < volume->lattice().size[2]; ++k) volume->read(k, 1, slice.data());
  };
  if (run_in_copy(read_series, progress) != CopyEnd::crashed) return open_sound_series(path, series, progress);
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    if (!entry.is_regular_file()) continue;
    std::vector<float> densities;
    const auto read_file = [&] {
      read_dicom_file(entry.path(), [&](std::size_t count) {
        densities.resize(count);
        return densities.data();
      });
    };
    if (run_in_copy(read_file, progress) == CopyEnd::crashed) refuse_crashed(entry.path(), dicom_library);
  }
  refuse(path, "holds a file that GDCM, which reads DICOM, gives up at");
}

/// Whether a file just written holds these samples. MetaIO, NrrdIO and nifti_clib do not report a
/// full disk.
bool holds(const Path& path, const std::vector<float>& densities) {
  try {
    const VolumePtr written = open(path, Progress::none());
    if (written->lattice().count() != densities.size()) return false;
    std::vector<float> read(densities.size());
    written->read(0, written->lattice().size[2], read.data());
    return std::memcmp(read.data(), densities.data(), densities.size() * sizeof(float)) == 0;
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::too_large) throw;
    return false;
  }
}

void write(const Volume& volume, const Path& path, Progress& progress) {
  const SampleLattice& lattice = volume.lattice();
  const std::vector<float> densities = read_all(volume, progress);
  const std::string extension = lower_extension(path);
  itk::ImageIOBase::Pointer io;
  if (extension == ".nrrd") io = itk::NrrdImageIO::New().GetPointer();
  if (extension == ".mha") io = itk::MetaImageIO::New().GetPointer();
  if (extension == ".nii" || (extension == ".gz" && lower_extension(path.stem()) == ".nii"))
    io = itk::NiftiImageIO::New().GetPointer();
  if (!io)
    refuse(path, fmt::format("there is no writer of volumes for '{}'; known are .nrrd .mha .nii .nii.gz", extension));
  PendingFile file(path);
  const std::size_t bytes = densities.size() * sizeof(float);
  const bool compressed = extension != ".mha" && extension != ".nii";
  if (!compressed) file.require_room(bytes);  // otherwise nifti_clib writes to stderr
  const Hushed hushed;
  bool complete = false;
  try {
    io->SetFileName(file.temporary().string());
    io->SetNumberOfDimensions(3);
    io->SetNumberOfComponents(1);
    io->SetPixelType(itk::IOPixelEnum::SCALAR);
    io->SetComponentType(Component::FLOAT);
    itk::ImageIORegion all(3);
    for (unsigned axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      io->SetDimensions(axis, static_cast<std::size_t>(lattice.size[axis]));
      io->SetSpacing(axis, lattice.spacing[a]);
      io->SetOrigin(axis, lattice.origin[a]);
      io->SetDirection(axis, std::vector<double>{lattice.axes(0, a), lattice.axes(1, a), lattice.axes(2, a)});
      all.SetSize(axis, static_cast<std::size_t>(lattice.size[axis]));
    }
    io->SetUseCompression(compressed);
    io->SetIORegion(all);
    io->Write(densities.data());
    progress.check();
    complete = holds(file.temporary(), densities);
  } catch (const itk::ExceptionObject&) {  // its message contains the temporary name and places in ITK
  }
  if (!complete) file.refuse_partial(bytes);
  file.commit();
}

}  // namespace

extern "C" const ItkPart fieldfab_itk = {open, open_dicom_tried, write, itk_denoised};

}  // namespace fieldfab
