#include "fieldfab/solid/formats.h"
#include "fieldfab/core/lower_case.h"

#include <algorithm>

#include "fieldfab/volume/volume_file.h"
#include "readers.h"

namespace fieldfab {

std::string_view name_of(FormatKind kind) {
  switch (kind) {
    case FormatKind::formula: return "formula";
    case FormatKind::script: return "script";
    case FormatKind::design: return "design";
    case FormatKind::distances: return "distances";
    case FormatKind::mesh: return "mesh";
    case FormatKind::volume: return "volume";
  }
  return "";
}

const Format* Formats::find(const std::filesystem::path& path) const {
  const std::string name = lower_case(path.filename().string());
  const Format* found = nullptr;
  std::size_t longest = 0;
  for (const Format& row : rows_)
    for (const std::string& extension : row.extensions)
      if (name.ends_with(extension) && extension.size() > longest) found = &row, longest = extension.size();
  std::error_code ignored;
  if (found == nullptr && std::filesystem::is_directory(path, ignored))
    for (const Format& row : rows_)
      if (row.kind == FormatKind::volume && row.read != nullptr) return &row;
  return found;
}

Formats Formats::with(std::vector<Format> more) const {
  std::vector<Format> rows = rows_;
  std::move(more.begin(), more.end(), std::back_inserter(rows));
  return Formats(std::move(rows));
}

namespace {

template <class Wanted>
std::string list_of(const std::vector<Format>& rows, const Wanted& wanted) {
  std::string list;
  for (const Format& row : rows)
    if (wanted(row))
      for (const std::string& extension : row.extensions) list += (list.empty() ? "" : " ") + extension;
  return list;
}

}  // namespace

std::string Formats::readable() const {
  return list_of(rows_, [](const Format& row) { return row.read != nullptr; }) +
         ", folders of TIFF, PNG or DICOM slices";
}

std::string Formats::writable(std::initializer_list<FormatKind> kinds) const {
  return list_of(rows_, [&](const Format& row) {
    return row.written && std::find(kinds.begin(), kinds.end(), *row.written) != kinds.end();
  });
}

std::optional<FormatKind> Formats::written(const std::filesystem::path& path) const {
  const Format* const format = find(path);
  return format == nullptr ? std::nullopt : format->written;
}

bool Formats::is_read_as(FormatKind kind, const std::filesystem::path& path) const {
  const Format* const format = find(path);
  return format != nullptr && format->read != nullptr && format->kind == kind;
}

const Formats& kernel_formats() {
  using Kind = FormatKind;
  constexpr std::optional<Kind> none;
  static const Formats formats({
      {{".math"}, Kind::formula, Kind::formula, "prefix math string, as kokopelli's", read_math},
      {{".vm"}, Kind::formula, Kind::formula, "one operation a line, as Fidget's", read_vm},
      {{".frep"},
       Kind::formula,
       Kind::formula,
       "the design language: formulas, shapes, opened files, parts",
       read_frep,
       true},
      {{".dot"}, Kind::formula, Kind::formula, "the formula as a graph, for Graphviz", nullptr},
      {{".py"}, Kind::script, none, "a Python script that makes solids", read_script},
      {{".ko"}, Kind::script, none, "a script of kokopelli", read_script},
      {{".asdf"}, Kind::distances, Kind::distances, "adaptively sampled distance field", read_asdf},
      {{".stl"}, Kind::mesh, Kind::mesh, "triangles", read_mesh_file},
      {{".ply"}, Kind::mesh, Kind::mesh, "triangles; colours", read_mesh_file},
      {{".off"}, Kind::mesh, Kind::mesh, "triangles", read_mesh_file},
      {{".obj"}, Kind::mesh, Kind::mesh, "triangles; parts, and colours in an .mtl file", read_mesh_file, true},
      {{".3mf"}, Kind::mesh, Kind::mesh, "triangles for printing; parts with names and colours", read_mesh_file, true},
      {{".glb"}, Kind::mesh, Kind::mesh, "glTF binary, for viewers; parts with names and colours", nullptr, true},
      {{".raw", ".vol", ".vgi"},
       Kind::volume,
       none,
       "samples without a header; sizes from the name or a .vgi file",
       read_volume},
      {{".tif", ".tiff"}, Kind::volume, none, "a stack of pictures", read_volume},
      {{".mha", ".nrrd", ".nii", ".nii.gz"}, Kind::volume, Kind::volume, "MetaImage, NRRD, NIfTI", read_volume},
      {{".mhd", ".nhdr"}, Kind::volume, none, "MetaImage and NRRD with samples beside the header", read_volume},
      {{".dcm", ".dicom", ".ima"}, Kind::volume, none, "DICOM", read_volume},
      {{".vdb"}, Kind::volume, Kind::distances, "OpenVDB level set or fog", read_volume},
  });
  return formats;
}

}  // namespace fieldfab
