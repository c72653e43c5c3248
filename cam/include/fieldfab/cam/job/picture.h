/// Pictures of programs (Keeter Fig. 6-16), and the set-up sheet that goes to the machine with them.
#pragma once

#include <filesystem>
#include <string>

#include "fieldfab/cam/job/job.h"

namespace fieldfab::cam {

/// What colours mean: from blue (first) to green (last), or from light (high) to dark (deep); rapids are red.
enum class Colouring { order, depth };

struct PictureSettings {
  Colouring colouring = Colouring::order;
  int size = 1024;       ///< pixels of a PNG's longer side
  bool oblique = false;  ///< seen from the front, above; else from straight above
  bool rapids = true;
};

/// A .png or an .svg (lines as vectors) of the tool's ways. Throws bad_input for another extension or a size out of range, io.
void write_picture(const Program& program, const std::filesystem::path& path, const PictureSettings& settings = {});

/// One HTML file, pictures within it: tools, zero, stock, operations with their settings and times, and notes. After Job::run().
void write_setup_sheet(const Job& job, const std::filesystem::path& path);

}  // namespace fieldfab::cam
