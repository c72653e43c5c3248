/// What the adapter's shared part (src/host) asks of MeshLab 2022.02 (Debian 13) and later versions.
#pragma once

#include <common/ml_document/mesh_document.h>
#include <common/parameters/rich_parameter_list.h>

#include <vector>

namespace fieldfab::meshlab {

#if __has_include(<common/parameters/rich_parameter/rich_percentage.h>)  // since 2023.12
using LengthRow = RichPercentage;
using FileRow = RichFileOpen;
#else
using LengthRow = RichAbsPerc;
using FileRow = RichOpenFile;
#endif

/// Returns the layers of a document in their order.
inline std::vector<const MeshModel*> layers_of(const MeshDocument& document) {
  std::vector<const MeshModel*> layers;
  for (const MeshModel& layer : document.meshIterator()) layers.push_back(&layer);
  return layers;
}

inline void update_box_and_normals(MeshModel& layer) { layer.updateBoxAndNormals(); }

inline void remove_layer(MeshDocument& document, MeshModel* layer) { document.delMesh(layer->id()); }

/// A row of a dialog that chooses a layer, by its index.
inline RichMesh layer_row(const QString& name, std::size_t index, const MeshDocument* document, const QString& label,
                          const QString& help) {
  const auto layers = layers_of(*document);
  return {name, index < layers.size() ? static_cast<unsigned>(layers[index]->id()) : 0U, document, label, help};
}

/// Returns the index of the layer chosen in such a row, or -1.
inline int chosen_layer(const RichParameterList& list, const QString& name, const MeshDocument& document) {
  const auto layers = layers_of(document);
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (layers[i]->id() == static_cast<int>(list.getMeshId(name))) return static_cast<int>(i);
  return -1;
}

}  // namespace fieldfab::meshlab
