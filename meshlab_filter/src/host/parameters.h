/// Parameters in MeshLab's dialogs and scripts.
#pragma once

#include <QString>

#include "../filter.h"

class MeshDocument;
class RichParameterList;

namespace fieldfab::meshlab {

/// Adds rows to a dialog; `document` may be null if no row asks for a layer.
void show_parameters(const std::vector<Parameter>& parameters, const MeshDocument* document, RichParameterList& list);

/// Returns the parameters with the values chosen by the user. A layer is its index in the document,
/// or -1 if the document does not contain it.
std::vector<Parameter> chosen_parameters(std::vector<Parameter> parameters, const MeshDocument* document,
                                         const RichParameterList& list);

QString text_of(const std::string& utf8);

}  // namespace fieldfab::meshlab
