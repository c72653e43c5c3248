/// Fieldfab's solids within OpenSCAD's designs: the library fieldfab.scad and the meshes it imports.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fieldfab/core/progress.h"

namespace fieldfab::openscad {

/// What refresh_cache() did.
struct CacheReport {
  std::size_t made = 0, kept = 0;              ///< meshes
  std::vector<std::filesystem::path> sources;  ///< files that were read: the design, and what it names
  std::vector<std::string> notes;
};

/// Lets OpenSCAD find what a design asks of fieldfab.scad, and makes the meshes it lacks or whose sources have changed, in
/// fieldfab-cache/ beside it: closed and manifold, so that OpenSCAD's CGAL takes them. Puts the library beside the design where
/// there is none. A scan or formula that a design names is looked for beside it; scripts are not run. Throws io, bad_input (also
/// with OpenSCAD's own message), cancelled.
CacheReport refresh_cache(const std::filesystem::path& design, Progress& progress = Progress::none());

/// Runs OpenSCAD to make `output` of a design, by its extension. Throws as refresh_cache() does.
void export_design(const std::filesystem::path& design, const std::filesystem::path& output,
                   Progress& progress = Progress::none());

/// The text of fieldfab.scad.
std::string library_text();

}  // namespace fieldfab::openscad
