/// OpenSCAD designs as solids.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/openscad/tree.h"
#include "fieldfab/solid/formats.h"
#include "fieldfab/solid/solid.h"

namespace fieldfab::openscad {

struct DesignOptions {
  /// whether circles, spheres, cylinders and solids of revolution are exact instead of faceted as in OpenSCAD
  bool smooth = false;
  bool formulas_only = false;  ///< whether a design without an equivalent formula is an error (bad_input)
};

/// Reads a .csg file, or a .scad file through the installed `openscad`. Throws Error(io), Error(bad_input) (also with
/// OpenSCAD's own message), Error(cancelled).
Tree read_tree(const std::filesystem::path& path, Progress& progress = Progress::none());

/// Returns the number of dimensions of each node's shape: 2 or 3, or 0 for an empty one. Throws Error(bad_input) with
/// FILE:LINE for an unknown node.
std::vector<int> dimensions_of(const Tree& tree);

/// Returns the solid of a tree.
/// - It has a formula if the whole tree has one.
/// - Its voxel resolves the thinnest part, unless that needs too many cells.
/// - Its Field is null for an empty design.
/// - Its notes start with FILE:LINE.
/// Imported file names are relative to `folder`. Throws Error(bad_input) with FILE:LINE for unknown or invalid nodes,
/// Error(io) for a missing file, Error(cancelled).
std::shared_ptr<OpenedSolid> make_design(const Tree& tree, const std::filesystem::path& folder,
                                         const DesignOptions& options = {}, Progress& progress = Progress::none());

/// Returns all formats: those of the kernel, and .csg and .scad.
const Formats& all_formats();

}  // namespace fieldfab::openscad
