/// Long work that leaves MeshLab's window responsive.
#pragma once

#include <functional>

#include "fieldfab/core/progress.h"

namespace fieldfab::meshlab {

/// MeshLab's progress bar: percentage and description; returns false to request a stop.
using Bar = bool(int, const char*);

/// Runs `work` on its own thread. Meanwhile the calling thread, MeshLab's, updates the bar and
/// handles requests to stop: the bar's result, the Cancel button and the Escape key (the bar of
/// MeshLab 2020.09 never requests a stop). Rethrows exceptions of the work; cancelled work throws
/// Error(cancelled).
void work_beside(const std::function<void(Progress&)>& work, Bar* bar);

}  // namespace fieldfab::meshlab
