/// Long work beside MeshLab's window.
#pragma once

#include <functional>

#include "fieldfab/core/progress.h"

namespace fieldfab::meshlab {

/// MeshLab's progress bar: percent and what is being done; false asks to stop.
using Bar = bool(int, const char*);

/// Runs `work` on a thread of its own while this one, MeshLab's, tells the bar and listens: to the bar's answer, and to the
/// Cancel button and the Escape key in its window (this version's bar never asks to stop). Throws what the work throws; cancelled
/// work throws Error(cancelled).
void work_beside(const std::function<void(Progress&)>& work, Bar* bar);

}  // namespace fieldfab::meshlab
