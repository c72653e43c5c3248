#include "file_plugin.h"

#include <wrap/io_trimesh/io_mask.h>

#include <QDir>
#include <QFileInfo>
#include <new>

#include "../files.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "layers.h"
#include "parameters.h"
#include "work.h"

using namespace fieldfab;
using namespace fieldfab::meshlab;

namespace {

QList<MeshIOInterface::Format> formats(const std::vector<FileKind>& kinds) {
  QList<MeshIOInterface::Format> list;
  for (const FileKind& kind : kinds) {
    MeshIOInterface::Format format(text_of(kind.description), text_of(kind.extensions.front()));
    for (std::size_t i = 1; i < kind.extensions.size(); ++i) format.extensions << text_of(kind.extensions[i]);
    list << format;
  }
  return list;
}

std::filesystem::path path_of(const QString& file) { return QFileInfo(file).absoluteFilePath().toUtf8().toStdString(); }

std::string in_lower_case(const QString& format) { return format.toLower().toUtf8().toStdString(); }

Document document_of(const MeshModel& model) {
  const Layer layer = layer_from(model);
  Document document;
  document.layers.push_back({layer.name, layer.mesh.bounds(), layer.mesh.triangles.size(), 0});
  return document;
}

/// Runs work; stores the message of an error in `message`.
bool done(const std::function<void()>& work, QString& message) {
  try {
    work();
    return true;
  } catch (const std::bad_alloc&) {
    message = "There is not enough memory for it.";
  } catch (const Error& error) {
    message = error.kind() == ErrorKind::cancelled ? QString("Cancelled.") : text_of(printable(error.what()));
  } catch (const std::exception& error) {
    message = text_of(printable(error.what()));
  }
  return false;
}

}  // namespace

QList<MeshIOInterface::Format> FieldfabFiles::importFormats() const { return formats(files_read()); }
QList<MeshIOInterface::Format> FieldfabFiles::exportFormats() const { return formats(files_written()); }

void FieldfabFiles::GetExportMaskCapability(QString&, int& capability, int& defaults) const {
  capability = defaults = 0;
}

void FieldfabFiles::initPreOpenParameter(const QString& format, const QString&, RichParameterList& parameters) {
  show_parameters(reading_parameters(in_lower_case(format)), nullptr, parameters);
}

bool FieldfabFiles::open(const QString& format, const QString& file, MeshModel& model, int& mask,
                         const RichParameterList& parameters, vcg::CallBackPos* bar, QWidget*) {
  mask = vcg::tri::io::Mask::IOM_VERTCOORD | vcg::tri::io::Mask::IOM_FACEINDEX;
  const bool good = done(
      [&] {
        const Values values(chosen_parameters(reading_parameters(in_lower_case(format)), nullptr, parameters), {}, 0);
        Layer layer;
        std::vector<std::string> log;
        work_beside([&](Progress& progress) { layer = read_file_as_layer(path_of(file), values, log, progress); }, bar);
        for (const std::string& line : log) Log(GLLogStream::FILTER, printable(line));
        if (!layer.colours.empty()) mask |= vcg::tri::io::Mask::IOM_VERTCOLOR;
        write_layer(layer, model);
      },
      errorMessage);
  if (!good) Log(GLLogStream::WARNING, errorMessage.toUtf8().toStdString());
  if (!good) qWarning("Fieldfab: %s", qUtf8Printable(errorMessage));
  return good;
}

void FieldfabFiles::initSaveParameter(const QString&, MeshModel& model, RichParameterList& parameters) {
  QString ignored;
  done([&] { show_parameters(writing_parameters(document_of(model)), nullptr, parameters); }, ignored);
}

bool FieldfabFiles::save(const QString&, const QString& file, MeshModel& model, int,
                         const RichParameterList& parameters, vcg::CallBackPos* bar, QWidget*) {
  const bool good = done(
      [&] {
        const Layer layer = layer_from(model);
        const Values values(chosen_parameters(writing_parameters(document_of(model)), nullptr, parameters), {}, 0);
        std::vector<std::string> log;
        work_beside([&](Progress& progress) { write_layer_as_asdf(layer, path_of(file), values, log, progress); }, bar);
        for (const std::string& line : log) Log(GLLogStream::FILTER, printable(line));
      },
      errorMessage);
  if (!good) qWarning("Fieldfab: %s", qUtf8Printable(errorMessage));
  return good;
}
