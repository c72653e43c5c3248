/// A filter's run on a document of MeshLab.
#pragma once

#include <functional>
#include <string>

#include "../filter.h"
#include "work.h"

class MeshDocument;
class RichParameterList;

namespace fieldfab::meshlab {

/// Runs a filter with the parameters that a user chose, and adds its layers and colours. If it fails, the layers are as
/// they were. `log` receives the filter's report, a line each. Throws Error, std::bad_alloc.
void run_filter(const Filter& filter, MeshDocument& document, const RichParameterList& list, Bar* bar,
                const std::function<void(const std::string&)>& log);

/// Does work, and returns the message for the user if it fails: an empty text if not. `unchanged` is added to messages
/// of cancelled work and of missing memory: what the work left as it was.
std::string message_of(const std::function<void()>& work, const std::string& unchanged);

}  // namespace fieldfab::meshlab
