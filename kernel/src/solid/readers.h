/// Readers of the kernel's formats.
#pragma once

#include "fieldfab/solid/open.h"

namespace fieldfab {

Model read_math(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress);
Model read_vm(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress);
Model read_frep(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress);
Model read_script(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress);
Model read_asdf(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress);
Model read_mesh_file(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress);
Model read_volume(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress);

}  // namespace fieldfab
