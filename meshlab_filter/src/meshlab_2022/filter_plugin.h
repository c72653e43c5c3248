/// Filters as a plugin of MeshLab 2022.02 (Debian 13) and later versions.
#pragma once

#include <common/plugins/interfaces/filter_plugin.h>

#include <QObject>

class FieldfabFilters : public QObject, public FilterPlugin {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
  Q_INTERFACES(FilterPlugin)
 public:
  FieldfabFilters();
  QString pluginName() const override { return "Fieldfab"; }
  QString vendor() const override { return "Fieldfab"; }
  QString filterName(ActionIDType filter) const override;
  QString filterInfo(ActionIDType filter) const override;
  FilterClass getClass(const QAction* action) const override;
  FilterArity filterArity(const QAction* action) const override;
  int getPreConditions(const QAction* action) const override;
  int postCondition(const QAction* action) const override;
  RichParameterList initParameterList(const QAction* action, const MeshDocument& document) override;
  std::map<std::string, QVariant> applyFilter(const QAction* action, const RichParameterList& parameters,
                                              MeshDocument& document, unsigned int& changed,
                                              vcg::CallBackPos* bar) override;
};
