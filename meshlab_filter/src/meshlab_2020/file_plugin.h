/// Fieldfab's file formats as a plugin of MeshLab 2020.09 (Debian 12).
#pragma once

#include <common/interfaces.h>

#include <QObject>
#include <functional>

class FieldfabFiles : public QObject, public MeshIOInterface {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(MESH_IO_INTERFACE_IID)
  Q_INTERFACES(MeshIOInterface)
 public:
  QString pluginName() const override { return "Fieldfab files"; }
  QList<Format> importFormats() const override;
  QList<Format> exportFormats() const override;
  void GetExportMaskCapability(QString& format, int& capability, int& defaults) const override;
  void initPreOpenParameter(const QString& format, const QString& file, RichParameterList& parameters) override;
  bool open(const QString& format, const QString& file, MeshModel& model, int& mask,
            const RichParameterList& parameters, vcg::CallBackPos* bar, QWidget* parent) override;
  void initSaveParameter(const QString& format, MeshModel& model, RichParameterList& parameters) override;
  bool save(const QString& format, const QString& file, MeshModel& model, int mask, const RichParameterList& parameters,
            vcg::CallBackPos* bar, QWidget* parent) override;

 private:
  bool done(const std::function<void()>& work);
};
