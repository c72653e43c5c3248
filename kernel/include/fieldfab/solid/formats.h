/// The table of file formats, shared by the command, Python, FreeCAD, MeshLab and the documentation.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/core/progress.h"

namespace fieldfab {

struct Model;
struct OpenSettings;

/// Kind of content of a format.
enum class FormatKind { formula, script, design, distances, mesh, volume };
/// Returns "formula", "script", "design", "distances", "mesh" or "volume".
std::string_view name_of(FormatKind kind);

/// Reads a file as a Model. Throws as open_model().
using ModelReader =
    std::function<Model(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress)>;

/// A file format.
struct Format {
  std::vector<std::string> extensions;  ///< extensions in lower case, with the dot
  FormatKind kind;                      ///< kind of content when read
  std::optional<FormatKind> written;    ///< kind of content when written; std::nullopt: there is no writer
  std::string help;                     ///< description, one line
  ModelReader read;                     ///< null: the format is written only
  bool parts = false;                   ///< whether the format keeps several parts with their names
};

/// A table of formats, as a value: that of the kernel, or one extended by libraries above it.
class Formats {
 public:
  explicit Formats(std::vector<Format> rows) : rows_(std::move(rows)) {}

  [[nodiscard]] const std::vector<Format>& rows() const { return rows_; }
  /// Returns the format with the longest extension that matches the file name, or null. A folder has the format of
  /// volumes. The pointer is valid as long as this table.
  [[nodiscard]] const Format* find(const std::filesystem::path& path) const;
  /// Returns a copy of the table with additional rows.
  [[nodiscard]] Formats with(std::vector<Format> more) const;
  /// Returns the extensions of all readable formats, separated by spaces, for messages and help.
  [[nodiscard]] std::string readable() const;
  /// Returns the extensions of all formats to which one of these kinds is written, separated by spaces.
  [[nodiscard]] std::string writable(std::initializer_list<FormatKind> kinds) const;
  /// Returns the kind written to a file of that name, or std::nullopt if there is no writer.
  [[nodiscard]] std::optional<FormatKind> written(const std::filesystem::path& path) const;
  /// Whether a file of that name is read as that kind.
  [[nodiscard]] bool is_read_as(FormatKind kind, const std::filesystem::path& path) const;

 private:
  std::vector<Format> rows_;
};

/// Returns the formats that the kernel reads and writes itself.
const Formats& kernel_formats();

}  // namespace fieldfab
