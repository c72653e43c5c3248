// What meshlabserver was, for MeshLab 2022.02 and later, which have none: opens files as layers, runs a script's
// filters, saves layers. The plugins are those beside this program, loaded by MeshLab's own library.
// meshlab_server [-i MESH]... [-o MESH [-l LAYER] [-m MASK]]... [-s SCRIPT]; LAYER "x" is the current one.
#include <common/globals.h>
#include <common/ml_document/mesh_document.h>
#include <common/mlexception.h>
#include <common/plugins/plugin_manager.h>
#include <common/utilities/load_save.h>

#include <wrap/io_trimesh/io_mask.h>

#include <QApplication>
#include <QDomDocument>
#include <QFile>
#include <iostream>

namespace {

GLLogStream& logged() {
  static GLLogStream stream;
  return stream;
}

void set_value(RichParameterList& list, const QString& name, const QString& text) {
  auto row = list.findParameter(name), end = list.end();
  if (row == end) throw MLException("the filter has no parameter " + name);
  const Value& value = row->value();
  if (value.isBool())
    list.setValue(name, BoolValue(text == "true"));
  else if (value.isInt())
    list.setValue(name, IntValue(text.toInt()));
  else if (value.isFloat())
    list.setValue(name, FloatValue(text.toDouble()));
  else
    list.setValue(name, StringValue(text));
}

QAction* action_named(const QString& name, FilterPlugin*& owner) {
  for (FilterPlugin* plugin : meshlab::pluginManagerInstance().filterPluginIterator())
    for (QAction* action : plugin->actions())
      if (plugin->filterName(action) == name) {
        owner = plugin;
        return action;
      }
  throw MLException("there is no filter " + name);
}

void run_script(const QString& path, MeshDocument& document) {
  QFile file(path);
  QDomDocument script;
  if (!file.open(QIODevice::ReadOnly) || !script.setContent(&file)) throw MLException(path + " is no script");
  const QDomNodeList filters = script.elementsByTagName("filter");
  for (int i = 0; i < filters.count(); ++i) {
    const QDomElement filter = filters.at(i).toElement();
    FilterPlugin* plugin = nullptr;
    QAction* action = action_named(filter.attribute("name"), plugin);
    plugin->setLog(&logged());
    RichParameterList list = plugin->initParameterList(action, document);
    const QDomNodeList rows = filter.elementsByTagName("Param");
    for (int row = 0; row < rows.count(); ++row)
      set_value(list, rows.at(row).toElement().attribute("name"), rows.at(row).toElement().attribute("value"));
    unsigned int changed = 0;
    if (const int needs = plugin->getRequirements(action); document.mm() != nullptr)
      document.mm()->updateDataMask(needs | plugin->postCondition(action));
    plugin->applyFilter(action, list, document, changed, nullptr);
    std::cout << "Filter successfully ended: " << filter.attribute("name").toStdString() << "\n";
  }
}

/// Saves places and triangles of a layer, and what the mask names besides.
void save(const QString& path, MeshModel& layer, int mask) {
  const QString format = QFileInfo(path).suffix().toUpper();
  IOPlugin* writer = meshlab::pluginManagerInstance().outputMeshPlugin(format);
  if (writer == nullptr) throw MLException(format + " is no format that can be written");
  writer->setLog(&logged());
  writer->save(format, path, layer, mask, writer->initSaveParameter(format, layer), nullptr);
}

}  // namespace

int main(int count, char** words) {
  const QApplication application(count, words);
  QStringList arguments = QApplication::arguments().mid(1), inputs;
  QString script;
  struct Output {
    QString path, layer;
    int mask = 0;
  };
  QList<Output> outputs;
  for (int i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] == "-i")
      inputs << arguments[++i];
    else if (arguments[i] == "-s")
      script = arguments[++i];
    else if (arguments[i] == "-o")
      outputs << Output{arguments[++i], "x"};
    else if (arguments[i] == "-l")
      outputs.last().layer = arguments[++i];
    else if (arguments[i] == "-m")
      while (i + 1 < arguments.size() && !arguments[i + 1].startsWith('-'))
        outputs.last().mask |=
            arguments[++i] == "vc" ? vcg::tri::io::Mask::IOM_VERTCOLOR : vcg::tri::io::Mask::IOM_VERTQUALITY;
  }
  int code = 0;
  MeshDocument document;
  try {
    meshlab::pluginManagerInstance().loadPlugins();
    for (const QString& input : inputs) {
      if (IOPlugin* reader = meshlab::pluginManagerInstance().inputMeshPlugin(QFileInfo(input).suffix()))
        reader->setLog(&logged());
      meshlab::loadMeshWithStandardParameters(input, document);
    }
    if (!script.isEmpty()) run_script(script, document);
    for (const Output& output : outputs) {
      MeshModel* layer = document.mm();
      if (int at = output.layer == "x" ? -1 : output.layer.toInt(); at >= 0)
        for (MeshModel& each : document.meshIterator())
          if (at-- == 0) layer = &each;
      if (layer == nullptr) throw MLException("there is no layer to save as " + output.path);
      save(output.path, *layer, output.mask);
      std::cout << output.path.toStdString() << " is written\n";
    }
  } catch (const std::exception& error) {
    std::cout << "Error: " << error.what() << "\n";
    code = 1;
  }
  return code;
}
