/// Pictures of programs (Keeter Fig. 6-16), and set-up sheets.
#pragma once

#include <filesystem>
#include <string>

#include "fieldfab/cam/job/job.h"

namespace fieldfab::cam {

/// Colour scale: by order from blue (first) to green (last), or by depth from light (high) to dark (deep). Rapids are
/// red.
enum class Colouring { order, depth };

struct PictureSettings {
  Colouring colouring = Colouring::order;
  int size = 1024;       ///< longer side of a PNG, pixels
  bool oblique = false;  ///< oblique view from the front and above; default: from above
  bool rapids = true;
};

/// Draws the tool paths into a .png or an .svg file (vector lines). Throws Error(bad_input) for another extension or a
/// size out of range, Error(io).
void write_picture(const Program& program, const std::filesystem::path& path, const PictureSettings& settings = {});

/// Writes the set-up sheet, one HTML file with embedded pictures: tools, zero, stock, operations with settings and
/// times, and notes. Precondition: Job::run(). Throws Error(io).
void write_setup_sheet(const Job& job, const std::filesystem::path& path);

}  // namespace fieldfab::cam
