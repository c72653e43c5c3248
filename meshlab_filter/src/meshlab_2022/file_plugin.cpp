#include "file_plugin.h"

#include "../files.h"
#include "../host/file_run.h"
#include "../host/filter_run.h"
#include "../host/parameters.h"
#include "meshlab.h"

using namespace fieldfab::meshlab;

namespace {

std::list<FileFormat> formats(const std::vector<FileKind>& kinds) {
  std::list<FileFormat> list;
  for (const FileKind& kind : kinds) {
    QStringList extensions;
    for (const std::string& extension : kind.extensions) extensions << text_of(extension);
    list.emplace_back(text_of(kind.description), extensions);
  }
  return list;
}

/// Does work; throws its error in MeshLab's way.
void require(const std::function<void()>& work) {
  const std::string message = message_of(work, "");
  if (!message.empty()) throw MLException(text_of(message));
}

}  // namespace

std::list<FileFormat> FieldfabFiles::importFormats() const { return formats(files_read()); }
std::list<FileFormat> FieldfabFiles::exportFormats() const { return formats(files_written()); }

void FieldfabFiles::exportMaskCapability(const QString&, int& capability, int& defaults) const {
  capability = defaults = 0;
}

RichParameterList FieldfabFiles::initPreOpenParameter(const QString& format) const {
  RichParameterList parameters;
  show_parameters(reading_parameters(in_lower_case(format)), nullptr, parameters);
  return parameters;
}

void FieldfabFiles::open(const QString& format, const QString& file, MeshModel& model, int& mask,
                         const RichParameterList& parameters, vcg::CallBackPos* bar) {
  const auto report = [&](const std::string& line) { log(GLLogStream::FILTER, line); };
  require([&] { mask = open_file(format, file, model, parameters, bar, report); });
}

RichParameterList FieldfabFiles::initSaveParameter(const QString&, const MeshModel& model) const {
  RichParameterList parameters;
  message_of([&] { show_parameters(writing_parameters(document_of(model)), nullptr, parameters); }, "");
  return parameters;
}

void FieldfabFiles::save(const QString&, const QString& file, MeshModel& model, int,
                         const RichParameterList& parameters, vcg::CallBackPos* bar) {
  const auto report = [&](const std::string& line) { log(GLLogStream::FILTER, line); };
  require([&] { save_file(file, model, parameters, bar, report); });
}

#include "moc_file_plugin.cpp"
