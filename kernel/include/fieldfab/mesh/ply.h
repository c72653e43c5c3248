/// PLY files that say more of a mesh's vertices than where they are.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "fieldfab/core/colour.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// What is known of each vertex; each property has one entry for each; without colours there are none.
struct VertexProperties {
  std::span<const Colour> colours;
  std::vector<std::pair<std::string, std::span<const float>>> floats = {};  ///< names without spaces, and values
  std::vector<std::pair<std::string, std::span<const int>>> integers = {};
};

/// Writes a binary .ply with these properties of its vertices, after their places and in this order. Throws bad_input where a
/// property does not have a value for each vertex, io, cancelled. The file is written whole or not at all.
void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path, const VertexProperties& properties,
               Progress& progress = Progress::none());

}  // namespace fieldfab
