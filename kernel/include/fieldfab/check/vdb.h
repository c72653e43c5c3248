/// Export of level sets to OpenVDB.
#pragma once

#include <filesystem>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// Writes the solid's level set as a .vdb file: signed distances in mm within four voxels of the surface, computed by
/// OpenVDB's sweeping from samples of the Field. Throws Error(bad_input) if there is no surface within `bounds`,
/// Error(io), Error(cancelled).
void write_vdb(const Field& solid, const Box& bounds, double voxel, const std::filesystem::path& path,
               Progress& progress = Progress::none());

}  // namespace fieldfab
