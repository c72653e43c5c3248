#include "filter_plugin.h"

#include "../filter.h"
#include "../host/filter_run.h"
#include "../host/layers.h"
#include "../host/parameters.h"
#include "meshlab.h"

using namespace fieldfab::meshlab;

namespace {

const Filter& filter_of(int id) { return filters().at(static_cast<std::size_t>(id)); }

}  // namespace

FieldfabFilters::FieldfabFilters() {
  for (std::size_t id = 0; id < filters().size(); ++id) {
    typeList.push_back(static_cast<int>(id));
    actionList.push_back(new QAction(filterName(static_cast<int>(id)), this));
  }
}

QString FieldfabFilters::filterName(ActionIDType filter) const { return text_of(filter_of(filter).name); }
QString FieldfabFilters::filterInfo(ActionIDType filter) const { return text_of(filter_of(filter).help); }

FilterPlugin::FilterClass FieldfabFilters::getClass(const QAction* action) const {
  switch (filter_of(ID(action)).group) {
    case Filter::Group::remeshing: return Remeshing;
    case Filter::Group::creation: return MeshCreation;
    case Filter::Group::quality: return static_cast<FilterClass>(Quality | VertexColoring);
    case Filter::Group::measure: return Measure;
  }
  return Remeshing;
}

FilterPlugin::FilterArity FieldfabFilters::filterArity(const QAction* action) const {
  return filter_of(ID(action)).needs_layer ? SINGLE_MESH : NONE;
}

// A filter reports missing input itself, in words.
int FieldfabFilters::getPreConditions(const QAction*) const { return MeshModel::MM_NONE; }

int FieldfabFilters::postCondition(const QAction* action) const {
  return filter_of(ID(action)).colours ? MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR : MeshModel::MM_NONE;
}

RichParameterList FieldfabFilters::initParameterList(const QAction* action, const MeshDocument& document) {
  RichParameterList parameters;
  const std::string message = message_of(
      [&] { show_parameters(filter_of(ID(action)).parameters(document_from(document)), &document, parameters); }, "");
  if (!message.empty()) log(GLLogStream::WARNING, message);
  return parameters;
}

std::map<std::string, QVariant> FieldfabFilters::applyFilter(const QAction* action, const RichParameterList& list,
                                                             MeshDocument& document, unsigned int& changed,
                                                             vcg::CallBackPos* bar) {
  const Filter& filter = filter_of(ID(action));
  const auto report = [&](const std::string& line) { log(GLLogStream::FILTER, line); };
  const std::string message =
      message_of([&] { run_filter(filter, document, list, bar, report); }, "; the layers are as they were");
  if (!message.empty()) {
    log(GLLogStream::WARNING, message);  // MeshLab's own line comes after its message is closed
    throw MLException(text_of(message));
  }
  changed = static_cast<unsigned int>(postCondition(action));
  return {};
}

#include "moc_filter_plugin.cpp"
