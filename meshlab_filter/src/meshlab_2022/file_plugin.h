/// Fieldfab's file formats as a plugin of MeshLab 2022.02 (Debian 13) and later versions.
#pragma once

#include <common/plugins/interfaces/io_plugin.h>

#include <QObject>

class FieldfabFiles : public QObject, public IOPlugin {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(IO_PLUGIN_IID)
  Q_INTERFACES(IOPlugin)
 public:
  QString pluginName() const override { return "Fieldfab files"; }
  QString vendor() const override { return "Fieldfab"; }
  std::list<FileFormat> importFormats() const override;
  std::list<FileFormat> exportFormats() const override;
  void exportMaskCapability(const QString& format, int& capability, int& defaults) const override;
  RichParameterList initPreOpenParameter(const QString& format) const override;
  void open(const QString& format, const QString& file, MeshModel& model, int& mask,
            const RichParameterList& parameters, vcg::CallBackPos* bar) override;
  RichParameterList initSaveParameter(const QString& format, const MeshModel& model) const override;
  void save(const QString& format, const QString& file, MeshModel& model, int mask, const RichParameterList& parameters,
            vcg::CallBackPos* bar) override;
};
