#include "filter_plugin.h"

#include <new>

#include "../filter.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "layers.h"
#include "parameters.h"
#include "work.h"

using namespace fieldfab;
using namespace fieldfab::meshlab;

namespace {

const Filter& filter_of(int id) { return filters().at(static_cast<std::size_t>(id)); }

/// Copies only the layers that a filter asks for.
std::map<std::size_t, std::shared_ptr<const Layer>> layers_for(const std::vector<Parameter>& parameters,
                                                               const Document& seen, const MeshDocument& document) {
  std::map<std::size_t, std::shared_ptr<const Layer>> layers;
  const auto take = [&](double index) {
    const auto at = static_cast<std::size_t>(index);
    if (index >= 0 && at < seen.layers.size() && !layers.contains(at))
      layers[at] = std::make_shared<const Layer>(layer_from(*document.meshList[static_cast<int>(at)]));
  };
  take(static_cast<double>(seen.current));
  for (const Parameter& row : parameters)
    if (row.kind == Parameter::Kind::layer) take(std::get<double>(row.value));
  return layers;
}

void add_layers(const std::vector<Layer>& layers, MeshDocument& document) {
  MeshModel* const before = document.mm();
  std::vector<MeshModel*> added;
  added.reserve(layers.size());
  try {
    for (const Layer& layer : layers) {
      added.push_back(document.addNewMesh("", text_of(layer.name)));
      write_layer(layer, *added.back());
    }
  } catch (...) {  // out of memory: no layer is kept
    for (MeshModel* const model : added) document.delMesh(model);
    if (before != nullptr) document.setCurrentMesh(before->id());
    throw;
  }
}

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
  const Filter& filter = filter_of(ID(action));
  return filter.needs_layer ? SINGLE_MESH : NONE;
}

// A filter reports missing input itself, in words; MeshLab's own check evaluates a layer that may
// not exist.
int FieldfabFilters::getPreConditions(QAction*) const { return MeshModel::MM_NONE; }

int FieldfabFilters::postCondition(QAction* action) const {
  return filter_of(ID(action)).colours ? MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR : MeshModel::MM_NONE;
}

void FieldfabFilters::initParameterSet(QAction* action, MeshDocument& document, RichParameterList& parameters) {
  try {
    show_parameters(filter_of(ID(action)).parameters(document_from(document)), &document, parameters);
  } catch (const std::exception& error) {
    Log(GLLogStream::WARNING, std::string(error.what()));
  }
}

bool FieldfabFilters::applyFilter(QAction* action, MeshDocument& document, const RichParameterList& list,
                                  vcg::CallBackPos* bar) {
  errorMessage.clear();
  try {
    const Filter& filter = filter_of(ID(action));
    const Document seen = document_from(document);
    if (filter.needs_layer && document.mm() == nullptr)
      throw Error(ErrorKind::bad_input, "layer", "there is none; open a mesh first");
    MeshModel* const chosen = document.mm();
    const std::vector<Parameter> parameters = chosen_parameters(filter.parameters(seen), &document, list);
    const Values values(parameters, layers_for(parameters, seen, document), seen.current);
    Result result;
    work_beside([&](Progress& progress) { result = filter.run(values, progress); }, bar);
    for (const std::string& line : result.log) Log(GLLogStream::FILTER, printable(line));
    if (!result.quality.empty()) write_colours(result, *chosen);
    add_layers(result.layers, document);
    return true;
  } catch (const std::bad_alloc&) {
    errorMessage = "There is not enough memory for it; the layers are as they were.";
  } catch (const Error& error) {
    errorMessage = error.kind() == ErrorKind::cancelled ? QString("Cancelled; the layers are as they were.")
                                                        : text_of(printable(error.what()));
  } catch (const std::exception& error) {
    errorMessage = text_of(printable(error.what()));
  }
  Log(GLLogStream::WARNING, errorMessage.toUtf8().toStdString());
  return false;
}
