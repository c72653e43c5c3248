/// Parameters as MeshLab's dialogs and scripts have them.
#pragma once

#include <QString>

#include "../filter.h"

class MeshDocument;
class RichParameterList;

namespace fieldfab::meshlab {

/// Adds rows to a dialog; `document` may be null where no row asks for a layer.
void show_parameters(const std::vector<Parameter>& parameters, MeshDocument* document, RichParameterList& list);

/// The same parameters with what a user has chosen; layers by their index in the document, -1 where it has none like that.
std::vector<Parameter> chosen_parameters(std::vector<Parameter> parameters, const MeshDocument* document,
                                         const RichParameterList& list);

QString text_of(const std::string& utf8);

}  // namespace fieldfab::meshlab
