#include "filter_run.h"

#include <new>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "layers.h"
#include "meshlab.h"
#include "parameters.h"

namespace fieldfab::meshlab {
namespace {

/// Copies only the layers that a filter asks for.
std::map<std::size_t, std::shared_ptr<const Layer>> layers_for(const std::vector<Parameter>& parameters,
                                                               const Document& seen, const MeshDocument& document) {
  const std::vector<const MeshModel*> all = layers_of(document);
  std::map<std::size_t, std::shared_ptr<const Layer>> layers;
  const auto take = [&](double index) {
    const auto at = static_cast<std::size_t>(index);
    if (index >= 0 && at < seen.layers.size() && !layers.contains(at))
      layers[at] = std::make_shared<const Layer>(layer_from(*all[at]));
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
    for (MeshModel* const model : added) remove_layer(document, model);
    if (before != nullptr) document.setCurrentMesh(static_cast<int>(before->id()));
    throw;
  }
}

}  // namespace

void run_filter(const Filter& filter, MeshDocument& document, const RichParameterList& list, Bar* bar,
                const std::function<void(const std::string&)>& log) {
  const Document seen = document_from(document);
  MeshModel* const chosen = document.mm();
  if (filter.needs_layer && chosen == nullptr)
    throw Error(ErrorKind::bad_input, "layer", "there is none; open a mesh first");
  const std::vector<Parameter> parameters = chosen_parameters(filter.parameters(seen), &document, list);
  const Values values(parameters, layers_for(parameters, seen, document), seen.current);
  Result result;
  work_beside([&](Progress& progress) { result = filter.run(values, progress); }, bar);
  for (const std::string& line : result.log) log(printable(line));
  if (!result.quality.empty()) write_colours(result, *chosen);
  add_layers(result.layers, document);
}

std::string message_of(const std::function<void()>& work, const std::string& unchanged) {
  try {
    work();
    return "";
  } catch (const std::bad_alloc&) {
    return "There is not enough memory for it" + unchanged + ".";
  } catch (const Error& error) {
    return error.kind() == ErrorKind::cancelled ? "Cancelled" + unchanged + "." : printable(error.what());
  } catch (const std::exception& error) {
    return printable(error.what());
  }
}

}  // namespace fieldfab::meshlab
