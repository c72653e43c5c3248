/// Fieldfab's solids in OpenSCAD designs: the library fieldfab.scad and its imported meshes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fieldfab/core/progress.h"

namespace fieldfab::openscad {

/// Result of refresh_cache().
struct CacheReport {
  std::size_t made = 0, kept = 0;              ///< meshes made and meshes reused
  std::vector<std::filesystem::path> sources;  ///< files read: the design and the files it names
  std::vector<std::string> notes;
};

/// Provides the meshes that a design requests through fieldfab.scad. Creates missing and outdated ones in
/// fieldfab-cache/ beside the design; they are closed and manifold, as OpenSCAD's CGAL requires. Copies the library
/// beside the design if it is missing. File names in the design are relative to it; scripts are not run. Throws
/// Error(io), Error(bad_input) (also with OpenSCAD's own message), Error(cancelled).
CacheReport refresh_cache(const std::filesystem::path& design, Progress& progress = Progress::none());

/// Runs OpenSCAD to export a design to `output`, in the format of its extension. Throws as refresh_cache().
void export_design(const std::filesystem::path& design, const std::filesystem::path& output,
                   Progress& progress = Progress::none());

/// Returns the text of fieldfab.scad.
std::string library_text();

}  // namespace fieldfab::openscad
