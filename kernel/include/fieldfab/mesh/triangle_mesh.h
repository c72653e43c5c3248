/// A triangle mesh as plain arrays, and its files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/progress.h"

namespace fieldfab {

/// A triangle mesh: vertices in mm, and triangles as triples of vertex indices, counter-clockwise seen from outside.
/// Positions have single precision, so that validated coordinates are those of a binary STL file, bit for bit.
struct TriangleMesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// signed volume, mm^3, by the divergence theorem; meaningful for a closed mesh
  [[nodiscard]] double volume() const;
  [[nodiscard]] double area() const;  ///< surface area, mm^2
  /// Bounding box of all vertices, mm; the zero box if there are none.
  [[nodiscard]] Box bounds() const;
};

/// Writes .stl (binary), .ply (binary), .off, .obj, .3mf or .glb, by the extension. Text formats keep the exact floats.
/// Throws Error(bad_input) for another extension, Error(too_large) beyond the limits of the format, Error(io),
/// Error(cancelled). The file is written completely or not at all. See write_mesh_parts() for parts with names and
/// colours.
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path, Progress& progress = Progress::none());

/// Reads any of these formats except .glb, text or binary. Merges vertices at equal positions. Throws Error(io),
/// Error(bad_input).
TriangleMesh read_mesh(const std::filesystem::path& path);

/// Whether `extension` (lower case, with the dot) is one of write_mesh(). This includes .glb, which read_mesh()
/// refuses.
bool is_mesh_extension(const std::string& extension);

}  // namespace fieldfab
