// Surface in a CT volume.
#include <fmt/format.h>

#include "../solids.h"
#include "../volume_import.h"
#include "all.h"

namespace fieldfab::meshlab {
namespace {

std::vector<Parameter> volume_file_parameters(const Document&) {
  Parameter file;
  file.name = "File", file.label = "Volume", file.kind = Parameter::Kind::file, file.value = std::string();
  file.help = fmt::format("{}: of a stack of slices any one of them.", volume_patterns_text());
  file.choices = volume_patterns();
  std::vector<Parameter> rows{std::move(file)};
  for (Parameter& row : volume_parameters()) rows.push_back(std::move(row));
  return rows;
}

Result run_volume(const Values& values, Progress& progress) {
  Result result;
  result.layers.push_back(import_volume(values.text("File"), values, result.log, progress));
  return result;
}

}  // namespace

Filter volume_solid() {
  return {"Fieldfab: Volume import with threshold",
          "The surface of a CT volume at a threshold: a closed mesh, capped where the scan ends. Noise can be "
          "filtered and small pieces removed. The result is a new layer.",
          Filter::Group::creation,
          false,
          false,
          volume_file_parameters,
          run_volume};
}

}  // namespace fieldfab::meshlab
