/// Other programs, run without a shell; private.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/core/temporary.h"

namespace fieldfab::openscad {

/// A folder of our own that goes with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  [[nodiscard]] const std::filesystem::path& path() const { return folder_->path(); }

 private:
  std::optional<Temporary> folder_;
};

/// Runs the installed `openscad` to make `output` of `input`, and waits. Returns what it said. Throws bad_input with its message
/// where it fails or makes nothing, io where it is not installed, cancelled (it is ended then).
std::string run_openscad(const std::filesystem::path& input, const std::filesystem::path& output, Progress& progress,
                         const std::vector<std::string>& options = {});

}  // namespace fieldfab::openscad
