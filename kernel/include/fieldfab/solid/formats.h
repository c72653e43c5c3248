/// The one table of file formats: what the command, Python, FreeCAD, MeshLab and the docs know of them.
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

/// What a format holds.
enum class FormatKind { formula, script, design, distances, mesh, volume };
/// "formula", "script", "design", "distances", "mesh", "volume".
std::string_view name_of(FormatKind kind);

using ModelReader = std::function<Model(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress)>;

struct Format {
  std::vector<std::string> extensions;  ///< in lower case, with the dot
  FormatKind kind;                      ///< what it is read as
  std::optional<FormatKind> written;    ///< what is written to it; nothing where there is no writer
  std::string help;                     ///< one line
  ModelReader read;                     ///< null where it is only written
  bool parts = false;                   ///< whether several parts stay apart in it, with their names
};

/// A table of formats, as a value: the kernel's own, or those with what libraries above it can read.
class Formats {
 public:
  explicit Formats(std::vector<Format> rows) : rows_(std::move(rows)) {}

  [[nodiscard]] const std::vector<Format>& rows() const { return rows_; }
  /// The format of a file's name, or null: the longest extension that fits. A folder is a volume's.
  [[nodiscard]] const Format* find(const std::filesystem::path& path) const;
  /// The same table with more rows.
  [[nodiscard]] Formats with(std::vector<Format> more) const;
  /// ".math .vm .frep ..." of all formats that are read; for messages and help.
  [[nodiscard]] std::string readable() const;
  /// The extensions of all formats that what is of these kinds is written to.
  [[nodiscard]] std::string writable(std::initializer_list<FormatKind> kinds) const;
  /// What is written to a file of that name; nothing where there is no writer for it.
  [[nodiscard]] std::optional<FormatKind> written(const std::filesystem::path& path) const;
  /// Whether a file of that name is read as that kind.
  [[nodiscard]] bool is_read_as(FormatKind kind, const std::filesystem::path& path) const;

 private:
  std::vector<Format> rows_;
};

/// What the kernel reads and writes by itself.
const Formats& kernel_formats();

}  // namespace fieldfab
