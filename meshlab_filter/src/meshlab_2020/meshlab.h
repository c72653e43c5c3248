/// What the adapter's shared part (src/host) asks of MeshLab 2020.09 (Debian 12).
#pragma once

#include <common/filter_parameter/rich_parameter_list.h>
#include <common/meshmodel.h>

#include <vector>

namespace fieldfab::meshlab {

using LengthRow = RichAbsPerc;
using FileRow = RichOpenFile;

/// Returns the layers of a document in their order.
inline std::vector<const MeshModel*> layers_of(const MeshDocument& document) {
  return {document.meshList.begin(), document.meshList.end()};
}

inline void update_box_and_normals(MeshModel& layer) { layer.UpdateBoxAndNormals(); }

inline void remove_layer(MeshDocument& document, MeshModel* layer) { document.delMesh(layer); }

/// A row of a dialog that chooses a layer, by its index.
inline RichMesh layer_row(const QString& name, std::size_t index, const MeshDocument* document, const QString& label,
                          const QString& help) {
  // The row only reads the document.
  return {name, static_cast<int>(index), const_cast<MeshDocument*>(document), label, help};
}

/// Returns the index of the layer chosen in such a row, or -1.
inline int chosen_layer(const RichParameterList& list, const QString& name, const MeshDocument& document) {
  return document.meshList.indexOf(list.getMesh(name));
}

}  // namespace fieldfab::meshlab
