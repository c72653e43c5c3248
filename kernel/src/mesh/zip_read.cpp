#include <fmt/format.h>
#include <zip.h>

#include <algorithm>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "zip_archive.h"

namespace fieldfab {
namespace {

constexpr std::uint64_t most_bytes = std::uint64_t{1} << 36;  // as for other mesh files
constexpr std::uint64_t always_allowed = std::uint64_t{1} << 26, most_times = 200;

}  // namespace

struct ZipReader::Archive {
  ~Archive() { zip_discard(zip); }
  [[noreturn]] void fail(const std::string& how) const { throw Error(ErrorKind::bad_input, path.string(), how); }
  [[nodiscard]] zip_int64_t find(const std::string& name) const {
    return zip_name_locate(zip, name.c_str(), ZIP_FL_NOCASE);
  }

  /// Parts may share their bytes, so all reads count together.
  void allow(std::uint64_t size) {
    if (size > most - inflated)
      throw Error(
          ErrorKind::too_large, path.string(),
          fmt::format("would inflate to more than {} bytes: {} is the most, above {} at most {} times the archive",
                      most, most_bytes, always_allowed, most_times));
    inflated += size;
  }

  std::filesystem::path path;
  zip_t* zip = nullptr;
  std::uint64_t most = 0, inflated = 0;
};

ZipReader::ZipReader(std::string_view bytes, const std::filesystem::path& path)
    : archive_(std::make_unique<Archive>()) {
  archive_->path = path;
  archive_->most = std::clamp(most_times * std::uint64_t{bytes.size()}, always_allowed, most_bytes);
  zip_error_t error;
  zip_error_init(&error);
  const std::unique_ptr<zip_error_t, void (*)(zip_error_t*)> ended(&error, zip_error_fini);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  archive_->zip = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive_->zip != nullptr) return;
  zip_source_free(source);
  archive_->fail(fmt::format("is not a zip archive, which .3mf files are: {}", zip_error_strerror(&error)));
}

ZipReader::~ZipReader() = default;

bool ZipReader::has(const std::string& name) const { return archive_->find(name) >= 0; }

void ZipReader::read(const std::string& name, const std::function<void(std::string_view)>& take) const {
  const zip_int64_t index = archive_->find(name);
  const std::string shown = printable(name);
  if (index < 0) archive_->fail(fmt::format("has no part '{:.200}'", shown));
  zip_stat_t told;
  zip_stat_init(&told);
  constexpr zip_uint64_t wanted = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_ENCRYPTION_METHOD;
  if (zip_stat_index(archive_->zip, static_cast<zip_uint64_t>(index), 0, &told) != 0 || (told.valid & wanted) != wanted)
    archive_->fail(fmt::format("does not tell the size of its part '{:.200}'", shown));
  if (told.encryption_method != ZIP_EM_NONE) archive_->fail(fmt::format("its part '{:.200}' is encrypted", shown));
  archive_->allow(told.size);
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> part(
      zip_fopen_index(archive_->zip, static_cast<zip_uint64_t>(index), 0), zip_fclose);
  if (part == nullptr)
    archive_->fail(fmt::format("its part '{:.200}' cannot be read: {}", shown, zip_strerror(archive_->zip)));
  std::string buffer(std::size_t{1} << 18, '\0');
  for (std::uint64_t left = told.size;;) {
    const zip_int64_t got = zip_fread(part.get(), buffer.data(), buffer.size());
    if (got < 0) archive_->fail(fmt::format("its part '{:.200}' is damaged: {}", shown, zip_file_strerror(part.get())));
    if (static_cast<std::uint64_t>(got) > left)
      archive_->fail(fmt::format("its part '{:.200}' is damaged: it is longer than it says", shown));
    if (got == 0) return;
    left -= static_cast<std::uint64_t>(got);
    take(std::string_view(buffer).substr(0, static_cast<std::size_t>(got)));
  }
}

}  // namespace fieldfab
