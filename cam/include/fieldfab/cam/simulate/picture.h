/// Pictures of simulated stock: what is left, coloured by what made it or by how far it is from the target, wrong places marked.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/render/triangles.h"

namespace fieldfab::cam {

/// What the colours of a finished stock tell.
enum class StockColouring : std::uint8_t {
  deviation,  ///< from the target, see DeviationScale
  tool,       ///< which tool made the place
  line,       ///< the program's lines, from violet (first) over green to yellow (last)
};
/// The deviation where there is a target; else the tool where several have cut, else the line.
StockColouring default_colouring(const SimulationResult& result);

/// From deviations to colours: grey within the tolerances, red where too much is gone, blue where something is left over; both
/// begin pale at the tolerance, so that its edge is seen, and are full at `full` and beyond.
struct DeviationScale {
  double gouge = 0, excess = 0;  ///< tolerances, mm
  double full = 1;               ///< mm

  /// By the set-up's tolerances (that of gouges where any excess is allowed) and what there is: `full` is a round number from
  /// 4 tolerances on, about the deepest gouge or, without gouges, the highest excess, and at most 20 tolerances.
  static DeviationScale of(const SimulationResult& result);
  [[nodiscard]] Colour colour(double deviation) const;
};

/// The colour of a tool in pictures: some are told apart, then they begin again. 0: the stock's first surface.
Colour colour_of_tool(std::size_t place_in_set_up);
/// The colour of a line, by its share of the way from the first that cuts (0) to the last (1).
Colour colour_of_line(double share);

/// Of the mesh's vertices. Throws bad_input for deviations where there is no target.
std::vector<Colour> vertex_colours(const SimulationResult& result, StockColouring colouring);

/// The events that pictures mark, as indices into the report's: the worst of each kind, then the next worst of each, but only one
/// of a neighbourhood.
std::vector<std::size_t> worst_events(const SimulationResult& result, std::size_t most = 9);

/// From where a stock is seen, and how it is shown.
struct StockPictureSettings {
  int size = 1024;                                         ///< pixels of the longer side
  double alpha = 0.5;                                      ///< turn about z, radians
  double beta = -0.95;                                     ///< then tilt about x, radians
  std::optional<StockColouring> colouring = std::nullopt;  ///< nothing: default_colouring()
  bool marks = true;                         ///< number the places of worst_events(), as the report does: its first event is 1
  double aspect = 0;                         ///< width over height; 0: as what is left has it
  std::optional<Box> window = std::nullopt;  ///< of the picture's plane, as RenderSettings has it; then `aspect` does not count
};

/// A shaded picture of the finished stock. Marks are rings with a number beside them; where the place is hidden
/// the number is pale. Throws bad_input, cancelled.
TrianglePicture stock_picture(const SimulationResult& result, const StockPictureSettings& settings = {},
                              Progress& progress = Progress::none());

/// Whether such a picture shows the place of an event.
bool shows_event(const SimulationResult& result, const TrianglePicture& picture, const SimulationEvent& event);

/// The same as a .png, what the colours of deviations mean below it. Throws bad_input for another extension, io.
void write_stock_picture(const SimulationResult& result, const std::filesystem::path& path,
                         const StockPictureSettings& settings = {}, Progress& progress = Progress::none());

/// The finished stock as a mesh, as write_mesh() does. In a .ply vertices also have default_colouring()'s colours, where there is
/// a target their `deviation`, mm, and the program's `line` and the `tool` that made them. Throws bad_input for another
/// extension, io, cancelled.
void write_stock_mesh(const SimulationResult& result, const std::filesystem::path& path, Progress& progress = Progress::none());

}  // namespace fieldfab::cam
