/// Shapes from files and fonts.
#pragma once

#include <filesystem>

#include "arguments.h"
#include "fieldfab/core/progress.h"
#include "polyhedron.h"

namespace fieldfab::openscad {

/// Whether import() of this file gives a flat shape (.dxf and .svg).
bool is_flat_file(const std::string& file);

/// Lets OpenSCAD draw a flat node: text(), for its fonts, and import() of .dxf and .svg. File names
/// are relative to `folder`. Throws io if openscad is not installed.
Region drawn_by_openscad(const Tree& tree, NodeIndex node, const std::filesystem::path& folder, Progress& progress);

/// Reads the mesh of import(): .stl, .off, .obj and .3mf by our own readers, other formats through
/// OpenSCAD.
Polyhedron import_mesh(const std::filesystem::path& file, Progress& progress);

/// Returns the block of surface(): the heights of a .dat file of numbers or a .png picture, on a
/// floor below the lowest one.
Polyhedron surface(const std::filesystem::path& file, bool centre, bool invert);

}  // namespace fieldfab::openscad
