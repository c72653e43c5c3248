#include "filter_plugin.h"

#include "../filter.h"
#include "../host/filter_run.h"
#include "../host/layers.h"
#include "../host/parameters.h"

using namespace fieldfab;
using namespace fieldfab::meshlab;

namespace {

const Filter& filter_of(int id) { return filters().at(static_cast<std::size_t>(id)); }

}  // namespace

FieldfabFilters::FieldfabFilters() {
  for (std::size_t id = 0; id < filters().size(); ++id) {
    typeList << static_cast<int>(id);
    actionList << new QAction(filterName(static_cast<int>(id)), this);
  }
}

QString FieldfabFilters::filterName(FilterIDType filter) const { return text_of(filter_of(filter).name); }
QString FieldfabFilters::filterInfo(FilterIDType filter) const { return text_of(filter_of(filter).help); }

MeshFilterInterface::FilterClass FieldfabFilters::getClass(QAction* action) {
  switch (filter_of(ID(action)).group) {
    case Filter::Group::remeshing: return Remeshing;
    case Filter::Group::creation: return MeshCreation;
    case Filter::Group::quality: return static_cast<FilterClass>(Quality | VertexColoring);
    case Filter::Group::measure: return Measure;
  }
  return Remeshing;
}

MeshFilterInterface::FILTER_ARITY FieldfabFilters::filterArity(QAction* action) const {
  return filter_of(ID(action)).needs_layer ? SINGLE_MESH : NONE;
}

// A filter reports missing input itself, in words; MeshLab's own check evaluates a layer that may
// not exist.
int FieldfabFilters::getPreConditions(QAction*) const { return MeshModel::MM_NONE; }

int FieldfabFilters::postCondition(QAction* action) const {
  return filter_of(ID(action)).colours ? MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR : MeshModel::MM_NONE;
}

void FieldfabFilters::initParameterSet(QAction* action, MeshDocument& document, RichParameterList& parameters) {
  const std::string message = message_of(
      [&] { show_parameters(filter_of(ID(action)).parameters(document_from(document)), &document, parameters); }, "");
  if (!message.empty()) Log(GLLogStream::WARNING, message);
}

bool FieldfabFilters::applyFilter(QAction* action, MeshDocument& document, const RichParameterList& list,
                                  vcg::CallBackPos* bar) {
  const auto log = [&](const std::string& line) { Log(GLLogStream::FILTER, line); };
  errorMessage = text_of(message_of([&] { run_filter(filter_of(ID(action)), document, list, bar, log); },
                                    "; the layers are as they were"));
  if (errorMessage.isEmpty()) return true;
  Log(GLLogStream::WARNING, errorMessage.toUtf8().toStdString());
  return false;
}

#include "moc_filter_plugin.cpp"
