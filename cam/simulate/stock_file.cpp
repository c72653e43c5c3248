#include <cctype>

#include "fieldfab/cam/simulate/picture.h"
#include "fieldfab/core/lower_case.h"
#include "fieldfab/mesh/ply.h"

namespace fieldfab::cam {

void write_stock_mesh(const SimulationResult& result, const std::filesystem::path& path, Progress& progress) {
  const std::string extension = lower_extension(path);
  if (extension == ".fieldstock") return write_stock(result.stock(), path);
  if (extension != ".ply") return write_mesh(result.surface().mesh, path, progress);
  const std::vector<Colour> colours = vertex_colours(result, default_colouring(result));
  const std::vector<int> lines = result.lines_of_vertices(), tools = result.tools_of_vertices();
  VertexProperties properties{colours};
  if (const auto& deviation = result.report().deviation)
    properties.floats.emplace_back("deviation", deviation->at_vertex);
  properties.integers.emplace_back("line", lines);
  properties.integers.emplace_back("tool", tools);
  write_ply(result.surface().mesh, path, properties, progress);
}

}  // namespace fieldfab::cam
