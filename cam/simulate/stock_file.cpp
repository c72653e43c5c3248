#include <cctype>

#include "fieldfab/cam/simulate/picture.h"
#include "fieldfab/mesh/ply.h"

namespace fieldfab::cam {

void write_stock_mesh(const Simulation& simulation, const std::filesystem::path& path, Progress& progress) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension != ".ply") return write_mesh(simulation.mesh(), path, progress);
  const std::vector<Colour> colours = vertex_colours(simulation, default_colouring(simulation));
  VertexProperties properties{colours};
  if (const auto& deviation = simulation.report().deviation) properties.floats.emplace_back("deviation", deviation->at_vertex);
  properties.integers.emplace_back("line", simulation.lines_of_vertices());
  properties.integers.emplace_back("tool", simulation.tools_of_vertices());
  write_ply(simulation.mesh(), path, properties, progress);
}

}  // namespace fieldfab::cam
