/// From MeshLab's meshes to layers as filters know them, and back.
#pragma once

#include "../filter.h"

class MeshDocument;
class MeshModel;

namespace fieldfab::meshlab {

/// The mesh as it is drawn: where its transform puts it, without what is deleted.
Layer layer_from(const MeshModel& model);

/// What defaults are worked out from.
Document document_from(const MeshDocument& document);

/// Fills a new, empty mesh.
void write_layer(const Layer& layer, MeshModel& model);

/// Gives each vertex its quality and colour; they are in the order of layer_from().
void write_colours(const Result& result, MeshModel& model);

}  // namespace fieldfab::meshlab
