/// Other programs, run without a shell; private.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/core/temporary.h"

namespace fieldfab::openscad {

/// A temporary folder, removed with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  [[nodiscard]] const std::filesystem::path& path() const { return folder_->path(); }

 private:
  std::optional<Temporary> folder_;
};

/// Runs the installed `openscad` to make `output` from `input`, and waits. Returns its messages.
/// Throws bad_input with its message if it fails or makes no file, io if it is not installed, and
/// cancelled, which ends it.
std::string run_openscad(const std::filesystem::path& input, const std::filesystem::path& output, Progress& progress,
                         const std::vector<std::string>& options = {});

}  // namespace fieldfab::openscad
