/// Scans as solids and as distance field files.
#pragma once

#include <filesystem>
#include <vector>

#include "fieldfab/asdf/import.h"
#include "fieldfab/solid/solid.h"
#include "fieldfab/volume/scan.h"

namespace fieldfab {

/// Writes the .asdf file of a scan of any size within the memory that the settings permit (see import_asdf()). Each
/// further level is the volume at half the resolution of the previous one.
ImportCounts import_scan(const Scan& scan, const std::filesystem::path& path, const ImportSettings& settings,
                         Progress& progress = Progress::none());

/// Returns the lattices that import_scan() reads: the scan itself and its halved volumes, `levels` in all.
std::vector<LatticeSource> lattices_of(const Scan& scan, int levels);

/// Reads a scan into memory as a solid. Throws as volume_field().
std::shared_ptr<OpenedSolid> opened_scan(const Scan& scan, Progress& progress = Progress::none());

}  // namespace fieldfab
