/// Mesh files with several named and coloured parts.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "fieldfab/core/colour.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// A mesh with a name and a colour.
struct MeshPart {
  TriangleMesh mesh;
  std::string name = {};                        ///< UTF-8; may be empty
  std::optional<Colour> colour = std::nullopt;  ///< std::nullopt: the reader's default colour
};

/// Writes the parts to one file. The extension selects the format, as in write_mesh():
/// - .3mf: an object and a build item per part, with names and colours (base materials);
/// - .glb: a node, a mesh and a material per part, with names and colours;
/// - .obj: an object per part, with names; colours go to an .mtl file of the same base name, which is replaced;
/// - .ply: vertices and triangles of all parts in sequence, with vertex colours if a part has a colour;
/// - .stl, .off: triangles of all parts in sequence.
/// One part without name and colour gives the file of write_mesh(). Throws Error(bad_input) for no parts or an unknown
/// extension, Error(too_large) beyond the limits of the format, Error(io), Error(cancelled). Each file is written
/// completely or not at all, the .mtl file first.
void write_mesh_parts(std::span<const MeshPart> parts, const std::filesystem::path& path,
                      Progress& progress = Progress::none());

/// Reads a mesh file as parts. Each build item of a .3mf file is a part in mm, with transforms applied and components
/// merged. Its name is that of the object, otherwise the item's part number; its colour is the base material of the
/// object, or the one shared by all its components. A repeated name gets " 2", " 3" and so on. Items without triangles
/// are omitted. Other files give one part without name and colour. Vertices at equal positions within a part are
/// merged. Appends omitted content to `notes`, for people, one line each. Throws as load_mesh().
std::vector<MeshPart> load_mesh_parts(const std::filesystem::path& path, Progress& progress,
                                      std::vector<std::string>& notes);

}  // namespace fieldfab
