/// Program files in any supported language.
#pragma once

#include <filesystem>
#include <vector>

#include "fieldfab/cam/simulate/setup.h"
#include "fieldfab/core/mapped_file.h"

namespace fieldfab::cam {

/// An open program file.
class ProgramFile {
 public:
  /// Throws Error(io).
  explicit ProgramFile(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] int lines() const { return lines_; }
  /// Reads it as G-code, .sbp, .rml or .hpgl by its extension, with the settings of the set-up's
  /// machine. Throws as read_gcode().
  std::vector<ReadingNote> read(const SimulationSetup& setup, const MotionSink& sink, Progress& progress) const;

 private:
  std::filesystem::path path_;
  MappedFile file_;
  int lines_;
};

}  // namespace fieldfab::cam
