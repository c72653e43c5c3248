/// Reading of volumes by libraries in a copy of this process: a damaged file may make them abort, or overwrite memory,
/// which then is the copy's.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "volume/readers.h"

namespace fieldfab {

/// What a reader knows of the samples in a file.
struct Samples {
  SampleLattice lattice;
  SampleType type = SampleType::float32;
  std::optional<double> own_threshold = {};
};

/// Returns memory for that many densities, which outlives the copy. Called at most once. Throws Error(too_large).
using Room = std::function<float*(std::size_t count)>;

/// Reads a file: the densities into room, or only what is known of them. It runs in a copy of this process, or in this
/// one where there can be no copy. What must not be destroyed in a copy, since that would use threads, belongs to the
/// caller.
using Reader = std::function<Samples(const Room& room)>;

/// What a reader returned and wrote.
struct WhatWasRead {
  Samples samples;
  std::shared_ptr<const float> densities;  ///< null if the reader wrote none
};

/// Throws Error(bad_input): the library crashed at this file.
[[noreturn]] void refuse_crashed(const Path& path, const char* library);

/// Runs a reader of `path`. Throws what it throws; refuse_crashed() if the library crashed; Error(cancelled) within
/// 50 ms of cancellation.
WhatWasRead read_in_copy(const Path& path, const char* library, const Reader& reader, Progress& progress);

/// Runs a reader that writes densities, and returns the volume.
VolumePtr volume_read_in_copy(const Path& path, const char* library, const Reader& reader, Progress& progress);

}  // namespace fieldfab
