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

/// Whether a model may be a program: a .py or .ko script can do anything its user can, so only those run it who were told to by
/// name.
enum class Scripts { refused, run };

/// How a file is opened.
struct OpenSettings {
  Scripts scripts = Scripts::refused;
  /// What a file does not tell by itself, by the names that open() has in .frep text: see open_options().
  std::vector<frep::OpenOption> options = {};
  std::optional<Box> region = {};    ///< mm; of an .asdf file only the blocks that meet it
  bool opens_others = true;          ///< whether a text or script may open() further files
  const Formats* formats = nullptr;  ///< those that are known; null: the kernel's own
  /// Gets the paths of all files that are read, each once.
  std::vector<std::filesystem::path>* files_read = nullptr;
  /// What all files of one model share: which are being read, and which were. Made by the first.
  std::shared_ptr<struct OpenFiles> files = nullptr;
};

/// An option of open() (`part = "NAME"` is one besides, of all formats), and of the command by the same name with dashes.
struct OpenOptionInfo {
  std::string_view name;
  FormatKind kind;        ///< of formats that take it
  std::string_view help;  ///< one line
};
const std::vector<OpenOptionInfo>& open_options();

/// How to take a volume, from the options that say so; others are left aside. Throws bad_input for a value that means nothing.
ScanOptions scan_options(std::span<const frep::OpenOption> options);
/// The number of an option, or what stands in for it. Throws bad_input for words.
double option_number(std::span<const frep::OpenOption> options, std::string_view name, double otherwise);

/// Reads a file of any known format. Throws io, bad_input (also for an extension that no format has, with a list of those known),
/// cancelled.
Model open_model(const std::filesystem::path& path, const OpenSettings& settings = {}, Progress& progress = Progress::none());

/// Opens a file as open() of .frep text does: as one solid, or the one that `part = "NAME"` asks for. Scripts are refused, and so
/// is an option that the format does not have.
Solid open_solid(const std::filesystem::path& path, std::span<const frep::OpenOption> options, const OpenSettings& settings = {},
                 Progress& progress = Progress::none());

/// The model of .frep text. open() in it takes names relative to `folder`. Throws as frep::parse_parts() and open_model() do.
Model parse_model(std::string_view text, std::string_view name, const std::filesystem::path& folder,
                  const OpenSettings& settings = {}, Progress& progress = Progress::none());

/// The mistakes of .frep text, as frep::diagnostics() tells them; there is none exactly where parse_model() throws none.
std::vector<frep::Diagnostic> diagnose_model(std::string_view text, const std::filesystem::path& folder,
                                             const OpenSettings& settings = {}, Progress& progress = Progress::none());

/// A leaf as a model of one part, with its notes.
Model model_of(const std::shared_ptr<const OpenedSolid>& opened);

/// The same of a leaf that was just made from a file, which is named by it from then on.
Model model_of_file(const std::shared_ptr<OpenedSolid>& opened, const std::filesystem::path& path, const OpenSettings& settings);

/// The model as .frep text, which parse_model() reads back; files are named relative to `folder` where they are in it.
std::string print_model(const Model& model, const std::filesystem::path& folder = {});

}  // namespace fieldfab
