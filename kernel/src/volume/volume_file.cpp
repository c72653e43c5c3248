// Choice of the reader for a path.
#include "fieldfab/volume/volume_file.h"
#include "fieldfab/core/lower_case.h"

#include <algorithm>
#include <charconv>

#include "fieldfab/core/file.h"
#include "readers.h"

namespace fieldfab {

namespace {

bool is_one_of(const std::string& extension, std::initializer_list<std::string_view> known) {
  return std::find(known.begin(), known.end(), extension) != known.end();
}
bool is_tiff(const Path& path) { return is_one_of(lower_extension(path), {".tif", ".tiff"}); }
bool is_png(const Path& path) { return lower_extension(path) == ".png"; }

/// Natural order of names: slice2 before slice10.
bool natural_order(const Path& a, const Path& b) {
  const std::string x = a.filename().string(), y = b.filename().string();
  std::size_t i = 0, j = 0;
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  while (i < x.size() && j < y.size()) {
    if (!digit(x[i]) || !digit(y[j])) {
      if (x[i] != y[j]) return x[i] < y[j];
      ++i, ++j;
      continue;
    }
    const auto number = [&](const std::string& text, std::size_t& at) {
      while (at < text.size() && text[at] == '0') ++at;
      const std::size_t first = at;
      while (at < text.size() && digit(text[at])) ++at;
      return text.substr(first, at - first);
    };
    const std::string m = number(x, i), n = number(y, j);
    if (m.size() != n.size()) return m.size() < n.size();
    if (m != n) return m < n;
  }
  return x.size() - i != y.size() - j ? x.size() - i < y.size() - j : x < y;
}

/// Splits off the last number in a name.
std::pair<std::string, std::optional<long long>> numbered(const Path& path) {
  const std::string name = path.filename().string();
  const auto last = name.find_last_of("0123456789", name.size() - path.extension().string().size() - 1);
  if (last == std::string::npos) return {name, std::nullopt};
  auto first = last;
  while (first > 0 && name[first - 1] >= '0' && name[first - 1] <= '9') --first;
  long long number = 0;
  if (std::from_chars(name.data() + first, name.data() + last + 1, number).ec != std::errc{})
    return {name, std::nullopt};
  return {name.substr(0, first) + "#" + name.substr(last + 1), number};
}

/// Throws if the numbers in the names do not increase by a constant step: a slice was lost.
void require_all_slices(const std::vector<Path>& files) {
  std::vector<long long> numbers;
  const std::string stem = numbered(files[0]).first;
  for (const Path& file : files) {
    const auto [name, number] = numbered(file);
    if (!number || name != stem) return;
    numbers.push_back(*number);
  }
  long long step = std::numeric_limits<long long>::max();
  for (std::size_t i = 1; i < numbers.size(); ++i) step = std::min(step, numbers[i] - numbers[i - 1]);
  for (std::size_t i = 1; i < numbers.size(); ++i)
    if (numbers[i] - numbers[i - 1] != step)
      refuse(files[0].parent_path(), fmt::format("a slice is missing between {} and {}",
                                                 files[i - 1].filename().string(), files[i].filename().string()));
}

/// Spacing in the folder's dimensions.txt: widthScale, heightScale, depthScale.
Vec3 spacing_of_folder(const Path& folder) {
  Vec3 spacing = Vec3::Ones();
  const Path path = folder / "dimensions.txt";
  if (!std::filesystem::is_regular_file(path)) return spacing;
  const auto settings = read_settings(path);
  constexpr std::array keys{"widthscale", "heightscale", "depthscale"};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto at = settings.find(keys[static_cast<std::size_t>(axis)]);
    if (at == settings.end()) continue;
    double scale = 0;
    const std::string& text = at->second;
    if (std::from_chars(text.data(), text.data() + text.size(), scale).ec != std::errc{} || !std::isfinite(scale) ||
        scale <= 0)
      refuse(path, fmt::format("'{:.40}' is not a distance", text));
    spacing[axis] = scale;
  }
  return spacing;
}

VolumePtr open_folder(const Path& folder, const VolumeFileOptions& options, Progress& progress) {
  std::vector<Path> tiffs, pngs, others;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Path& path = entry.path();
    if (!entry.is_regular_file() || path.filename().string().starts_with('.')) continue;
    (is_tiff(path) ? tiffs : is_png(path) ? pngs : others).push_back(path);
  }
  if (tiffs.empty() && pngs.empty()) {
    for (const Path& path : others)
      if (is_dicom(path)) return open_dicom(folder, options.series, progress);
    refuse(folder, "holds neither TIFF nor PNG slices nor a DICOM series");
  }
  if (!tiffs.empty() && !pngs.empty()) refuse(folder, "holds both TIFF and PNG files; slices of one kind are wanted");
  std::vector<Path>& files = tiffs.empty() ? pngs : tiffs;
  std::sort(files.begin(), files.end(), natural_order);
  if (files.size() > 1) require_all_slices(files);
  std::vector<SlicePtr> slices;
  for (const Path& file : files) {
    progress.check();
    progress.report(static_cast<double>(slices.size()) / static_cast<double>(files.size()), "looking at slices");
    if (pngs.empty()) {
      std::vector<SlicePtr> pages = tiff_pages(file);
      if (pages.size() > 1 && files.size() > 1)
        refuse(file, fmt::format("holds {} pictures, where each file should be one", pages.size()));
      for (SlicePtr& page : pages) slices.push_back(std::move(page));
    } else {
      slices.push_back(png_slice(file));
    }
  }
  SampleLattice lattice;
  lattice.spacing = spacing_of_folder(folder);
  return stack_of(std::move(slices), files, lattice);
}

VolumePtr open_as_is(const Path& path, const VolumeFileOptions& options, Progress& progress) {
  if (std::filesystem::is_directory(path)) return open_folder(path, options, progress);
  require_regular_file(path);
  const std::string extension = lower_extension(path);
  if (is_one_of(extension, {".raw", ".vol"})) return open_raw(path, options);
  if (extension == ".vgi") return open_vgi(path, options);
  if (is_tiff(path)) return stack_of(tiff_pages(path), {path}, {});
  if (is_one_of(extension, {".dcm", ".dicom", ".ima"})) return open_dicom(path, options.series, progress);
  if (extension == ".vdb") return open_vdb(path, progress);
  return open_with_itk(path, progress);
}

}  // namespace

VolumePtr open_volume(const Path& path, const VolumeFileOptions& options, Progress& progress) {
  VolumePtr volume = open_as_is(path, options, progress);
  if (options.spacing) volume = respaced(std::move(volume), *options.spacing);
  return straightened(std::move(volume));
}

void write_volume(const Volume& volume, const Path& path, Progress& progress) {
  write_with_itk(volume, path, progress);
}

}  // namespace fieldfab
