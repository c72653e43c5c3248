/// Shapes that come from files and fonts.
#pragma once

#include <filesystem>

#include "arguments.h"
#include "fieldfab/core/progress.h"
#include "polyhedron.h"

namespace fieldfab::openscad {

/// Whether import() of this file gives a flat shape (.dxf and .svg).
bool is_flat_file(const std::string& file);

/// A flat node as OpenSCAD itself draws it: text(), whose fonts it finds, and import() of .dxf and .svg. `folder` is where files
/// are looked for. Throws io where openscad is not installed.
Region drawn_by_openscad(const Tree& tree, NodeIndex node, const std::filesystem::path& folder, Progress& progress);

/// The mesh of import(): .stl, .off, .obj and .3mf by our own readers, others through OpenSCAD.
Polyhedron import_mesh(const std::filesystem::path& file, Progress& progress);

/// The block of surface(): heights of a .dat file of numbers or a .png picture, on a floor below the least of them.
Polyhedron surface(const std::filesystem::path& file, bool centre, bool invert);

}  // namespace fieldfab::openscad
