/// Pictures of simulated stock, coloured by origin or by deviation from the target, with events marked.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/render/triangles.h"

namespace fieldfab::cam {

/// Colouring of a finished stock.
enum class StockColouring : std::uint8_t {
  deviation,  ///< deviation from the target, see DeviationScale
  tool,       ///< tool that made the surface
  line,       ///< program line, from violet (first) over green to yellow (last)
};
/// Returns `deviation` if there is a target, otherwise `tool` if several have cut, otherwise `line`.
StockColouring default_colouring(const SimulationResult& result);

/// Colour scale of deviations: grey within tolerances, red for gouges, blue for excess material. Colours are pale just
/// above the tolerance, so that its limit is visible, and saturated from `full` on.
struct DeviationScale {
  double gouge = 0, excess = 0;  ///< tolerances, both not negative, mm
  double full = 1;               ///< mm

  /// Returns the scale for a result. Tolerances are those of the set-up; that of gouges also applies to excess if any
  /// excess is permitted. `full` is a round number between 4 and 20 tolerances, near the deepest gouge or, without
  /// gouges, the highest excess.
  static DeviationScale of(const SimulationResult& result);
  /// Returns the colour of a deviation in mm, negative in a gouge; the colour within tolerances for NaN.
  [[nodiscard]] Colour colour(double deviation) const;
};

/// Returns the colour of a tool by its position in the set-up, from a cyclic palette. 0 is the initial surface of the
/// stock.
Colour colour_of_tool(std::size_t place_in_set_up);
/// Returns the colour of a program line by its relative position between the first (0) and the last (1) that cut.
Colour colour_of_line(double share);

/// Returns a colour per vertex of the result's surface. A vertex that no line has cut has the colour of tool 0, except
/// for deviations. Throws Error(bad_input) for deviations without a target.
std::vector<Colour> vertex_colours(const SimulationResult& result, StockColouring colouring);

/// Returns the indices of the events to mark: the worst of each kind, then the second worst of each, with one per
/// neighbourhood, at most `most`.
std::vector<std::size_t> worst_events(const SimulationResult& result, std::size_t most = 9);

/// View and content of a picture.
struct StockPictureSettings {
  int size = 1024;                                         ///< longer side, pixels
  double alpha = 0.5;                                      ///< rotation about z, radians
  double beta = -0.95;                                     ///< then rotation about x, radians
  std::optional<StockColouring> colouring = std::nullopt;  ///< default: default_colouring()
  /// whether to number worst_events() as in the report, whose first event is 1
  bool marks = true;
  double aspect = 0;  ///< width divided by height; 0: that of the remaining stock
  /// window in the picture's plane, as in RenderSettings; `aspect` is then ignored
  std::optional<Box> window = std::nullopt;
};

/// Renders a shaded picture of the finished stock. Marks are rings with numbers; the number of a hidden place is pale.
/// Throws Error(bad_input), Error(cancelled).
TrianglePicture stock_picture(const SimulationResult& result, const StockPictureSettings& settings = {},
                              Progress& progress = Progress::none());

/// Whether the position of an event is visible in such a picture.
bool shows_event(const SimulationResult& result, const TrianglePicture& picture, const SimulationEvent& event);

/// Writes the picture as .png; if it is coloured by deviation, with a legend. Throws Error(bad_input) for another
/// extension, or as stock_picture() does, Error(io), Error(cancelled).
void write_stock_picture(const SimulationResult& result, const std::filesystem::path& path,
                         const StockPictureSettings& settings = {}, Progress& progress = Progress::none());

/// Writes the finished stock as a mesh, in the formats of write_mesh(). A .ply has vertex colours of
/// default_colouring(), the `deviation` in mm if there is a target, and the program `line` and `tool` of each vertex.
/// Throws Error(bad_input) for another extension, Error(io), Error(cancelled).
void write_stock_mesh(const SimulationResult& result, const std::filesystem::path& path,
                      Progress& progress = Progress::none());

}  // namespace fieldfab::cam
