#include "volume/read_in_copy.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

#include "fieldfab/core/copy_of_process.h"
#include "fieldfab/core/file.h"

namespace fieldfab {
namespace {

/// Text of at most a fixed length: its end is cut off.
template <std::size_t most>
class FixedText {
 public:
  void operator=(std::string_view text) { text_[std::min(text.copy(text_.data(), most - 1), most - 1)] = '\0'; }
  [[nodiscard]] std::string str() const { return text_.data(); }

 private:
  std::array<char, most> text_{};
};

/// What a copy tells of its reading; in memory that it shares with the original.
struct Told {
  enum class Outcome { none, read, refused, out_of_memory } outcome = Outcome::none;
  Samples samples;
  ErrorKind kind{};
  FixedText<8192> place;
  FixedText<4096> message;

  void error(const Error& error) {
    place = error.place();
    message = std::string_view(error.what()).substr(error.place().empty() ? 0 : error.place().size() + 2);
    kind = error.kind();
    outcome = Outcome::refused;
  }
};

/// A mapping of shared memory.
template <class T>
std::shared_ptr<T> mapped(std::size_t bytes, int protection, int flags, int descriptor) {
  void* const memory = mmap(nullptr, bytes, protection, MAP_SHARED | flags, descriptor, 0);
  if (memory == MAP_FAILED) return nullptr;
  return {static_cast<T*>(memory), [bytes](T* all) { munmap(const_cast<std::remove_const_t<T>*>(all), bytes); }};
}

/// Memory for densities whose amount the copy decides.
class SharedDensities {
 public:
  SharedDensities() : descriptor_(memfd_create("fieldfab densities", MFD_CLOEXEC)) {}
  ~SharedDensities() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  SharedDensities(const SharedDensities&) = delete;
  SharedDensities& operator=(const SharedDensities&) = delete;

  [[nodiscard]] bool possible() const { return descriptor_ >= 0; }
  /// In the copy.
  [[nodiscard]] float* room(std::size_t count) const {
    const std::size_t bytes = count * sizeof(float);
    require_memory(bytes, "volume");
    int failed = 0;
    while ((failed = posix_fallocate(descriptor_, 0, static_cast<off_t>(bytes))) == EINTR) {
    }
    void* const memory =
        failed != 0 ? MAP_FAILED : mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    return static_cast<float*>(memory);
  }
  /// In the original: what the copy made; null for nothing.
  [[nodiscard]] std::shared_ptr<const float> all() const {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0 || status.st_size == 0) return nullptr;
    auto densities = mapped<const float>(static_cast<std::size_t>(status.st_size), PROT_READ, 0, descriptor_);
    if (!densities) throw std::bad_alloc();
    return densities;
  }

 private:
  int descriptor_;
};

WhatWasRead read_here(const Reader& reader) {
  WhatWasRead made;
  made.samples = reader([&](std::size_t count) {
    auto densities = std::make_shared<std::vector<float>>(count);
    float* const first = densities->data();
    made.densities = {std::move(densities), first};
    return first;
  });
  return made;
}

}  // namespace

void refuse_crashed(const Path& path, const char* library) {
  refuse(path, fmt::format("is damaged: {}, which reads it, gives up at it", library));
}

WhatWasRead read_in_copy(const Path& path, const char* library, const Reader& reader, Progress& progress) {
  const auto memory = mapped<Told>(sizeof(Told), PROT_READ | PROT_WRITE, MAP_ANONYMOUS, -1);
  const SharedDensities shared;
  if (!memory || !shared.possible()) return read_here(reader);
  Told& told = *new (memory.get()) Told;
  const auto read = [&] {
    try {
      told.samples = reader([&](std::size_t count) { return shared.room(count); });
      told.outcome = Told::Outcome::read;
    } catch (const Error& error) {
      told.error(error);
    } catch (const std::bad_alloc&) {
      told.outcome = Told::Outcome::out_of_memory;
    }
  };
  progress.report(0, "reading " + path.filename().string());
  const CopyEnd end = run_in_copy(read, progress);
  if (end == CopyEnd::unknown) return read_here(reader);
  if (end == CopyEnd::completed) switch (told.outcome) {
      case Told::Outcome::read: return {told.samples, shared.all()};
      case Told::Outcome::refused: throw Error(told.kind, told.place.str(), told.message.str());
      case Told::Outcome::out_of_memory: throw std::bad_alloc();
      case Told::Outcome::none: break;
    }
  refuse_crashed(path, library);
}

VolumePtr volume_read_in_copy(const Path& path, const char* library, const Reader& reader, Progress& progress) {
  auto [samples, densities] = read_in_copy(path, library, reader, progress);
  return volume_in(std::move(densities), samples.lattice, samples.own_threshold, samples.type);
}

}  // namespace fieldfab
