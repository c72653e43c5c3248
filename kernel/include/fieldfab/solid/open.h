/// Models from files and texts.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fieldfab/frep/language.h"
#include "fieldfab/solid/formats.h"
#include "fieldfab/solid/solid.h"
#include "fieldfab/volume/scan.h"

namespace fieldfab {

/// Whether scripts may run. A .py or .ko script has all rights of its user; it runs only on explicit request.
enum class Scripts { refused, run };

/// Parameters for opening a file.
struct OpenSettings {
  Scripts scripts = Scripts::refused;
  /// Properties that the file does not state, by their names in open() of .frep text; see open_options().
  std::vector<frep::OpenOption> options = {};
  /// region to read of an .asdf file, mm: only blocks that overlap it; std::nullopt: all
  std::optional<Box> region = {};
  bool opens_others = true;          ///< whether a text or script may open() further files
  const Formats* formats = nullptr;  ///< table of formats, not owned; null: kernel_formats()
  /// Receives the path of each file read, once; not owned, may be null.
  std::vector<std::filesystem::path>* files_read = nullptr;
  /// State shared by all files of one model: the files being read and those read. Created by the first file.
  std::shared_ptr<struct OpenFiles> files = nullptr;
};

/// An option of open(), available in the command under the same name with dashes. All formats also accept `part =
/// "NAME"`.
struct OpenOptionInfo {
  std::string_view name;
  FormatKind kind;        ///< kind of the formats that accept the option
  std::string_view help;  ///< description, one line
};
/// Returns all options of open().
const std::vector<OpenOptionInfo>& open_options();

/// Extracts the options for volumes and ignores all others. Throws Error(bad_input) for an invalid value.
ScanOptions scan_options(std::span<const frep::OpenOption> options);
/// Returns the number of an option, or `otherwise` if it is absent. Throws Error(bad_input) if its value is a text.
double option_number(std::span<const frep::OpenOption> options, std::string_view name, double otherwise);

/// Reads a file of any known format. Throws Error(io), Error(bad_input) (for an unknown extension with a list of the
/// known ones), Error(cancelled).
Model open_model(const std::filesystem::path& path, const OpenSettings& settings = {},
                 Progress& progress = Progress::none());

/// Opens a file as open() of .frep text does: as one solid, or as the part selected by `part = "NAME"`. Throws
/// Error(bad_input) for scripts and for options that the format does not accept; else as open_model().
Solid open_solid(const std::filesystem::path& path, std::span<const frep::OpenOption> options,
                 const OpenSettings& settings = {}, Progress& progress = Progress::none());

/// Parses .frep text. Relative file names in open() refer to `folder`. Throws as frep::parse_parts() and open_model().
Model parse_model(std::string_view text, std::string_view name, const std::filesystem::path& folder,
                  const OpenSettings& settings = {}, Progress& progress = Progress::none());

/// Returns the errors of .frep text, as frep::diagnostics(). The result is empty exactly if parse_model() does not
/// throw.
std::vector<frep::Diagnostic> diagnose_model(std::string_view text, const std::filesystem::path& folder,
                                             const OpenSettings& settings = {}, Progress& progress = Progress::none());

/// Returns a model of one part, with the notes of the leaf.
Model model_of(const std::shared_ptr<const OpenedSolid>& opened);

/// Returns a model of one part for a leaf just read from a file, and sets the leaf's path and options accordingly.
Model model_of_file(const std::shared_ptr<OpenedSolid>& opened, const std::filesystem::path& path,
                    const OpenSettings& settings);

/// Prints a model as .frep text, which parse_model() reads back. File names are relative to `folder` if they are in it.
std::string print_model(const Model& model, const std::filesystem::path& folder = {});

}  // namespace fieldfab
