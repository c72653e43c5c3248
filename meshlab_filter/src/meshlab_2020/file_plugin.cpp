#include "file_plugin.h"

#include "../files.h"
#include "../host/file_run.h"
#include "../host/filter_run.h"
#include "../host/parameters.h"

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
  const auto log = [&](const std::string& line) { Log(GLLogStream::FILTER, line); };
  return done([&] { mask = open_file(format, file, model, parameters, bar, log); });
}

void FieldfabFiles::initSaveParameter(const QString&, MeshModel& model, RichParameterList& parameters) {
  message_of([&] { show_parameters(writing_parameters(document_of(model)), nullptr, parameters); }, "");
}

bool FieldfabFiles::save(const QString&, const QString& file, MeshModel& model, int,
                         const RichParameterList& parameters, vcg::CallBackPos* bar, QWidget*) {
  const auto log = [&](const std::string& line) { Log(GLLogStream::FILTER, line); };
  return done([&] { save_file(file, model, parameters, bar, log); });
}

/// Does work; reports its error in MeshLab's way.
bool FieldfabFiles::done(const std::function<void()>& work) {
  errorMessage = text_of(message_of(work, ""));
  if (errorMessage.isEmpty()) return true;
  Log(GLLogStream::WARNING, errorMessage.toUtf8().toStdString());
  qWarning("Fieldfab: %s", qUtf8Printable(errorMessage));
  return false;
}

#include "moc_file_plugin.cpp"
