/// A design of OpenSCAD as a solid.
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
  bool smooth = false;         ///< circles, spheres, cylinders and turned shapes round, not faceted as OpenSCAD draws them
  bool formulas_only = false;  ///< throw bad_input rather than give what has no formula
};

/// Reads a .csg file, or a .scad file through the installed `openscad`. Throws io, bad_input: also with OpenSCAD's own message
/// where it fails.
Tree read_tree(const std::filesystem::path& path, Progress& progress = Progress::none());

/// How many dimensions each node's shape has: 2 or 3, or 0 where it draws nothing. Throws bad_input with FILE:LINE for what is
/// unknown.
std::vector<int> dimensions_of(const Tree& tree);

/// The solid of a tree, with its formula where all of it has one; its voxel is one that does not miss its thinnest part, where
/// that does not take too many; notes have FILE:LINE. Its Field is null where the design is empty. `folder` is where the files
/// that it imports are looked for. Throws bad_input with FILE:LINE for what is unknown or cannot be, io for a missing file,
/// cancelled.
std::shared_ptr<OpenedSolid> make_design(const Tree& tree, const std::filesystem::path& folder, const DesignOptions& options = {},
                                         Progress& progress = Progress::none());

/// The kernel's formats, and .csg and .scad files: all that there are.
const Formats& all_formats();

}  // namespace fieldfab::openscad
