/// Mesh files of several parts with names and colours.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "fieldfab/core/colour.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// A mesh with what people call it.
struct MeshPart {
  TriangleMesh mesh;
  std::string name = {};                        ///< UTF-8; empty where it has none
  std::optional<Colour> colour = std::nullopt;  ///< none: readers take theirs
};

/// Writes the parts to one file; its form is chosen by the extension, as by write_mesh():
/// - .3mf: an object and an item of the build each, with names and colours (base materials);
/// - .glb: a node, a mesh and a material each, with names and colours;
/// - .obj: an object each, with names; colours in an .mtl file of the same name beside it, replacing one that is there;
/// - .ply: vertices and triangles one part after the other, colours at the vertices where a part has one;
/// - .stl, .off: triangles one part after the other.
/// One part without name and colour makes the file that write_mesh() makes. Throws bad_input for no part or another
/// extension, too_large for more than the form holds, io, cancelled. Each file is written whole or not at all, the .mtl
/// file first.
void write_mesh_parts(std::span<const MeshPart> parts, const std::filesystem::path& path, Progress& progress = Progress::none());

/// Reads a mesh file as parts. Of a .3mf file each item of the build is one, in mm, transforms carried out and components
/// merged into it: its name is that of the item's object, or else the item's part number; its colour is the base material
/// of the object, or the one that all components below it share. A name that was there before has " 2", " 3" and so on
/// appended. Items without triangles are left out. Other files are one part without a name and a colour. Vertices at the
/// same place within a part are merged. Adds to `notes` what of the file was left out, for people, one line each. Throws
/// as load_mesh().
std::vector<MeshPart> load_mesh_parts(const std::filesystem::path& path, Progress& progress, std::vector<std::string>& notes);

}  // namespace fieldfab
