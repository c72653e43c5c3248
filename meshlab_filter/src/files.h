/// Files as layers, and layers as files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "filter.h"

namespace fieldfab::meshlab {

/// A kind of file, with its extensions in lower case without the dot.
struct FileKind {
  std::string description;
  std::vector<std::string> extensions;
};
std::vector<FileKind> files_read();
std::vector<FileKind> files_written();

/// Parameters of the dialogs before a file is read or written.
std::vector<Parameter> reading_parameters(const std::string& extension);
std::vector<Parameter> writing_parameters(const Document& document);

/// Throw io, bad_input, too_large, cancelled. A file is written whole or not at all.
Layer read_file_as_layer(const std::filesystem::path& file, const Values& values, std::vector<std::string>& log,
                         Progress& progress);
void write_layer_as_asdf(const Layer& layer, const std::filesystem::path& file, const Values& values,
                         std::vector<std::string>& log, Progress& progress);

}  // namespace fieldfab::meshlab
