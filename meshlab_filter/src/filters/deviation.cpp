// Deviation of a layer from its target.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "../solids.h"
#include "all.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/surface_distance.h"
#include "fieldfab/mesh/mesh_field.h"

namespace fieldfab::meshlab {
namespace {

std::vector<Parameter> deviation_parameters(const Document& document) {
  std::size_t other = document.current;
  if (document.layers.size() > 1) other = document.current == 0 ? 1 : 0;
  const double diagonal = document.chosen().bounds.valid() ? document.chosen().bounds.diagonal() : 100;
  return {choice_parameter("Reference", "Measured from", "The surface that the layer is compared with.",
                           {"a layer", "a formula or file"}),
          layer_parameter("Layer", "Reference layer", "May be open; the volume that it encloses is inside.", other),
          text_parameter(
              "Formula", "Formula or file",
              "The language of docs/frep-language.md, or the path of a .frep, .math, .vm, .asdf, mesh or volume file. "
              "Distances to these are limited to 10 mm.",
              ""),
          length_parameter("Range", "Ends of the colour ramp (mm)",
                           "Dark blue is this far inside, dark red this far outside; 0 takes the largest deviation.", 0,
                           0, diagonal)};
}

/// Blue inside, nearly white on the target, red outside: the colours of the FreeCAD workbench.
Colour colour(double share) {
  constexpr double stops[5][3] = {
      {0.10, 0.25, 0.80}, {0.35, 0.70, 0.95}, {0.92, 0.95, 0.92}, {0.98, 0.70, 0.25}, {0.80, 0.10, 0.08}};
  const double at = (std::clamp(share, -1.0, 1.0) + 1) * 2;
  const int stop = std::min(3, static_cast<int>(at));
  Colour mixed;
  for (std::size_t c = 0; c < 3; ++c)
    mixed[c] = static_cast<std::uint8_t>(
        std::lround(255 * (stops[stop][c] + (at - stop) * (stops[stop + 1][c] - stops[stop][c]))));
  return mixed;
}

/// The largest deviation, rounded up to 1, 2 or 5 times a power of ten.
double nice_range(double most) {
  if (!(most > 0)) return 1e-6;
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= most * 0.999) return step * power;
  return 10 * power;
}

std::vector<float> distances_to(const FieldPtr& field, bool exact, const std::vector<std::array<float, 3>>& places,
                                Progress& progress) {
  std::vector<float> found(places.size());
  constexpr std::size_t part = 4096;
  std::atomic<std::size_t> done{0};
  parallel_for((places.size() + part - 1) / part, [&](std::size_t n) {
    progress.check();
    const std::size_t first = n * part, count = std::min(part, places.size() - first);
    if (exact) {
      std::vector<float> x(count), y(count), z(count);
      for (std::size_t i = 0; i < count; ++i)
        x[i] = places[first + i][0], y[i] = places[first + i][1], z[i] = places[first + i][2];
      field->values({x.data(), y.data(), z.data(), count}, &found[first]);
    } else {
      surface_distances(*field, {&places[first], count}, {&found[first], count});
    }
    progress.report(static_cast<double>(done += count) / static_cast<double>(places.size()), "measuring distances");
  });
  return found;
}

void tell_histogram(const std::vector<float>& distances, double range, std::vector<std::string>& log) {
  constexpr int bins = 10;
  std::vector<std::size_t> counts(bins, 0);
  for (const float d : distances)
    if (std::isfinite(d)) ++counts[static_cast<std::size_t>(std::clamp((d / range + 1) / 2 * bins, 0.0, bins - 1.0))];
  const std::size_t most = std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  for (int bin = 0; bin < bins; ++bin) {
    const double low = range * (2.0 * bin / bins - 1), high = range * (2.0 * (bin + 1) / bins - 1);
    const std::size_t count = counts[static_cast<std::size_t>(bin)];
    log.push_back(
        fmt::format("{:>9.3g} to {:>9.3g} mm {:>8} {}", low, high, count, std::string(count * 40 / most, '#')));
  }
}

Result run_deviation(const Values& values, Progress& progress) {
  Result result;
  const double wanted = values.not_negative("Range");
  const Layer& layer = values.layer();
  if (layer.mesh.vertices.empty()) throw Error(ErrorKind::bad_input, "layer '" + layer.name + "'", "has no vertices");
  const bool from_layer = values.whole("Reference") == 0;
  std::string reference;
  FieldPtr field;
  if (from_layer) {
    const Layer& other = values.layer("Layer");
    field = mesh_field(usable_triangles(other, result.log), progress);
    reference = "layer '" + other.name + "'";
  } else {
    field = united(model_of_text(values.text("Formula"), progress)).field;
    reference = values.text("Formula");
  }
  result.quality = distances_to(field, from_layer, layer.mesh.vertices, progress);
  double least = HUGE_VAL, most = -HUGE_VAL, sum = 0, squares = 0;
  std::size_t nowhere = 0;
  for (const float d : result.quality) {
    if (!std::isfinite(d)) {
      ++nowhere;
      continue;
    }
    least = std::min<double>(least, d), most = std::max<double>(most, d), sum += d,
    squares += static_cast<double>(d) * d;
  }
  const auto count = static_cast<double>(result.quality.size() - nowhere);
  if (count == 0) throw Error(ErrorKind::bad_input, "layer '" + layer.name + "'", "has no vertex at a finite place");
  const double range = wanted > 0 ? wanted : nice_range(std::max(std::abs(least), std::abs(most)));
  result.log.push_back(fmt::format("Deviation of '{}' from {}, at {} vertices; below 0 is inside", layer.name,
                                   reference, static_cast<std::size_t>(count)));
  result.log.push_back(fmt::format("least {:.6g} mm, most {:.6g} mm, mean {:.6g} mm, root mean square {:.6g} mm", least,
                                   most, sum / count, std::sqrt(squares / count)));
  if (nowhere > 0) result.log.push_back(fmt::format("{} vertices are not at finite places; they are grey", nowhere));
  tell_histogram(result.quality, range, result.log);
  for (float& d : result.quality) {
    result.colours.push_back(std::isfinite(d) ? colour(d / range) : Colour{128, 128, 128});
    if (!std::isfinite(d)) d = 0;
  }
  return result;
}

}  // namespace

Filter deviation() {
  return {"Fieldfab: Deviation from a layer or f-rep",
          "The signed distance of each vertex to the surface of another layer, a formula or a file: as vertex "
          "quality, as vertex colour (blue inside, white on the surface, orange to red outside) and as a histogram "
          "in the log. Vertices and faces are not changed.",
          Filter::Group::quality,
          true,
          true,
          deviation_parameters,
          run_deviation};
}

}  // namespace fieldfab::meshlab
