/// A triangle mesh as plain arrays, its files, and its view as an OpenMesh.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/progress.h"

namespace fieldfab {

/// Vertices in mm and triangles as triples of vertex indices, counter-clockwise seen from outside.
/// Positions are single precision, so that what is validated is bit for bit what a binary STL holds.
struct TriangleMesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  [[nodiscard]] double volume() const;  ///< signed, mm^3; the divergence theorem
  [[nodiscard]] double area() const;    ///< mm^2
  [[nodiscard]] Box bounds() const;
};

/// Writes .stl (binary), .ply (binary), .off, .obj, .3mf or .glb, by the extension; text forms carry the exact floats.
/// Throws bad_input for another extension, too_large for more than the form holds, io, cancelled. The file is written
/// whole or not at all. For parts with names and colours there is write_mesh_parts().
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path, Progress& progress = Progress::none());

/// Reads any of these forms but .glb (text or binary). Vertices at the same place are merged. Throws io, bad_input.
TriangleMesh read_mesh(const std::filesystem::path& path);

/// The extensions that write_mesh() knows, with the dot, in lower case; read_mesh() says of .glb that it is not read.
bool is_mesh_extension(const std::string& extension);

}  // namespace fieldfab
