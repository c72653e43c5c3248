/// Files opened as layers of MeshLab, and layers saved.
#pragma once

#include <QString>
#include <functional>
#include <string>

#include "../filter.h"
#include "work.h"

class MeshModel;
class RichParameterList;

namespace fieldfab::meshlab {

/// Fills an empty layer from a file, and returns MeshLab's mask of what the file holds. `format` is the file's
/// extension; `log` receives the reader's notes. Throws Error, std::bad_alloc.
int open_file(const QString& format, const QString& file, MeshModel& model, const RichParameterList& parameters,
              Bar* bar, const std::function<void(const std::string&)>& log);

/// Saves a layer as .asdf. Throws as open_file().
void save_file(const QString& file, const MeshModel& model, const RichParameterList& parameters, Bar* bar,
               const std::function<void(const std::string&)>& log);

/// Returns the data for the defaults of a layer that is saved.
Document document_of(const MeshModel& model);

std::string in_lower_case(const QString& format);

}  // namespace fieldfab::meshlab
