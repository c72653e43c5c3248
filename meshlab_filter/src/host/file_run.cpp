#include "file_run.h"

#include <wrap/io_trimesh/io_mask.h>

#include <QFileInfo>

#include "../files.h"
#include "fieldfab/core/text.h"
#include "layers.h"
#include "meshlab.h"
#include "parameters.h"

namespace fieldfab::meshlab {
namespace {

std::filesystem::path path_of(const QString& file) { return QFileInfo(file).absoluteFilePath().toUtf8().toStdString(); }

}  // namespace

std::string in_lower_case(const QString& format) { return format.toLower().toUtf8().toStdString(); }

Document document_of(const MeshModel& model) {
  const Layer layer = layer_from(model);
  Document document;
  document.layers.push_back({layer.name, layer.mesh.bounds(), layer.mesh.triangles.size(), 0});
  return document;
}

int open_file(const QString& format, const QString& file, MeshModel& model, const RichParameterList& parameters,
              Bar* bar, const std::function<void(const std::string&)>& log) {
  using vcg::tri::io::Mask;
  const Values values(chosen_parameters(reading_parameters(in_lower_case(format)), nullptr, parameters), {}, 0);
  Layer layer;
  std::vector<std::string> lines;
  work_beside([&](Progress& progress) { layer = read_file_as_layer(path_of(file), values, lines, progress); }, bar);
  for (const std::string& line : lines) log(printable(line));
  write_layer(layer, model);
  return Mask::IOM_VERTCOORD | Mask::IOM_FACEINDEX | (layer.colours.empty() ? 0 : Mask::IOM_VERTCOLOR);
}

void save_file(const QString& file, const MeshModel& model, const RichParameterList& parameters, Bar* bar,
               const std::function<void(const std::string&)>& log) {
  const Layer layer = layer_from(model);
  const Values values(chosen_parameters(writing_parameters(document_of(model)), nullptr, parameters), {}, 0);
  std::vector<std::string> lines;
  work_beside([&](Progress& progress) { write_layer_as_asdf(layer, path_of(file), values, lines, progress); }, bar);
  for (const std::string& line : lines) log(printable(line));
}

}  // namespace fieldfab::meshlab
