/// PLY files with additional vertex properties.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "fieldfab/core/colour.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Properties of vertices. Each span has one entry per vertex; `colours` may be empty. Spans are not owned.
struct VertexProperties {
  std::span<const Colour> colours;
  std::vector<std::pair<std::string, std::span<const float>>> floats = {};  ///< names without spaces, and values
  std::vector<std::pair<std::string, std::span<const int>>> integers = {};
};

/// Writes a binary .ply file with these properties after the coordinates, in this order. Throws Error(bad_input) if a
/// property does not have one value per vertex, Error(io), Error(cancelled). The file is written completely or not at
/// all.
void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path, const VertexProperties& properties,
               Progress& progress = Progress::none());

}  // namespace fieldfab
