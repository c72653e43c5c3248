/// Conversion of MeshLab's meshes to the layers of filters, and back.
#pragma once

#include "../filter.h"

class MeshDocument;
class MeshModel;

namespace fieldfab::meshlab {

/// Returns the mesh as drawn: with its transform applied, without deleted elements.
Layer layer_from(const MeshModel& model);

/// Returns the data for the computation of defaults.
Document document_from(const MeshDocument& document);

/// Fills a new, empty mesh.
void write_layer(const Layer& layer, MeshModel& model);

/// Sets quality and colour of each vertex; they are in the order of layer_from().
void write_colours(const Result& result, MeshModel& model);

}  // namespace fieldfab::meshlab
