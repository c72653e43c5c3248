/// Level sets for programs that know OpenVDB.
#pragma once

#include <filesystem>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// Writes the solid's level set as a .vdb file: signed distances in mm, four voxels to either side, swept by OpenVDB from samples
/// of the Field. Throws bad_input where there is no surface within the bounds, io, cancelled.
void write_vdb(const Field& solid, const Box& bounds, double voxel, const std::filesystem::path& path,
               Progress& progress = Progress::none());

}  // namespace fieldfab
